// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointF>
#include <QString>
#include <QToolButton>
#include <functional>
#include <optional>
#include <vector>

#include "app/views/chip_places.h"
#include "croquis/geometry/vector.h"

namespace croquis::app {

/// A small button over the sketch, about one place of it. It is clicked, or dragged away from where it stays.
class SketchChip : public QToolButton {
  Q_OBJECT

 public:
  explicit SketchChip(QWidget* views);

  /// What it shows: an icon by its name, words beside it, and how strongly it stands out.
  struct Look {
    enum class Strength { Plain, Half, Full, Warning };
    QString icon;
    QString text;  ///< empty for the icon alone
    QString tooltip;
    Strength strength = Strength::Plain;
  };
  void set_look(const Look& look);

  /// Without this a drag is a click.
  void set_draggable(bool draggable) { draggable_ = draggable; }

 signals:
  void dragged(const QPointF& by);  ///< logical pixels from where it was pressed
  void dropped();                   ///< the drag has ended
  void asked();                     ///< clicked with the right button

 protected:
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;

 private:
  bool draggable_ = false;
  std::optional<QPointF> pressed_at_;
  bool dragging_ = false;
};

/// As many chips of one kind as are needed; those that aren't wait hidden.
class ChipRow : public QObject {
  Q_OBJECT

 public:
  struct Chip {
    Vec2 at = Vec2::Zero();  ///< sketch units, where its middle is wanted
    SketchChip::Look look;
    double above = 0;  ///< logical pixels that it stands above that place
  };

  /// @param views that they stand on
  /// @param name  chips are called by it and their numbers
  ChipRow(QWidget* views, const QString& name, bool draggable);

  void show(std::vector<Chip> chips);

  /// @param shown false while a stroke is under way: nothing covers it
  /// @param drawn_through the pointer goes through them, so that a stroke can begin there
  void place(ChipPlaces& places, bool shown, bool drawn_through = false);

  SketchChip* chip(std::size_t number) const { return buttons_.at(number); }

 signals:
  void clicked(std::size_t number);
  void dragged(std::size_t number, const QPointF& by);
  void dropped(std::size_t number);
  void asked(std::size_t number);

 private:
  void add_button();

  QWidget* views_;
  QString name_;
  bool draggable_;
  std::vector<Chip> chips_;
  std::vector<SketchChip*> buttons_;
};

/// Numbers of chips have two decimals.
double chip_number(double value);
QString chip_text(double value);

/// Asks for a number in a small window below a chip. It takes every change, and goes with Enter, Escape or a click
/// elsewhere.
/// @param name of the field, by which tests find it
void ask_number(SketchChip& chip, const QString& name, double value, double low, double high,
                const std::function<void(double)>& take);

}  // namespace croquis::app
