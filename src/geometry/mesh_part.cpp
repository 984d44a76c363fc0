// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/geometry/mesh_part.h"

#include <algorithm>
#include <array>
#include <span>
#include <utility>

#include "croquis/geometry/edge_channels.h"

namespace croquis {
namespace {

/// Elements of a domain that stay, ascending.
using KeptElements = std::vector<Index>;

/// Old vertices' new numbers, no_index for those that go.
using Renumbering = std::vector<Index>;

KeptElements kept_of(const std::vector<bool>& keep) {
  KeptElements kept;
  for (std::size_t i = 0; i < keep.size(); ++i) {
    if (keep[i]) kept.push_back(static_cast<Index>(i));
  }
  return kept;
}

Renumbering renumbering_of(const KeptElements& kept, std::size_t count) {
  Renumbering number(count, no_index);
  for (std::size_t i = 0; i < kept.size(); ++i) number[kept[i]] = static_cast<Index>(i);
  return number;
}

bool all_stay(std::span<const Index> vertices, const Renumbering& number) {
  return std::all_of(vertices.begin(), vertices.end(), [&](Index v) { return number[v] != no_index; });
}

std::vector<Index> renumbered(std::span<const Index> vertices, const Renumbering& number) {
  std::vector<Index> result;
  result.reserve(vertices.size());
  for (const Index v : vertices) result.push_back(number[v]);
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

KeptElements corners_of(const PolyMesh& mesh, const KeptElements& faces) {
  KeptElements corners;
  for (const Index f : faces) {
    for (Index c = mesh.face_offsets[f]; c < mesh.face_offsets[f + 1]; ++c) corners.push_back(c);
  }
  return corners;
}

}  // namespace

MeshPart part_of(const PolyMesh& mesh, const std::vector<bool>& keep_vertex, const std::vector<bool>& keep_face) {
  MeshPart part;
  part.vertices = kept_of(keep_vertex);
  const Renumbering number = renumbering_of(part.vertices, mesh.vertex_count());
  part.mesh.positions.reserve(part.vertices.size());
  for (const Index v : part.vertices) part.mesh.positions.push_back(mesh.positions[v]);
  for (const Index f : kept_of(keep_face)) {
    if (!all_stay(mesh.face(f), number)) continue;
    part.faces.push_back(f);
    part.mesh.add_face(renumbered(mesh.face(f), number));
  }
  KeptElements lines;
  for (Index l = 0; l < mesh.line_count(); ++l) {
    if (!all_stay(mesh.line(l), number)) continue;
    lines.push_back(l);
    part.mesh.add_line(renumbered(mesh.line(l), number));
  }
  const KeptElements corners = corners_of(mesh, part.faces);
  for (const AttributeChannel& channel : mesh.channels) {
    const KeptElements& kept = channel.domain == Domain::Vertex ? part.vertices
                               : channel.domain == Domain::Face ? part.faces
                               : channel.domain == Domain::Line ? lines
                                                                : corners;
    // Those of edges stay whole until the part's edges are known.
    part.mesh.channels.push_back(channel.domain == Domain::Edge ? channel : gathered(channel, kept));
  }
  renumber_edge_channels(mesh, part.vertices, part.mesh);
  part.mesh.tags = TagSelection(number).apply(mesh.tags);
  return part;
}

}  // namespace croquis
