// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "croquis/geometry/brep.h"
#include "document/values/rational_members.h"

namespace croquis {

inline auto members(const GregoryPatch& patch) { return std::tie(patch.boundary, patch.inner); }
static_assert(lists_every_member<GregoryPatch>);

inline auto members(const BrepVertex& vertex) { return std::tie(vertex.point, vertex.network_vertex); }
static_assert(lists_every_member<BrepVertex>);

inline auto members(const BrepEdge& edge) {
  return std::tie(edge.id, edge.curve, edge.start, edge.end, edge.pieces, edge.fitted, edge.straight, edge.half_edges,
                  edge.smooth, edge.across);
}
static_assert(lists_every_member<BrepEdge>);

inline auto members(const BrepHalfEdge& half) { return std::tie(half.edge, half.reversed, half.loop, half.next); }
static_assert(lists_every_member<BrepHalfEdge>);

inline auto members(const BrepLoop& loop) { return std::tie(loop.face, loop.first); }
static_assert(lists_every_member<BrepLoop>);

inline auto members(const BrepFace& face) {
  return std::tie(face.shell, face.outline, face.loops, face.planar, face.origin, face.normal, face.flatness,
                  face.patches);
}
static_assert(lists_every_member<BrepFace>);

inline auto members(const BrepShell& shell) { return std::tie(shell.faces, shell.closed, shell.is_void); }
static_assert(lists_every_member<BrepShell>);

inline auto members(const Brep& brep) {
  return std::tie(brep.vertices, brep.edges, brep.half_edges, brep.loops, brep.faces, brep.shells);
}
static_assert(lists_every_member<Brep>);

inline void require_valid(const BrepFace& face) {
  constexpr double largest_normal_error = 1e-9;  // of stored unit normals
  if (face.planar && std::abs(face.normal.norm() - 1) > largest_normal_error)
    throw BadBytes("a face's normal is not of length 1");
  if (!(face.flatness >= 0 && is_usable_number(face.flatness))) throw BadBytes("a face's flatness is not a distance");
}

inline void require_valid(const Brep& brep) {
  if (const Findings wrong = validate(brep); !wrong.empty()) throw BadBytes(wrong.front().message);
}

namespace {

/// What bounds a solid: faces with exact curves and patches.
struct BrepValue : ListedValue<Brep> {
  static constexpr const char* name = "B-rep";
  static constexpr std::uint64_t tag = 6;
};

}  // namespace

constinit const ValueTraits ValueTraits::Brep = value_row<BrepValue>();

}  // namespace croquis
