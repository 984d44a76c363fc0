// SPDX-License-Identifier: GPL-3.0-or-later
#include <utility>

#include "algorithms/silhouette/drawing_reading.h"
#include "algorithms/silhouette/reading_search.h"
#include "algorithms/silhouette/stage.h"
#include "croquis/base/error.h"
#include "croquis/silhouette/labelled_figure.h"

namespace croquis::silhouette {
namespace {

LabelledDrawing label_anew(const Drawing& drawing, const Options& options, Progress& progress) {
  Progress reading = progress.step("reading strokes", 0.4);
  const ReadStrokes read = read_strokes(drawing, options, {}, reading);
  Progress labelling = progress.step("labelling contours", 0.5);
  LabelledDrawing result = label_strokes(drawing, options, read, labelling);
  if (has_errors(result.findings) && reads_again(options.strokes)) {
    const Progress again = progress.step("reading strokes again", 0.1);
    result = read_again(drawing, options, std::move(result), read.clean.scale.tremble, again);
  }
  if (result.figures.empty()) throw Error(result.findings);
  return result;
}

}  // namespace

LabelledDrawing label(const Drawing& drawing, const Options& options, Progress& progress) {
  StageKey key;
  if (options.cache != nullptr) {
    add_drawing(drawing, key);
    key.add(options.strokes).add(options.completion);
  }
  const auto labelled = cached<LabelledDrawing>(
      options.cache, "silhouette labels", key, [&] { return label_anew(drawing, options, progress); },
      [](const LabelledDrawing& result) { return bytes_of(result); });
  progress.report(1);
  return *labelled;
}

}  // namespace croquis::silhouette
