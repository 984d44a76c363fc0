// SPDX-License-Identifier: GPL-3.0-or-later
#include "silhouette/labelled_counts.h"

#include <algorithm>
#include <numeric>

#include "croquis/base/error.h"

namespace croquis::test {

std::ostream& operator<<(std::ostream& out, const LabelledCounts& counts) {
  out << counts.contours << " contours, " << counts.crossings << " crossings, " << counts.arcs << " arcs, "
      << counts.hidden_arcs << " hidden, " << counts.panels << " panels, " << counts.objects << " objects, chi "
      << counts.euler_region << ", depths";
  for (const int count : counts.depth_histogram) out << ' ' << count;
  return out;
}

LabelledCounts counts_of(const silhouette::LabelledDrawing& labelled) {
  LabelledCounts counts;
  for (const silhouette::LabelledFigure& figure : labelled.figures) {
    counts.contours += static_cast<int>(figure.contours.size());
    counts.crossings += static_cast<int>(figure.crossings.size());
    counts.arcs += static_cast<int>(figure.arcs.size());
    counts.panels += figure.panels;
    counts.objects += static_cast<int>(figure.objects.size());
    for (const silhouette::FigureObject& object : figure.objects) counts.euler_region += object.euler_region;
    for (const silhouette::FigureArc& arc : figure.arcs) {
      if (!arc.visible) ++counts.hidden_arcs;
      const auto depth = static_cast<std::size_t>(arc.depth);
      if (counts.depth_histogram.size() <= depth) counts.depth_histogram.resize(depth + 1, 0);
      ++counts.depth_histogram[depth];
    }
  }
  return counts;
}

LabelledCounts counts_of(const SketchTruth& truth) {
  LabelledCounts counts{truth.contours,
                        truth.crossings,
                        truth.arcs,
                        truth.hidden_arcs,
                        truth.panels,
                        truth.components,
                        std::accumulate(truth.euler_region.begin(), truth.euler_region.end(), 0),
                        truth.depth_histogram};
  while (!counts.depth_histogram.empty() && counts.depth_histogram.back() == 0) counts.depth_histogram.pop_back();
  return counts;
}

std::vector<int> euler_numbers(const silhouette::LabelledDrawing& labelled) {
  std::vector<int> numbers;
  for (const silhouette::LabelledFigure& figure : labelled.figures) {
    for (const silhouette::FigureObject& object : figure.objects) numbers.push_back(object.euler_region);
  }
  std::sort(numbers.begin(), numbers.end());
  return numbers;
}

Drawing drawing_of(std::vector<Stroke> strokes) {
  Drawing drawing;
  drawing.strokes = std::move(strokes);
  return drawing;
}

silhouette::LabelledDrawing label_quietly(const Drawing& drawing, const silhouette::Options& options) {
  Progress progress;
  return silhouette::label(drawing, options, progress);
}

Findings findings_of(const Drawing& drawing, const silhouette::Options& options) {
  try {
    return label_quietly(drawing, options).findings;
  } catch (const Error& error) {
    return error.findings();
  }
}

std::vector<std::string> strokes_named(const Finding& finding) {
  std::vector<std::string> ids;
  for (const Subject& subject : finding.subjects) {
    if (subject.kind == SubjectKind::Stroke && std::find(ids.begin(), ids.end(), subject.id) == ids.end()) {
      ids.push_back(subject.id);
    }
  }
  return ids;
}

}  // namespace croquis::test
