// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tools/silhouette/joint_chips.h"

#include <utility>

namespace croquis::app {
namespace {

constexpr int joint_size = 18;
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

void show_joint(QToolButton& chip, const Joint& joint) {
  const QString names = QString::fromStdString(joint.a) + " – " + QString::fromStdString(joint.b);
  chip.setChecked(joint.attached);
  chip.setText(joint.attached ? QStringLiteral("✓") : QStringLiteral("+"));
  chip.setToolTip(joint.attached ? JointChips::tr("%1 are one body: click to part them").arg(names)
                                 : JointChips::tr("%1: click to make them one body").arg(names));
  chip.setAccessibleName(chip.toolTip());
}

}  // namespace

JointChips::JointChips(Studio& studio, QWidget* views) : QObject(views), studio_(studio), views_(views) {}

void JointChips::add_chip() {
  auto* chip = new QToolButton(views_);
  const std::size_t place = chips_.size();
  chip->setObjectName("joint-" + QString::number(place));
  chip->setCheckable(true);
  chip->setFixedSize(joint_size, joint_size);
  chip->setFocusPolicy(Qt::NoFocus);
  chip->setStyleSheet(joint_style);
  chip->hide();
  connect(chip, &QToolButton::clicked, this, [this, place] {
    const std::string text = toggled_joint(attach_text(studio_), joints_.at(place));
    studio_.set_parameter(studio_.solid_node(), "attach", text, false);
  });
  chips_.push_back(chip);
}

void JointChips::follow_result() {
  joints_.clear();
  if (const auto result = studio_.result()) joints_ = suggested_joints(*result, attach_text(studio_));
  while (chips_.size() < joints_.size()) add_chip();
  for (std::size_t i = 0; i < joints_.size(); ++i) show_joint(*chips_[i], joints_[i]);
}

void JointChips::join_all() {
  std::string text = attach_text(studio_);
  for (const Joint& joint : joints_) {
    if (!joint.attached) text = toggled_joint(text, joint);
  }
  if (!joints_.empty()) studio_.set_parameter(studio_.solid_node(), "attach", text, false);
}

void JointChips::place(ChipPlaces& places, bool shown) {
  const ViewPane& pane = places.layout().pane(SketchView);
  for (std::size_t i = 0; i < chips_.size(); ++i) {
    QToolButton& chip = *chips_[i];
    chip.hide();
    if (i >= joints_.size() || !pane.visible() || !shown) continue;
    const Vec2 pixel = pane.sketch_frame().to_pixel(joints_[i].at);
    const QPointF at = pane.rect.topLeft() + QPointF(pixel.x(), pixel.y());
    if (pane.rect.contains(at)) places.put(chip, at - QPointF(chip.width(), chip.height()) / 2, pane.rect);
  }
}

}  // namespace croquis::app
