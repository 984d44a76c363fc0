// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tools/scene_parts.h"

#include <QStringList>

#include "app/window/theme.h"

namespace croquis::app {
namespace {

constexpr double mark_reach = 12;  // logical pixels

}  // namespace

render::LineItemPtr lines_of(const std::vector<render::LinePath>& paths, const render::LineStyle& style) {
  return paths.empty() ? nullptr : render::make_line_item(paths, style);
}

render::LineItemPtr lines_of(const PolyMesh& mesh, const render::LineStyle& style) {
  std::vector<render::LinePath> paths;
  for (std::size_t l = 0; l < mesh.line_count(); ++l)
    paths.push_back(path_of(mesh.line(l), [&](Index vertex) { return to_glm(mesh.positions[vertex]); }));
  return lines_of(paths, style);
}

render::MarkItemPtr marks_of(const std::vector<render::Mark>& marks, render::MarkDepth depth) {
  return marks.empty() ? nullptr : render::make_mark_item(marks, depth);
}

std::vector<Vec2> corners_of_box(const Vec2& low, const Vec2& high) {
  return {low, {high.x(), low.y()}, high, {low.x(), high.y()}};
}

void add_items(render::Scene& scene, std::initializer_list<render::LineItemPtr> lines,
               std::initializer_list<render::MarkItemPtr> marks) {
  for (const render::LineItemPtr& item : lines) {
    if (item) scene.lines.emplace_back(item);
  }
  for (const render::MarkItemPtr& item : marks) {
    if (item) scene.marks.emplace_back(item);
  }
}

render::Mark symbol_of(const FindingMark& finding) {
  return {to_glm(finding.at), finding.error ? render::MarkShape::Cross : render::MarkShape::Warning,
          finding.error ? 14.0F : 18.0F, to_color(finding.error ? colors::error : colors::warning)};
}

QString sentences_at(const std::vector<FindingMark>& findings, const ViewFrame& frame, const Vec2& pixel) {
  QStringList sentences;
  for (const FindingMark& finding : findings) {
    const auto seen = frame.project(finding.at);
    const bool is_under = seen && (seen->pixel - pixel).norm() < mark_reach;
    if (is_under && !sentences.contains(finding.sentence)) sentences << finding.sentence;
  }
  return sentences.join("\n");
}

}  // namespace croquis::app
