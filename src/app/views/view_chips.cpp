// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/views/view_chips.h"

#include <QLocale>
#include <QPainter>
#include <algorithm>

#include "app/panels/object_names.h"
#include "app/window/theme.h"
#include "croquis/render/sharpness_color.h"
#include "croquis/render/value_color.h"

namespace croquis::app {
namespace {

constexpr int joint_size = 18;
constexpr int legend_row = 16;
constexpr QSize legend_size(96, 16 * 7 + 24);
constexpr QColor legend_ink(60, 66, 76);
constexpr const char* name_style = "color: #5c6470; background: transparent; font-size: 12px";
constexpr const char* value_style =
    "background: #2b2d31; color: #f2f3f5; border: 1px solid #609ce6; border-radius: 5px; padding: 1px 6px;"
    " font-size: 12px";
constexpr const char* joint_style =
    "QToolButton { background: white; color: #3c4654; border: 1px solid #7a8698; border-radius: 9px; padding: 0;"
    " font-size: 13px }"
    "QToolButton:hover { background: #ffe2c2 }"
    "QToolButton:checked { background: #f28c28; color: #1c1c1e; border: 1px solid #a85a10 }";

std::string attach_text(const Studio& studio) {
  const Node* operation = studio.solid_operation();
  if (operation == nullptr) return {};
  const auto attach = operation->parameters.find("attach");
  return attach == operation->parameters.end() ? "" : std::get<std::string>(attach->second);
}

QLabel* label(QWidget* views, const char* style) {
  auto* made = new QLabel(views);
  made->setAttribute(Qt::WA_TransparentForMouseEvents);
  made->setStyleSheet(style);
  made->hide();
  return made;
}

QPointF sketch_to_widget(const ViewPane& pane, const Vec2& place) {
  const Vec2 pixel = pane.sketch_frame().to_pixel(place);
  return pane.rect.topLeft() + QPointF(pixel.x(), pixel.y());
}

QString faces(std::size_t count) {
  return count == 1 ? ViewChips::tr("1 face") : ViewChips::tr("%1 faces").arg(QLocale().toString(qulonglong(count)));
}

void prepare_legend(QWidget& legend, const QString& name, const QString& meaning, const QSize& size) {
  legend.setObjectName(name);
  legend.setAccessibleName(meaning);
  legend.setAttribute(Qt::WA_TransparentForMouseEvents);
  legend.setFixedSize(size);
  legend.hide();
}

/// A legend's ground and title. @return where its first row begins
int draw_card(QPainter& painter, const QRect& card, const QString& title) {
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  painter.setBrush(QColor(255, 255, 255, 190));
  painter.drawRoundedRect(card, 6, 6);
  QFont font = painter.font();
  font.setPixelSize(11);
  painter.setFont(font);
  painter.setPen(legend_ink);
  painter.drawText(QRect(8, 4, card.width() - 8, legend_row), Qt::AlignVCenter, title);
  return 4 + legend_row;
}

}  // namespace

SharpnessLegend::SharpnessLegend(QWidget* parent) : QWidget(parent) {
  prepare_legend(*this, "sharpness-legend", tr("Colours of tagged edges by sharpness"), legend_size);
}

void SharpnessLegend::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  int y = draw_card(painter, rect(), tr("Sharpness"));
  for (const render::SharpnessSample& sample : render::sharpness_legend()) {
    const QColor color(sample.color.r, sample.color.g, sample.color.b);
    painter.setPen(QPen(color, render::sharpness_width(sample.sharpness), Qt::SolidLine, Qt::RoundCap));
    painter.drawLine(QPointF(10, y + legend_row / 2.0), QPointF(32, y + legend_row / 2.0));
    painter.setPen(legend_ink);
    painter.drawText(QRect(40, y, width() - 40, legend_row), Qt::AlignVCenter, QString::fromStdString(sample.label));
    y += legend_row;
  }
}

ConfidenceLegend::ConfidenceLegend(QWidget* parent) : QWidget(parent) {
  prepare_legend(*this, "confidence-legend", tr("Colours of patches by confidence"),
                 {legend_size.width(), legend_row * 6 + 14});
}

void ConfidenceLegend::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  int y = draw_card(painter, rect(), tr("Confidence"));
  auto samples = render::value_legend();
  std::reverse(samples.begin(), samples.end());  // as scales stand: much above
  for (const render::ValueSample& sample : samples) {
    painter.fillRect(QRect(10, y, 22, legend_row), QColor(sample.color.r, sample.color.g, sample.color.b));
    painter.drawText(QRect(40, y, width() - 40, legend_row), Qt::AlignVCenter, QString::fromStdString(sample.label));
    y += legend_row;
  }
}

ViewChips::ViewChips(Studio& studio, QWidget* views)
    : QObject(views),
      studio_(studio),
      views_(views),
      hint_(label(views, "color: #8a93a0; background: transparent; font-size: 15px")),
      counts_(label(views, name_style)),
      value_(label(views, value_style)),
      legend_(new SharpnessLegend(views)),
      confidence_(new ConfidenceLegend(views)) {
  hint_->setText(tr("Trace me: one closed line becomes a solid"));
  counts_->setObjectName("counts");
  value_->setObjectName("edge-value");
  hint_->setObjectName("hint");
  for (QLabel*& name : names_) name = label(views, name_style);
}

void ViewChips::say(const QString& sentence) {
  hint_->setText(sentence);
  hint_stays_ = true;
}

void ViewChips::put(QWidget* chip, const QPointF& at, const QRectF& bounds, ChipSpace& space) {
  const auto place = space.take(QRect(at.toPoint(), chip->size()), bounds.toAlignedRect());
  if (place) chip->move(place->topLeft());
  chip->setVisible(place.has_value());
}

void ViewChips::place(const PaneLayout& layout, const Wanted& wanted) {
  ChipSpace space;
  const ViewPane& sketch = layout.pane(SketchView);
  const ViewPane& solid = layout.pane(layout.alone() >= 0 ? layout.alone() : PerspectiveView);
  place_names(layout, wanted, space);
  place_legends(solid, wanted, space);
  place_hint(sketch, wanted, space);
  place_joints(sketch, wanted, space);
  place_value(wanted, space);
}

void ViewChips::place_hint(const ViewPane& pane, const Wanted& wanted, ChipSpace& space) {
  if (!hint_stays_ && !(wanted.sketch->invites() && pane.visible() && !wanted.drawing)) return hint_->hide();
  hint_->adjustSize();
  put(hint_, QPointF(pane.rect.center().x() - hint_->width() / 2.0, pane.rect.bottom() - 60), views_->rect(), space);
}

void ViewChips::place_value(const Wanted& wanted, ChipSpace& space) {
  if (!wanted.value) return value_->hide();
  value_->setText(wanted.value->text);
  value_->adjustSize();
  put(value_, wanted.value->at + QPointF(14, -24), views_->rect(), space);
}

QString ViewChips::counts() const {
  QStringList lines;
  for (const StudioObject& object : studio_.objects()) {
    if (!object.visible || !object.shown()) continue;
    const QString name = object.node == studio_.solid_node() ? tr("Solid") : shown_name(object);
    QString line = name + ": " + faces(object.shown()->face_count());
    if (object.cage_mesh && object.shown()->face_count() != object.cage_mesh->face_count()) {
      line += tr(" from %1").arg(faces(object.cage_mesh->face_count()));
    }
    lines << line;
  }
  constexpr int lines_at_most = 8;
  if (lines.size() > lines_at_most) {
    const auto more = lines.size() - lines_at_most;
    lines = lines.mid(0, lines_at_most) << tr("and %1 more").arg(more);
  }
  return lines.join("\n");
}

void ViewChips::place_names(const PaneLayout& layout, const Wanted& wanted, ChipSpace& space) {
  const std::array<QString, view_count> titles{tr("Front"), tr("Perspective"), tr("Top"), tr("Side"),
                                               wanted.comparison};
  for (std::size_t view = 0; view < view_count; ++view) {
    const ViewPane& pane = layout.pane(static_cast<int>(view));
    const bool sketching = view == SketchView && (wanted.sketch->has_strokes() || wanted.sketch->invites());
    names_[view]->setText(sketching ? tr("Sketch") : titles[view]);
    names_[view]->adjustSize();
    if (pane.visible())
      put(names_[view], pane.rect.topLeft() + QPointF(10, 8), pane.rect, space);
    else
      names_[view]->hide();
  }
}

void ViewChips::place_legends(const ViewPane& pane, const Wanted& wanted, ChipSpace& space) {
  counts_->setText(counts());
  counts_->setAlignment(Qt::AlignRight);
  counts_->adjustSize();
  const auto place = [&](QWidget* chip, bool shown, double y) {
    if (shown && pane.visible())
      put(chip, QPointF(pane.rect.right() - chip->width() - 10, y), views_->rect(), space);
    else
      chip->hide();
  };
  place(counts_, !counts_->text().isEmpty(), pane.rect.top() + 8);
  place(legend_, wanted.legend, pane.rect.bottom() - legend_->height() - 10);
  place(confidence_, wanted.confidence, pane.rect.bottom() - confidence_->height() - 10);
}

void ViewChips::show_joints() {
  joints_.clear();
  if (studio_.result()) joints_ = suggested_joints(*studio_.result(), attach_text(studio_));
  while (joint_chips_.size() < joints_.size()) {
    auto* chip = new QToolButton(views_);
    const std::size_t place = joint_chips_.size();
    chip->setObjectName("joint-" + QString::number(place));
    chip->setCheckable(true);
    chip->setFixedSize(joint_size, joint_size);
    chip->setFocusPolicy(Qt::NoFocus);
    chip->setStyleSheet(joint_style);
    connect(chip, &QToolButton::clicked, this, [this, place] {
      const std::string text = toggled_joint(attach_text(studio_), joints_.at(place));
      studio_.set_parameter(studio_.solid_node(), "attach", text, false);
    });
    joint_chips_.push_back(chip);
  }
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    const Joint& joint = joints_[i];
    const QString names = QString::fromStdString(joint.a) + " – " + QString::fromStdString(joint.b);
    joint_chips_[i]->setChecked(joint.attached);
    joint_chips_[i]->setText(joint.attached ? QStringLiteral("✓") : QStringLiteral("+"));
    joint_chips_[i]->setToolTip(joint.attached ? tr("%1 are one body: click to part them").arg(names)
                                               : tr("%1: click to make them one body").arg(names));
    joint_chips_[i]->setAccessibleName(joint_chips_[i]->toolTip());
  }
}

void ViewChips::join_all() {
  std::string text = attach_text(studio_);
  for (const Joint& joint : joints_) {
    if (!joint.attached) text = toggled_joint(text, joint);
  }
  if (!joints_.empty()) studio_.set_parameter(studio_.solid_node(), "attach", text, false);
}

void ViewChips::place_joints(const ViewPane& pane, const Wanted& wanted, ChipSpace& space) {
  for (std::size_t i = 0; i < joint_chips_.size(); ++i) {
    QToolButton* chip = joint_chips_[i];
    const bool shown = i < joints_.size() && pane.visible() && !wanted.drawing;
    const QPointF at = shown ? sketch_to_widget(pane, joints_[i].at) : QPointF();
    if (shown && pane.rect.contains(at))
      put(chip, at - QPointF(chip->width(), chip->height()) / 2, pane.rect, space);
    else
      chip->hide();
  }
}

}  // namespace croquis::app
