// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tools/silhouette/covered_pieces.h"

#include <algorithm>

#include <Eigen/Geometry>

#include "croquis/geometry/polyline.h"
#include "croquis/operators/inflate_result.h"

namespace croquis::app {
namespace {

/// Of the drawing's diagonal: more than smoothing moves a line.
constexpr double reach_in_diagonals = 0.006;

bool lies_on(const Vec2& place, const std::vector<Vec2>& line, double reach) {
  for (std::size_t i = 1; i < line.size(); ++i) {
    const double t = nearest_parameter(place, line[i - 1], line[i]);
    if ((line[i - 1] + t * (line[i] - line[i - 1]) - place).norm() <= reach) return true;
  }
  return false;
}

}  // namespace

CoveredStrokes covered_strokes(const Evaluation* solid) {
  CoveredStrokes covered;
  const InflateResult* inflated = result_of<InflateResult>(solid);
  if (inflated == nullptr || solid->failed || inflated->crossings_in_view.empty()) return covered;
  const auto labels = solid->outputs.find("labels");
  if (labels == solid->outputs.end()) return covered;
  for (const StrokesInView& crossing : inflated->crossings_in_view) covered.ids.push_back(crossing.behind);
  Eigen::AlignedBox2d box;
  const Drawing& arcs = labels->second.get<Drawing>();
  for (std::size_t i = 0; i < inflated->arcs.size() && i < arcs.strokes.size(); ++i) {
    std::vector<Vec2> line;
    for (const StrokeSample& sample : arcs.strokes[i].samples) {
      line.push_back(sample.position);
      box.extend(sample.position);
    }
    if (inflated->arcs[i].depth > 0) covered.hidden.push_back(std::move(line));
  }
  covered.reach = box.isEmpty() ? 0 : reach_in_diagonals * box.diagonal().norm();
  return covered;
}

std::vector<bool> covered_samples(const Stroke& stroke, const CoveredStrokes& covered) {
  if (std::ranges::find(covered.ids, stroke.id) == covered.ids.end()) return {};
  std::vector<bool> samples;
  for (const StrokeSample& sample : stroke.samples) {
    samples.push_back(std::ranges::any_of(
        covered.hidden, [&](const std::vector<Vec2>& line) { return lies_on(sample.position, line, covered.reach); }));
  }
  return samples;
}

}  // namespace croquis::app
