// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tools/perspective/perspective_chips.h"

#include <QLabel>
#include <algorithm>
#include <utility>

#include "app/tools/perspective/solid_state.h"

namespace croquis::app {
namespace {

constexpr double chip_margin = 10;  // logical pixels
constexpr double hint_width = 620;
constexpr const char* sheet_hint_style = "color: #8a93a0; background: transparent; font-size: 15px";
constexpr const char* open_style =
    "QToolButton { background: #fff4df; color: #7a4a00; border: 1px solid #e0a030; border-radius: 9px; padding: 2px 9px"
    "} QToolButton:hover { background: #ffe2a8 }";
constexpr const char* closed_style =
    "QToolButton { background: #dff5e3; color: #14602a; border: 1px solid #2f9a4c; border-radius: 9px; padding: 2px 9px"
    "}";
constexpr const char* sheet_button_style =
    "QToolButton { background: white; color: #3c4654; border: 1px solid #7a8698; border-radius: 9px;"
    " padding: 2px 9px }"
    "QToolButton:hover { background: #ffe2c2 }"
    "QToolButton:checked { background: #f28c28; color: #1c1c1e; border: 1px solid #a85a10 }";

QPointF sheet_to_widget(const ViewPane& pane, const Vec2& sheet) {
  const Vec2 pixel = pane.sketch_frame().to_pixel({sheet.x(), -sheet.y()});
  return pane.rect.topLeft() + QPointF(pixel.x(), pixel.y());
}

/// Parted at the blank nearest to the middle.
QString on_two_lines(QString sentence) {
  const qsizetype middle = sentence.size() / 2;
  const qsizetype before = sentence.lastIndexOf(' ', middle), after = sentence.indexOf(' ', middle);
  const qsizetype blank = after < 0 || middle - before < after - middle ? before : after;
  return blank < 0 ? sentence : sentence.replace(blank, 1, '\n');
}

}  // namespace

PerspectiveChips::PerspectiveChips(SheetInteraction& sheet, QWidget* views)
    : QObject(views),
      sheet_(sheet),
      views_(views),
      alternatives_(views),
      hint_(make_chip_label(*views, sheet_hint_style)),
      faces_(make_button("perspective-faces")),
      fix_(make_button("perspective-fix-chip")),
      mirror_(make_button("perspective-mirror-chip")),
      through_(make_button("look-through-chip")) {
  hint_->setObjectName("perspective-hint");
  hint_->setWordWrap(true);
  hint_->setAlignment(Qt::AlignCenter);
  through_->setCheckable(true);
  connect(faces_, &QToolButton::clicked, this, [this] { emit strokes_wanted(faces_strokes_); });
  connect(fix_, &QToolButton::clicked, this, &PerspectiveChips::fix_wanted);
  connect(mirror_, &QToolButton::clicked, this, &PerspectiveChips::mirror_wanted);
  connect(through_, &QToolButton::clicked, this, &PerspectiveChips::look_through_wanted);
}

QToolButton* PerspectiveChips::make_button(const QString& name) {
  auto* button = new QToolButton(views_);
  button->setObjectName(name);
  button->setFocusPolicy(Qt::NoFocus);
  button->setStyleSheet(sheet_button_style);
  button->hide();
  return button;
}

void PerspectiveChips::put(ChipPlaces& places, QWidget& chip, const QPointF& at, const ViewPane& pane) {
  places.put(chip, at, pane.rect);
  placed_.push_back(&chip);
}

/// Chips that stay are never hidden meanwhile: a button would forget that it is pressed.
void PerspectiveChips::place(ChipPlaces& places, bool shown, bool through) {
  placed_.clear();
  const ViewPane& pane = places.layout().pane(SketchView);
  const PerspectiveResult* result = sheet_.result();
  if (shown && pane.visible()) {
    place_hint(places, pane);
    place_faces(places, pane);
    alternatives_.place(places, pane, result == nullptr ? 0 : result->alternatives.size());
    place_fix(places, pane);
    place_mirror(places, pane);
  } else {
    alternatives_.hide();
  }
  if (shown) place_through(places, through);
  for (QWidget* chip : std::initializer_list<QWidget*>{hint_, faces_, fix_, mirror_, through_}) {
    if (std::ranges::find(placed_, chip) == placed_.end()) chip->hide();
  }
}

/// What to draw first, as long as there is no camera.
void PerspectiveChips::place_hint(ChipPlaces& places, const ViewPane& pane) {
  if (sheet_.result() != nullptr && !sheet_.drawing().strokes.empty()) return;
  hint_->setText(tr("Draw two lines along each axis: they take the axis' colour from where they point"));
  const int width = static_cast<int>(std::min(pane.rect.width() - 2 * chip_margin, hint_width));
  hint_->setFixedSize(width, hint_->heightForWidth(width));
  put(places, *hint_, QPointF(pane.rect.center().x() - hint_->width() / 2.0, pane.rect.bottom() - 60), pane);
}

void PerspectiveChips::place_faces(ChipPlaces& places, const ViewPane& pane) {
  const PerspectiveResult* result = sheet_.result();
  if (result == nullptr || result->edge_strokes == 0) return;
  SolidState state = solid_state(sheet_.drawing(), *result, sheet_.findings());
  const char* style = state.sound ? closed_style : open_style;
  if (faces_->styleSheet() != style) faces_->setStyleSheet(style);
  faces_->setText(state.sentence);
  faces_->setToolTip(state.strokes.empty() ? QString() : tr("Click to see the strokes"));
  faces_strokes_ = std::move(state.strokes);
  faces_->adjustSize();
  if (faces_->width() > pane.rect.width() - 2 * chip_margin) {
    faces_->setText(on_two_lines(state.sentence));
    faces_->adjustSize();
  }
  put(places, *faces_, QPointF(pane.rect.center().x() - faces_->width() / 2.0, pane.rect.top() + chip_margin), pane);
}

void PerspectiveChips::place_fix(ChipPlaces& places, const ViewPane& pane) {
  const PerspectiveResult* result = sheet_.result();
  if (result == nullptr || result->fixes.empty()) return;
  const ProposedFix& fix = result->fixes.front();
  const PerspectiveStroke* stroke = find_stroke(sheet_.drawing(), fix.stroke);
  if (stroke == nullptr) return;
  fix_->setText(tr("Fix"));
  fix_->setToolTip(QString::fromStdString(fix.text));
  fix_->setAccessibleName(fix_->toolTip());
  fix_->adjustSize();
  put(places, *fix_, sheet_to_widget(pane, middle_of_stroke(*stroke)) + QPointF(14, 10), pane);
}

void PerspectiveChips::place_mirror(ChipPlaces& places, const ViewPane& pane) {
  if (!sheet_.proposal()) return;
  const auto count = static_cast<int>(sheet_.proposal()->strokes.size());
  mirror_->setText(count == 1 ? tr("Add 1 mirrored stroke (Enter)") : tr("Add %1 mirrored strokes (Enter)").arg(count));
  mirror_->adjustSize();
  put(places, *mirror_, QPointF(pane.rect.center().x() - mirror_->width() / 2.0, pane.rect.bottom() - 40), pane);
}

void PerspectiveChips::place_through(ChipPlaces& places, bool through) {
  const ViewPane& pane = places.layout().pane(PerspectiveView);
  if (sheet_.result() == nullptr || !pane.visible()) return;
  through_->setText(tr("Look through"));
  through_->setToolTip(tr("See the solid from the drawing's eye, with the drawing over it (V)"));
  through_->setChecked(through);
  through_->adjustSize();
  put(places, *through_, QPointF(pane.rect.center().x() - through_->width() / 2.0, pane.rect.top() + chip_margin),
      pane);
}

}  // namespace croquis::app
