// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointF>
#include <QSizeF>
#include <array>
#include <optional>
#include <vector>

#include "app/views/view_pane.h"

namespace croquis::app {

constexpr double even_share = 0.5;  ///< of the views' width, for each of two

/// Which views stand beside each other.
enum class Arrangement {
  SketchAndSolid,  ///< the sketch, the perspective view
  Four,            ///< top, perspective; front, side
  Compare          ///< the perspective view twice, with the same camera: another scheme in the second one
};

/// Where the window's views lie: one alone, or several with borders that can be dragged.
class PaneLayout {
 public:
  PaneLayout();

  ViewPane& pane(int view) { return panes_[static_cast<std::size_t>(view)]; }
  const ViewPane& pane(int view) const { return panes_[static_cast<std::size_t>(view)]; }

  /// Logical pixels of the widget.
  void resize(const QSizeF& size);

  Arrangement arrangement() const { return arrangement_; }
  void arrange(Arrangement arrangement);  ///< shows all of its views

  /// The view that fills the widget, or -1.
  int alone() const { return alone_; }
  void show_alone(int view);  ///< -1: all views of the arrangement

  std::vector<int> shown() const;

  /// The view at a place of the widget; the nearest one on a border.
  int view_at(const QPointF& place) const;

  /// What of the borders lies at a place: they can be dragged one by one, or both where they cross.
  struct Border {
    bool across = false;  ///< the upright one, which parts left from right
    bool down = false;
    bool any() const { return across || down; }
  };
  Border border_at(const QPointF& place) const;
  void drag_border(const Border& border, const QPointF& place);

  /// Shares of the left and of the upper views; what can't be dragged to becomes the nearest that can.
  QPointF shares() const { return {across_, down_}; }
  void set_shares(const QPointF& shares);

 private:
  void lay_out();

  std::array<ViewPane, view_count> panes_;
  QSizeF size_{1, 1};
  Arrangement arrangement_ = Arrangement::SketchAndSolid;
  int alone_ = -1;
  double across_ = 0.5;  ///< share of the left views
  double down_ = 0.5;    ///< share of the upper views
};

}  // namespace croquis::app
