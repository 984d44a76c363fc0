// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cstdio>
#include <string>
#include <utility>

#include "algorithms/hole_filling/analysis/box_search.h"
#include "croquis/base/text.h"
#include "croquis/hole_filling/fill_holes.h"
#include "croquis/hole_filling/hole_patch.h"

namespace croquis::hole_filling {
namespace {

Subject hole_subject(const PolyMesh& mesh, const Hole& hole) {
  const Vec3& at = mesh.positions[hole.vertices.front()];
  return numbered_subject(SubjectKind::Hole, hole.id, {at.x(), at.y(), at.z()});
}

void report_outer(const PolyMesh& scan, const FillResult& result, Findings& findings) {
  std::vector<Subject> subjects;
  for (const Hole& hole : result.analysis.holes) {
    if (hole.kind == HoleClass::Outer && result.outcomes[hole.id].action == FillAction::Leave)
      subjects.push_back(hole_subject(scan, hole));
  }
  if (subjects.empty()) return;
  const bool one = subjects.size() == 1;
  const std::string count = one ? "1 rim looks" : std::to_string(subjects.size()) + " rims look";
  const std::string choice =
      one ? "this one by its number, to close it too." : "these by their numbers, to close them too.";
  findings.push_back(
      make_warning(Category::Geometry, "W_OUTER_LEFT",
                   count + " like the border of an open surface and stayed open: choose all holes, or " + choice,
                   std::move(subjects)));
}

/// "Holes 3, 7 and 9", or with many the first of them and how many more.
std::string names_of(const std::vector<Subject>& subjects) {
  constexpr std::size_t most_named = 10;
  if (subjects.size() == 1) return "Hole " + name_of(subjects[0]);
  const std::size_t named = std::min(subjects.size() - 1, most_named);
  std::string text = "Holes " + name_of(subjects[0]);
  for (std::size_t i = 1; i < named; ++i) text += ", " + name_of(subjects[i]);
  const std::size_t left = subjects.size() - named;
  return text + " and " + (left == 1 ? name_of(subjects.back()) : std::to_string(left) + " more");
}

/// "Hole 3 was filled", "Holes 3 and 5 were filled".
std::string filled(const std::vector<Subject>& holes) {
  return names_of(holes) + (holes.size() == 1 ? " was filled " : " were filled ");
}

/// Triangles that patches were made past: the rims that they hang at, and how many.
void report_detached(const PolyMesh& scan, const FillResult& result, Findings& findings) {
  std::vector<Subject> subjects;
  std::size_t triangles = 0;
  for (const Hole& hole : result.analysis.holes) {
    std::size_t own = 0;
    for (const Index other : hole.companions) {
      const HoleOutcome& outcome = result.outcomes[other];
      if (outcome.action == FillAction::Leave && outcome.reason == hangs_at_rim)
        own += result.analysis.holes[other].vertices.size() - 2;
    }
    if (own == 0 || result.outcomes[hole.id].action != FillAction::Fill) continue;
    subjects.push_back(hole_subject(scan, hole));
    triangles += own;
  }
  if (subjects.empty()) return;
  const bool one = triangles == 1;
  const std::string sentence = names_of(subjects) + (subjects.size() == 1 ? " was" : " were") + " closed past " +
                               counted(triangles, "triangle that hangs", "triangles that hang") +
                               " there by a corner and " + (one ? "stays" : "stay") + " as " +
                               (one ? "it was" : "they were") + ": delete " + (one ? "it" : "them") + " in the source.";
  findings.push_back(make_warning(Category::Geometry, "W_STRAYS", sentence, std::move(subjects)));
}

std::string rounded(double length) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", length);
  return text;
}

/// The holes filled for which something holds.
template <typename Holds>
std::vector<Subject> filled_where(const PolyMesh& scan, const FillResult& result, Holds&& holds) {
  std::vector<Subject> subjects;
  for (const Hole& hole : result.analysis.holes) {
    const HoleOutcome& outcome = result.outcomes[hole.id];
    if (outcome.action == FillAction::Fill && holds(outcome)) subjects.push_back(hole_subject(scan, hole));
  }
  return subjects;
}

/// Holes about which the same is reported.
using Alike = std::vector<std::pair<const HoleOutcome*, std::vector<Subject>>>;

void add(const Subject& hole, const HoleOutcome& outcome, Alike& lists) {
  const auto is_alike = [&](const auto& list) {
    return list.first->method == outcome.method && list.first->reason == outcome.reason;
  };
  const auto found = std::ranges::find_if(lists, is_alike);
  if (found == lists.end())
    lists.push_back({&outcome, {hole}});
  else
    found->second.push_back(hole);
}

/// One warning for all holes that stay open, or were filled by another method, for one reason.
void report_failed(const PolyMesh& scan, const FillResult& result, Findings& findings) {
  Alike failed, replaced;
  for (const Hole& hole : result.analysis.holes) {
    const HoleOutcome& outcome = result.outcomes[hole.id];
    if (outcome.action == FillAction::Failed && outcome.reason != piece_left_out)
      add(hole_subject(scan, hole), outcome, failed);
    else if (outcome.action == FillAction::Fill && !outcome.reason.empty())
      add(hole_subject(scan, hole), outcome, replaced);
  }
  for (auto& [outcome, holes] : failed) {
    const std::string sentence = names_of(holes) + (holes.size() == 1 ? " stays" : " stay") +
                                 " open, since no patch would be sound (" + outcome->reason +
                                 "): look at the surface around, or trim the rim.";
    findings.push_back(make_warning(Category::Geometry, "W_HOLE_FAILED", sentence, std::move(holes)));
  }
  for (auto& [outcome, holes] : replaced) {
    const std::string sentence =
        filled(holes) + option_of(outcome->method) + " instead (" + outcome->reason + "): look at the shape.";
    findings.push_back(make_warning(Category::Geometry, "W_FALLBACK", sentence, std::move(holes)));
  }
}

/// One warning for all of them.
void report_doubtful(std::vector<Subject> holes, const std::string& what, Findings& findings) {
  if (holes.empty()) return;
  const std::string sentence = filled(holes) + what;
  findings.push_back(make_warning(Category::Geometry, "W_LOW_CONFIDENCE", sentence, std::move(holes)));
}

/// Their shape is a guess, whatever the method.
void report_low_confidence(const PolyMesh& scan, const FillResult& result, Findings& findings) {
  const auto is_flat = [](const HoleOutcome& o) { return option_of(o.method) == "flat"; };
  // Flat patches meet rims at any angle: they were asked for, or are reported as taken instead.
  const auto is_folded = [](const HoleOutcome& o) {
    return o.max_normal_jump > doubtful_fold && o.method != "minimal";
  };
  const auto report = [&](bool flat, const char* what) {
    const auto is_low = [&](const HoleOutcome& o) {
      return o.confidence < low_confidence && is_flat(o) == flat && !is_folded(o);
    };
    report_doubtful(filled_where(scan, result, is_low), what, findings);
  };
  report(false, "far from what the surface around them shows: look at the shape, or choose flat patches.");
  report(true,
         "by flat patches, which do not continue the surface around them: look at the shape, or leave them open.");
  report_doubtful(filled_where(scan, result, is_folded),
                  "with a fold of more than 120 degrees at the rim: look at the rim, or trim it.", findings);
}

/// Patches that lead out of the scan's box, where they make a side of it longer by over a twentieth.
void report_growth(const PolyMesh& scan, const FillResult& result, Findings& findings) {
  constexpr double greatest_growth = 0.05;
  constexpr double least_reported = 0.01;  // × diagonal: flat scans have sides of next to no length
  const Box before = box_of(scan.corners, [&](Index vertex) -> const Vec3& { return scan.positions[vertex]; });
  Box after = before;
  for (const HoleOutcome& outcome : result.outcomes) after.extend(outcome.box);
  for (const int axis : {0, 1, 2}) {
    const double side = before.sizes()[axis], grown = after.sizes()[axis];
    const double growth = grown - side;
    if (growth <= greatest_growth * side || growth <= least_reported * before.diagonal().norm()) continue;
    const auto leads_out = [&](const HoleOutcome& o) {
      return !o.box.isEmpty() && (o.box.min()[axis] < before.min()[axis] || o.box.max()[axis] > before.max()[axis]);
    };
    std::vector<Subject> holes = filled_where(scan, result, leads_out);
    const std::string sentence = filled(holes) + "beyond the box of the scan, which grows along " + "xyz"[axis] +
                                 " from " + rounded(side) + " to " + rounded(grown) +
                                 ": look at the shape, or choose flat patches.";
    findings.push_back(make_warning(Category::Geometry, "W_BOX_GROWN", sentence, std::move(holes)));
  }
}

}  // namespace

std::string option_of(std::string_view method) {
  if (method.starts_with("cgal")) return "smooth";
  if (method.starts_with("band")) return "bridged";
  return method == "minimal" || method == "avoiding" ? "flat" : "by rbf";
}

Findings fill_findings(const PolyMesh& scan, const FillResult& result) {
  Findings findings = result.analysis.warnings;
  report_outer(scan, result, findings);
  report_detached(scan, result, findings);
  report_failed(scan, result, findings);
  report_low_confidence(scan, result, findings);
  report_growth(scan, result, findings);
  return findings;
}

}  // namespace croquis::hole_filling
