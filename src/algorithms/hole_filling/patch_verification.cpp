// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/hole_filling/patch_verification.h"

#include <algorithm>
#include <numeric>
#include <string>
#include <utility>

#include "algorithms/hole_filling/patch_structure.h"
#include "algorithms/hole_filling/rim_edges.h"
#include "algorithms/hole_filling/single_precision.h"
#include "croquis/geometry/self_intersection.h"

namespace croquis::hole_filling {
namespace {

/// Intersecting pairs looked at in one search; where there are more, those found condemn their patches first and the
/// rest is searched again.
constexpr std::size_t most_pairs = 1000000;

constexpr const char* intersects = "the patch cuts through the surface or itself";

/// Faces of the scene behind `first`, and which candidate each is of.
struct AddedFaces {
  Index first = 0;
  std::vector<Index> candidate;
};

void append_patch(PolyMesh& scene, const SurfaceView& view, std::size_t vertex_count, const HolePatch& patch) {
  const auto base = static_cast<Index>(scene.vertex_count());
  scene.positions.insert(scene.positions.end(), patch.points.begin(), patch.points.end());
  for (auto t : patch.triangles) {
    for (Index& vertex : t)
      vertex =
          vertex < vertex_count ? view.representative_of(vertex) : base + (vertex - static_cast<Index>(vertex_count));
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

/// Of two candidates that meet the later one goes, unless the earlier one is condemned for other reasons.
void condemn(std::span<const std::array<Index, 2>> pairs, const AddedFaces& added,
             std::vector<PatchVerdict>& verdicts) {
  std::vector<std::array<Index, 2>> between;
  for (const auto& [low, high] : pairs) {
    const Index later = added.candidate[high - added.first];
    const Index earlier = low < added.first ? later : added.candidate[low - added.first];
    if (earlier == later)
      verdicts[later].fault = intersects;
    else
      between.push_back({later, earlier});
  }
  std::sort(between.begin(), between.end());
  for (const auto& [later, earlier] : between) {
    if (verdicts[earlier].is_sound()) verdicts[later].fault = intersects;
  }
}

}  // namespace

PatchVerifier::PatchVerifier(const PolyMesh& mesh, const HoleAnalysis& analysis, Precision precision)
    : mesh_(mesh), analysis_(analysis), rim_edges_(edges_between_rims(mesh, analysis)) {
  scene_.positions = mesh.positions;
  if (precision == Precision::Single) round_to_single(scene_.positions);
  scene_.face_offsets.reserve(analysis.view.triangles.size() + 1);
  scene_.corners.reserve(3 * analysis.view.triangles.size());
  for (const auto& t : analysis.view.triangles) scene_.add_face(t);
}

std::vector<PatchVerdict> PatchVerifier::accept_sound(std::span<const HolePatch> candidates, Progress& progress) {
  std::vector<PatchVerdict> verdicts;
  for (const HolePatch& candidate : candidates) {
    progress.check();
    verdicts.push_back(judge_alone(candidate));
  }
  Progress searching = progress.step("search intersections", 1);
  judge_intersections(candidates, verdicts, searching);
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    if (!verdicts[i].is_sound()) continue;
    if (clashes_with_accepted(candidates[i]))
      verdicts[i].fault = "an edge of the patch joins vertices that another patch joins already";
    else
      accept(candidates[i]);
  }
  return verdicts;
}

PatchVerdict PatchVerifier::judge_alone(const HolePatch& patch) const {
  if (std::string fault = structure_fault(mesh_, analysis_, patch); !fault.empty()) return {std::move(fault), 0, 0};
  PatchVerdict verdict = measure_patch(mesh_, analysis_, patch);
  if (clashes_with_accepted(patch)) verdict.fault = "an edge of the patch joins vertices that are joined already";
  return verdict;
}

bool PatchVerifier::clashes_with_accepted(const HolePatch& patch) const {
  const auto chords = chords_of(mesh_, analysis_, patch);
  return std::any_of(chords.begin(), chords.end(), [&](const auto& chord) {
    return std::binary_search(rim_edges_.begin(), rim_edges_.end(), chord);
  });
}

void PatchVerifier::judge_intersections(std::span<const HolePatch> candidates, std::vector<PatchVerdict>& verdicts,
                                        Progress& progress) {
  const Restore restore(scene_);
  bool is_complete = false;
  while (!is_complete) {
    restore.now();
    AddedFaces added{static_cast<Index>(scene_.face_count()), {}};
    for (Index i = 0; i < candidates.size(); ++i) {
      if (!verdicts[i].is_sound()) continue;
      append_patch(scene_, analysis_.view, mesh_.vertex_count(), candidates[i]);
      added.candidate.insert(added.candidate.end(), candidates[i].triangles.size(), i);
    }
    if (added.candidate.empty()) return;
    std::vector<Index> faces(added.candidate.size());
    std::iota(faces.begin(), faces.end(), added.first);
    const SelfIntersections found = find_intersections_of(scene_, faces, progress, {.max_pairs = most_pairs});
    condemn(found.pairs, added, verdicts);
    is_complete = found.count <= found.pairs.size();
  }
}

void PatchVerifier::accept(const HolePatch& patch) {
  append_patch(scene_, analysis_.view, mesh_.vertex_count(), patch);
  const auto chords = chords_of(mesh_, analysis_, patch);
  const auto known = std::ssize(rim_edges_);
  rim_edges_.insert(rim_edges_.end(), chords.begin(), chords.end());
  std::inplace_merge(rim_edges_.begin(), rim_edges_.begin() + known, rim_edges_.end());
}

}  // namespace croquis::hole_filling
