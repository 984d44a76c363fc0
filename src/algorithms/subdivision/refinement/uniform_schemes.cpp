// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/subdivision/uniform_schemes.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <optional>
#include <span>
#include <string>
#include <unordered_set>
#include <utility>
#include <vector>

#include "algorithms/subdivision/levels/level_geometry.h"
#include "algorithms/subdivision/opensubdiv/primal_refinement.h"
#include "croquis/base/error.h"
#include "croquis/subdivision/half_edges.h"
#include "croquis/subdivision/level_mesh.h"

namespace croquis::subdivision {
namespace {

/// The triangles that Loop's scheme refines.
struct LoopTriangles {
  std::vector<Index> corners;        ///< 3 per triangle
  std::vector<Index> source_face;    ///< #T, the face each came from
  std::vector<Index> centred_faces;  ///< faces with a new vertex in the middle, which is #V, #V+1, … in this order
  std::size_t cut_faces = 0;         ///< faces that weren't triangles
};

constexpr std::size_t largest_fan = 64;

std::uint64_t pair_key(Index a, Index b) {
  const auto [low, high] = std::minmax(a, b);
  return (std::uint64_t{low} << 32U) | high;
}

class Cutter {
 public:
  explicit Cutter(const HalfEdges& mesh) : mesh_(mesh), valence_(mesh.vertex_count(), 0) {
    for (const Index corner : mesh.edge_corner) {
      const Index other = twin_end(corner);
      joined_.insert(pair_key(mesh.corner_vertex[corner], other));
      ++valence_[mesh.corner_vertex[corner]];
      ++valence_[other];
    }
  }

  LoopTriangles cut() {
    for (Index face = 0; face < mesh_.face_count(); ++face) cut(face);
    return std::move(result_);
  }

 private:
  /// The vertex at the far end of the half-edge.
  Index twin_end(Index corner) const {
    const auto after = std::upper_bound(mesh_.face_offsets.begin(), mesh_.face_offsets.end(), corner);
    return corner + 1 == *after ? mesh_.corner_vertex[*(after - 1)] : mesh_.corner_vertex[corner + 1];
  }

  void add(Index a, Index b, Index c, Index face) {
    result_.corners.insert(result_.corners.end(), {a, b, c});
    result_.source_face.push_back(face);
  }

  void cut(Index face) {
    const auto vertices = mesh_.face(face);
    if (vertices.size() == 3) return add(vertices[0], vertices[1], vertices[2], face);
    ++result_.cut_faces;
    const std::optional<std::size_t> tip = vertices.size() <= largest_fan ? best_tip(vertices) : std::nullopt;
    if (tip) {
      add_fan(vertices, *tip, face);
    } else {
      add_centre(vertices, face);
    }
  }

  /// The corner whose fan of diagonals makes the least sum of squared valences, the first of several.
  std::optional<std::size_t> best_tip(std::span<const Index> vertices) const {
    const std::size_t n = vertices.size();
    std::optional<std::size_t> best;
    std::size_t least = 0;
    for (std::size_t tip = 0; tip < n; ++tip) {
      bool free = true;
      std::size_t cost = (n - 3) * (2 * valence_[vertices[tip]] + n - 3);
      for (std::size_t i = 2; i + 1 < n; ++i) {
        const Index other = vertices[(tip + i) % n];
        free = free && !joined_.contains(pair_key(vertices[tip], other));
        cost += 2 * valence_[other] + 1;
      }
      if (!free || (best && cost >= least)) continue;
      best = tip;
      least = cost;
    }
    return best;
  }

  void add_fan(std::span<const Index> vertices, std::size_t tip, Index face) {
    const std::size_t n = vertices.size();
    for (std::size_t i = 1; i + 1 < n; ++i) {
      const Index a = vertices[tip], b = vertices[(tip + i) % n];
      add(a, b, vertices[(tip + i + 1) % n], face);
      if (i == 1) continue;
      joined_.insert(pair_key(a, b));
      ++valence_[a];
      ++valence_[b];
    }
  }

  void add_centre(std::span<const Index> vertices, Index face) {
    const auto centre = static_cast<Index>(mesh_.vertex_count() + result_.centred_faces.size());
    result_.centred_faces.push_back(face);
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      add(vertices[i], vertices[(i + 1) % vertices.size()], centre, face);
      ++valence_[vertices[i]];
    }
  }

  const HalfEdges& mesh_;
  std::vector<std::size_t> valence_;
  std::unordered_set<std::uint64_t> joined_;  // asked, never listed
  LoopTriangles result_;
};

/// Cuts faces by connectivity alone: fans from the corner that keeps valences lowest, so that the same cage is cut the
/// same way wherever its points are. No diagonal joins vertices that are joined already. O(n^2) for a face of n
/// corners up to 64; larger ones get a centre at once.
LoopTriangles loop_triangles(const HalfEdges& mesh) { return Cutter(mesh).cut(); }

}  // namespace

struct UniformPlan::State {
  UniformRules rules;
  Findings warnings;
  std::vector<Level> levels;
  std::vector<std::vector<Index>> face_parents;  ///< [k] into the faces of level k-1, [0] into the cage's
  std::vector<WeightRows> rows;                  ///< [k] over level k-1, [0] of the centres over the cage
};

namespace {

/// Elements of a level, before they are made.
struct RefinedCounts {
  double vertices, edges, faces, corners;
};

RefinedCounts refined(const RefinedCounts& counts, UniformScheme scheme) {
  if (scheme == UniformScheme::Loop) {
    const double faces = 4 * counts.faces;
    return {counts.vertices + counts.edges, 2 * counts.edges + 3 * counts.faces, faces, 3 * faces};
  }
  return {counts.vertices + counts.edges + counts.faces, 2 * counts.edges + counts.corners, counts.corners,
          4 * counts.corners};
}

std::string whole(double number) { return std::to_string(static_cast<long long>(number)); }

void require_few_faces(RefinedCounts counts, UniformScheme scheme, const Depth& depth) {
  constexpr double most_corners = 2e9;  // OpenSubdiv counts in 32 bits with a sign
  for (int k = 1; k <= depth.levels; ++k) {
    counts = refined(counts, scheme);
    if (counts.faces <= static_cast<double>(depth.face_limit) && counts.corners <= most_corners) continue;
    throw Error(make_error(Category::Limit, "E_TOO_MANY_FACES",
                           "Level " + std::to_string(k) + " would have " + whole(counts.faces) + " faces, " +
                               whole(counts.edges) + " edges and " + whole(counts.vertices) +
                               " vertices, but the limit is " + std::to_string(depth.face_limit) +
                               " faces: take fewer levels, or a higher limit.",
                           {{SubjectKind::Parameter, "levels", {}, {}, {}}}));
  }
}

Level cage_level(const Cage& cage) {
  Level level;
  level.topology = cage.topology;
  for (Index corner = 0; corner < cage.topology.corner_count(); ++corner) {
    if (cage.topology.twin[corner] == no_index) level.boundary.push_back(corner);
  }
  for (Index edge = 0; edge < cage.sharpness.size(); ++edge) {
    const bool inner = cage.topology.twin[cage.topology.edge_corner[edge]] != no_index;
    if (inner && cage.sharpness[edge] > 0) level.sharp.push_back({edge, cage.sharpness[edge]});
  }
  for (Index vertex = 0; vertex < cage.pinned.size(); ++vertex) {
    if (cage.pinned[vertex] != 0) level.pins.push_back(vertex);
  }
  return level;
}

/// Rows that put a vertex into the middle of each face.
WeightRows centre_rows(const HalfEdges& mesh, std::span<const Index> faces) {
  WeightRows rows;
  for (const Index face : faces) {
    const auto vertices = mesh.face(face);
    for (const Index vertex : vertices) rows.add(vertex, 1 / static_cast<double>(vertices.size()));
    rows.end_row();
  }
  return rows;
}

Finding triangulated_notice(std::size_t count) {
  return make_warning(Category::Geometry, "W_TRIANGULATED",
                      std::to_string(count) + (count == 1 ? " face has" : " faces have") +
                          " more than three corners and " + (count == 1 ? "was" : "were") +
                          " cut into triangles, which Loop's scheme needs.");
}

/// The topology with its faces replaced by triangles.
void use_triangles(const LoopTriangles& triangles, PrimalTopology& topology) {
  topology.vertex_count += triangles.centred_faces.size();
  topology.face_sizes.assign(triangles.source_face.size(), 3);
  topology.corners = triangles.corners;
}

RefinedCounts counts_of(const PrimalTopology& topology, const Level& base) {
  const auto corners = static_cast<double>(topology.corners.size());
  return {static_cast<double>(topology.vertex_count), (corners + static_cast<double>(base.boundary.size())) / 2,
          static_cast<double>(topology.face_sizes.size()), corners};
}

/// OpenSubdiv refuses meshes without faces; all levels of one are the same.
std::vector<PrimalLevel> refined_levels(const PrimalTopology& topology, int levels, Progress& progress) {
  if (topology.face_sizes.empty()) return std::vector<PrimalLevel>(static_cast<std::size_t>(levels) + 1);
  return refine(topology, levels, progress);
}

}  // namespace

UniformPlan::UniformPlan(const Cage& cage, const UniformRules& rules, const Depth& depth, Progress& progress) {
  auto state = std::make_shared<State>();
  state->rules = rules;
  Level base = cage_level(cage);
  PrimalTopology topology = primal_topology(base, rules);
  std::vector<Index> base_parents(cage.topology.face_count());
  std::iota(base_parents.begin(), base_parents.end(), Index{0});
  LoopTriangles triangles;
  if (rules.scheme == UniformScheme::Loop) triangles = loop_triangles(cage.topology);
  if (triangles.cut_faces > 0) {
    state->warnings.push_back(triangulated_notice(triangles.cut_faces));
    use_triangles(triangles, topology);
    base_parents = std::move(triangles.source_face);
  }
  require_few_faces(counts_of(topology, base), rules.scheme, depth);

  std::vector<PrimalLevel> levels = refined_levels(topology, depth.levels, progress);
  if (triangles.cut_faces == 0) levels[0].level = std::move(base);  // edges keep the cage's numbers
  levels[0].face_parents = std::move(base_parents);
  levels[0].rows = centre_rows(cage.topology, triangles.centred_faces);
  for (PrimalLevel& level : levels) {
    state->levels.push_back(std::move(level.level));
    state->face_parents.push_back(std::move(level.face_parents));
    state->rows.push_back(std::move(level.rows));
  }
  state_ = std::move(state);
}

const UniformRules& UniformPlan::rules() const { return state_->rules; }
const Findings& UniformPlan::warnings() const { return state_->warnings; }
int UniformPlan::levels() const { return static_cast<int>(state_->levels.size()) - 1; }
const Level& UniformPlan::level(int k) const { return state_->levels.at(static_cast<std::size_t>(k)); }

void UniformPlan::positions(std::span<const Vec3> cage, PositionBuffers& buffers, int threads) const {
  buffers.levels.resize(state_->levels.size());
  std::vector<Vec3>& base = buffers.levels[0];
  base.resize(cage.size() + state_->rows[0].size());
  std::copy(cage.begin(), cage.end(), base.begin());
  apply(state_->rows[0], cage, std::span(base).subspan(cage.size()), threads);
  for (std::size_t k = 1; k < state_->levels.size(); ++k) {
    buffers.levels[k].resize(state_->rows[k].size());
    apply(state_->rows[k], buffers.levels[k - 1], buffers.levels[k], threads);
  }
}

Eigen::SparseMatrix<double, Eigen::RowMajor> UniformPlan::weights(int k) const {
  return to_matrix(state_->rows.at(static_cast<std::size_t>(k)), level(k - 1).topology.vertex_count());
}

Index UniformPlan::cage_face(int k, Index face) const {
  for (; k >= 0; --k) face = state_->face_parents.at(static_cast<std::size_t>(k)).at(face);
  return face;
}

PolyMesh to_mesh(const UniformPlan& plan, int k, std::span<const Vec3> positions) {
  PolyMesh mesh = to_mesh(plan.level(k), positions);
  std::vector<std::int32_t> elements(mesh.face_count());
  for (Index face = 0; face < elements.size(); ++face) {
    elements[face] = static_cast<std::int32_t>(plan.cage_face(k, face));
  }
  mesh.channels.push_back({"cage_kind",
                           Domain::Face,
                           1,
                           std::vector<std::int32_t>(elements.size(), 0),
                           {"face", "edge", "vertex", "band"}});
  mesh.channels.push_back({"cage_element", Domain::Face, 1, std::move(elements), {}});
  return mesh;
}

}  // namespace croquis::subdivision
