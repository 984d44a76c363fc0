// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/cage/whole_cage.h"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <set>
#include <vector>

#include "croquis/geometry/disjoint_sets.h"

namespace croquis::silhouette {
namespace {

/// Of the mesh's width: how far vertices may lie from their images.
constexpr double mirror_tolerance = 0.015;

struct NumberedCage {
  const FigureCage& part;
  std::span<const std::int32_t> number;
};

/// The faces of the objects that have a depth to be mirrored at, or of all as they are.
void append_faces(const NumberedCage& from, const std::map<Index, double>* mirrored, QuadCage& cage) {
  const PolyMesh& mesh = from.part.mesh;
  auto& values = std::get<std::vector<std::int32_t>>(cage.mesh.channels.front().data);
  std::vector<Index> copies(mesh.vertex_count(), no_index);
  for (Index f = 0; f < mesh.face_count(); ++f) {
    const Index object = from.part.objects[f];
    if (from.number[object] < 0 || (mirrored != nullptr && !mirrored->contains(object))) continue;
    std::array<Index, 4> face{};
    std::ranges::copy(mesh.face(f), face.begin());
    for (Index& v : face) {
      if (copies[v] == no_index) {
        copies[v] = static_cast<Index>(cage.mesh.positions.size());
        Vec3 position = mesh.positions[v];
        if (mirrored != nullptr) position.z() = 2 * mirrored->at(object) - position.z();
        cage.mesh.positions.push_back(position);
      }
      v = copies[v];
    }
    if (mirrored != nullptr) std::swap(face[1], face[3]);
    cage.mesh.add_face(face);
    values.push_back(from.number[object]);
  }
}

std::size_t count_shells(const PolyMesh& mesh) {
  DisjointSets shells(mesh.vertex_count());
  for (Index f = 0; f < mesh.face_count(); ++f) {
    for (const Index v : mesh.face(f)) shells.unite(mesh.face(f)[0], v);
  }
  return shells.lists().size();
}

/// Per vertex the one at its image; none where one has no image of its own.
std::optional<std::vector<Index>> images_of(const PolyMesh& mesh, double axis, double tolerance) {
  std::vector<Index> images(mesh.vertex_count(), no_index);
  for (Index v = 0; v < images.size(); ++v) {
    const Vec3& own = mesh.positions[v];
    const Vec3 image(2 * axis - own.x(), own.y(), own.z());
    double nearest = tolerance * tolerance;
    for (Index other = 0; other < images.size(); ++other) {
      const double distance = (mesh.positions[other] - image).squaredNorm();
      if (distance < nearest) std::tie(images[v], nearest) = std::pair(other, distance);
    }
    if (images[v] == no_index) return std::nullopt;
  }
  for (Index v = 0; v < images.size(); ++v) {
    if (images[images[v]] != v) return std::nullopt;
  }
  return images;
}

bool keeps_faces(const PolyMesh& mesh, const std::vector<Index>& images) {
  const auto sorted = [](std::array<Index, 4> face) {
    std::ranges::sort(face);
    return face;
  };
  std::set<std::array<Index, 4>> faces;
  for (Index f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    faces.insert(sorted({face[0], face[1], face[2], face[3]}));
  }
  return std::ranges::all_of(faces, [&](const std::array<Index, 4>& face) {
    return faces.contains(sorted({images[face[0]], images[face[1]], images[face[2]], images[face[3]]}));
  });
}

}  // namespace

void append_cage(const FigureCage& part, std::span<const std::int32_t> number, const std::map<Index, double>& mirrored,
                 QuadCage& cage) {
  if (cage.mesh.channels.empty()) {
    cage.mesh.channels.push_back({"object", Domain::Face, 1, std::vector<std::int32_t>{}, {}});
  }
  append_faces({part, number}, nullptr, cage);
  append_faces({part, number}, &mirrored, cage);
  cage.caps += part.caps;
  cage.shells = count_shells(cage.mesh);
}

bool make_symmetric(PolyMesh& mesh) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const Vec3& position : mesh.positions) {
    low = std::min(low, position.x());
    high = std::max(high, position.x());
  }
  const double axis = (low + high) / 2;
  const std::optional<std::vector<Index>> images = images_of(mesh, axis, mirror_tolerance * (high - low));
  if (!images || !keeps_faces(mesh, *images)) return false;
  const std::vector<Vec3> old = mesh.positions;
  for (Index v = 0; v < old.size(); ++v) {
    const Vec3& image = old[(*images)[v]];
    const double aside = ((old[v].x() - axis) - (image.x() - axis)) / 2;
    mesh.positions[v] = {axis + aside, (old[v].y() + image.y()) / 2, (old[v].z() + image.z()) / 2};
  }
  return true;
}

}  // namespace croquis::silhouette
