// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "croquis/silhouette/labelled_figure.h"
#include "support/sketches/sketch.h"

namespace croquis::test {

/// What must not change with the order, direction, place, size or rotation of strokes.
struct LabelledCounts {
  int contours = 0;
  int crossings = 0;
  int arcs = 0;
  int hidden_arcs = 0;
  int panels = 0;
  int objects = 0;
  int euler_region = 0;
  std::vector<int> depth_histogram;

  friend bool operator==(const LabelledCounts&, const LabelledCounts&) = default;
};

std::ostream& operator<<(std::ostream& out, const LabelledCounts& counts);

LabelledCounts counts_of(const silhouette::LabelledDrawing& labelled);
LabelledCounts counts_of(const SketchTruth& truth);

/// The Euler number of each object's region, ascending.
std::vector<int> euler_numbers(const silhouette::LabelledDrawing& labelled);

Drawing drawing_of(std::vector<Stroke> strokes);

/// Labels with no progress to report.
silhouette::LabelledDrawing label_quietly(const Drawing& drawing, const silhouette::Options& options = {});

/// All findings of a drawing, whether it can be labelled or not.
Findings findings_of(const Drawing& drawing, const silhouette::Options& options = {});

/// Ids of the strokes that a finding names, each once, in the order named.
std::vector<std::string> strokes_named(const Finding& finding);

}  // namespace croquis::test
