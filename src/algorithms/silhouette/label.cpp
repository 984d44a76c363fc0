// SPDX-License-Identifier: GPL-3.0-or-later
#include <utility>

#include "algorithms/silhouette/drawing_reading.h"
#include "algorithms/silhouette/stage.h"
#include "croquis/base/error.h"
#include "croquis/silhouette/labelled_figure.h"

namespace croquis::silhouette {
namespace {

LabelledDrawing label_anew(const Drawing& drawing, const Options& options, Progress& progress) {
  LabelledDrawing result = read_drawing(drawing, options, progress);
  if (result.figures.empty()) throw Error(result.findings);
  return result;
}

}  // namespace

LabelledDrawing label(const Drawing& drawing, const Options& options, Progress& progress) {
  StageKey key;
  if (options.cache != nullptr) {
    add_drawing(drawing, key);
    key.add(options.strokes).add(options.completion).add(options.attach_suggested);
  }
  const auto labelled = cached<LabelledDrawing>(
      options.cache, "silhouette labels", key, [&] { return label_anew(drawing, options, progress); },
      [](const LabelledDrawing& result) { return bytes_of(result); });
  progress.report(1);
  return *labelled;
}

}  // namespace croquis::silhouette
