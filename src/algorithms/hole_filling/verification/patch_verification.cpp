// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/hole_filling/verification/patch_verification.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "algorithms/hole_filling/analysis/box_search.h"
#include "algorithms/hole_filling/analysis/sorted_lists.h"
#include "croquis/base/parallel.h"
#include "croquis/geometry/degenerate_faces.h"
#include "croquis/geometry/mesh_topology.h"
#include "croquis/geometry/self_intersection.h"
#include "croquis/geometry/single_precision.h"
#include "croquis/hole_filling/hole_analysis.h"

namespace croquis::hole_filling {
namespace {

using Edge = std::array<Index, 2>;

/// A patch as a mesh of its own, with the view's vertices.
struct LocalPatch {
  PolyMesh mesh;
  std::vector<Index> vertices;  ///< sorted: vertex i is that vertex of the view, or #V + a new point's number
};

/// Rim edges as the patch must run them: against the holes' faces, by the view's vertices; sorted.
std::vector<Edge> expected_border(const HoleAnalysis& analysis, const HolePatch& patch) {
  std::vector<Edge> border;
  for (const Index id : patch.holes) {
    const auto& rim = analysis.holes[id].vertices;
    for (std::size_t i = 0; i < rim.size(); ++i)
      border.push_back({analysis.view.representative_of(rim[i + 1 == rim.size() ? 0 : i + 1]),
                        analysis.view.representative_of(rim[i])});
  }
  std::sort(border.begin(), border.end());
  return border;
}

std::string edge_fault(const LocalPatch& local, const MeshTopology& topology, const std::vector<Edge>& expected) {
  std::vector<Edge> border;
  for (Index edge = 0; edge < topology.edge_count(); ++edge) {
    const auto corners = topology.edge_corners(edge);
    const auto ends = topology.edge_vertices(edge);
    if (corners.size() > 2) return "an edge of the patch has more than two faces";
    if (corners.size() == 1)
      border.push_back({local.vertices[ends[0]], local.vertices[ends[1]]});
    else if (topology.vertex(corners[0]) == topology.vertex(corners[1]))
      return "faces of the patch disagree in direction";
  }
  std::sort(border.begin(), border.end());
  return border == expected ? "" : "the patch's border isn't the rim";
}

/// More fans at a vertex than one, or than rims there are that share it.
bool touches_itself(const LocalPatch& local, const MeshTopology& topology, const std::vector<Edge>& border) {
  for (Index vertex = 0; vertex < topology.vertex_count(); ++vertex) {
    if (topology.fan_count(vertex) == 1) continue;
    const auto rims = with_key(border, local.vertices[vertex], [](const Edge& e) { return e[0]; });
    if (topology.fan_count(vertex) > rims.size()) return true;
  }
  return false;
}

bool is_sphere_with_holes(const LocalPatch& local, const MeshTopology& topology, std::size_t holes) {
  const auto euler = static_cast<std::ptrdiff_t>(local.vertices.size() + topology.face_count()) -
                     static_cast<std::ptrdiff_t>(topology.edge_count());
  return topology.component_count() == 1 && euler == 2 - static_cast<std::ptrdiff_t>(holes);
}

/// Vertices of the view come first, which are few and searched for, then the new ones.
/// @param precision how coordinates will be stored
LocalPatch make_local(const PolyMesh& mesh, const HoleAnalysis& analysis, const HolePatch& patch, Precision precision) {
  const auto given = static_cast<Index>(mesh.vertex_count());
  LocalPatch local;
  std::vector<Index> number_of_new(patch.points.size(), no_index);
  for (const auto& t : patch.triangles) {
    for (const Index v : t) {
      if (v < given)
        local.vertices.push_back(analysis.view.representative_of(v));
      else
        number_of_new[v - given] = 0;
    }
  }
  sort_unique(local.vertices);
  const auto of_view = std::ssize(local.vertices);
  for (Index i = 0; i < number_of_new.size(); ++i) {
    if (number_of_new[i] == no_index) continue;
    number_of_new[i] = static_cast<Index>(local.vertices.size());
    local.vertices.push_back(given + i);
  }
  const auto number = [&](Index v) {
    if (v >= given) return number_of_new[v - given];
    const auto end = local.vertices.begin() + of_view;
    const auto found = std::lower_bound(local.vertices.begin(), end, analysis.view.representative_of(v));
    return static_cast<Index>(found - local.vertices.begin());
  };
  for (const Index v : local.vertices)
    local.mesh.positions.push_back(v < given ? mesh.positions[v] : patch.points[v - given]);
  if (precision == Precision::Single) round_to_single(local.mesh.positions);
  for (const auto& t : patch.triangles) local.mesh.add_face(std::array{number(t[0]), number(t[1]), number(t[2])});
  return local;
}

/// What is wrong with a patch's connectivity, its rims included, or nothing: see PatchVerifier.
std::string structure_fault(const HoleAnalysis& analysis, const HolePatch& patch, const LocalPatch& local) {
  if (!degenerate_faces(local.mesh).empty()) return "a triangle of the patch has no area";
  const MeshTopology topology(local.mesh);
  const std::vector<Edge> border = expected_border(analysis, patch);
  if (std::string fault = edge_fault(local, topology, border); !fault.empty()) return fault;
  if (touches_itself(local, topology, border)) return "parts of the patch touch in a vertex";
  if (!is_sphere_with_holes(local, topology, patch.holes.size())) return "the patch isn't one simple piece";
  return "";
}

/// The inner edges of a patch between two vertices of the mesh, as pairs (low, high) of the view's vertices.
std::vector<Edge> chords_of(const PolyMesh& mesh, const HoleAnalysis& analysis, const HolePatch& patch) {
  std::vector<Edge> edges;
  for (const auto& t : patch.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      if (std::max(t[i], t[(i + 1) % 3]) >= mesh.vertex_count()) continue;
      const auto [low, high] =
          std::minmax({analysis.view.representative_of(t[i]), analysis.view.representative_of(t[(i + 1) % 3])});
      edges.push_back({low, high});
    }
  }
  std::ranges::sort(edges);
  std::vector<Edge> chords;  // inner edges come twice
  for (std::size_t i = 1; i < edges.size(); ++i) {
    if (edges[i] == edges[i - 1]) chords.push_back(edges[i]);
  }
  return chords;
}

/// The least corner angle, and the greatest angle between faces across a rim edge. For patches without a structure
/// fault.
PatchVerdict measure_patch(const PolyMesh& mesh, const HoleAnalysis& analysis, const HolePatch& patch) {
  double greatest = -std::numeric_limits<double>::infinity();  // cotangent: one arc tangent does for all angles
  for (const auto& [a, b, c] : patch.triangles) {
    const Vec3 &p = place_of(patch, mesh, a), &q = place_of(patch, mesh, b), &r = place_of(patch, mesh, c);
    const std::array<Vec3, 3> sides = {q - p, r - q, p - r};
    const double twice_area = sides[0].cross(sides[1]).norm();
    for (std::size_t i = 0; i < 3; ++i) greatest = std::max(greatest, -sides[i].dot(sides[(i + 1) % 3]) / twice_area);
  }
  PatchVerdict verdict;
  verdict.min_angle = std::isinf(greatest) && greatest < 0 ? std::numbers::pi : std::atan2(1, greatest);
  for (const std::vector<RimFold>& along : rim_folds(patch, mesh, analysis)) {
    for (const RimFold& fold : along) verdict.max_normal_jump = std::max(verdict.max_normal_jump, std::abs(fold.angle));
  }
  return verdict;
}

/// Sorted pairs (low, high) of the view's vertices that lie on holes' rims and are joined by an edge. Linear.
std::vector<Edge> edges_between_rims(const PolyMesh& mesh, const HoleAnalysis& analysis) {
  const SurfaceView& view = analysis.view;
  std::vector<std::uint8_t> on_rim(mesh.vertex_count(), 0);
  for (const Hole& hole : analysis.holes) {
    for (const Index vertex : hole.vertices) on_rim[view.representative_of(vertex)] = 1;
  }
  std::vector<Edge> edges;
  for (const auto& t : view.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const auto [low, high] = std::minmax({t[i], t[(i + 1) % 3]});
      if (on_rim[low] != 0 && on_rim[high] != 0) edges.push_back({low, high});
    }
  }
  sort_unique(edges);
  return edges;
}

/// Intersecting pairs looked at in one search; where there are more, those found exclude their patches first and the
/// rest is searched again.
constexpr std::size_t most_pairs = 1000000;

constexpr const char* intersects = "the patch cuts through the surface or itself";
constexpr const char* meets_another = "the patch cuts through another one";

/// Faces of the scene behind `first`, and which candidate each is of.
struct AddedFaces {
  Index first = 0;
  std::vector<Index> candidate;

  std::vector<Index> faces_of(const std::vector<bool>& is_wanted) const {
    std::vector<Index> wanted;
    for (std::size_t i = 0; i < candidate.size(); ++i) {
      if (is_wanted[candidate[i]]) wanted.push_back(first + static_cast<Index>(i));
    }
    return wanted;
  }
};

/// Which boxes meet another one; empty ones meet none.
std::vector<bool> meet_others(const std::vector<Box>& boxes) {
  std::vector<Index> full;
  for (Index i = 0; i < boxes.size(); ++i) {
    if (!boxes[i].isEmpty()) full.push_back(i);
  }
  const BoxSearch search(full.size(), [&](Index item) -> const Box& { return boxes[full[item]]; });
  std::vector<bool> result(boxes.size(), false);
  for (Index i = 0; i < full.size(); ++i)
    search.visit(boxes[full[i]], [&](Index other) { result[full[i]] = result[full[i]] || other != i; });
  return result;
}

/// @param known gives the scene's number of a vertex of the mesh
template <typename Known>
void append_patch(PolyMesh& scene, std::size_t vertex_count, const HolePatch& patch, Known&& known) {
  const auto base = static_cast<Index>(scene.vertex_count());
  scene.positions.insert(scene.positions.end(), patch.points.begin(), patch.points.end());
  for (auto t : patch.triangles) {
    for (Index& vertex : t)
      vertex = vertex < vertex_count ? known(vertex) : base + (vertex - static_cast<Index>(vertex_count));
    scene.add_face(t);
  }
}

/// Takes off what is appended to a mesh, at the latest when it goes out of scope.
class Restore {
 public:
  explicit Restore(PolyMesh& mesh) : mesh_(mesh), vertices_(mesh.vertex_count()), faces_(mesh.face_count()) {}
  Restore(const Restore&) = delete;
  Restore& operator=(const Restore&) = delete;
  ~Restore() { now(); }

  void now() const {
    mesh_.positions.resize(vertices_);
    mesh_.face_offsets.resize(faces_ + 1);
    mesh_.corners.resize(mesh_.face_offsets.back());
  }

 private:
  PolyMesh& mesh_;
  std::size_t vertices_;
  std::size_t faces_;
};

/// Of two candidates that meet the later one goes, unless the earlier one goes for other reasons.
void refuse_later(std::span<const Edge> pairs, const AddedFaces& added, std::vector<PatchVerdict>& verdicts) {
  std::vector<Edge> between;
  for (const auto& [low, high] : pairs) {
    const Index later = added.candidate[high - added.first];
    if (low < added.first)
      verdicts[later].fault = meets_another;
    else if (const Index earlier = added.candidate[low - added.first]; earlier != later)
      between.push_back({later, earlier});
  }
  std::sort(between.begin(), between.end());
  for (const auto& [later, earlier] : between) {
    if (verdicts[earlier].is_sound()) verdicts[later].fault = meets_another;
  }
}

/// Every thread the faces of some candidates.
template <typename JudgeFaces>
bool judge_in_parts(const AddedFaces& added, Index count, const JudgeFaces& judge_faces, int threads,
                    Progress& progress) {
  const auto parts = static_cast<Index>(std::min<std::size_t>(thread_count(threads), count));
  if (parts == 1) return judge_faces(added.faces_of(std::vector<bool>(count, true)), progress);
  std::vector<std::uint8_t> is_complete(parts, 0);
  Progress silent = progress.silent();
  for_each_part(parts, 1, threads, silent, [&](std::size_t part, std::size_t) {
    std::vector<bool> is_wanted(count, false);
    for (std::size_t i = part; i < count; i += parts) is_wanted[i] = true;
    Progress own = progress.silent();
    is_complete[part] = judge_faces(added.faces_of(is_wanted), own) ? 1 : 0;
  });
  return std::ranges::count(is_complete, 0) == 0;
}

}  // namespace

PatchVerifier::PatchVerifier(const PolyMesh& mesh, const HoleAnalysis& analysis, Precision precision, int threads)
    : mesh_(mesh),
      analysis_(analysis),
      precision_(precision),
      threads_(threads),
      mesh_edges_(edges_between_rims(mesh, analysis)),
      rim_edges_(mesh_edges_) {
  for (const Hole& hole : analysis.holes) {
    for (const Index vertex : hole.vertices) rim_vertices_.push_back(analysis.view.representative_of(vertex));
  }
  sort_unique(rim_vertices_);
  for (const Index vertex : rim_vertices_) patches_.positions.push_back(mesh.positions[vertex]);
  if (precision_ != Precision::Single) return;
  const std::vector<Vec3> as_given = patches_.positions;
  round_to_single(patches_.positions);
  // Where rims are single the rest is taken for single, too.
  if (patches_.positions != as_given)
    as_given_ = std::make_unique<PatchVerifier>(mesh, analysis, Precision::Double, threads);
}

std::vector<PatchVerdict> PatchVerifier::judge(std::span<const HolePatch> candidates, Progress& progress) {
  std::vector<PatchVerdict> verdicts(candidates.size());
  Progress judging = progress.silent();
  for_each_part(candidates.size(), 1, threads_, judging,
                [&](std::size_t i, std::size_t) { verdicts[i] = judge_structure(candidates[i]); });
  judge_against_mesh(candidates, verdicts, progress);
  if (as_given_) {
    Progress silent = progress.silent();
    const std::vector<PatchVerdict> besides = as_given_->judge(candidates, silent);
    for (std::size_t i = 0; i < verdicts.size(); ++i) {
      if (verdicts[i].is_sound()) verdicts[i] = besides[i];
    }
  }
  return verdicts;
}

std::vector<PatchVerdict> PatchVerifier::accept_sound(std::span<const HolePatch> candidates,
                                                      std::vector<PatchVerdict> verdicts, Progress& progress) {
  constexpr const char* joins = "an edge of the patch joins vertices that another patch joins already";
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    if (verdicts[i].is_sound() && joins_any(candidates[i], rim_edges_)) verdicts[i].fault = joins;
  }
  judge_against_each_other(candidates, verdicts, progress);
  if (as_given_) {
    Progress silent = progress.silent();
    as_given_->judge_against_each_other(candidates, verdicts, silent);
  }
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    if (!verdicts[i].is_sound()) continue;
    if (joins_any(candidates[i], rim_edges_))
      verdicts[i].fault = joins;
    else
      accept(candidates[i]);
  }
  return verdicts;
}

std::vector<PatchVerdict> PatchVerifier::accept_sound(std::span<const HolePatch> candidates, Progress& progress) {
  Progress judging = progress.step("search intersections", 0.8);
  std::vector<PatchVerdict> verdicts = judge(candidates, judging);
  Progress comparing = progress.step("compare patches", 0.2);
  return accept_sound(candidates, std::move(verdicts), comparing);
}

PatchVerdict PatchVerifier::judge_structure(const HolePatch& patch) const {
  if (patch.triangles.empty()) return {"the patch is empty", 0, 0};
  if (!std::ranges::all_of(patch.points, [](const Vec3& point) { return point.allFinite(); }))
    return {"a coordinate isn't finite", 0, 0};
  const LocalPatch local = make_local(mesh_, analysis_, patch, precision_);
  if (std::string fault = structure_fault(analysis_, patch, local); !fault.empty()) return {std::move(fault), 0, 0};
  PatchVerdict verdict = measure_patch(mesh_, analysis_, patch);
  if (joins_any(patch, mesh_edges_)) verdict.fault = "an edge of the patch joins vertices that are joined already";
  return verdict;
}

bool PatchVerifier::joins_any(const HolePatch& patch, const Edges& edges) const {
  return std::ranges::any_of(chords_of(mesh_, analysis_, patch),
                             [&](const Edge& chord) { return std::ranges::binary_search(edges, chord); });
}

void PatchVerifier::judge_against_mesh(std::span<const HolePatch> candidates, std::vector<PatchVerdict>& verdicts,
                                       Progress& progress) {
  make_scene(candidates);
  const auto count = static_cast<Index>(candidates.size());
  AddedFaces added{static_cast<Index>(scene_.face_count()), {}};
  const auto append = [&](Index i) {
    if (!verdicts[i].is_sound()) return;
    append_patch(scene_, mesh_.vertex_count(), candidates[i],
                 [&](Index v) { return analysis_.view.representative_of(v); });
    added.candidate.insert(added.candidate.end(), candidates[i].triangles.size(), i);
  };
  /// @return whether all pairs of these faces were seen
  const auto judge_faces = [&](const std::vector<Index>& faces, Progress& searching) {
    const auto found = find_intersections_of(scene_, faces, searching, {.max_pairs = most_pairs});
    for (const auto& [low, high] : found.pairs) {
      const Index candidate = added.candidate[high - added.first];
      if (low < added.first || added.candidate[low - added.first] == candidate) verdicts[candidate].fault = intersects;
    }
    return found.count <= found.pairs.size();
  };
  const auto judge_together = [&] {
    const Restore restore(scene_);
    for (Index i = 0; i < count; ++i) append(i);
    return added.candidate.empty() || judge_in_parts(added, count, judge_faces, threads_, progress);
  };
  if (judge_together()) return;
  for (Index i = 0; i < count; ++i) {
    const Restore restore(scene_);
    added.candidate.clear();
    append(i);
    if (!added.candidate.empty()) judge_faces(added.faces_of(std::vector<bool>(count, true)), progress);
  }
}

void PatchVerifier::make_scene(std::span<const HolePatch> candidates) {
  if (scene_.face_count() > 0) return;
  std::size_t points = 0, faces = 0;
  for (const HolePatch& patch : candidates) points += patch.points.size(), faces += patch.triangles.size();
  scene_.positions.reserve(mesh_.vertex_count() + points);
  scene_.face_offsets.reserve(analysis_.view.triangles.size() + faces + 1);
  scene_.corners.reserve(3 * (analysis_.view.triangles.size() + faces));
  scene_.positions = mesh_.positions;
  if (precision_ == Precision::Single) round_to_single(scene_.positions);
  const auto& triangles = analysis_.view.triangles;
  scene_.face_offsets.resize(triangles.size() + 1);
  for (std::size_t t = 0; t <= triangles.size(); ++t) scene_.face_offsets[t] = static_cast<Index>(3 * t);
  scene_.corners.assign(triangles.front().data(), triangles.front().data() + 3 * triangles.size());
}

Eigen::AlignedBox3d PatchVerifier::append_to_patches(const HolePatch& patch) {
  const std::size_t first = patches_.face_count();
  append_patch(patches_, mesh_.vertex_count(), patch,
               [&](Index vertex) { return place_in(rim_vertices_, analysis_.view.representative_of(vertex)); });
  return box_of(std::span(patches_.corners).subspan(3 * first),
                [&](Index vertex) -> const Vec3& { return patches_.positions[vertex]; });
}

void PatchVerifier::judge_against_each_other(std::span<const HolePatch> candidates, std::vector<PatchVerdict>& verdicts,
                                             Progress& progress) {
  const Restore restore(patches_);
  bool is_complete = false;
  while (!is_complete) {
    restore.now();
    AddedFaces added{static_cast<Index>(patches_.face_count()), {}};
    std::vector<Box> boxes(candidates.size());
    for (Index i = 0; i < candidates.size(); ++i) {
      if (!verdicts[i].is_sound()) continue;
      boxes[i] = append_to_patches(candidates[i]);
      added.candidate.insert(added.candidate.end(), candidates[i].triangles.size(), i);
    }
    // What else meets themselves was seen against the mesh: those apart from all others need no second test.
    boxes.insert(boxes.end(), accepted_boxes_.begin(), accepted_boxes_.end());
    const std::vector<Index> faces = added.faces_of(meet_others(boxes));
    if (faces.empty()) return;
    const auto found = find_intersections_of(patches_, faces, progress, {.max_pairs = most_pairs});
    refuse_later(found.pairs, added, verdicts);
    is_complete = found.count <= found.pairs.size();
  }
}

void PatchVerifier::accept(const HolePatch& patch) {
  if (as_given_) as_given_->accepted_boxes_.push_back(as_given_->append_to_patches(patch));
  accepted_boxes_.push_back(append_to_patches(patch));
  const auto chords = chords_of(mesh_, analysis_, patch);
  const auto known = std::ssize(rim_edges_);
  rim_edges_.insert(rim_edges_.end(), chords.begin(), chords.end());
  std::inplace_merge(rim_edges_.begin(), rim_edges_.begin() + known, rim_edges_.end());
}

}  // namespace croquis::hole_filling
