// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/views/view_chips.h"

#include <QLocale>
#include <QToolButton>
#include <algorithm>
#include <utility>

#include "app/panels/object_names.h"
#include "app/views/view_handles.h"
#include "app/views/views.h"
#include "app/window/theme.h"

namespace croquis::app {
namespace {

constexpr int chip_gap = 2;

QRect held_within(QRect place, const QRect& bounds) {
  place.moveLeft(std::max(bounds.left(), std::min(place.left(), bounds.right() - place.width() + 1)));
  place.moveTop(std::max(bounds.top(), std::min(place.top(), bounds.bottom() - place.height() + 1)));
  return place;
}

int distance_squared(const QPoint& a, const QPoint& b) {
  const QPoint way = a - b;
  return QPoint::dotProduct(way, way);
}

constexpr double legend_margin = 10;

constexpr const char* name_style = "color: #4a515c; background: transparent; font-size: 12px";
constexpr const char* value_style =
    "background: #2b2d31; color: #f2f3f5; border: 1px solid %1; border-radius: 5px; padding: 1px 6px; font-size: 12px";
constexpr int lines_at_most = 8;

QString faces(std::size_t count) {
  return count == 1 ? Views::tr("1 face") : Views::tr("%1 faces").arg(QLocale().toString(qulonglong(count)));
}

/// How large the objects are that are shown.
QString counts_of(const Studio& studio) {
  QStringList lines;
  for (const WorkObject& object : studio.objects()) {
    if (!object.visible || !object.shown()) continue;
    const QString name = shown_name(object);
    QString line = name + ": " + faces(object.shown()->face_count());
    if (object.cage_mesh && object.shown()->face_count() != object.cage_mesh->face_count()) {
      line += Views::tr(" from %1").arg(faces(object.cage_mesh->face_count()));
    }
    lines << line;
  }
  if (lines.size() > lines_at_most) {
    const auto more = lines.size() - lines_at_most;
    lines = lines.mid(0, lines_at_most) << Views::tr("and %1 more").arg(more);
  }
  return lines.join("\n");
}

/// What a view is called by a tool, the camera that it is held at, or what it looks along.
QString title_of(const Views& views, int view) {
  const auto camera = view == PerspectiveView ? looked_through(views) : std::nullopt;
  if (camera) return Views::tr("Camera of %1").arg(camera->name);
  for (const Tool* tool : views.tools) {
    if (const QString title = tool->use_of(view).title; !title.isEmpty()) return title;
  }
  switch (view) {
    case SketchView: return Views::tr("Front");
    case PerspectiveView: return Views::tr("Perspective");
    case TopView: return Views::tr("Top");
    case SideView: return Views::tr("Side");
    default: return {};
  }
}

}  // namespace

bool ChipSpace::is_free(const QRect& place) const {
  const QRect wide = place.adjusted(-chip_gap, -chip_gap, chip_gap, chip_gap);
  return std::none_of(taken_.begin(), taken_.end(), [&](const QRect& other) { return other.intersects(wide); });
}

std::optional<QRect> ChipSpace::take(const QRect& wanted, const QRect& bounds) {
  const QRect first = held_within(wanted, bounds);
  std::optional<QRect> best;
  // The nearest free place is the wanted one, or touches others, or lies beside one at the wanted height or width.
  std::vector<int> lefts{first.left()};
  std::vector<int> tops{first.top()};
  if (!is_free(first)) {
    for (const QRect& other : taken_) {
      lefts.insert(lefts.end(), {other.left() - chip_gap - wanted.width(), other.right() + 1 + chip_gap});
      tops.insert(tops.end(), {other.top() - chip_gap - wanted.height(), other.bottom() + 1 + chip_gap});
    }
  }
  for (const int left : lefts) {
    for (const int top : tops) {
      const QRect place(QPoint(left, top), wanted.size());
      const bool nearer = !best || distance_squared(place.topLeft(), first.topLeft()) <
                                       distance_squared(best->topLeft(), first.topLeft());
      if (nearer && bounds.contains(place) && is_free(place)) best = place;
    }
  }
  if (best) taken_.push_back(*best);
  return best;
}

const ViewPane& ChipPlaces::scene_pane() const {
  return layout_.pane(layout_.alone() >= 0 ? layout_.alone() : PerspectiveView);
}

void ChipPlaces::put(QWidget& chip, const QPointF& at, const QRectF& bounds) {
  const auto place = space_.take(QRect(at.toPoint(), chip.size()), bounds.toAlignedRect());
  if (place) chip.move(place->topLeft());
  chip.setVisible(place.has_value());
}

void ChipPlaces::put(QWidget& chip, const QPointF& at) { put(chip, at, views_.rect()); }

void ChipPlaces::put_legend(QWidget& legend, bool shown) {
  const ViewPane& pane = scene_pane();
  if (!shown || !pane.visible()) return legend.hide();
  put(legend, QPointF(pane.rect.right() - legend.width(), pane.rect.bottom() - legend.height()) -
                  QPointF(legend_margin, legend_margin));
}

QLabel* ChipSet::label(const QString& name, const char* style) {
  QLabel* label = make_chip_label(views_, style);
  label->setObjectName(name);
  chips_.push_back(label);
  return label;
}

QToolButton* ChipSet::button(const QString& name, const char* style, std::function<void()> clicked) {
  auto* button = new QToolButton(&views_);
  button->setObjectName(name);
  button->setFocusPolicy(Qt::NoFocus);
  button->setStyleSheet(style);
  button->hide();
  QObject::connect(button, &QToolButton::clicked, button, std::move(clicked));
  chips_.push_back(button);
  return button;
}

void ChipSet::begin(ChipPlaces& places) {
  places_ = &places;
  put_.clear();
  used_values_ = 0;
}

void ChipSet::put(QWidget& chip, const QPointF& at, const QRectF& bounds) {
  places_->put(chip, at, bounds);
  put_.push_back(&chip);
}

void ChipSet::put_in_middle(QWidget& chip, double top, const QRectF& bounds) {
  chip.adjustSize();
  put(chip, QPointF(bounds.center().x() - chip.width() / 2.0, top), bounds);
}

void ChipSet::put_value(const QString& name, const QString& text, const QString& border, const QPointF& at,
                        const QRectF& bounds) {
  if (used_values_ == values_.size()) values_.push_back(label(name, ""));
  QLabel& value = *values_[used_values_++];
  const QString style = QString(value_style).arg(border);
  if (value.styleSheet() != style) value.setStyleSheet(style);
  value.setText(text);
  value.adjustSize();
  put(value, at, bounds);
}

void ChipSet::end() {
  for (QWidget* chip : chips_) {
    if (std::ranges::find(put_, chip) == put_.end()) chip->hide();
  }
}

QLabel* make_chip_label(QWidget& views, const char* style) {
  auto* made = new QLabel(&views);
  made->setAttribute(Qt::WA_TransparentForMouseEvents);
  made->setStyleSheet(style);
  made->hide();
  return made;
}

ViewChips::ViewChips(Views& views)
    : chips_(views.widget),
      handles_(std::make_unique<ViewHandles>(views)),
      message_(chips_.label({}, hint_style)),
      counts_(chips_.label("counts", name_style)) {
  for (QLabel*& name : names_) name = chips_.label({}, name_style);
}

ViewChips::~ViewChips() = default;

void ViewChips::say(const QString& sentence) {
  message_->setText(sentence);
  message_->adjustSize();
}

void ViewChips::place(const Views& views) {
  ChipPlaces places(views.layout, views.widget);
  chips_.begin(places);
  for (std::size_t view = 0; view < view_count; ++view) {
    const ViewPane& pane = views.layout.pane(static_cast<int>(view));
    names_[view]->setText(title_of(views, static_cast<int>(view)));
    names_[view]->adjustSize();
    if (pane.visible()) chips_.put(*names_[view], pane.rect.topLeft() + QPointF(10, 8), pane.rect);
  }
  counts_->setText(counts_of(views.studio));
  counts_->setAlignment(Qt::AlignRight);
  counts_->adjustSize();
  const QRectF scene = places.scene_pane().rect, all = views.widget.rect();
  if (!counts_->text().isEmpty() && places.scene_pane().visible())
    chips_.put(*counts_, QPointF(scene.right() - counts_->width() - 10, scene.top() + 8), all);
  if (!message_->text().isEmpty()) chips_.put_in_middle(*message_, all.center().y(), all);
  for (const Tool* tool : views.tools) {
    const QString text = tool->state().beside_pointer;
    if (text.isEmpty()) continue;
    constexpr QPointF from_pointer(14, -24);
    const PointerPlace& pointer = tool->pointer;
    const QPointF at(pointer.pixel.x(), pointer.pixel.y());
    const QPointF view = views.layout.pane(pointer.view).rect.topLeft();
    chips_.put_value("pointer-value", text, "#609ce6", view + at + from_pointer, all);
  }
  chips_.end();
  handles_->place(places);
  for (Tool* tool : views.tools) tool->place_chips(places);
}

}  // namespace croquis::app
