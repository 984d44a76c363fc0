// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/surface/sheet_surface.h"

#include <algorithm>

#include "croquis/base/error.h"

namespace croquis::silhouette {
namespace {

Index object_of_edge(const LabelledFigure& figure, const SheetSampling& sheets, Index lifted_triangle,
                     std::size_t corner) {
  const Index piece = sheets.planar.constraints[sheets.lifted.planar_triangle[lifted_triangle]][corner];
  return figure.contours[sheets.pieces[piece].contour].object;
}

/// Marks everything connected with the triangle. @return the object whose boundary was met
Index flood_component(const LabelledFigure& figure, const SheetSampling& sheets, Index start,
                      std::vector<std::uint8_t>& seen, std::vector<Index>& members) {
  Index object = no_index;
  members.assign(1, start);
  seen[start] = 1;
  for (std::size_t head = 0; head < members.size(); ++head) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const Index next = sheets.lifted.neighbours[members[head]][corner];
      if (next == no_index) {
        const Index owner = object_of_edge(figure, sheets, members[head], corner);
        if (object != no_index && object != owner) {
          throw Error(make_error(Category::Internal, "E_INTERNAL", "Contours of two objects bound one surface"));
        }
        object = owner;
      } else if (!seen[next]) {
        seen[next] = 1;
        members.push_back(next);
      }
    }
  }
  return object;
}

/// Front and back copies of lifted vertices in one object's mesh; the same where the vertex is on the boundary.
class VertexCopies {
 public:
  VertexCopies(const SheetMesh& sheets, PolyMesh& mesh)
      : sheets_(sheets), mesh_(mesh), front_(sheets.place.size(), no_index), back_(front_) {}

  Index front(Index v) {
    if (front_[v] == no_index) front_[v] = add(v, sheets_.z[v] + sheets_.thickness[v]);
    return front_[v];
  }

  Index back(Index v) {
    if (sheets_.on_boundary[v]) return front(v);
    if (back_[v] == no_index) back_[v] = add(v, sheets_.z[v] - sheets_.thickness[v]);
    return back_[v];
  }

 private:
  Index add(Index v, double height) {
    mesh_.positions.emplace_back(sheets_.place[v].x(), sheets_.place[v].y(), height);
    return static_cast<Index>(mesh_.positions.size()) - 1;
  }

  const SheetMesh& sheets_;
  PolyMesh& mesh_;
  std::vector<Index> front_;
  std::vector<Index> back_;
};

int count_euler_number(const SheetMesh& sheets, const std::vector<Index>& triangles) {
  std::vector<Index> vertices;
  int half_edges = 0;
  int boundary_edges = 0;
  for (const Index m : triangles) {
    vertices.insert(vertices.end(), sheets.triangles[m].begin(), sheets.triangles[m].end());
    for (const Index next : sheets.neighbours[m]) ++(next == no_index ? boundary_edges : half_edges);
  }
  std::sort(vertices.begin(), vertices.end());
  const auto used = std::unique(vertices.begin(), vertices.end()) - vertices.begin();
  return static_cast<int>(used) - (half_edges / 2 + boundary_edges) + static_cast<int>(triangles.size());
}

}  // namespace

std::vector<Index> objects_of_triangles(const LabelledFigure& figure, const SheetSampling& sheets) {
  const std::size_t count = sheets.lifted.triangles.size();
  std::vector<Index> objects(count, no_index);
  std::vector<std::uint8_t> seen(count, 0);
  std::vector<Index> members;
  for (Index m = 0; m < count; ++m) {
    if (seen[m]) continue;
    const Index object = flood_component(figure, sheets, m, seen, members);
    for (const Index member : members) objects[member] = object;
  }
  return objects;
}

std::vector<ObjectSurface> object_surfaces(const LabelledFigure& figure, const SheetMesh& sheets) {
  std::vector<std::vector<Index>> triangles(figure.objects.size());
  for (Index m = 0; m < sheets.objects.size(); ++m) triangles[sheets.objects[m]].push_back(m);

  std::vector<ObjectSurface> surfaces;
  for (Index object = 0; object < figure.objects.size(); ++object) {
    ObjectSurface surface;
    surface.object = object;
    surface.euler_region = count_euler_number(sheets, triangles[object]);
    VertexCopies copies(sheets, surface.mesh);
    for (const Index m : triangles[object]) {
      const auto& [a, b, c] = sheets.triangles[m];
      surface.mesh.add_triangle(copies.front(a), copies.front(b), copies.front(c));
    }
    for (const Index m : triangles[object]) {
      const auto& [a, b, c] = sheets.triangles[m];
      surface.mesh.add_triangle(copies.back(a), copies.back(c), copies.back(b));
    }
    surfaces.push_back(std::move(surface));
  }
  return surfaces;
}

}  // namespace croquis::silhouette
