// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "croquis/base/finding.h"
#include "croquis/geometry/drawing.h"
#include "croquis/silhouette/stroke_data.h"

/// Subjects and phrases of findings about a drawing. Places are in the input's own frame: y down.
namespace croquis::silhouette {

inline Subject crossing_subject(const Drawing& drawing, const std::optional<Vec2>& at) {
  Subject subject;
  subject.kind = SubjectKind::Crossing;
  if (!drawing.file.empty()) subject.file = drawing.file;
  if (at) subject.at = {at->x(), at->y() == 0 ? 0 : -at->y()};  // zero must not become "-0"
  return subject;
}

inline Subject stroke_subject(const Drawing& drawing, Index stroke, const std::optional<Vec2>& at = std::nullopt) {
  Subject subject = crossing_subject(drawing, at);
  subject.kind = SubjectKind::Stroke;
  subject.id = drawing.strokes[stroke].id;
  subject.line = drawing.strokes[stroke].line;
  return subject;
}

/// The stroke's id in quotes.
inline std::string in_quotes(const Drawing& drawing, Index stroke) { return "\"" + drawing.strokes[stroke].id + "\""; }

/// E_NO_LABELLING.
/// @param why no solid looks like the drawing
inline Finding no_solid(const std::string& why, std::vector<Subject> subjects) {
  return make_error(Category::Geometry, "E_NO_LABELLING",
                    "No solid looks like this: " + why + "; check what passes behind what there", std::move(subjects));
}

/// E_PIN: no reading keeps what is set for ends.
Finding pins_not_kept(const Drawing& drawing, const std::vector<PinnedEnds>& pins);

/// W_TINY.
inline Finding too_short(const Drawing& drawing, Index stroke) {
  return make_warning(Category::Geometry, "W_TINY",
                      "The stroke " + in_quotes(drawing, stroke) + " is too short and was ignored",
                      {stroke_subject(drawing, stroke)});
}

}  // namespace croquis::silhouette
