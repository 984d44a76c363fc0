// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/hole_filling/patch_verification.h"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <string>
#include <utility>

#include "algorithms/hole_filling/verification/patch_structure.h"
#include "algorithms/hole_filling/verification/rim_edges.h"
#include "croquis/base/parallel.h"
#include "croquis/geometry/self_intersection.h"
#include "croquis/geometry/single_precision.h"

namespace croquis::hole_filling {
namespace {

/// Intersecting pairs looked at in one search; where there are more, those found exclude their patches first and the
/// rest is searched again.
constexpr std::size_t most_pairs = 1000000;

constexpr const char* intersects = "the patch cuts through the surface or itself";
constexpr const char* meets_another = "the patch cuts through another one";

/// Faces of the scene behind `first`, and which candidate each is of.
struct AddedFaces {
  Index first = 0;
  std::vector<Index> candidate;

  std::vector<Index> faces() const {
    std::vector<Index> all(candidate.size());
    std::iota(all.begin(), all.end(), first);
    return all;
  }

  std::vector<Index> faces_of(const std::vector<bool>& is_wanted) const {
    std::vector<Index> wanted;
    for (std::size_t i = 0; i < candidate.size(); ++i) {
      if (is_wanted[candidate[i]]) wanted.push_back(first + static_cast<Index>(i));
    }
    return wanted;
  }
};

using Box = Eigen::AlignedBox3d;

Box box_of(const PolyMesh& scene, std::size_t first_face, std::size_t end_face) {
  Box box;
  for (std::size_t f = first_face; f < end_face; ++f) {
    for (const Index vertex : scene.face(f)) box.extend(scene.positions[vertex]);
  }
  return box;
}

/// Which boxes meet another one: a sweep along x.
std::vector<bool> meet_others(const std::vector<Box>& boxes) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    if (!boxes[i].isEmpty()) order.push_back(i);
  }
  const auto low = [&](std::size_t i) { return boxes[i].min().x(); };
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return low(a) < low(b); });
  std::vector<bool> result(boxes.size(), false);
  for (std::size_t i = 0; i < order.size(); ++i) {
    for (std::size_t j = i + 1; j < order.size() && low(order[j]) <= boxes[order[i]].max().x(); ++j) {
      if (boxes[order[i]].intersects(boxes[order[j]])) result[order[i]] = result[order[j]] = true;
    }
  }
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
void condemn_later(std::span<const std::array<Index, 2>> pairs, const AddedFaces& added,
                   std::vector<PatchVerdict>& verdicts) {
  std::vector<std::array<Index, 2>> between;
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
  if (parts == 1) return judge_faces(added.faces(), progress);
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
  std::sort(rim_vertices_.begin(), rim_vertices_.end());
  rim_vertices_.erase(std::unique(rim_vertices_.begin(), rim_vertices_.end()), rim_vertices_.end());
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
  if (std::string fault = structure_fault(mesh_, analysis_, patch, precision_); !fault.empty())
    return {std::move(fault), 0, 0};
  PatchVerdict verdict = measure_patch(mesh_, analysis_, patch);
  if (joins_any(patch, mesh_edges_)) verdict.fault = "an edge of the patch joins vertices that are joined already";
  return verdict;
}

bool PatchVerifier::joins_any(const HolePatch& patch, const Edges& edges) const {
  const auto chords = chords_of(mesh_, analysis_, patch);
  return std::any_of(chords.begin(), chords.end(),
                     [&](const auto& chord) { return std::binary_search(edges.begin(), edges.end(), chord); });
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
    if (!added.candidate.empty()) judge_faces(added.faces(), progress);
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
  append_patch(patches_, mesh_.vertex_count(), patch, [&](Index vertex) {
    const Index representative = analysis_.view.representative_of(vertex);
    const auto found = std::lower_bound(rim_vertices_.begin(), rim_vertices_.end(), representative);
    return static_cast<Index>(found - rim_vertices_.begin());
  });
  return box_of(patches_, first, patches_.face_count());
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
    condemn_later(found.pairs, added, verdicts);
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
