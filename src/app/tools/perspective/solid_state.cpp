// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tools/perspective/solid_state.h"

#include <QObject>
#include <algorithm>
#include <array>
#include <set>

#include "app/panels/finding_elements.h"
#include "croquis/tools/perspective/drawing_edit.h"

namespace croquis::app {
namespace {

QString faces_text(std::size_t count) {
  return count == 1 ? QObject::tr("1 face") : QObject::tr("%1 faces").arg(count);
}

/// Of all findings with that code.
std::vector<std::string> strokes_with(const Findings& findings, const std::string& code) {
  std::vector<std::string> strokes;
  for (const Finding& finding : findings) {
    if (finding.code != code) continue;
    for (std::string& id : strokes_of(finding)) strokes.push_back(std::move(id));
  }
  return strokes;
}

int count_of(const Findings& findings, const std::string& code) {
  return static_cast<int>(std::ranges::count(findings, code, &Finding::code));
}

/// Edges that bound no face, and of which the result knows.
std::vector<std::string> unused_edges(const PerspectiveDrawing& drawing, const PerspectiveResult& result) {
  std::set<std::string> used;
  for (const PerspectiveFace& face : result.faces) {
    for (const std::vector<std::string>& loop : face.strokes) used.insert(loop.begin(), loop.end());
  }
  std::vector<std::string> unused;
  for (const PerspectiveStrokeResult& one : result.strokes) {
    const PerspectiveStroke* stroke = find_stroke(drawing, one.id);
    if (stroke != nullptr && stroke->role == StrokeRole::Edge && !used.contains(one.id)) unused.push_back(one.id);
  }
  return unused;
}

SolidState state_of_open(const PerspectiveDrawing& drawing, const PerspectiveResult& result) {
  std::vector<std::string> open = unused_edges(drawing, result);
  for (const std::string& id : result.open_strokes) {
    if (std::ranges::find(open, id) == open.end()) open.push_back(id);
  }
  if (result.faces.empty()) {
    const QString edges =
        result.edge_strokes == 1 ? QObject::tr("1 edge") : QObject::tr("%1 edges").arg(result.edge_strokes);
    return {edges + QObject::tr(", no face yet"), false, open};
  }
  const QString lacking =
      open.size() == 1 ? QObject::tr("1 edge lacks a face") : QObject::tr("%1 edges lack a face").arg(open.size());
  return {faces_text(result.faces.size()) + ", " + lacking, false, open};
}

/// What is wrong with a solid that is closed, the worst first; nothing: an empty sentence.
SolidState doubt_about(const PerspectiveDrawing& drawing, const PerspectiveResult& result, const Findings& findings) {
  if (const int bent = count_of(findings, "NONPLANAR_STRAIGHT_FACE"); bent > 0) {
    return {bent == 1 ? QObject::tr("Closed, but one face is bent: a stroke is probably missing")
                      : QObject::tr("Closed, but %1 faces are bent: strokes are probably missing").arg(bent),
            false, strokes_with(findings, "NONPLANAR_STRAIGHT_FACE")};
  }
  if (count_of(findings, "MISSING_STROKE") > 0)
    return {QObject::tr("Closed, but a stroke is missing at a corner"), false,
            strokes_with(findings, "MISSING_STROKE")};
  if (count_of(findings, "PATCH_FOLDED") > 0)
    return {QObject::tr("Closed, but a face is folded"), false, strokes_with(findings, "PATCH_FOLDED")};
  const std::vector<std::string> contrary = strokes_with(findings, "CONTRADICTION");
  if (contrary.size() == 1) return {QObject::tr("Closed, but one stroke contradicts the others"), false, contrary};
  if (!contrary.empty())
    return {QObject::tr("Closed, but %1 strokes contradict the others").arg(contrary.size()), false, contrary};
  if (const std::vector<std::string> left = unused_edges(drawing, result); !left.empty()) {
    return {left.size() == 1 ? QObject::tr("Closed, but one edge is left out")
                             : QObject::tr("Closed, but %1 edges are left out").arg(left.size()),
            false, left};
  }
  if (count_of(findings, "DISCONNECTED") > 0)
    return {QObject::tr("Closed, but nothing ties its parts together"), false, strokes_with(findings, "DISCONNECTED")};
  if (!result.alternatives.empty())
    return {QObject::tr("Closed, but other faces fit as well"), false, strokes_with(findings, "AMBIGUOUS")};
  return {};
}

}  // namespace

SolidState solid_state(const PerspectiveDrawing& drawing, const PerspectiveResult& result, const Findings& findings) {
  if (result.edge_strokes == 0) return {};
  if (!result.closed) return state_of_open(drawing, result);
  if (SolidState doubt = doubt_about(drawing, result, findings); !doubt.sentence.isEmpty()) return doubt;
  if (result.shells > 1) return {QObject::tr("Solid closed, %1 shells").arg(result.shells), true, {}};
  return {QObject::tr("Solid closed"), true, {}};
}

bool is_of_unfinished(const Finding& finding) {
  constexpr std::array codes{"DANGLING", "NOT_CLOSED", "DISCONNECTED"};
  return std::ranges::find(codes, finding.code) != codes.end();
}

}  // namespace croquis::app
