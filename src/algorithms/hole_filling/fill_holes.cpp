// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/hole_filling/fill_holes.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <memory>
#include <string>
#include <utility>
#include <variant>

#include "algorithms/hole_filling/patch_making.h"
#include "algorithms/hole_filling/rim_trimming.h"
#include "croquis/base/error.h"
#include "croquis/base/parallel.h"
#include "croquis/base/stage_key.h"
#include "croquis/hole_filling/hole_choice.h"
#include "croquis/hole_filling/hole_patch.h"

namespace croquis::hole_filling {
namespace {

std::size_t bytes_of(const HoleAnalysis& analysis) {
  const SurfaceView& view = analysis.view;
  std::size_t bytes = sizeof analysis + view.triangles.size() * (sizeof view.triangles[0] + 5 * sizeof(Index) + 1) +
                      (view.representative.size() + view.rim_corners.size()) * sizeof(Index);
  for (const Hole& hole : analysis.holes) bytes += sizeof hole + 2 * hole.vertices.size() * sizeof(Index);
  return bytes;
}

/// The mesh as the caller names it, or all of it.
StageKey key_of(const PolyMesh& mesh, const FillOptions& options) {
  StageKey key;
  key.add(options.analysis).add(options.scan_key);
  if (options.scan_key.empty() && options.cache != nullptr)
    key.add(mesh.positions).add(mesh.face_offsets).add(mesh.corners);
  return key;
}

std::size_t bytes_of(const TrimmedScan& trimmed) {
  const PolyMesh& mesh = trimmed.part.mesh;
  std::size_t bytes = bytes_of(trimmed.analysis) + mesh.positions.size() * (sizeof(Vec3) + sizeof(Index)) +
                      (2 * mesh.face_offsets.size() + mesh.corners.size()) * sizeof(Index);
  for (const AttributeChannel& channel : mesh.channels) bytes += channel.size() * sizeof(double);
  return bytes;
}

template <typename List>
bool begins_with(const List& list, const List& first) {
  return list.size() >= first.size() && std::equal(first.begin(), first.end(), list.begin());
}

HoleAnalysis analysed(const PolyMesh& scan, const FillOptions& options, const StageKey& key, Progress& progress) {
  const auto make = [&] { return analyse_holes(scan, progress, options.analysis); };
  if (options.cache == nullptr) return make();
  return *cached<HoleAnalysis>(options.cache, "fill/analysis/1", key, make,
                               [](const HoleAnalysis& analysis) { return bytes_of(analysis); });
}

/// Null where nothing is to be trimmed.
std::shared_ptr<const TrimmedScan> trimmed_scan(const PolyMesh& scan, const HoleAnalysis& analysis,
                                                const HoleChoice& choice, const FillOptions& options, StageKey key,
                                                Progress& progress) {
  const std::vector<int> rings = rings_to_trim(analysis.holes, options, choice.is_chosen);
  if (std::ranges::all_of(rings, [](int count) { return count == 0; })) return nullptr;
  return cached<TrimmedScan>(
      options.cache, "fill/trimmed/1", key.add(rings),
      [&] { return trim_rims(scan, analysis, rings, options.analysis, progress); },
      [](const TrimmedScan& trimmed) { return bytes_of(trimmed); });
}

double widest_diagonal(const HoleAnalysis& analysis, const std::vector<Index>& holes) {
  double widest = 0;
  for (const Index hole : holes) widest = std::max(widest, analysis.component_diagonal[analysis.holes[hole].component]);
  return widest;
}

/// The mean angle between a patch and the surface along a rim, by length.
double mean_fold(const std::vector<RimFold>& along) {
  double sum = 0, length = 0;
  for (const RimFold& fold : along) {
    sum += fold.length * std::abs(fold.angle);
    length += fold.length;
  }
  return length > 0 ? sum / length : 0;
}

/// Per hole of the analysis.
/// @param number of the first patch
std::vector<HoleOutcome> outcomes_of(const PolyMesh& mesh, const HoleAnalysis& analysis,
                                     const std::vector<FillJob>& all_made, const std::vector<FillJob>& jobs,
                                     const FillOptions& options, Index number) {
  std::vector<HoleOutcome> outcomes(analysis.holes.size());
  for (const FillJob& job : jobs) {
    for (const Index hole : job.detached) outcomes[hole].reason = hangs_at_rim;  // unless a patch joins it
  }
  std::vector<double> confidences(all_made.size());
  for_each_part(all_made.size(), 1, options.threads, [&](std::size_t i, std::size_t) {
    const std::optional<HolePatch>& patch = all_made[i].patch;
    if (!patch) return;
    confidences[i] = confidence_of(*patch, mesh, analysis);
    const auto folds = rim_folds(*patch, mesh, analysis);
    for (std::size_t k = 0; k < folds.size(); ++k) outcomes[patch->holes[k]].mean_fold = mean_fold(folds[k]);
  });
  for (std::size_t i = 0; i < all_made.size(); ++i) {
    const FillJob& made = all_made[i];
    HoleOutcome outcome = made.outcome;
    if (made.patch) {
      outcome.patch = number++;
      outcome.confidence = confidences[i];
      outcome.box = box_of(made.patch->points, std::identity());
      if (options.preset == Preset::Sharp)
        outcome.expected_error = error_at(outcome.confidence) * widest_diagonal(analysis, made.holes);
    }
    for (const Index hole : made.holes) {
      outcome.mean_fold = outcomes[hole].mean_fold;
      outcomes[hole] = outcome;
    }
    if (!made.patch) continue;
    outcomes[made.holes.front()].new_vertices = made.patch->points.size();
    outcomes[made.holes.front()].new_faces = made.patch->triangles.size();
  }
  return outcomes;
}

void count_domains(const std::vector<FillJob>& all_made, FillResult& result) {
  std::vector<std::size_t> points;
  for (const FillJob& made : all_made) {
    if (made.patch) points.insert(points.end(), made.patch->domain_points.begin(), made.patch->domain_points.end());
  }
  if (points.empty()) return;
  std::ranges::sort(points);
  result.domains = points.size();
  result.points_per_domain = {points.front(), points[points.size() / 2], points.back()};
}

void assemble(const PolyMesh& mesh, const HoleAnalysis& analysis, std::vector<FillJob> all_made,
              const FillOptions& options, FillResult& result) {
  std::vector<HolePatch> patches;
  result.open_edges = analysis.view.rim_corners.size();
  for (FillJob& made : all_made) {
    if (!made.patch) continue;
    for (const Index hole : made.patch->holes) result.open_edges -= analysis.holes[hole].vertices.size();
    patches.push_back(std::move(*made.patch));
  }
  result.mesh = append_patches(mesh, analysis, patches, options.mark_patches, options.threads);
  result.new_vertices = result.mesh.vertex_count() - mesh.vertex_count();
  result.new_faces = result.mesh.face_count() - mesh.face_count();
  result.outside_unchanged = begins_with(result.mesh.positions, mesh.positions) &&
                             begins_with(result.mesh.face_offsets, mesh.face_offsets) &&
                             begins_with(result.mesh.corners, mesh.corners);
}

void require_memory(const PolyMesh& mesh, const FillOptions& options) {
  if (options.memory_limit == 0) return;
  const std::size_t bytes = predicted_fill_bytes(mesh, options);
  if (bytes <= options.memory_limit) return;
  const auto mebibytes = [](std::size_t count) { return std::to_string((count + (1 << 20) - 1) >> 20) + " MiB"; };
  throw Error(make_error(Category::Limit, "E_MEMORY",
                         "Filling the holes of these " + std::to_string(mesh.face_count()) +
                             " faces would take about " + mebibytes(bytes) + ", more than the limit of " +
                             mebibytes(options.memory_limit) +
                             ": raise the limit, or fill the parts of the model one by one."));
}

}  // namespace

std::size_t predicted_fill_bytes(const PolyMesh& mesh, const FillOptions& options) {
  constexpr std::size_t view_triangle = 35, joined_triangle = 75;  // of SurfaceView, and at most while it is made
  constexpr std::size_t index = sizeof(Index), point = sizeof(Vec3);
  constexpr std::size_t allowance = std::size_t{48} << 20;  // patches under way and what they are made with
  const std::size_t vertices = mesh.vertex_count();
  const std::size_t corners = mesh.corners.size();
  const std::size_t triangles = corners - std::min(corners, 2 * mesh.face_count());
  const std::size_t views = (options.cache == nullptr ? 1 : 2) * view_triangle * triangles;
  // Verification has the triangles twice, once for the search.
  const std::size_t scenes = options.precision == Precision::Single ? 2 : 1;
  const std::size_t verification = (scenes + 1) * point * vertices + (4 * scenes + 1 + 3) * index * triangles;
  std::size_t result = point * vertices + index * (corners + mesh.face_count());
  for (const AttributeChannel& channel : mesh.channels)
    result += channel.size() * std::visit([](const auto& values) { return sizeof values[0]; }, channel.data);
  if (options.mark_patches) result += index * (mesh.face_count() + vertices);
  const bool trims = options.trim_rim > 0 || std::ranges::any_of(options.requests, [](const HoleRequest& request) {
                       return request.trim_rim.value_or(0) > 0;
                     });
  const std::size_t trimmed = trims ? result + view_triangle * triangles : 0;
  return allowance + trimmed + std::max(joined_triangle * triangles, views + std::max(verification, result));
}

const char* to_string(FillAction action) {
  switch (action) {
    case FillAction::Fill: return "fill";
    case FillAction::Leave: return "leave";
    case FillAction::Failed: return "failed";
  }
  return "";
}

FillResult fill_holes(const PolyMesh& scan, const FillOptions& options, Progress& progress) {
  require_memory(scan, options);
  const StageKey key = key_of(scan, options);
  FillResult result;
  Progress analysing = progress.step("analyse holes", 0.2);
  result.analysis = analysed(scan, options, key, analysing);
  const HoleChoice choice = choose_holes(result.analysis.holes, options);
  std::vector<FillJob> jobs = make_jobs(result.analysis.holes, options, choice.is_chosen);
  Progress trimming = progress.step("trim rims", 0.1);
  const auto trimmed = trimmed_scan(scan, result.analysis, choice, options, key, trimming);
  const PolyMesh& mesh = trimmed ? trimmed->part.mesh : scan;
  const HoleAnalysis& analysis = trimmed ? trimmed->analysis : result.analysis;
  Progress filling = progress.step("fill holes", 0.7);
  if (trimmed)
    jobs = moved_jobs(*trimmed, jobs);
  else if (!jobs.empty())
    std::ranges::copy(waiting_jobs(result.analysis.holes, options, choice.is_border), std::back_inserter(jobs));
  const ScanNumbers numbers(scan, trimmed.get(), analysis, key.bytes());
  std::vector<FillJob> made = make_patches(mesh, analysis, jobs, options, numbers, filling);
  result.outcomes = outcomes_of(mesh, analysis, made, jobs, options, next_patch_number(scan));
  if (trimmed) result.outcomes = outcomes_before_trimming(*trimmed, result.outcomes, choice.is_chosen);
  for (std::size_t i = 0; i < result.outcomes.size(); ++i) {
    HoleOutcome& outcome = result.outcomes[i];
    if (!choice.is_chosen[i] && outcome.action == FillAction::Leave) outcome.reason = choice.reason[i];
  }
  count_domains(made, result);
  result.removed_vertices = scan.vertex_count() - mesh.vertex_count();
  result.removed_faces = scan.face_count() - mesh.face_count();
  assemble(mesh, analysis, std::move(made), options, result);
  result.warnings = fill_findings(scan, result);
  progress.report(1);
  return result;
}

}  // namespace croquis::hole_filling
