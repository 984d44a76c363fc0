// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAction>
#include <QWidget>
#include <array>

class QColor;

namespace croquis::app {

/// The colour of an action in menus that are rings of sectors; such a sector shows its iconText.
void set_sector_color(QAction& action, const QColor& color);

/// Eight actions around the place where a button went down: the pointer's direction chooses, release runs the action.
/// Directions work before the menu is read. Labels around the place; where actions have colours, a small ring of
/// coloured sectors with letters. Over its parent, which passes on the pointer's movement.
class MarkingMenu : public QWidget {
  Q_OBJECT

 public:
  /// Clockwise, the first one above.
  static constexpr std::size_t places = 8;

  explicit MarkingMenu(QWidget* parent);

  void set_action(std::size_t place, QAction* action) { actions_.at(place) = action; }

  /// @param at logical pixels of the parent
  void open(const QPointF& at);
  bool is_open() const { return isVisible(); }
  void move_to(const QPointF& at);

  /// Does the action in the pointer's direction; none from the middle. @return whether something was chosen
  bool choose();
  void dismiss() { hide(); }

  /// The place in a direction from the middle, or -1.
  static int place_towards(const QPointF& way);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  bool is_ring() const;
  QRectF label_rect(std::size_t place) const;
  void paint_labels(QPainter& painter, int chosen) const;
  void paint_ring(QPainter& painter, int chosen) const;
  void paint_sector(QPainter& painter, std::size_t place, bool marked) const;
  void paint_name(QPainter& painter, const QAction& action) const;

  std::array<QAction*, places> actions_{};
  QPointF middle_;
  QPointF pointer_;
};

}  // namespace croquis::app
