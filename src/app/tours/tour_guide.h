// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <vector>

#include "app/views/views.h"
#include "croquis/tools/recording/step.h"

namespace croquis::app {

/// Where a recorded step happens.
struct StepPath {
  int view = SketchView;
  std::vector<Vec3> places;  ///< of the model: of a stroke, or one place of a click; none for other steps
};

StepPath path_of(const recorded::Step& step);

/// How far what was done is from what was asked for: 0 the same, below 1 near enough, 1 and more something else.
/// Strokes are near within 15 % of the asked one's size, all along; closed ones of any shape that lie there, too.
double misfit(const recorded::Step& done, const recorded::Step& asked);

/// Dotted lines over the views where people are asked to draw, with a dot where each begins, and rings where they are
/// asked to click. Lets the pointer through.
class TourGuide : public QWidget {
 public:
  explicit TourGuide(Views& views);

  /// Views that don't show all of it are framed.
  void show_paths(std::vector<StepPath> paths);

  /// Covers the views as they lie now.
  void follow();

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  Views& views_;
  std::vector<StepPath> paths_;
};

}  // namespace croquis::app
