// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tools/surface/surface_chips.h"

#include <QLabel>
#include <QToolButton>
#include <algorithm>

#include "app/panels/number_box.h"
#include "app/views/viewport.h"
#include "croquis/attribute_surface/open_loop.h"

namespace croquis::app {
namespace {

constexpr double state_margin = 10;  // logical pixels
constexpr double network_hint_height = 70;
constexpr const char* network_hint_style = "color: #6d7683; background: transparent; font-size: 15px";
constexpr const char* lacking_style =
    "QToolButton, QLabel { background: #fff4df; color: #7a4a00; border: 1px solid #e0a030; border-radius: 9px;"
    " padding: 2px 9px } QToolButton:hover { background: #ffe2a8 }";
constexpr const char* sound_style =
    "QToolButton { background: #dff5e3; color: #14602a; border: 1px solid #2f9a4c; border-radius: 9px;"
    " padding: 2px 9px }";
constexpr const char* offer_style =
    "QToolButton { background: #f28c28; color: #1c1c1e; border: 1px solid #a85a10; border-radius: 9px;"
    " padding: 2px 9px } QToolButton:hover { background: #ffac58 }";
constexpr const char* number_style =
    "background: #2b2d31; color: #f2f3f5; border-radius: 5px; padding: 1px 6px; font-size: 12px; border: 1px solid %1";
constexpr std::size_t most_numbers = 60;

QString offset_number(double value) { return number_words(value, 2); }

}  // namespace

SurfaceChips::SurfaceChips(NetworkInteraction& network, const UniformGhost& ghost, Viewport& views)
    : QObject(&views),
      network_(network),
      ghost_(ghost),
      views_(views),
      hint_(make_chip_label(views, network_hint_style)),
      sentence_(make_chip("network-state")),
      patch_(make_chip("patch-chip")),
      gap_(make_chip_label(views, lacking_style)) {
  hint_->setObjectName("network-hint");
  hint_->setText(tr("Draw a curve: it lies on the ground, on what is under the pen, or between the curves it meets"));
  gap_->setObjectName("gap-chip");
  patch_->setText(tr("Patch (Enter)"));
  patch_->setToolTip(tr("The closed loop of curves becomes the border of one smooth patch"));
  patch_->setStyleSheet(offer_style);
  connect(patch_, &QToolButton::clicked, this, &SurfaceChips::patch_wanted);
  connect(sentence_, &QToolButton::clicked, this, [this] {
    if (!state_.elements.empty()) emit elements_wanted(state_.elements);
  });
}

QToolButton* SurfaceChips::make_chip(const QString& name) {
  auto* button = new QToolButton(&views_);
  button->setObjectName(name);
  button->setFocusPolicy(Qt::NoFocus);
  button->hide();
  return button;
}

void SurfaceChips::follow() {
  state_ = network_state(network_.network(), network_.shown(), network_.findings());
  const AttributeNetwork& network = network_.network();
  const NetworkElements selected = network_.tool().selected();
  offered_.clear();
  if (selected.empty()) {
    for (const AttributeSide& side : open_loop(network, {tolerance_of(network)}).sides)
      offered_.push_back(network.curves[side.curve].id);
  }
  loop_ = loop_state(network, selected.empty() ? offered_ : selected.curves);
}

/// Chips that stay are never hidden meanwhile: a button would forget that it is pressed.
void SurfaceChips::place(ChipPlaces& places, bool shown) {
  placed_.clear();
  view_ = places.layout().alone() >= 0 ? places.layout().alone() : PerspectiveView;
  if (shown && places.scene_pane().visible()) {
    place_hint(places);
    place_state(places);
    if (!network_.down()) place_loop(places);
    place_numbers(places);
  }
  std::vector<QWidget*> all{hint_, sentence_, patch_, gap_};
  all.insert(all.end(), labels_.begin(), labels_.end());
  for (QWidget* chip : all) {
    if (std::ranges::find(placed_, chip) == placed_.end()) chip->hide();
  }
}

void SurfaceChips::put(ChipPlaces& places, QWidget& chip, const QPointF& at, const QRectF& bounds) {
  places.put(chip, at, bounds);
  placed_.push_back(&chip);
}

/// Beside a place of the model, where it is seen.
void SurfaceChips::put_at(ChipPlaces& places, QWidget& chip, const Vec3& world) {
  constexpr QPointF beside(12, -10);
  const ViewPane& pane = places.scene_pane();
  const auto seen = views_.frame_of(view_).project(world);
  const QPointF at = pane.rect.topLeft() + (seen ? QPointF(seen->pixel.x(), seen->pixel.y()) : QPointF(-1, -1));
  if (seen && pane.rect.contains(at)) put(places, chip, at + beside, pane.rect);
}

void SurfaceChips::place_hint(ChipPlaces& places) {
  if (!network_.network().curves.empty() || network_.down()) return;
  hint_->adjustSize();
  const QRectF& rect = places.scene_pane().rect;
  put(places, *hint_, QPointF(rect.center().x() - hint_->width() / 2.0, rect.bottom() - network_hint_height), rect);
}

void SurfaceChips::place_state(ChipPlaces& places) {
  if (state_.sentence.isEmpty()) return;
  const char* style = state_.sound ? sound_style : lacking_style;
  if (sentence_->styleSheet() != style) sentence_->setStyleSheet(style);
  const QRectF& rect = places.scene_pane().rect;
  const int room = static_cast<int>(rect.width() - 8 * state_margin);
  sentence_->setText(sentence_->fontMetrics().elidedText(state_.sentence, Qt::ElideRight, room));
  sentence_->setToolTip(state_.elements.empty() ? QString() : state_.sentence + "\n" + tr("Click to see where"));
  sentence_->adjustSize();
  put(places, *sentence_, QPointF(rect.center().x() - sentence_->width() / 2.0, rect.top() + state_margin), rect);
}

/// On the selected curves: that they are a loop, or what they lack.
void SurfaceChips::place_loop(ChipPlaces& places) {
  if (!loop_) return;
  if (loop_->closed) {
    patch_->adjustSize();
    return put_at(places, *patch_, network_.to_world()(loop_->middle));
  }
  if (loop_->sentence.isEmpty()) return;
  gap_->setText(loop_->sentence);
  gap_->adjustSize();
  put_at(places, *gap_, network_.to_world()(loop_->gap.value_or(loop_->middle)));
}

std::vector<PlacedText> SurfaceChips::numbers() const {
  std::vector<PlacedText> numbers;
  const SurfacePreview& preview = network_.tool().preview();
  const std::vector<Vec3> ring = network_.tool().ring();
  if (preview.radius && !ring.empty())
    numbers.push_back(
        {network_.to_world()(ring.front()), tr("radius %1").arg(number_words(*preview.radius)), QColor("#f28c28")});
  if (const UniformGhost::Compared* compared = ghost_.compared()) {
    for (const ComparedPoint& point : compared->comparison.points) {
      const Index index = find_element(network_.network(), NetworkElement::Point, point.id);
      if (index == no_index || !point.own || !point.uniform) continue;
      numbers.push_back(
          {network_.to_world()(network_.network().points[index].point),
           tr("off by %1, uniform %2").arg(offset_number(point.own->offset), offset_number(point.uniform->offset)),
           QColor("#f28c28")});
    }
  }
  const std::vector<PlacedText>& jumps = network_.scene().numbers();
  numbers.insert(numbers.end(), jumps.begin(), jumps.end());
  if (numbers.size() > most_numbers) numbers.resize(most_numbers);
  return numbers;
}

QLabel& SurfaceChips::label(std::size_t number) {
  while (labels_.size() <= number) {
    labels_.push_back(make_chip_label(views_, ""));
    labels_.back()->setObjectName("network-number");
  }
  return *labels_[number];
}

void SurfaceChips::place_numbers(ChipPlaces& places) {
  std::size_t used = 0;
  for (const PlacedText& number : numbers()) {
    QLabel& chip = label(used++);
    const QString style = QString(number_style).arg(number.color.name());
    if (chip.styleSheet() != style) chip.setStyleSheet(style);
    chip.setText(number.text);
    chip.adjustSize();
    put_at(places, chip, number.at);
  }
}

}  // namespace croquis::app
