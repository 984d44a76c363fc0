// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/hole_filling/fill_findings.h"

#include <string>
#include <utility>

#include "algorithms/hole_filling/patch_confidence.h"

namespace croquis::hole_filling {
namespace {

Subject hole_subject(const PolyMesh& mesh, const Hole& hole) {
  const Vec3& at = mesh.positions[hole.vertices.front()];
  return {SubjectKind::Hole, std::to_string(hole.id), {}, {}, {at.x(), at.y(), at.z()}};
}

std::string named(const Hole& hole) {
  return "Hole " + std::to_string(hole.id) + " (" + std::to_string(hole.vertices.size()) + " edges)";
}

void tell_outer(const FillResult& result, Findings& findings) {
  std::vector<Subject> subjects;
  for (const Hole& hole : result.analysis.holes) {
    if (hole.kind == HoleClass::Outer && result.outcomes[hole.id].action == FillAction::Leave)
      subjects.push_back(hole_subject(result.mesh, hole));
  }
  if (subjects.empty()) return;
  const std::string count = subjects.size() == 1 ? "1 rim looks" : std::to_string(subjects.size()) + " rims look";
  findings.push_back(make_warning(Category::Geometry, "W_OUTER_LEFT",
                                  count + " like the border of an open surface and stayed open: choose all holes, or "
                                          "these by their numbers, to close them too.",
                                  std::move(subjects)));
}

void tell_hole(const FillResult& result, const Hole& hole, Findings& findings) {
  const HoleOutcome& outcome = result.outcomes[hole.id];
  if (outcome.action == FillAction::Failed)
    findings.push_back(make_warning(Category::Geometry, "W_HOLE_FAILED",
                                    named(hole) + " stays open, since no method made a sound patch (" + outcome.reason +
                                        "): look at the surface around it.",
                                    {hole_subject(result.mesh, hole)}));
  else if (outcome.action == FillAction::Fill && !outcome.reason.empty())
    findings.push_back(make_warning(
        Category::Geometry, "W_FALLBACK",
        named(hole) + " was filled by " + outcome.method + " instead (" + outcome.reason + "): look at its shape.",
        {hole_subject(result.mesh, hole)}));
}

/// One warning for all of them: their shape is a guess, whatever the method.
void tell_low_confidence(const FillResult& result, Findings& findings) {
  std::vector<Subject> subjects;
  for (const Hole& hole : result.analysis.holes) {
    const HoleOutcome& outcome = result.outcomes[hole.id];
    if (outcome.action == FillAction::Fill && outcome.confidence < low_confidence)
      subjects.push_back(hole_subject(result.mesh, hole));
  }
  if (subjects.empty()) return;
  const std::string count = subjects.size() == 1 ? "1 hole was" : std::to_string(subjects.size()) + " holes were";
  findings.push_back(make_warning(Category::Geometry, "W_LOW_CONFIDENCE",
                                  count + " filled far beyond what the surface around tells: look at the shape, or "
                                          "choose flat patches.",
                                  std::move(subjects)));
}

}  // namespace

Findings fill_findings(const FillResult& result) {
  Findings findings = result.analysis.warnings;
  tell_outer(result, findings);
  for (const Hole& hole : result.analysis.holes) tell_hole(result, hole, findings);
  tell_low_confidence(result, findings);
  return findings;
}

}  // namespace croquis::hole_filling
