// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/hole_filling/fill_holes.h"

#include <algorithm>
#include <optional>
#include <span>
#include <utility>

#include "algorithms/hole_filling/fill_findings.h"
#include "algorithms/hole_filling/patch_assembly.h"
#include "algorithms/hole_filling/patch_confidence.h"
#include "algorithms/hole_filling/patch_ladder.h"
#include "algorithms/hole_filling/single_precision.h"
#include "croquis/hole_filling/hole_choice.h"
#include "croquis/hole_filling/hole_groups.h"

namespace croquis::hole_filling {
namespace {

/// Holes that one patch joins, and how far their ladder is climbed.
struct Job {
  std::vector<Index> holes;
  const Ladder* ladder = nullptr;
  std::size_t rung = 0;
  std::string first_fault;
  std::optional<HolePatch> patch;  ///< accepted
  PatchVerdict verdict;

  bool is_pending() const { return !patch && rung < ladder->size(); }
};

class Filling {
 public:
  Filling(const PolyMesh& mesh, const FillOptions& options, HoleAnalysis analysis)
      : mesh_(mesh),
        options_(options),
        chosen_(choose_holes(analysis.holes, options)),
        wish_{options.fairness, options.implicit, options.bulge, {}},
        ladder_(ladder_for(wish_, options.preset, false, options.most_patch_triangles)),
        flat_ladder_(ladder_for(wish_, options.preset, true, options.most_patch_triangles)) {
    result_.analysis = std::move(analysis);
    make_jobs();
  }

  FillResult run(Progress& progress) {
    if (!jobs_.empty()) climb(progress);
    report_outcomes();
    assemble();
    result_.warnings = fill_findings(result_);
    return std::move(result_);
  }

 private:
  const std::vector<Hole>& holes() const { return result_.analysis.holes; }

  /// Companions that are chosen go together.
  void make_jobs() {
    HoleGroups together(holes().size());
    for (const Hole& hole : holes()) {
      for (const Index other : hole.companions) {
        if (chosen_.is_chosen[hole.id] && chosen_.is_chosen[other]) together.merge(hole.id, other);
      }
    }
    for (std::vector<Index>& group : together.lists()) {
      if (!chosen_.is_chosen[group.front()]) continue;
      const bool is_cap = options_.flat_caps && holes()[group.front()].kind == HoleClass::Outer;
      jobs_.push_back({std::move(group), is_cap ? &flat_ladder_ : &ladder_, 0, {}, {}, {}});
    }
  }

  /// In rounds: each open job makes a patch by its next method, then all are verified together.
  void climb(Progress& progress) {
    PatchVerifier verifier(mesh_, result_.analysis, options_.precision);
    const std::size_t rounds = std::max(ladder_.size(), flat_ladder_.size());
    for (std::size_t round = 0; round < rounds; ++round) {
      // The first round has nearly all the work; the others take what is left of the scale.
      Progress patching = progress.step("make patches", round == 0 ? 0.7 : 0.02);
      std::vector<Job*> tried;
      std::vector<HolePatch> candidates;
      attempt_all(verifier, tried, candidates, patching);
      Progress verifying = progress.step("verify patches", round == 0 ? 0.2 : 0.01);
      const std::vector<PatchVerdict> verdicts = verifier.accept_sound(candidates, verifying);
      for (std::size_t i = 0; i < tried.size(); ++i) settle(*tried[i], std::move(candidates[i]), verdicts[i]);
    }
  }

  void attempt_all(const PatchVerifier& verifier, std::vector<Job*>& tried, std::vector<HolePatch>& candidates,
                   Progress& progress) {
    for (std::size_t i = 0; i < jobs_.size(); ++i) {
      progress.report(static_cast<double>(i) / static_cast<double>(jobs_.size()));
      Job& job = jobs_[i];
      if (!job.is_pending()) continue;
      HoleSite site = make_site(mesh_, result_.analysis, job.holes, verifier.rim_edges());
      site.wish = wish_;
      std::optional<HolePatch> patch = (*job.ladder)[job.rung]->attempt(site, progress);
      if (!patch) {
        fail(job, "the method found no patch");
        continue;
      }
      tried.push_back(&job);
      candidates.push_back(as_stored(std::move(*patch)));
    }
  }

  HolePatch as_stored(HolePatch patch) const {
    if (options_.precision == Precision::Single) round_to_single(patch.points);
    return patch;
  }

  static void fail(Job& job, const std::string& fault) {
    if (job.rung == 0) job.first_fault = std::string((*job.ladder)[0]->method()) + ": " + fault;
    ++job.rung;
  }

  static void settle(Job& job, HolePatch patch, const PatchVerdict& verdict) {
    if (!verdict.is_sound()) {
      fail(job, verdict.fault);
      return;
    }
    job.patch = std::move(patch);
    job.verdict = verdict;
  }

  void report_outcomes() {
    result_.outcomes.resize(holes().size());
    for (std::size_t i = 0; i < holes().size(); ++i) result_.outcomes[i].reason = chosen_.reason[i];
    Index patch_number = 0;
    for (const Job& job : jobs_) {
      const double confidence = job.patch ? confidence_of(*job.patch, mesh_, result_.analysis) : 0;
      for (const Index hole : job.holes) {
        HoleOutcome& outcome = result_.outcomes[hole];
        outcome.action = job.patch ? FillAction::Fill : FillAction::Failed;
        outcome.reason = job.first_fault;
        if (!job.patch) continue;
        outcome.method = (*job.ladder)[job.rung]->method();
        outcome.max_normal_jump = job.verdict.max_normal_jump;
        outcome.min_angle = job.verdict.min_angle;
        outcome.confidence = confidence;
        outcome.patch = patch_number;
      }
      if (!job.patch) continue;
      ++patch_number;
      result_.outcomes[job.holes.front()].new_vertices = job.patch->points.size();
      result_.outcomes[job.holes.front()].new_faces = job.patch->triangles.size();
    }
  }

  void assemble() {
    std::vector<HolePatch> patches;
    for (Job& job : jobs_) {
      if (job.patch) patches.push_back(std::move(*job.patch));
    }
    result_.mesh = append_patches(mesh_, result_.analysis, patches, options_.mark_patches);
    result_.new_vertices = result_.mesh.vertex_count() - mesh_.vertex_count();
    result_.new_faces = result_.mesh.face_count() - mesh_.face_count();
  }

  const PolyMesh& mesh_;
  const FillOptions& options_;
  HoleChoice chosen_;
  PatchWish wish_;
  Ladder ladder_, flat_ladder_;
  std::vector<Job> jobs_;
  FillResult result_;
};

}  // namespace

const char* to_string(FillAction action) {
  switch (action) {
    case FillAction::Fill: return "fill";
    case FillAction::Leave: return "leave";
    case FillAction::Failed: return "failed";
  }
  return "";
}

FillResult fill_holes(const PolyMesh& mesh, const FillOptions& options, Progress& progress) {
  Progress analysing = progress.step("analyse holes", 0.2);
  HoleAnalysis analysis = analyse_holes(mesh, analysing, options.analysis);
  Progress filling = progress.step("fill holes", 0.8);
  FillResult result = Filling(mesh, options, std::move(analysis)).run(filling);
  progress.report(1);
  return result;
}

}  // namespace croquis::hole_filling
