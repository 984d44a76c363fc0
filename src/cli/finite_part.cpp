// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/finite_part.h"

#include <algorithm>
#include <array>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace croquis::cli {
namespace {

/// Elements of a domain that stay, ascending.
struct Kept {
  std::vector<Index> elements;

  void keep(std::size_t element) { elements.push_back(static_cast<Index>(element)); }
};

/// Old vertices' new numbers, no_index for those that go.
using Renumbering = std::vector<Index>;

Renumbering number_finite(const PolyMesh& mesh, Kept& vertices) {
  Renumbering number(mesh.vertex_count(), no_index);
  for (std::size_t v = 0; v < number.size(); ++v) {
    if (!mesh.positions[v].allFinite()) continue;
    number[v] = static_cast<Index>(vertices.elements.size());
    vertices.keep(v);
  }
  return number;
}

bool all_stay(std::span<const Index> vertices, const Renumbering& number) {
  return std::all_of(vertices.begin(), vertices.end(), [&](Index v) { return number[v] != no_index; });
}

template <typename Element>
Kept kept_elements(std::size_t count, const Renumbering& number, const Element& element) {
  Kept kept;
  for (std::size_t i = 0; i < count; ++i) {
    if (all_stay(element(i), number)) kept.keep(i);
  }
  return kept;
}

std::vector<Index> renumbered(std::span<const Index> vertices, const Renumbering& number) {
  std::vector<Index> result;
  for (const Index v : vertices) result.push_back(number[v]);
  return result;
}

AttributeChannel selected(const AttributeChannel& channel, const Kept& kept) {
  AttributeChannel result{channel.name, channel.domain, channel.width, {}, channel.labels};
  const auto width = static_cast<std::size_t>(channel.width);
  std::visit(
      [&](const auto& values) {
        std::remove_cvref_t<decltype(values)> some;
        some.reserve(kept.elements.size() * width);
        for (const Index e : kept.elements) {
          for (std::size_t i = 0; i < width; ++i) some.push_back(values[e * width + i]);
        }
        result.data = std::move(some);
      },
      channel.data);
  return result;
}

/// Tags need not fit the mesh: those of vertices that aren't there go, too.
class TagSelection {
 public:
  explicit TagSelection(const Renumbering& number) : number_(number) {}

  MeshTags apply(const MeshTags& tags) const {
    MeshTags result;
    for (const Crease& crease : tags.creases) {
      if (stays(crease.vertices)) result.creases.push_back({moved(crease.vertices), crease.sharpness});
    }
    result.pins = pins_of(tags.pins);
    for (const CreaseSet& set : tags.sets) {
      CreaseSet some{set.name, set.sharpness, {}, pins_of(set.pins)};
      for (const auto& edge : set.edges) {
        if (stays(edge)) some.edges.push_back(moved(edge));
      }
      result.sets.push_back(std::move(some));
    }
    return result;
  }

 private:
  using Edge = std::array<Index, 2>;

  bool stays(Index v) const { return v < number_.size() && number_[v] != no_index; }
  bool stays(const Edge& edge) const { return stays(edge[0]) && stays(edge[1]); }
  Edge moved(const Edge& edge) const { return {number_[edge[0]], number_[edge[1]]}; }

  std::vector<Index> pins_of(const std::vector<Index>& pins) const {
    std::vector<Index> some;
    for (const Index pin : pins) {
      if (stays(pin)) some.push_back(number_[pin]);
    }
    return some;
  }

  const Renumbering& number_;
};

Kept corners_of(const PolyMesh& mesh, const Kept& faces) {
  Kept corners;
  for (const Index f : faces.elements) {
    for (Index c = mesh.face_offsets[f]; c < mesh.face_offsets[f + 1]; ++c) corners.keep(c);
  }
  return corners;
}

Finding dropped_finding(const PolyMesh& before, const PolyMesh& after) {
  const std::size_t vertices = before.vertex_count() - after.vertex_count();
  const std::size_t faces = before.face_count() - after.face_count();
  return make_warning(Category::Malformed, "W_BAD_DROPPED",
                      "Dropped " + std::to_string(vertices) + (vertices == 1 ? " vertex" : " vertices") +
                          " with coordinates that are not finite, and " + std::to_string(faces) +
                          (faces == 1 ? " face that uses it" : " faces that use them") +
                          "; those behind them have lower numbers now.");
}

}  // namespace

FinitePart finite_part(PolyMesh mesh) {
  Kept vertices;
  const Renumbering number = number_finite(mesh, vertices);
  if (vertices.elements.size() == mesh.vertex_count()) return {std::move(mesh), {}};
  const Kept faces = kept_elements(mesh.face_count(), number, [&](std::size_t f) { return mesh.face(f); });
  const Kept lines = kept_elements(mesh.line_count(), number, [&](std::size_t l) { return mesh.line(l); });
  const Kept corners = corners_of(mesh, faces);
  PolyMesh part;
  for (const Index v : vertices.elements) part.positions.push_back(mesh.positions[v]);
  for (const Index f : faces.elements) part.add_face(renumbered(mesh.face(f), number));
  for (const Index l : lines.elements) part.add_line(renumbered(mesh.line(l), number));
  for (const AttributeChannel& channel : mesh.channels) {
    const Kept* kept = channel.domain == Domain::Vertex ? &vertices
                       : channel.domain == Domain::Face ? &faces
                       : channel.domain == Domain::Line ? &lines
                                                        : &corners;
    part.channels.push_back(selected(channel, *kept));
  }
  part.tags = TagSelection(number).apply(mesh.tags);
  Findings warnings = {dropped_finding(mesh, part)};
  return {std::move(part), std::move(warnings)};
}

}  // namespace croquis::cli
