// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <QToolButton>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/tools/perspective/sheet.h"
#include "app/views/view_chips.h"
#include "croquis/base/finding.h"
#include "croquis/operators/perspective_result.h"
#include "croquis/render/line_item.h"

class QLabel;

namespace croquis::app {

/// A button for each other set of faces that fits a drawing as well: under the pointer it is shown, clicked it is
/// taken.
class AlternativeChips : public QObject {
  Q_OBJECT

 public:
  /// They stand on the views.
  explicit AlternativeChips(Sheet& sheet);

  /// @param count of other sets, 0: none
  void place(ChipPlaces& places, const ViewPane& pane, std::size_t count);

  /// What the one under the pointer would change. @param on_sheet on the sheet, else in space
  void add_to(render::Scene& scene, bool on_sheet) const;

 signals:
  void hovered_changed();

 protected:
  bool eventFilter(QObject* button, QEvent* event) override;

 private:
  void make_button();
  void set_hovered(std::optional<std::size_t> alternative);

  Sheet& sheet_;
  ChipSet chips_;
  std::vector<QToolButton*> buttons_;
  std::optional<std::size_t> hovered_;
};

/// How far a drawing is a solid, in one sentence.
struct SolidState {
  QString sentence;                  ///< "2 faces, 5 edges lack a face", "Solid closed"; empty without edges
  bool sound = false;                ///< closed, and nothing that was drawn is doubtful or left out
  std::vector<std::string> strokes;  ///< to look at: those that the sentence is about
};

/// @param drawing that the result was found in, or a newer one
SolidState solid_state(const PerspectiveDrawing& drawing, const PerspectiveResult& result, const Findings& findings);

/// What stands over the views of a perspective drawing: how far it is a solid, the change that is proposed, the mirror,
/// and the way back to the drawing's eye.
class PerspectiveChips {
 public:
  explicit PerspectiveChips(Sheet& sheet);

  AlternativeChips& alternatives() { return alternatives_; }

  void place(ChipPlaces& places, bool shown);

 private:
  void place_hint(const QRectF& rect);
  void place_faces(const QRectF& rect);
  void place_fix(const ViewPane& pane);
  void place_mirror(const QRectF& rect);
  void place_through(const ViewPane& pane);

  Sheet& sheet_;
  AlternativeChips alternatives_;
  ChipSet chips_;
  QLabel* hint_;
  QToolButton* faces_;
  std::vector<std::string> faces_strokes_;  ///< that its sentence is about
  QToolButton* fix_;
  QToolButton* mirror_;
  QToolButton* through_;
};

}  // namespace croquis::app
