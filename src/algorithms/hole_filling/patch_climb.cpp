// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/hole_filling/patch_climb.h"

#include <algorithm>
#include <atomic>
#include <deque>
#include <functional>
#include <span>
#include <thread>
#include <utility>

#include "algorithms/hole_filling/patching/near_scene.h"
#include "algorithms/hole_filling/patching/patch_height.h"
#include "algorithms/hole_filling/patching/patch_ladder.h"
#include "algorithms/hole_filling/patching/rim_crossing.h"
#include "algorithms/hole_filling/patching/site_memory.h"
#include "croquis/base/parallel.h"
#include "croquis/base/stage_key.h"
#include "croquis/geometry/single_precision.h"
#include "croquis/hole_filling/fill_findings.h"
#include "croquis/hole_filling/wide_holes.h"

namespace croquis::hole_filling {
namespace {

constexpr const char* patch_stage = "fill/patch/2";
constexpr const char* verdict_stage = "fill/verdict/2";

/// Rims of more edges aren't joined with a border on trial: it takes ten seconds, and fails mostly.
constexpr std::size_t most_edges_with_border = 500;

/// A job on its ladder.
struct Climber {
  FillJob job;
  Ladder ladder;
  std::size_t rung = 0;
  StageKey key;  ///< of the patch under way
  std::optional<HolePatch> candidate;
  SiteMemory memory;
  PatchVerdict alone;  ///< of the candidate, against the mesh
  ClimbedJob result;
  std::vector<Climber> joined;  ///< those it was made of, each on its next rung: tried alone when this one has no patch
  std::optional<std::size_t> folded_rung;  ///< the first whose patch was sound but folded back at the rim
  bool takes_folds = false;                ///< since no other method of the kind did better
  bool may_join = true;
  bool is_gone = false;  ///< has become part of another

  bool is_pending() const { return !job.waits && !is_gone && !result.patch && rung < ladder.size(); }
  bool is_waiting() const { return job.waits && !is_gone; }
  bool holds(Index hole) const { return std::binary_search(job.holes.begin(), job.holes.end(), hole); }
  bool is_back_at_folded() const { return takes_folds && folded_rung == rung; }
  std::string method() const { return ladder[rung]->method(); }
};

std::size_t bytes_of(const Attempt& attempt) {
  if (!attempt.patch) return sizeof attempt;
  return sizeof attempt + attempt.patch->points.size() * sizeof(Vec3) +
         attempt.patch->triangles.size() * sizeof(std::array<Index, 3>);
}

/// Methods for the same wish have names that begin alike; any of them is as asked.
bool is_as_asked(const std::string& method, const FillJob& job) {
  if (job.is_cap || job.wish.fairness == Fairness::Flat) return false;
  if (job.wish.fairness == Fairness::Implicit || !job.wish.through.empty())
    return method.starts_with("implicit") || method == "creased";
  return method.starts_with(job.wish.fairness == Fairness::Tangent ? "cgal-c1" : "cgal-c2");
}

class Climb {
 public:
  Climb(const PolyMesh& mesh, const HoleAnalysis& analysis, const FillOptions& options, const ScanNumbers& numbers)
      : mesh_(mesh),
        analysis_(analysis),
        options_(options),
        numbers_(numbers),
        verifier_(mesh, analysis, options.precision, options.threads),
        search_(mesh, analysis.view) {}

  std::vector<ClimbedJob> run(std::vector<FillJob> jobs, Progress& progress) {
    climbers_.resize(jobs.size());
    for_each_part(jobs.size(), 1, options_.threads, [&](std::size_t begin, std::size_t) {
      Climber& climber = climbers_[begin];
      if (jobs[begin].waits) {
        climber = waiting(std::move(jobs[begin]));
        return;
      }
      climber = climber_for(std::move(jobs[begin]));
      if (!climber.job.strays.empty()) climber.joined.push_back(climber_for(without_strays(climber.job)));
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
  Climber climber_for(FillJob job) const {
    Climber climber;
    HoleSite site = site_of(job);
    site.memory = &climber.memory;
    climber.ladder = ladder_for(site, options_.preset, job.is_cap, options_.most_patch_triangles);
    climber.result.holes = job.holes;
    climber.job = std::move(job);
    if (site.holes.size() > 1 || is_wide(analysis_, site.holes.front())) leave_if_hopeless(climber, site);
    return climber;
  }

  static Climber waiting(FillJob job) {
    Climber climber;
    climber.result.holes = job.holes;
    climber.job = std::move(job);
    return climber;
  }

  /// Where a rim itself goes through the surface no method has a sound patch.
  static void leave_if_hopeless(Climber& climber, const HoleSite& site) {
    if (!rims_cross_surface(site)) return;
    climber.result.first_fault = "its rim goes through the surface";
    climber.rung = climber.ladder.size();
  }

  /// By their lowest holes.
  std::vector<ClimbedJob> take_results() {
    std::vector<ClimbedJob> results;
    for (Climber& climber : climbers_) {
      if (!climber.is_gone && !climber.job.waits) results.push_back(std::move(climber.result));
    }
    std::ranges::sort(results, {}, [](const ClimbedJob& job) { return job.holes.front(); });
    return results;
  }

  HoleSite site_of(const FillJob& job) const {
    HoleSite site = make_site(mesh_, analysis_, job.holes, verifier_.rim_edges());
    site.wish = job.wish;
    site.bridge = job.bridge;
    site.search = &search_;
    return site;
  }

  /// Caps come last: a rim that looked like the border of a piece by itself may prove to be an island's, when the
  /// surface around another hole goes on to it.
  bool find_pending() {
    pending_.clear();
    for (const bool is_cap : {false, true}) {
      for (Climber& climber : climbers_) {
        if (climber.is_pending() && climber.job.is_cap == is_cap) pending_.push_back(&climber);
      }
      if (!pending_.empty()) return true;
    }
    return false;
  }

  std::size_t rim_edges(const Climber& climber) const {
    std::size_t count = 0;
    for (const Index hole : climber.job.holes) count += analysis_.holes[hole].vertices.size();
    return count;
  }

  /// Reports the number of patches made, and from the calling thread alone. Long rims first, so that no thread has a
  /// long one left when the others have finished.
  void attempt_all(Progress& progress) {
    std::vector<Climber*> order = pending_;
    std::ranges::stable_sort(order, std::greater(), [&](const Climber* climber) { return rim_edges(*climber); });
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

  void attempt(Climber& climber, Progress& progress) const {
    HoleSite site = site_of(climber.job);
    site.memory = &climber.memory;
    climber.key = key_of(climber, site);
    SiteMemory* memory = SiteMemory::of(site);
    if (climber.is_back_at_folded() && memory->folded) {
      climber.candidate = memory->folded;
      return;
    }
    const auto made = cached<Attempt>(
        options_.cache, patch_stage, climber.key,
        [&] {
          return numbers_.in_scan(kept_low(site, climber.ladder[climber.rung]->attempt(site, progress), progress));
        },
        [](const Attempt& attempt) { return bytes_of(attempt); });
    climber.candidate = numbers_.in_mesh(*made, climber.job.holes);
    if (climber.candidate && options_.precision == Precision::Single) round_to_single(climber.candidate->points);
  }

  /// The patch, or only the word that it rises too far.
  std::optional<HolePatch> kept_low(const HoleSite& site, std::optional<HolePatch> patch, Progress& progress) const {
    if (patch && rises_too_far(site, *patch, options_.most_patch_triangles, progress)) {
      patch = HolePatch{site.holes, {}, {}};
      patch->rises_too_far = true;
    }
    return patch;
  }

  /// Of all that a method may look at.
  StageKey key_of(const Climber& climber, const HoleSite& site) const {
    const FillJob& job = climber.job;
    StageKey key;
    numbers_.add_surroundings(site, key);
    key.add(job.bridge).add(job.is_cap).add(site.polygon.blocked).add(job.wish);
    key.add(options_.preset).add(options_.most_patch_triangles).add(climber.rung);
    return key;
  }

  void verify(Progress& progress) {
    for (Climber* climber : pending_) {
      if (climber->is_pending() && climber->candidate && !climber->candidate->arrives_at.empty())
        join_or_fail(*climber);
    }
    std::vector<Climber*> tried;
    for (Climber* climber : pending_) {
      if (climber->is_gone) continue;
      if (!climber->candidate)
        refuse(*climber, "no patch was found");
      else if (climber->candidate->rises_too_far)
        refuse(*climber, "the patch would lead far away from its hole");
      else
        tried.push_back(climber);
    }
    Progress judging = progress.step("verify patches", 0.8);
    judge_alone(tried, judging);
    std::erase_if(tried, [](Climber* climber) { return goes_on_for_fold(*climber); });
    std::vector<HolePatch> candidates;
    std::vector<PatchVerdict> verdicts;
    for (Climber* climber : tried) {
      candidates.push_back(std::move(*climber->candidate));
      verdicts.push_back(climber->alone);
    }
    Progress comparing = progress.step("compare patches", 0.2);
    verdicts = verifier_.accept_sound(candidates, std::move(verdicts), comparing);
    for (std::size_t i = 0; i < tried.size(); ++i) settle(*tried[i], std::move(candidates[i]), verdicts[i]);
  }

  /// Those not yet known together: one pass over the mesh for all.
  void judge_alone(std::span<Climber* const> tried, Progress& progress) {
    std::vector<Climber*> unknown;
    std::vector<HolePatch> candidates;
    for (Climber* climber : tried) {
      numbers_.add_removed(*climber->candidate, climber->key.add(options_.precision));
      if (const auto verdict = kept<PatchVerdict>(options_.cache, verdict_stage, climber->key)) {
        climber->alone = *verdict;
        continue;
      }
      unknown.push_back(climber);
      candidates.push_back(*climber->candidate);
    }
    const std::vector<PatchVerdict> verdicts = verifier_.judge(candidates, progress);
    for (std::size_t i = 0; i < unknown.size(); ++i) {
      unknown[i]->alone = *cached<PatchVerdict>(
          options_.cache, verdict_stage, unknown[i]->key, [&] { return verdicts[i]; },
          [](const PatchVerdict& verdict) { return sizeof verdict + verdict.fault.size(); });
    }
  }

  /// Whether a cap closes a piece of surface that a climber's own holes are in: no island of theirs.
  bool is_own_border(const Climber& climber, const Climber& cap) const {
    return cap.job.is_cap && std::ranges::any_of(climber.job.holes, [&](Index hole) {
             return analysis_.holes[hole].component == analysis_.holes[cap.job.holes.front()].component;
           });
  }

  /// Whether the border that waits is of a smaller piece than one of the climber's holes, and of none of theirs.
  bool is_island_of(const Climber& border, const Climber& climber) const {
    const Index piece = analysis_.holes[border.job.holes.front()].component;
    double widest = 0;
    std::size_t edges = analysis_.holes[border.job.holes.front()].vertices.size();
    for (const Index id : climber.job.holes) {
      edges += analysis_.holes[id].vertices.size();
      const Index own = analysis_.holes[id].component;
      if (own == piece) return false;
      widest = std::max(widest, analysis_.component_size[own]);
    }
    return edges <= most_edges_with_border && analysis_.component_size[piece] < widest;
  }

  bool may_be_joined(const Climber& climber, const Climber& other) const {
    if (!climber.may_join || !other.may_join || is_own_border(climber, other)) return false;
    return other.is_pending() || (other.is_waiting() && is_island_of(other, climber));
  }

  /// The surface continued from some rims arrives at others: one patch for all of them, where those are to be filled
  /// and aren't yet, or are of islands.
  void join_or_fail(Climber& climber) {
    std::vector<Climber*> others;
    for (const Index hole : climber.candidate->arrives_at) {
      const auto found =
          std::ranges::find_if(climbers_, [&](const Climber& c) { return c.holds(hole) && may_be_joined(climber, c); });
      if (found == climbers_.end()) {
        refuse(climber, "the surface around it goes on to hole " + std::to_string(hole));
        return;
      }
      if (std::ranges::find(others, &*found) == others.end()) others.push_back(&*found);
    }
    refuse(climber, "");
    FillJob job = climber.job;
    std::vector<Climber> joined;
    others.push_back(&climber);
    for (Climber* part : others) {
      if (part->job.holes.front() < job.holes.front()) job.wish = part->job.wish;
      job.holes.insert(job.holes.end(), part->job.holes.begin(), part->job.holes.end());
      joined.push_back(*part);
      part->is_gone = true;
    }
    std::ranges::sort(job.holes);
    job.holes.erase(std::unique(job.holes.begin(), job.holes.end()), job.holes.end());
    Climber whole = climber_for(std::move(job));
    whole.joined = std::move(joined);
    climbers_.push_back(std::move(whole));
  }

  /// Others cost little at first: looked at where the first method failed.
  void leave_hopeless() {
    for (Climber* climber : pending_) {
      if (climber->is_pending() && climber->rung == 1 && !climber->folded_rung)
        leave_if_hopeless(*climber, site_of(climber->job));
    }
  }

  /// Those that were joined in vain go on alone.
  void part_failed() {
    for (std::size_t i = 0; i < climbers_.size(); ++i) {  // it grows
      Climber& climber = climbers_[i];
      const bool is_done = climber.is_gone || climber.result.patch || climber.is_pending();
      if (is_done || climber.joined.empty()) continue;
      climber.is_gone = true;
      for (Climber& part : climber.joined) {
        part.may_join = false;
        climbers_.push_back(std::move(part));
      }
    }
  }

  /// A patch that folds back over the surface at its rim is sound, but hardly what was there: other methods of the same
  /// type come first. @return whether it goes on to those
  static bool goes_on_for_fold(Climber& climber) {
    const bool is_doubtful = climber.alone.is_sound() && climber.alone.max_normal_jump > doubtful_fold;
    if (!is_doubtful || climber.takes_folds || !is_as_asked(climber.method(), climber.job)) return false;
    if (!climber.folded_rung) {
      climber.folded_rung = climber.rung;
      climber.memory.folded = std::move(climber.candidate);
    }
    refuse(climber, "");
    return true;
  }

  /// Those that found nothing better.
  void return_to_folded() {
    for (Climber& climber : climbers_) {
      const bool is_at_end = climber.is_pending() && !is_as_asked(climber.method(), climber.job);
      if (!is_at_end || !climber.folded_rung || climber.takes_folds) continue;
      climber.rung = *climber.folded_rung;
      climber.takes_folds = true;
    }
  }

  /// On to the next method. The first one's fault is reported.
  static void refuse(Climber& climber, const std::string& fault) {
    if (climber.result.first_fault.empty() && !fault.empty())
      climber.result.first_fault = option_of(climber.method()) + ": " + fault;
    climber.candidate.reset();
    ++climber.rung;
  }

  static void settle(Climber& climber, HolePatch patch, const PatchVerdict& verdict) {
    if (!verdict.is_sound()) {
      refuse(climber, verdict.fault);
      return;
    }
    climber.result.verdict = verdict;
    climber.result.method = patch.method.empty() ? climber.method() : patch.method;
    if (is_as_asked(climber.result.method, climber.job)) climber.result.first_fault.clear();
    climber.result.patch = std::move(patch);
    climber.memory = {};
  }

  const PolyMesh& mesh_;
  const HoleAnalysis& analysis_;
  const FillOptions& options_;
  const ScanNumbers& numbers_;
  PatchVerifier verifier_;
  SurfaceSearch search_;
  std::deque<Climber> climbers_;  ///< grows while others are pointed at
  std::vector<Climber*> pending_;
};

}  // namespace

std::vector<ClimbedJob> climb(const PolyMesh& mesh, const HoleAnalysis& analysis, std::vector<FillJob> jobs,
                              const FillOptions& options, const ScanNumbers& numbers, Progress& progress) {
  if (jobs.empty()) return {};
  return Climb(mesh, analysis, options, numbers).run(std::move(jobs), progress);
}

}  // namespace croquis::hole_filling
