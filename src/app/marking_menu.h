// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAction>
#include <QWidget>
#include <array>

namespace croquis::app {

/// Eight actions around the place where a button went down: the pointer's direction chooses, letting go does it.
/// Directions work before the eye has read anything. Over its parent, which hands it the pointer's way.
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

  /// Does what the direction says; nothing from the middle. @return whether something was chosen
  bool choose();
  void dismiss() { hide(); }

  /// The place that the pointer's way from the middle points to, or -1.
  static int place_towards(const QPointF& way);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QRectF label_rect(std::size_t place) const;

  std::array<QAction*, places> actions_{};
  QPointF middle_;
  QPointF pointer_;
};

}  // namespace croquis::app
