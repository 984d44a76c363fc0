// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/strokes/drawing_findings.h"

#include <array>
#include <charconv>
#include <utility>

namespace croquis::silhouette {
namespace {

std::string number_text(double value, int digits) {
  std::array<char, 64> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, digits).ptr;
  return {text.data(), end};
}

// Findings are in the file's y-down frame; zero must not become "-0".
double flipped(double y) { return y == 0 ? 0 : -y; }

}  // namespace

Subject stroke_subject(const Drawing& drawing, Index stroke) {
  Subject subject;
  subject.kind = SubjectKind::Stroke;
  subject.id = drawing.strokes[stroke].id;
  if (!drawing.file.empty()) subject.file = drawing.file;
  subject.line = drawing.strokes[stroke].line;
  return subject;
}

Subject stroke_subject(const Drawing& drawing, Index stroke, const Vec2& at) {
  Subject subject = stroke_subject(drawing, stroke);
  subject.at = {at.x(), flipped(at.y())};
  return subject;
}

Subject crossing_subject(const Drawing& drawing, const Vec2& at) {
  Subject subject;
  subject.kind = SubjectKind::Crossing;
  if (!drawing.file.empty()) subject.file = drawing.file;
  subject.at = {at.x(), flipped(at.y())};
  return subject;
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

std::string length_text(double length) { return number_text(length, 4); }

}  // namespace croquis::silhouette
