// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QToolButton>

#include "app/tools/perspective/alternative_chips.h"
#include "app/tools/perspective/sheet_interaction.h"
#include "app/views/chip_places.h"

class QAction;
class QLabel;

namespace croquis::app {

/// What stands over the views of a perspective drawing: how far it is a solid, the change that is proposed, the mirror,
/// and the way back to the drawing's eye.
class PerspectiveChips : public QObject {
  Q_OBJECT

 public:
  /// @param views that they stand on
  PerspectiveChips(SheetInteraction& sheet, QWidget* views);

  AlternativeChips& alternatives() { return alternatives_; }
  const AlternativeChips& alternatives() const { return alternatives_; }

  /// @param through the perspective view is held at the drawing's eye
  void place(ChipPlaces& places, bool shown, bool through);

 signals:
  void fix_wanted();
  void mirror_wanted();
  void look_through_wanted(bool on);
  void strokes_wanted(const std::vector<std::string>& strokes);  ///< selected, and looked at

 private:
  QToolButton* make_button(const QString& name);
  void put(ChipPlaces& places, QWidget& chip, const QPointF& at, const ViewPane& pane);
  void place_hint(ChipPlaces& places, const ViewPane& pane);
  void place_faces(ChipPlaces& places, const ViewPane& pane);
  void place_fix(ChipPlaces& places, const ViewPane& pane);
  void place_mirror(ChipPlaces& places, const ViewPane& pane);
  void place_through(ChipPlaces& places, bool through);

  SheetInteraction& sheet_;
  QWidget* views_;
  AlternativeChips alternatives_;
  std::vector<QWidget*> placed_;  ///< this time
  QLabel* hint_;
  QToolButton* faces_;
  std::vector<std::string> faces_strokes_;  ///< that its sentence is about
  QToolButton* fix_;
  QToolButton* mirror_;
  QToolButton* through_;
};

}  // namespace croquis::app
