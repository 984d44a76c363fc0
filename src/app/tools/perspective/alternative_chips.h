// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QToolButton>
#include <optional>
#include <vector>

#include "app/views/chip_places.h"

namespace croquis::app {

/// A button for each other set of faces that fits a drawing as well: under the pointer it is shown, clicked it is
/// taken.
class AlternativeChips : public QObject {
  Q_OBJECT

 public:
  explicit AlternativeChips(QWidget* views);

  /// @param count of other sets, 0: none
  void place(ChipPlaces& places, const ViewPane& pane, std::size_t count);
  void hide();

  /// Of the one under the pointer.
  const std::optional<std::size_t>& hovered() const { return hovered_; }

 signals:
  void hovered_changed();
  void wanted(std::size_t alternative);

 protected:
  bool eventFilter(QObject* button, QEvent* event) override;

 private:
  void make_button();
  void set_hovered(std::optional<std::size_t> alternative);

  QWidget* views_;
  std::vector<QToolButton*> buttons_;
  std::optional<std::size_t> hovered_;
};

}  // namespace croquis::app
