// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/subdivision/doo_sabin.h"

#include <algorithm>
#include <string>
#include <utility>

#include "algorithms/subdivision/refinement/point_rules.h"
#include "algorithms/subdivision/refinement/refine.h"
#include "croquis/base/error.h"

namespace croquis::subdivision {
namespace {

struct ElementCounts {
  std::size_t vertices = 0, edges = 0, faces = 0;
};

ElementCounts counts_of(const HalfEdges& mesh) { return {mesh.vertex_count(), mesh.edge_count(), mesh.face_count()}; }

/// Predicts by the counts of closed meshes without tags, a little more than others have, how large the last level gets.
/// @throws Error (E_TOO_MANY_FACES)
void require_face_limit(ElementCounts counts, int level, const Depth& depth) {
  for (; level < depth.levels; ++level) {
    counts = {2 * counts.edges, 4 * counts.edges, counts.vertices + counts.edges + counts.faces};
    // Corners are numbered with 32 bits, and an edge has two.
    if (counts.faces <= depth.face_limit && 2 * counts.edges < no_index) continue;
    throw Error(make_error(Category::Limit, "E_TOO_MANY_FACES",
                           "Level " + std::to_string(level + 1) + " would have about " + std::to_string(counts.faces) +
                               " faces, " + std::to_string(counts.edges) + " edges and " +
                               std::to_string(counts.vertices) + " vertices, but the limit is " +
                               std::to_string(depth.face_limit) + " faces: take fewer levels, or a higher limit.",
                           {{SubjectKind::Parameter, "levels", {}, {}, {}}}));
  }
}

/// The cage as level 0.
Level first_level(const Cage& cage) {
  Level level;
  level.topology = cage.topology;
  const HalfEdges& mesh = level.topology;
  for (Index edge = 0; edge < mesh.edge_count(); ++edge) {
    if (mesh.twin[mesh.edge_corner[edge]] == no_index) {
      level.boundary.push_back(mesh.edge_corner[edge]);
    } else if (cage.sharpness[edge] > 0) {
      level.sharp.push_back({edge, cage.sharpness[edge]});
    }
  }
  std::sort(level.boundary.begin(), level.boundary.end());
  std::vector<Index> valence(mesh.vertex_count(), 0);
  for (const Index vertex : mesh.corner_vertex) ++valence[vertex];
  for (Index vertex = 0; vertex < mesh.vertex_count(); ++vertex) {
    if (cage.pinned[vertex] != 0) level.pins.push_back(vertex);
    if (cage.settled[vertex] != 0) level.settled.push_back(vertex);
    // On the boundary the fan's first half-edge has no twin.
    if (valence[vertex] == 2 && mesh.twin[mesh.vertex_corner[vertex]] != no_index) level.valence_two.push_back(vertex);
  }
  return level;
}

Index face_of(const HalfEdges& mesh, Index corner) {
  const auto after = std::upper_bound(mesh.face_offsets.begin(), mesh.face_offsets.end(), corner);
  return static_cast<Index>(after - mesh.face_offsets.begin()) - 1;
}

Index lowest_face_at_edge(const HalfEdges& mesh, Index edge) {
  const Index corner = mesh.edge_corner[edge], twin = mesh.twin[corner];
  return face_of(mesh, twin == no_index ? corner : std::min(corner, twin));
}

Index lowest_face_at_vertex(const HalfEdges& mesh, Index vertex) {
  const Index start = mesh.vertex_corner[vertex];
  Index lowest = no_index, corner = start;
  do {
    const Index face = face_of(mesh, corner);
    lowest = std::min(lowest, face);
    corner = mesh.twin[corner == mesh.face_offsets[face] ? mesh.face_offsets[face + std::size_t{1}] - 1 : corner - 1];
  } while (corner != no_index && corner != start);
  return lowest;
}

void require_count(std::size_t given, std::size_t wanted) {
  if (given == wanted) return;
  throw Error(make_error(Category::Internal, "E_INTERNAL",
                         "A plan for a cage of " + std::to_string(wanted) + " vertices was given " +
                             std::to_string(given) + " positions."));
}

void resize_untouched(std::vector<Vec3>& points, std::size_t count) {
  const bool grows = count > points.capacity();
  if (grows) points = {};  // what was there needs no copy
  points.resize(count);    // Vec3 leaves its memory as it is
  if (grows) request_large_pages(points.data(), count * sizeof(Vec3));
}

}  // namespace

struct DooSabinPlan::State {
  explicit State(const Rules& chosen) : rules(chosen), mask(chosen.weights) {}

  Rules rules;
  FaceMask mask;
  Level cage;
  std::vector<Refinement> refinements;

  const Level& level(int k) const { return k == 0 ? cage : refinement(k).level; }
  const Refinement& refinement(int k) const { return refinements[static_cast<std::size_t>(k - 1)]; }
};

DooSabinPlan::DooSabinPlan(const Cage& cage, const Rules& rules, const Depth& depth, Progress& progress) {
  require_face_limit(counts_of(cage.topology), 0, depth);
  auto state = std::make_shared<State>(rules);
  state->cage = first_level(cage);
  state->refinements.reserve(static_cast<std::size_t>(depth.levels));
  FlatScratch scratch;
  for (int k = 1; k <= depth.levels; ++k) {
    const Level& old = state->level(k - 1);
    require_face_limit(counts_of(old.topology), k - 1, depth);
    state->refinements.push_back(refine(old, rules, state->mask, scratch, progress));
    progress.report(static_cast<double>(counts_of(state->level(k).topology).faces) /
                    static_cast<double>(std::max<std::size_t>(1, counts_of(state->level(k).topology).faces)
                                        << (2 * (depth.levels - k))));
  }
  progress.report(1);
  state_ = std::move(state);
}

const Rules& DooSabinPlan::rules() const { return state_->rules; }

int DooSabinPlan::levels() const { return static_cast<int>(state_->refinements.size()); }

const Level& DooSabinPlan::level(int k) const { return state_->level(k); }

void DooSabinPlan::positions(std::span<const Vec3> cage, PositionBuffers& buffers, int threads) const {
  require_count(cage.size(), level(0).topology.vertex_count());
  buffers.levels.resize(state_->refinements.size() + 1);
  buffers.levels[0].assign(cage.begin(), cage.end());
  for (int k = 1; k <= levels(); ++k) {
    const auto& from = buffers.levels[static_cast<std::size_t>(k - 1)];
    auto& to = buffers.levels[static_cast<std::size_t>(k)];
    resize_untouched(to, level(k).topology.vertex_count());
    compute_positions(level(k - 1).topology, state_->refinement(k), state_->mask, from.data(), to.data(), threads);
  }
}

Eigen::SparseMatrix<double, Eigen::RowMajor> DooSabinPlan::weights(int k) const {
  return level_weights(level(k - 1).topology, state_->refinement(k), state_->mask);
}

FaceOrigin DooSabinPlan::face_origin(int k, Index face) const {
  return state_->refinement(k).origins.face(face, level(k - 1).topology, level(k).topology);
}

VertexOrigin DooSabinPlan::vertex_origin(int k, Index vertex) const {
  return state_->refinement(k).origins.vertex(vertex, level(k - 1).topology);
}

Index DooSabinPlan::cage_vertex(int k, Index vertex) const {
  for (; k > 0; --k) vertex = vertex_origin(k, vertex).vertex;
  return vertex;
}

FaceOrigin DooSabinPlan::cage_element(int k, Index face) const {
  for (; k > 1; --k) {
    const auto [kind, element] = face_origin(k, face);
    const HalfEdges& old = level(k - 1).topology;
    switch (kind) {
      case FaceKind::Face: face = element; break;
      case FaceKind::Edge:
      case FaceKind::Band: face = lowest_face_at_edge(old, element); break;
      case FaceKind::Vertex: face = lowest_face_at_vertex(old, element); break;
    }
  }
  return face_origin(1, face);
}

bool DooSabinPlan::banded(int k) const { return state_->refinement(k).banded; }

std::size_t DooSabinPlan::bytes(int k) const {
  return k == 0 ? bytes_of(state_->cage) : bytes_of(state_->refinement(k));
}

}  // namespace croquis::subdivision
