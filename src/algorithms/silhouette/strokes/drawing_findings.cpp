// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/strokes/drawing_findings.h"

#include <utility>

namespace croquis::silhouette {
namespace {

/// Findings are in the file's y-down frame; zero must not become "-0".
Subject subject_at(const Drawing& drawing, SubjectKind kind, const std::optional<Vec2>& at) {
  Subject subject;
  subject.kind = kind;
  if (!drawing.file.empty()) subject.file = drawing.file;
  if (at) subject.at = {at->x(), at->y() == 0 ? 0 : -at->y()};
  return subject;
}

}  // namespace

Subject stroke_subject(const Drawing& drawing, Index stroke, const std::optional<Vec2>& at) {
  Subject subject = subject_at(drawing, SubjectKind::Stroke, at);
  subject.id = drawing.strokes[stroke].id;
  subject.line = drawing.strokes[stroke].line;
  return subject;
}

Subject crossing_subject(const Drawing& drawing, const Vec2& at) {
  return subject_at(drawing, SubjectKind::Crossing, at);
}

std::string in_quotes(const Drawing& drawing, Index stroke) { return "\"" + drawing.strokes[stroke].id + "\""; }

Finding no_solid(const std::string& why, std::vector<Subject> subjects) {
  return make_error(Category::Geometry, "E_NO_LABELLING",
                    "No solid looks like this: " + why + "; check what passes behind what there", std::move(subjects));
}

Finding too_short(const Drawing& drawing, Index stroke) {
  return make_warning(Category::Geometry, "W_TINY",
                      "The stroke " + in_quotes(drawing, stroke) + " is too short and was ignored",
                      {stroke_subject(drawing, stroke)});
}

}  // namespace croquis::silhouette
