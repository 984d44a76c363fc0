// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QRectF>
#include <QWidget>
#include <vector>

#include "app/tools/holes/hole_plan.h"
#include "app/tools/scene_parts.h"
#include "croquis/tools/holes/hole_pins.h"
#include "croquis/tools/holes/hole_tool.h"

namespace croquis::app {

/// The colour of a hole's rim and pin: distinct for any colour vision, and distinct from the selection's.
QColor hole_color(const HoleRow& hole);

/// Rims of holes over the surface, those behind it faint; handles of patches. Kept until what it shows changes.
class HoleOverlay {
 public:
  /// After holes, selection or handles have changed.
  void follow(const HoleTool& tool, const std::vector<HoleRow>& rows);

  /// What is under the pointer or being pulled; cheap enough for every event.
  void follow_hover(const HoleTool& tool);

  void add_to(render::Scene& scene) const;

  /// Of these holes with some of what is around; empty for none.
  static render::Bounds bounds_of(const HoleTool& tool, const std::vector<Index>& holes);

 private:
  SeenThrough all_;
  SeenThrough selected_;
  SeenThrough hovered_;
  render::MarkItemPtr handles_;
  render::LineItemPtr pull_;
  render::MarkItemPtr pulled_;
};

struct ScanHoles;

/// The numbers of holes over the views, where these show them. Takes no events.
class HolePinView : public QWidget {
  Q_OBJECT

 public:
  explicit HolePinView(QWidget* views);

  /// Pins of one view, in its pixels.
  struct ViewPins {
    QRectF view;
    std::vector<HolePin> pins;
  };
  using Pins = std::vector<ViewPins>;

  /// Draws them again when something of it has changed. None: nothing is shown.
  void show_pins(Pins pins, const ScanHoles& holes);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  struct Drawn {
    QPointF at, anchor;
    QRectF view;
    QString text;
    QColor color;
    bool selected = false;
    bool hovered = false;
    bool faint = false;
    bool operator==(const Drawn&) const = default;
  };
  static Drawn drawn(const ViewPins& view, const HolePin& pin, const ScanHoles& holes);

  std::vector<Drawn> drawn_;
};

}  // namespace croquis::app
