// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <vector>

#include "app/studio/studio.h"
#include "app/tools/silhouette/bodies.h"
#include "app/tools/silhouette/joints.h"
#include "app/tools/silhouette/outline_choices.h"
#include "app/tools/silhouette/sketch_chip.h"
#include "app/tools/silhouette/thickness_handle.h"
#include "croquis/tools/recording/step.h"
#include "croquis/tools/silhouette/sketch_tool.h"

namespace croquis::app {

/// Buttons over the views for how the drawing is read: how two parts are held, what a stroke is, whether an inner
/// outline is a hole or a part, which of two outlines that cross lies in front, and how thick the selected part is.
class SketchChips : public QObject {
  Q_OBJECT

 public:
  /// @param views that they stand on; @param tool outlives this
  SketchChips(Studio& studio, SketchTool& tool, Viewport& views);

  /// What the newest result and the drawing as it is now offer.
  void follow();

  /// Joins every pair that is offered.
  void join_all();

  void place(ChipPlaces& places, bool shown);

 signals:
  void committed(const croquis::recorded::Step& step);

 private:
  void connect_rows();
  QString name_of(const std::string& object_or_stroke) const;
  QString pair_name(const Joint& joint) const;
  ChipRow::Chip chip_of(const Joint& joint) const;
  ChipRow::Chip chip_of(const NestedStroke& nested) const;
  ChipRow::Chip chip_of(const StrokesInView& crossing) const;
  ChipRow::Chip chip_of(const ReadStroke& read) const;
  void ask_kind(const ReadStroke& read, QWidget& chip);

  AttachText attach() const;
  void set_attach(const AttachText& attach, const QString& step, bool dragging);
  QString seam_step(const Joint& joint) const;
  void set(const recorded::StrokeReading& setting, bool dragging);

  Studio& studio_;
  SketchTool& tool_;
  ChipRow joint_row_, nested_row_, crossing_row_, kind_row_;
  ThicknessHandle thickness_;
  std::vector<Body> bodies_;
  std::vector<Joint> joints_;
  std::vector<NestedStroke> nested_;
  std::vector<StrokesInView> crossings_;
  std::vector<ReadStroke> kinds_;
  std::optional<double> dragged_from_;  ///< the number that the chip under way began with
};

}  // namespace croquis::app
