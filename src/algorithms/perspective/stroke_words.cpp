// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/perspective/stroke_words.h"

#include <algorithm>

#include <Eigen/Geometry>

#include "croquis/base/limits.h"

namespace croquis {
namespace {

constexpr std::size_t most_names = 3;

std::vector<Index> by_id(const PerspectiveDrawing& drawing, std::span<const Index> strokes) {
  std::vector<Index> sorted(strokes.begin(), strokes.end());
  std::stable_sort(sorted.begin(), sorted.end(),
                   [&](Index a, Index b) { return drawing.strokes[a].id < drawing.strokes[b].id; });
  return sorted;
}

}  // namespace

Subject stroke_subject(const PerspectiveDrawing& drawing, Index stroke) {
  const PerspectiveStroke& drawn = drawing.strokes[stroke];
  Subject subject;
  subject.kind = SubjectKind::Stroke;
  subject.id = drawn.id;
  if (!drawing.file.empty()) subject.file = drawing.file;
  subject.line = drawn.line;
  const Vec2 middle = (drawn.start() + drawn.end()) / 2;
  if (are_usable_numbers(middle)) subject.at = {middle.x(), middle.y()};
  return subject;
}

std::vector<Subject> stroke_subjects(const PerspectiveDrawing& drawing, std::span<const Index> strokes) {
  std::vector<Subject> subjects;
  for (const Index stroke : by_id(drawing, strokes)) subjects.push_back(stroke_subject(drawing, stroke));
  return subjects;
}

std::string stroke_names(const PerspectiveDrawing& drawing, std::span<const Index> strokes) {
  const std::vector<Index> sorted = by_id(drawing, strokes);
  std::string names = sorted.size() == 1 ? "stroke " : "strokes ";
  const std::size_t named = std::min(sorted.size(), most_names);
  for (std::size_t i = 0; i < named; ++i) {
    const bool last = i + 1 == sorted.size();
    if (i > 0) names += last ? " and " : ", ";
    names += drawing.strokes[sorted[i]].id;
  }
  if (sorted.size() > named) names += " and " + std::to_string(sorted.size() - named) + " more";
  return names;
}

const char* axis_name(int axis) {
  constexpr const char* names[] = {"x", "y", "z"};
  return names[axis];
}

std::string group_words(StrokeGroup group) {
  if (group == StrokeGroup::Unknown) return {};
  return (is_parallel(group) ? "parallel to " : "in a plane at right angles to ") +
         std::string(axis_name(axis_of(group)));
}

}  // namespace croquis
