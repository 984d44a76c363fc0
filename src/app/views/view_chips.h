// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLabel>
#include <QToolButton>
#include <QWidget>
#include <array>
#include <optional>
#include <vector>

#include "app/studio/studio.h"
#include "app/tools/silhouette/joints.h"
#include "app/tools/silhouette/sketch_scene.h"
#include "app/views/chip_space.h"
#include "app/views/pane_layout.h"

namespace croquis::app {

/// The colours of tagged edges with what they mean.
class SharpnessLegend : public QWidget {
  Q_OBJECT

 public:
  explicit SharpnessLegend(QWidget* parent);

 protected:
  void paintEvent(QPaintEvent* event) override;
};

/// The colours of patches with their confidence.
class ConfidenceLegend : public QWidget {
  Q_OBJECT

 public:
  explicit ConfidenceLegend(QWidget* parent);

 protected:
  void paintEvent(QPaintEvent* event) override;
};

/// Labels and buttons over the views: their names, counts, the hint to draw, buttons at joints, the value of the edge
/// under the pointer. None covers another.
class ViewChips : public QObject {
  Q_OBJECT

 public:
  /// @param views that they stand on
  ViewChips(Studio& studio, QWidget* views);

  /// In the middle of the sketch view; for whatever can't be drawn.
  void say(const QString& sentence);

  /// What joints the newest result offers.
  void show_joints();

  /// Accepts every joint of limb and body that is offered.
  void join_all();

  /// What is to stand where.
  struct Wanted {
    const SketchScene* sketch = nullptr;
    bool drawing = false;  ///< a stroke is under way: nothing covers it
    bool legend = false;
    bool confidence = false;  ///< the legend of patches instead
    QString comparison;       ///< what the second view of a comparison shows
    struct Value {
      QPointF at;
      QString text;
    };
    std::optional<Value> value;  ///< beside the pointer
  };
  void place(const PaneLayout& layout, const Wanted& wanted);

 private:
  void place_names(const PaneLayout& layout, const Wanted& wanted, ChipSpace& space);
  void place_legends(const ViewPane& pane, const Wanted& wanted, ChipSpace& space);
  void place_hint(const ViewPane& pane, const Wanted& wanted, ChipSpace& space);
  void place_joints(const ViewPane& pane, const Wanted& wanted, ChipSpace& space);
  void place_value(const Wanted& wanted, ChipSpace& space);
  void put(QWidget* chip, const QPointF& at, const QRectF& bounds, ChipSpace& space);
  QString counts() const;

  Studio& studio_;
  QWidget* views_;
  QLabel* hint_;
  bool hint_stays_ = false;
  std::array<QLabel*, view_count> names_{};
  QLabel* counts_;
  QLabel* value_;
  SharpnessLegend* legend_;
  ConfidenceLegend* confidence_;
  std::vector<Joint> joints_;
  std::vector<QToolButton*> joint_chips_;  ///< one for each of joints_; later ones wait hidden
};

}  // namespace croquis::app
