// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLabel>
#include <QPointF>
#include <QRect>
#include <QRectF>
#include <QWidget>
#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "app/studio/studio.h"
#include "app/views/view_pane.h"

class QToolButton;

namespace croquis::app {

class ViewHandles;
class Views;

/// Places for labels and buttons over a view: none covers another. The first ones get the places they want.
class ChipSpace {
 public:
  /// Takes the free place nearest to the wanted one. Nothing when there is none.
  /// @param bounds that it has to stay within. O(n^3) in the chips near by, O(n) where the wanted place is free.
  std::optional<QRect> take(const QRect& wanted, const QRect& bounds);

 private:
  bool is_free(const QRect& place) const;

  std::vector<QRect> taken_;
};

/// Where labels and buttons over the views go. None covers another; one that finds no place is hidden.
class ChipPlaces {
 public:
  ChipPlaces(const PaneLayout& layout, QWidget& views) : layout_(layout), views_(views) {}

  const PaneLayout& layout() const { return layout_; }

  /// The view that stands for the whole scene: the one alone, else the perspective view.
  const ViewPane& scene_pane() const;

  /// Shows the chip at the free place nearest to the wanted one, within bounds of the views' widget.
  void put(QWidget& chip, const QPointF& at, const QRectF& bounds);

  /// The same within the whole widget.
  void put(QWidget& chip, const QPointF& at);

  /// In the lower right corner of the scene's view, or hidden.
  void put_legend(QWidget& legend, bool shown);

 private:
  const PaneLayout& layout_;
  QWidget& views_;
  ChipSpace space_;
};

/// Of what can be done next, in the middle of a view.
inline constexpr const char* hint_style = "color: #5c6470; background: transparent; font-size: 15px";

/// Of what is finished, and of what is lacking.
inline constexpr const char* sound_style =
    "QToolButton { background: #dff5e3; color: #14602a; border: 1px solid #2f9a4c; border-radius: 9px;"
    " padding: 2px 9px }";
inline constexpr const char* lacking_style =
    "QToolButton, QLabel { background: #fff4df; color: #7a4a00; border: 1px solid #e0a030; border-radius: 9px;"
    " padding: 2px 9px } QToolButton:hover { background: #ffe2a8 }";

/// A label over the views that lets the pointer through. @param style a style sheet
QLabel* make_chip_label(QWidget& views, const char* style);

/// The labels and buttons of one owner over the views. Those that aren't put again are hidden. Those that stay are
/// never hidden meanwhile: a button would forget that it is pressed.
class ChipSet {
 public:
  explicit ChipSet(QWidget& views) : views_(views) {}

  QLabel* label(const QString& name, const char* style);  ///< lets the pointer through
  QToolButton* button(const QString& name, const char* style, std::function<void()> clicked);

  void begin(ChipPlaces& places);
  void put(QWidget& chip, const QPointF& at, const QRectF& bounds);
  /// In the middle between left and right. @param top of the chip, in the views' pixels
  void put_in_middle(QWidget& chip, double top, const QRectF& bounds);
  /// A number beside what it is of, in as many labels as are wanted. @param border a colour
  void put_value(const QString& name, const QString& text, const QString& border, const QPointF& at,
                 const QRectF& bounds);
  void end();

 private:
  QWidget& views_;
  ChipPlaces* places_ = nullptr;
  std::vector<QLabel*> values_;
  std::size_t used_values_ = 0;
  std::vector<QWidget*> chips_;
  std::vector<QWidget*> put_;
};

/// The labels that every view has: its name, and in one of them how large the objects are.
class ViewChips {
 public:
  explicit ViewChips(Views& views);
  ~ViewChips();

  /// In the middle, for as long as the program runs: for whatever can't be drawn.
  void say(const QString& sentence);

  /// These labels, then those of the tools.
  void place(const Views& views);

 private:
  ChipSet chips_;
  std::unique_ptr<ViewHandles> handles_;
  QLabel* message_;
  std::array<QLabel*, view_count> names_{};
  QLabel* counts_;
};

}  // namespace croquis::app
