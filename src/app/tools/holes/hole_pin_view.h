// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QRectF>
#include <QWidget>
#include <vector>

#include "croquis/tools/holes/hole_pins.h"

namespace croquis::app {

class HoleInteraction;

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
  void show_pins(Pins pins, const HoleInteraction& holes);

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
  static Drawn drawn(const ViewPins& view, const HolePin& pin, const HoleInteraction& holes);

  std::vector<Drawn> drawn_;
};

}  // namespace croquis::app
