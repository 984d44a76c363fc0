// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/hole_filling/patch_making.h"

#include <algorithm>
#include <atomic>
#include <deque>
#include <functional>
#include <span>
#include <thread>
#include <utility>

#include "algorithms/hole_filling/analysis/sorted_lists.h"
#include "algorithms/hole_filling/patching/near_scene.h"
#include "algorithms/hole_filling/patching/patch_methods.h"
#include "algorithms/hole_filling/verification/patch_verification.h"
#include "croquis/base/parallel.h"
#include "croquis/base/stage_key.h"
#include "croquis/geometry/single_precision.h"
#include "croquis/hole_filling/fill_holes.h"

namespace croquis::hole_filling {
namespace {

constexpr const char* patch_stage = "fill/patch/2";
constexpr const char* verdict_stage = "fill/verdict/2";

/// Rims of more edges aren't joined with a border on trial: it takes ten seconds, and fails mostly.
constexpr std::size_t most_edges_with_border = 500;

/// A job under way: its methods are tried one after the other. Its outcome's reason is the fault of the first patch
/// that was tried, unless one of its kind was taken.
struct OpenJob : FillJob {
  std::vector<Method> methods = {};
  std::size_t next = 0;  ///< of the methods
  StageKey key = {};     ///< of the patch under way
  std::optional<HolePatch> candidate = {};
  SiteMemory memory = {};
  PatchVerdict alone = {};          ///< of the candidate, against the mesh
  std::vector<OpenJob> parts = {};  ///< those it was made of, each at its next method: tried alone when this has none
  std::optional<std::size_t> folded = {};  ///< the first method whose patch was sound but folded back at the rim
  bool takes_folds = false;                ///< since no other method of the kind did better
  bool may_join = true;
  bool is_gone = false;  ///< has become part of another

  bool is_pending() const { return !waits && !is_gone && !patch && next < methods.size(); }
  const Method& method() const { return methods[next]; }

  /// On to the next method. The first one's fault is reported.
  void refuse(const std::string& fault) {
    if (outcome.reason.empty() && !fault.empty()) outcome.reason = option_of(name_of(method())) + ": " + fault;
    candidate.reset();
    ++next;
  }
};

/// What all jobs of a mesh have in common, and the jobs.
struct Making {
  const PolyMesh& mesh;
  const HoleAnalysis& analysis;
  const FillOptions& options;
  const ScanNumbers& numbers;
  PatchVerifier verifier{mesh, analysis, options.precision, options.threads};
  SurfaceSearch search{mesh, analysis.view};
  std::deque<OpenJob> jobs = {};  ///< grows while others are pointed at
  std::vector<OpenJob*> pending = {};
};

std::size_t bytes_of(const std::optional<HolePatch>& patch) {
  if (!patch) return sizeof patch;
  return sizeof patch + patch->points.size() * sizeof(Vec3) + patch->triangles.size() * sizeof(Triangle);
}

/// Whether a method makes what the settings ask for.
bool is_as_asked(Maker maker, const FillJob& job) {
  if (job.is_cap || job.settings.fairness == Fairness::Flat) return false;
  if (job.settings.fairness == Fairness::Tangent && job.settings.through.empty()) return maker == Maker::Smooth;
  return maker == Maker::Implicit || maker == Maker::Cubes || maker == Maker::Creased;
}

HoleSite site_of(const Making& making, const FillJob& job) {
  const FillOptions& options = making.options;
  HoleSite site = make_site(making.mesh, making.analysis, job.holes, making.verifier.rim_edges());
  site.settings = adapted(job.settings, options.preset);
  site.preset = options.preset;
  site.most_triangles = options.most_patch_triangles;
  site.bridge = job.bridge;
  site.search = &making.search;
  return site;
}

/// Where a rim itself goes through the surface no method has a sound patch.
void leave_if_hopeless(OpenJob& job, const HoleSite& site) {
  if (!rims_cross_surface(site)) return;
  job.outcome.reason = "its rim goes through the surface";
  job.next = job.methods.size();
}

OpenJob begun(const Making& making, FillJob job) {
  OpenJob started{std::move(job)};
  started.outcome = {};
  started.outcome.action = FillAction::Failed;
  if (started.waits) return started;
  HoleSite site = site_of(making, started);
  site.memory = &started.memory;
  started.methods = methods_for(site, started.is_cap);
  if (site.holes.size() > 1 || is_wide(making.analysis, site.holes.front())) leave_if_hopeless(started, site);
  return started;
}

/// Caps come last: a rim that looked like the border of a piece by itself may prove to be an island's, when the
/// surface around another hole goes on to it.
bool find_pending(Making& making) {
  making.pending.clear();
  for (const bool is_cap : {false, true}) {
    for (OpenJob& job : making.jobs) {
      if (job.is_pending() && job.is_cap == is_cap) making.pending.push_back(&job);
    }
    if (!making.pending.empty()) return true;
  }
  return false;
}

std::size_t rim_edges(const Making& making, const std::vector<Index>& holes) {
  std::size_t count = 0;
  for (const Index hole : holes) count += making.analysis.holes[hole].vertices.size();
  return count;
}

/// Of all that a method may look at.
StageKey key_of(const Making& making, const OpenJob& job, const HoleSite& site) {
  StageKey key;
  making.numbers.add_surroundings(site, key);
  key.add(job.bridge).add(job.is_cap).add(site.polygon.blocked).add(job.settings);
  key.add(making.options.preset).add(making.options.most_patch_triangles).add(job.next);
  return key;
}

void attempt(const Making& making, OpenJob& job, Progress& progress) {
  HoleSite site = site_of(making, job);
  site.memory = &job.memory;
  job.key = key_of(making, job, site);
  SiteMemory* memory = SiteMemory::of(site);
  if (job.takes_folds && job.folded == job.next && memory->folded) {
    job.candidate = memory->folded;
    return;
  }
  const auto make = [&] {  // failures are kept too, so that they aren't tried again
    std::optional<HolePatch> patch = make_patch(job.method(), site, progress);
    if (patch && rises_too_far(site, *patch, progress)) {
      patch = HolePatch{site.holes, {}, {}};
      patch->rises_too_far = true;
    }
    if (patch) patch = making.numbers.in_scan(std::move(*patch));
    return patch;
  };
  const auto made =
      cached<std::optional<HolePatch>>(making.options.cache, patch_stage, job.key, make,
                                       [](const std::optional<HolePatch>& patch) { return bytes_of(patch); });
  job.candidate.reset();
  if (*made) job.candidate = making.numbers.in_mesh(**made, job.holes);
  if (job.candidate && making.options.precision == Precision::Single) round_to_single(job.candidate->points);
}

/// Reports the number of patches made, and from the calling thread alone. Long rims first, so that no thread has a
/// long one left when the others have finished.
void attempt_all(Making& making, Progress& progress) {
  std::vector<OpenJob*> order = making.pending;
  std::ranges::stable_sort(order, std::greater(), [&](const OpenJob* job) { return rim_edges(making, job->holes); });
  const auto caller = std::this_thread::get_id();
  std::atomic<std::size_t> done = 0;
  Progress silent = progress.silent();
  progress.report(0, order.size());
  for_each_part(order.size(), 1, making.options.threads, silent, [&](std::size_t begin, std::size_t end) {
    Progress own = progress.silent();
    for (std::size_t i = begin; i < end; ++i) attempt(making, *order[i], own);
    done += end - begin;
    if (std::this_thread::get_id() == caller) progress.report(done, order.size());
  });
  progress.report(order.size(), order.size());
}

/// Whether a job may be joined with another one, whose rim the surface around it arrives at: that is to be filled and
/// isn't yet, or it is the border of a smaller piece, which waits. A piece that the job's own holes are in is no island
/// of theirs.
bool may_be_joined(const Making& making, const OpenJob& job, const OpenJob& other) {
  const HoleAnalysis& analysis = making.analysis;
  const Index piece = analysis.holes[other.holes.front()].component;
  const auto piece_of = [&](Index hole) { return analysis.holes[hole].component; };
  const bool is_own = std::ranges::find(job.holes, piece, piece_of) != job.holes.end();
  if (!job.may_join || !other.may_join || (other.is_cap && is_own)) return false;
  if (!other.waits || other.is_gone) return other.is_pending();
  const auto size_of = [&](Index hole) { return analysis.component_size[piece_of(hole)]; };
  return !is_own && analysis.component_size[piece] < size_of(std::ranges::max(job.holes, {}, size_of)) &&
         rim_edges(making, other.holes) + rim_edges(making, job.holes) <= most_edges_with_border;
}

/// The surface continued from some rims arrives at others: one patch for all of them, where that may be.
void join_or_refuse(Making& making, OpenJob& job) {
  std::vector<OpenJob*> others;
  for (const Index hole : job.candidate->arrives_at) {
    const auto found = std::ranges::find_if(making.jobs, [&](const OpenJob& other) {
      return std::ranges::binary_search(other.holes, hole) && may_be_joined(making, job, other);
    });
    if (found == making.jobs.end()) {
      job.refuse("the surface around it goes on to hole " + std::to_string(hole));
      return;
    }
    if (std::ranges::find(others, &*found) == others.end()) others.push_back(&*found);
  }
  job.refuse("");
  FillJob whole = job;
  std::vector<OpenJob> parts;
  others.push_back(&job);
  for (OpenJob* part : others) {
    if (part->holes.front() < whole.holes.front()) whole.settings = part->settings;
    whole.holes.insert(whole.holes.end(), part->holes.begin(), part->holes.end());
    parts.push_back(*part);
    part->is_gone = true;
  }
  sort_unique(whole.holes);
  making.jobs.push_back(begun(making, std::move(whole)));
  making.jobs.back().parts = std::move(parts);
}

/// Those not yet known together: one pass over the mesh for all.
void judge_alone(Making& making, std::span<OpenJob* const> tried, Progress& progress) {
  StageCache* const cache = making.options.cache;
  std::vector<OpenJob*> unknown;
  std::vector<HolePatch> candidates;
  for (OpenJob* job : tried) {
    making.numbers.add_removed(*job->candidate, job->key.add(making.options.precision));
    if (const auto verdict = kept<PatchVerdict>(cache, verdict_stage, job->key)) {
      job->alone = *verdict;
      continue;
    }
    unknown.push_back(job);
    candidates.push_back(*job->candidate);
  }
  const std::vector<PatchVerdict> verdicts = making.verifier.judge(candidates, progress);
  for (std::size_t i = 0; i < unknown.size(); ++i) {
    unknown[i]->alone = *cached<PatchVerdict>(
        cache, verdict_stage, unknown[i]->key, [&] { return verdicts[i]; },
        [](const PatchVerdict& verdict) { return sizeof verdict + verdict.fault.size(); });
  }
}

/// A patch that folds back over the surface at its rim is sound, but hardly what was there: other methods of the same
/// kind come first. @return whether it goes on to those
bool goes_on_for_fold(OpenJob& job) {
  const bool is_doubtful = job.alone.is_sound() && job.alone.max_normal_jump > doubtful_fold;
  if (!is_doubtful || job.takes_folds || !is_as_asked(job.method().maker, job)) return false;
  if (!job.folded) {
    job.folded = job.next;
    job.memory.folded = std::move(job.candidate);
  }
  job.refuse("");
  return true;
}

void settle(OpenJob& job, HolePatch patch, const PatchVerdict& verdict) {
  if (!verdict.is_sound()) {
    job.refuse(verdict.fault);
    return;
  }
  job.outcome.action = FillAction::Fill;
  job.outcome.method = name_of(job.method());
  job.outcome.max_normal_jump = verdict.max_normal_jump;
  job.outcome.min_angle = verdict.min_angle;
  if (is_as_asked(job.method().maker, job)) job.outcome.reason.clear();
  job.patch = std::move(patch);
  job.memory = {};
}

void verify(Making& making, Progress& progress) {
  for (OpenJob* job : making.pending) {
    if (job->is_pending() && job->candidate && !job->candidate->arrives_at.empty()) join_or_refuse(making, *job);
  }
  std::vector<OpenJob*> tried;
  for (OpenJob* job : making.pending) {
    if (job->is_gone) continue;
    if (!job->candidate)
      job->refuse("no patch was found");
    else if (job->candidate->rises_too_far)
      job->refuse("the patch would lead far away from its hole");
    else
      tried.push_back(job);
  }
  Progress judging = progress.step("verify patches", 0.8);
  judge_alone(making, tried, judging);
  std::erase_if(tried, [](OpenJob* job) { return goes_on_for_fold(*job); });
  std::vector<HolePatch> candidates;
  std::vector<PatchVerdict> verdicts;
  for (OpenJob* job : tried) {
    candidates.push_back(std::move(*job->candidate));
    verdicts.push_back(job->alone);
  }
  Progress comparing = progress.step("compare patches", 0.2);
  verdicts = making.verifier.accept_sound(candidates, std::move(verdicts), comparing);
  for (std::size_t i = 0; i < tried.size(); ++i) settle(*tried[i], std::move(candidates[i]), verdicts[i]);
}

/// Those that were joined in vain go on alone.
void part_failed(Making& making) {
  for (std::size_t i = 0; i < making.jobs.size(); ++i) {  // it grows
    OpenJob& job = making.jobs[i];
    if (job.is_gone || job.patch || job.is_pending() || job.parts.empty()) continue;
    job.is_gone = true;
    for (OpenJob& part : job.parts) {
      part.may_join = false;
      making.jobs.push_back(std::move(part));
    }
  }
}

/// Where the first method failed, it is looked for rims that go through the surface: mostly it doesn't, and that costs.
/// Jobs joined in vain are taken apart; those that found nothing better return to the patch that folds.
void prepare_next_round(Making& making) {
  for (OpenJob* job : making.pending) {
    if (job->is_pending() && job->next == 1 && !job->folded) leave_if_hopeless(*job, site_of(making, *job));
  }
  part_failed(making);
  for (OpenJob& job : making.jobs) {
    if (!job.is_pending() || !job.folded || job.takes_folds || is_as_asked(job.method().maker, job)) continue;
    job.next = *job.folded;
    job.takes_folds = true;
  }
}

}  // namespace

std::vector<FillJob> make_patches(const PolyMesh& mesh, const HoleAnalysis& analysis, std::vector<FillJob> jobs,
                                  const FillOptions& options, const ScanNumbers& numbers, Progress& progress) {
  if (jobs.empty()) return {};
  Making making{mesh, analysis, options, numbers};
  making.jobs.resize(jobs.size());
  for_each_part(jobs.size(), 1, options.threads, [&](std::size_t i, std::size_t) {
    OpenJob& job = making.jobs[i] = begun(making, std::move(jobs[i]));
    if (!job.detached.empty()) job.parts.push_back(begun(making, without_detached(job)));
  });
  part_failed(making);
  for (std::size_t round = 0; find_pending(making); ++round) {
    // The first round has nearly all the work; the others share the rest of the progress range.
    Progress patching = progress.step("make patches", round == 0 ? 0.7 : 0.02);
    attempt_all(making, patching);
    Progress verifying = progress.step("verify patches", round == 0 ? 0.2 : 0.01);
    verify(making, verifying);
    prepare_next_round(making);
  }
  std::vector<FillJob> results;
  for (OpenJob& job : making.jobs) {
    if (!job.is_gone && !job.waits) results.push_back(static_cast<FillJob&&>(job));
  }
  std::ranges::sort(results, {}, [](const FillJob& job) { return job.holes.front(); });
  return results;
}

}  // namespace croquis::hole_filling
