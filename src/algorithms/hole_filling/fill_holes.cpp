// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/hole_filling/fill_holes.h"

#include <algorithm>
#include <iterator>
#include <memory>
#include <string>
#include <utility>
#include <variant>

#include "algorithms/hole_filling/patch_assembly.h"
#include "algorithms/hole_filling/patch_climb.h"
#include "algorithms/hole_filling/rim_trimming.h"
#include "algorithms/hole_filling/scan_numbers.h"
#include "croquis/base/error.h"
#include "croquis/base/parallel.h"
#include "croquis/base/stage_key.h"
#include "croquis/hole_filling/fill_findings.h"
#include "croquis/hole_filling/fill_jobs.h"
#include "croquis/hole_filling/hole_choice.h"
#include "croquis/hole_filling/patch_confidence.h"

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

class Filling {
 public:
  Filling(const PolyMesh& mesh, const FillOptions& options)
      : scan_(mesh), options_(options), key_(key_of(mesh, options)) {}

  FillResult run(Progress& progress) {
    Progress analysing = progress.step("analyse holes", 0.2);
    result_.analysis = analysed(analysing);
    const HoleChoice choice = choose_holes(result_.analysis.holes, options_);
    std::vector<FillJob> jobs = make_jobs(result_.analysis.holes, options_, choice.is_chosen);
    Progress trimming = progress.step("trim rims", 0.1);
    trim(choice, trimming);
    Progress filling = progress.step("fill holes", 0.7);
    const ScanNumbers numbers(scan_, trimmed_.get(), analysis(), key_.bytes());
    if (trimmed_)
      jobs = moved_jobs(*trimmed_, jobs);
    else if (!jobs.empty())
      std::ranges::copy(waiting_jobs(result_.analysis.holes, options_, choice.is_border), std::back_inserter(jobs));
    climbed_ = climb(mesh(), analysis(), jobs, options_, numbers, filling);
    report_outcomes(choice, jobs);
    assemble();
    result_.warnings = fill_findings(scan_, result_);
    progress.report(1);
    return std::move(result_);
  }

 private:
  HoleAnalysis analysed(Progress& progress) const {
    const auto make = [&] { return analyse_holes(scan_, progress, options_.analysis); };
    if (options_.cache == nullptr) return make();
    return *cached<HoleAnalysis>(options_.cache, "fill/analysis/1", key_, make,
                                 [](const HoleAnalysis& analysis) { return bytes_of(analysis); });
  }

  void trim(const HoleChoice& choice, Progress& progress) {
    const std::vector<int> rings = rings_to_trim(result_.analysis.holes, options_, choice.is_chosen);
    if (std::ranges::all_of(rings, [](int count) { return count == 0; })) return;
    StageKey key = key_;
    key.add(rings);
    trimmed_ = cached<TrimmedScan>(
        options_.cache, "fill/trimmed/1", key,
        [&] { return trim_rims(scan_, result_.analysis, rings, options_.analysis, progress); },
        [](const TrimmedScan& trimmed) { return bytes_of(trimmed); });
  }

  /// What patches are made for: the scan, or what trimming leaves of it.
  const PolyMesh& mesh() const { return trimmed_ ? trimmed_->part.mesh : scan_; }
  const HoleAnalysis& analysis() const { return trimmed_ ? trimmed_->analysis : result_.analysis; }

  void report_outcomes(const HoleChoice& choice, const std::vector<FillJob>& jobs) {
    std::vector<HoleOutcome> outcomes(analysis().holes.size());
    for (const FillJob& job : jobs) {
      for (const Index stray : job.strays) outcomes[stray].reason = hangs_at_rim;  // unless a patch joins it
    }
    std::vector<double> confidences(climbed_.size(), 0);
    for_each_part(climbed_.size(), 1, options_.threads, [&](std::size_t i, std::size_t) {
      if (climbed_[i].patch) confidences[i] = confidence_of(*climbed_[i].patch, mesh(), analysis());
    });
    Index number = next_patch_number(scan_);
    for (std::size_t i = 0; i < climbed_.size(); ++i) {
      const ClimbedJob& job = climbed_[i];
      const HoleOutcome outcome = outcome_of(job, number, confidences[i]);
      for (const Index hole : job.holes) outcomes[hole] = outcome;
      if (!job.patch) continue;
      ++number;
      outcomes[job.holes.front()].new_vertices = job.patch->points.size();
      outcomes[job.holes.front()].new_faces = job.patch->triangles.size();
    }
    if (trimmed_) outcomes = outcomes_before_trimming(*trimmed_, outcomes, choice.is_chosen);
    for (std::size_t i = 0; i < outcomes.size(); ++i) {
      if (!choice.is_chosen[i] && outcomes[i].action == FillAction::Leave) outcomes[i].reason = choice.reason[i];
    }
    result_.outcomes = std::move(outcomes);
    count_domains();
  }

  /// Of the patches that were taken.
  void count_domains() {
    std::vector<std::size_t> points;
    for (const ClimbedJob& job : climbed_) {
      if (job.patch) points.insert(points.end(), job.patch->domain_points.begin(), job.patch->domain_points.end());
    }
    if (points.empty()) return;
    std::ranges::sort(points);
    result_.domains = points.size();
    result_.points_per_domain = {points.front(), points[points.size() / 2], points.back()};
  }

  static HoleOutcome outcome_of(const ClimbedJob& job, Index patch_number, double confidence) {
    HoleOutcome outcome;
    outcome.action = job.patch ? FillAction::Fill : FillAction::Failed;
    outcome.reason = job.first_fault;
    if (!job.patch) return outcome;
    outcome.method = job.method;
    outcome.max_normal_jump = job.verdict.max_normal_jump;
    outcome.min_angle = job.verdict.min_angle;
    outcome.confidence = confidence;
    for (const Vec3& point : job.patch->points) outcome.box.extend(point);
    outcome.expected_error = job.patch->expected_error;
    outcome.patch = patch_number;
    return outcome;
  }

  void assemble() {
    std::vector<HolePatch> patches;
    result_.open_edges = analysis().view.rim_corners.size();
    for (ClimbedJob& job : climbed_) {
      if (!job.patch) continue;
      for (const Index hole : job.patch->holes) result_.open_edges -= analysis().holes[hole].vertices.size();
      patches.push_back(std::move(*job.patch));
    }
    result_.mesh = append_patches(mesh(), analysis(), patches, options_.mark_patches, options_.threads);
    result_.new_vertices = result_.mesh.vertex_count() - mesh().vertex_count();
    result_.new_faces = result_.mesh.face_count() - mesh().face_count();
    result_.removed_vertices = scan_.vertex_count() - mesh().vertex_count();
    result_.removed_faces = scan_.face_count() - mesh().face_count();
    result_.outside_unchanged = begins_with(result_.mesh.positions, mesh().positions) &&
                                begins_with(result_.mesh.face_offsets, mesh().face_offsets) &&
                                begins_with(result_.mesh.corners, mesh().corners);
  }

  const PolyMesh& scan_;
  const FillOptions& options_;
  StageKey key_;  ///< of the scan
  std::shared_ptr<const TrimmedScan> trimmed_;
  std::vector<ClimbedJob> climbed_;
  FillResult result_;
};

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

FillResult fill_holes(const PolyMesh& mesh, const FillOptions& options, Progress& progress) {
  require_memory(mesh, options);
  return Filling(mesh, options).run(progress);
}

}  // namespace croquis::hole_filling
