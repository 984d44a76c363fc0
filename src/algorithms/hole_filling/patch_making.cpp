// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/hole_filling/patch_making.h"

#include <algorithm>
#include <atomic>
#include <deque>
#include <functional>
#include <span>
#include <thread>
#include <utility>

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

/// A job under way: its methods are tried one after the other.
struct PatchJob {
  FillJob job;
  std::vector<Method> methods;
  std::size_t next = 0;  ///< of the methods
  StageKey key;          ///< of the patch under way
  std::optional<HolePatch> candidate;
  SiteMemory memory;
  PatchVerdict alone;  ///< of the candidate, against the mesh
  MadePatch result;
  std::vector<PatchJob> parts;  ///< those it was made of, each at its next method: tried alone when this has no patch
  std::optional<std::size_t> folded;  ///< the first method whose patch was sound but folded back at the rim
  bool takes_folds = false;           ///< since no other method of the kind did better
  bool may_join = true;
  bool is_gone = false;  ///< has become part of another

  bool is_pending() const { return !job.waits && !is_gone && !result.patch && next < methods.size(); }
  bool is_waiting() const { return job.waits && !is_gone; }
  bool holds(Index hole) const { return std::ranges::binary_search(job.holes, hole); }
  const Method& method() const { return methods[next]; }

  /// On to the next method. The first one's fault is reported.
  void refuse(const std::string& fault) {
    std::string& first = result.outcome.reason;
    if (first.empty() && !fault.empty()) first = option_of(name_of(method())) + ": " + fault;
    candidate.reset();
    ++next;
  }
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

class PatchMaking {
 public:
  PatchMaking(const PolyMesh& mesh, const HoleAnalysis& analysis, const FillOptions& options,
              const ScanNumbers& numbers)
      : mesh_(mesh),
        analysis_(analysis),
        options_(options),
        numbers_(numbers),
        verifier_(mesh, analysis, options.precision, options.threads),
        search_(mesh, analysis.view) {}

  std::vector<MadePatch> run(std::vector<FillJob> jobs, Progress& progress) {
    jobs_.resize(jobs.size());
    for_each_part(jobs.size(), 1, options_.threads, [&](std::size_t i, std::size_t) {
      jobs_[i] = begun(std::move(jobs[i]));
      if (!jobs_[i].job.detached.empty()) jobs_[i].parts.push_back(begun(without_detached(jobs_[i].job)));
    });
    part_failed();
    for (std::size_t round = 0; find_pending(); ++round) {
      // The first round has nearly all the work; the others share the rest of the progress range.
      Progress patching = progress.step("make patches", round == 0 ? 0.7 : 0.02);
      attempt_all(patching);
      Progress verifying = progress.step("verify patches", round == 0 ? 0.2 : 0.01);
      verify(verifying);
      leave_hopeless();
      part_failed();
      return_to_folded();
    }
    return take_results();
  }

 private:
  PatchJob begun(FillJob job) const {
    PatchJob started;
    started.result.holes = job.holes;
    started.result.outcome.action = FillAction::Failed;
    started.job = std::move(job);
    if (started.job.waits) return started;
    HoleSite site = site_of(started.job);
    site.memory = &started.memory;
    started.methods = methods_for(site, started.job.is_cap);
    if (site.holes.size() > 1 || is_wide(analysis_, site.holes.front())) leave_if_hopeless(started, site);
    return started;
  }

  /// Where a rim itself goes through the surface no method has a sound patch.
  static void leave_if_hopeless(PatchJob& job, const HoleSite& site) {
    if (!rims_cross_surface(site)) return;
    job.result.outcome.reason = "its rim goes through the surface";
    job.next = job.methods.size();
  }

  std::vector<MadePatch> take_results() {
    std::vector<MadePatch> results;
    for (PatchJob& job : jobs_) {
      if (!job.is_gone && !job.job.waits) results.push_back(std::move(job.result));
    }
    std::ranges::sort(results, {}, [](const MadePatch& made) { return made.holes.front(); });
    return results;
  }

  HoleSite site_of(const FillJob& job) const {
    HoleSite site = make_site(mesh_, analysis_, job.holes, verifier_.rim_edges());
    site.settings = adapted(job.settings, options_.preset);
    site.preset = options_.preset;
    site.most_triangles = options_.most_patch_triangles;
    site.bridge = job.bridge;
    site.search = &search_;
    return site;
  }

  /// Caps come last: a rim that looked like the border of a piece by itself may prove to be an island's, when the
  /// surface around another hole goes on to it.
  bool find_pending() {
    pending_.clear();
    for (const bool is_cap : {false, true}) {
      for (PatchJob& job : jobs_) {
        if (job.is_pending() && job.job.is_cap == is_cap) pending_.push_back(&job);
      }
      if (!pending_.empty()) return true;
    }
    return false;
  }

  std::size_t rim_edges(const std::vector<Index>& holes) const {
    std::size_t count = 0;
    for (const Index hole : holes) count += analysis_.holes[hole].vertices.size();
    return count;
  }

  /// Reports the number of patches made, and from the calling thread alone. Long rims first, so that no thread has a
  /// long one left when the others have finished.
  void attempt_all(Progress& progress) {
    std::vector<PatchJob*> order = pending_;
    std::ranges::stable_sort(order, std::greater(), [&](const PatchJob* job) { return rim_edges(job->job.holes); });
    const auto caller = std::this_thread::get_id();
    std::atomic<std::size_t> done = 0;
    Progress silent = progress.silent();
    progress.report(0, pending_.size());
    for_each_part(pending_.size(), 1, options_.threads, silent, [&](std::size_t begin, std::size_t end) {
      Progress own = progress.silent();
      for (std::size_t i = begin; i < end; ++i) attempt(*order[i], own);
      done += end - begin;
      if (std::this_thread::get_id() == caller) progress.report(done, pending_.size());
    });
    progress.report(pending_.size(), pending_.size());
  }

  void attempt(PatchJob& job, Progress& progress) const {
    HoleSite site = site_of(job.job);
    site.memory = &job.memory;
    job.key = key_of(job, site);
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
      if (patch) patch = numbers_.in_scan(std::move(*patch));
      return patch;
    };
    const auto made =
        cached<std::optional<HolePatch>>(options_.cache, patch_stage, job.key, make,
                                         [](const std::optional<HolePatch>& patch) { return bytes_of(patch); });
    job.candidate.reset();
    if (*made) job.candidate = numbers_.in_mesh(**made, job.job.holes);
    if (job.candidate && options_.precision == Precision::Single) round_to_single(job.candidate->points);
  }

  /// Of all that a method may look at.
  StageKey key_of(const PatchJob& job, const HoleSite& site) const {
    StageKey key;
    numbers_.add_surroundings(site, key);
    key.add(job.job.bridge).add(job.job.is_cap).add(site.polygon.blocked).add(job.job.settings);
    key.add(options_.preset).add(options_.most_patch_triangles).add(job.next);
    return key;
  }

  void verify(Progress& progress) {
    for (PatchJob* job : pending_) {
      if (job->is_pending() && job->candidate && !job->candidate->arrives_at.empty()) join_or_refuse(*job);
    }
    std::vector<PatchJob*> tried;
    for (PatchJob* job : pending_) {
      if (job->is_gone) continue;
      if (!job->candidate)
        job->refuse("no patch was found");
      else if (job->candidate->rises_too_far)
        job->refuse("the patch would lead far away from its hole");
      else
        tried.push_back(job);
    }
    Progress judging = progress.step("verify patches", 0.8);
    judge_alone(tried, judging);
    std::erase_if(tried, [](PatchJob* job) { return goes_on_for_fold(*job); });
    std::vector<HolePatch> candidates;
    std::vector<PatchVerdict> verdicts;
    for (PatchJob* job : tried) {
      candidates.push_back(std::move(*job->candidate));
      verdicts.push_back(job->alone);
    }
    Progress comparing = progress.step("compare patches", 0.2);
    verdicts = verifier_.accept_sound(candidates, std::move(verdicts), comparing);
    for (std::size_t i = 0; i < tried.size(); ++i) settle(*tried[i], std::move(candidates[i]), verdicts[i]);
  }

  /// Those not yet known together: one pass over the mesh for all.
  void judge_alone(std::span<PatchJob* const> tried, Progress& progress) {
    std::vector<PatchJob*> unknown;
    std::vector<HolePatch> candidates;
    for (PatchJob* job : tried) {
      numbers_.add_removed(*job->candidate, job->key.add(options_.precision));
      if (const auto verdict = kept<PatchVerdict>(options_.cache, verdict_stage, job->key)) {
        job->alone = *verdict;
        continue;
      }
      unknown.push_back(job);
      candidates.push_back(*job->candidate);
    }
    const std::vector<PatchVerdict> verdicts = verifier_.judge(candidates, progress);
    for (std::size_t i = 0; i < unknown.size(); ++i) {
      unknown[i]->alone = *cached<PatchVerdict>(
          options_.cache, verdict_stage, unknown[i]->key, [&] { return verdicts[i]; },
          [](const PatchVerdict& verdict) { return sizeof verdict + verdict.fault.size(); });
    }
  }

  /// Whether a cap closes a piece of surface that a job's own holes are in: no island of theirs.
  bool is_own_border(const PatchJob& job, const PatchJob& cap) const {
    return cap.job.is_cap && std::ranges::any_of(job.job.holes, [&](Index hole) {
             return analysis_.holes[hole].component == analysis_.holes[cap.job.holes.front()].component;
           });
  }

  /// Whether the border that waits is of a smaller piece than one of the job's holes, and of none of theirs.
  bool is_island_of(const PatchJob& border, const PatchJob& job) const {
    const Index piece = analysis_.holes[border.job.holes.front()].component;
    double widest = 0;
    for (const Index id : job.job.holes) {
      const Index own = analysis_.holes[id].component;
      if (own == piece) return false;
      widest = std::max(widest, analysis_.component_size[own]);
    }
    return rim_edges(border.job.holes) + rim_edges(job.job.holes) <= most_edges_with_border &&
           analysis_.component_size[piece] < widest;
  }

  bool may_be_joined(const PatchJob& job, const PatchJob& other) const {
    if (!job.may_join || !other.may_join || is_own_border(job, other)) return false;
    return other.is_pending() || (other.is_waiting() && is_island_of(other, job));
  }

  /// The surface continued from some rims arrives at others: one patch for all of them, where those are to be filled
  /// and aren't yet, or are of islands.
  void join_or_refuse(PatchJob& job) {
    std::vector<PatchJob*> others;
    for (const Index hole : job.candidate->arrives_at) {
      const auto found = std::ranges::find_if(
          jobs_, [&](const PatchJob& other) { return other.holds(hole) && may_be_joined(job, other); });
      if (found == jobs_.end()) {
        job.refuse("the surface around it goes on to hole " + std::to_string(hole));
        return;
      }
      if (std::ranges::find(others, &*found) == others.end()) others.push_back(&*found);
    }
    job.refuse("");
    FillJob whole = job.job;
    std::vector<PatchJob> parts;
    others.push_back(&job);
    for (PatchJob* part : others) {
      if (part->job.holes.front() < whole.holes.front()) whole.settings = part->job.settings;
      whole.holes.insert(whole.holes.end(), part->job.holes.begin(), part->job.holes.end());
      parts.push_back(*part);
      part->is_gone = true;
    }
    std::ranges::sort(whole.holes);
    whole.holes.erase(std::unique(whole.holes.begin(), whole.holes.end()), whole.holes.end());
    jobs_.push_back(begun(std::move(whole)));
    jobs_.back().parts = std::move(parts);
  }

  /// Others cost little at first: looked at where the first method failed.
  void leave_hopeless() {
    for (PatchJob* job : pending_) {
      if (job->is_pending() && job->next == 1 && !job->folded) leave_if_hopeless(*job, site_of(job->job));
    }
  }

  /// Those that were joined in vain go on alone.
  void part_failed() {
    for (std::size_t i = 0; i < jobs_.size(); ++i) {  // it grows
      PatchJob& job = jobs_[i];
      if (job.is_gone || job.result.patch || job.is_pending() || job.parts.empty()) continue;
      job.is_gone = true;
      for (PatchJob& part : job.parts) {
        part.may_join = false;
        jobs_.push_back(std::move(part));
      }
    }
  }

  /// A patch that folds back over the surface at its rim is sound, but hardly what was there: other methods of the same
  /// kind come first. @return whether it goes on to those
  static bool goes_on_for_fold(PatchJob& job) {
    const bool is_doubtful = job.alone.is_sound() && job.alone.max_normal_jump > doubtful_fold;
    if (!is_doubtful || job.takes_folds || !is_as_asked(job.method().maker, job.job)) return false;
    if (!job.folded) {
      job.folded = job.next;
      job.memory.folded = std::move(job.candidate);
    }
    job.refuse("");
    return true;
  }

  /// Those that found nothing better.
  void return_to_folded() {
    for (PatchJob& job : jobs_) {
      if (!job.is_pending() || !job.folded || job.takes_folds || is_as_asked(job.method().maker, job.job)) continue;
      job.next = *job.folded;
      job.takes_folds = true;
    }
  }

  static void settle(PatchJob& job, HolePatch patch, const PatchVerdict& verdict) {
    if (!verdict.is_sound()) {
      job.refuse(verdict.fault);
      return;
    }
    HoleOutcome& outcome = job.result.outcome;
    outcome.action = FillAction::Fill;
    outcome.method = name_of(job.method());
    outcome.max_normal_jump = verdict.max_normal_jump;
    outcome.min_angle = verdict.min_angle;
    if (is_as_asked(job.method().maker, job.job)) outcome.reason.clear();
    job.result.patch = std::move(patch);
    job.memory = {};
  }

  const PolyMesh& mesh_;
  const HoleAnalysis& analysis_;
  const FillOptions& options_;
  const ScanNumbers& numbers_;
  PatchVerifier verifier_;
  SurfaceSearch search_;
  std::deque<PatchJob> jobs_;  ///< grows while others are pointed at
  std::vector<PatchJob*> pending_;
};

}  // namespace

std::vector<MadePatch> make_patches(const PolyMesh& mesh, const HoleAnalysis& analysis, std::vector<FillJob> jobs,
                                    const FillOptions& options, const ScanNumbers& numbers, Progress& progress) {
  if (jobs.empty()) return {};
  return PatchMaking(mesh, analysis, options, numbers).run(std::move(jobs), progress);
}

}  // namespace croquis::hole_filling
