// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tools/mesh/tag_panel.h"

#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSlider>

#include "app/panels/number_box.h"
#include "app/tools/mesh/sharpness_field.h"

namespace croquis::app {
namespace {

constexpr double first_angle = 60;

QString elements(ComponentKind kind, std::size_t count) {
  const auto number = static_cast<int>(count);
  switch (kind) {
    case ComponentKind::Vertex: return number == 1 ? TagPanel::tr("1 vertex") : TagPanel::tr("%1 vertices").arg(number);
    case ComponentKind::Edge: return number == 1 ? TagPanel::tr("1 edge") : TagPanel::tr("%1 edges").arg(number);
    case ComponentKind::Face: break;
  }
  return number == 1 ? TagPanel::tr("1 face") : TagPanel::tr("%1 faces").arg(number);
}

}  // namespace

TagPanel::TagPanel(MeshInteraction& mesh, QWidget* parent)
    : QWidget(parent), mesh_(mesh), selected_(new QLabel(this)), sharpness_(new SharpnessField(this)) {
  setObjectName("tags");
  sharpness_->setObjectName("selected-sharpness");
  sharpness_->setToolTip(tr("Sharpness of the selected edges in levels: 0 smooth, 10 and more always sharp"));
  connect(sharpness_, &QDoubleSpinBox::valueChanged, this, [this] {
    const double sharpness = sharpness_->sharpness();
    mesh_.act([sharpness](MeshTool& tool) { return tool.tags().tag(sharpness); });
  });
  auto* layout = new QFormLayout(this);
  layout->setContentsMargins(6, 4, 6, 2);
  layout->setVerticalSpacing(3);
  layout->addRow(selected_, sharpness_);
  layout->addRow(make_angle_row());
}

QWidget* TagPanel::make_angle_row() {
  auto* row = new QWidget(this);
  auto* layout = new QHBoxLayout(row);
  layout->setContentsMargins(0, 0, 0, 0);
  angle_slider_ = new QSlider(Qt::Horizontal, row);
  angle_slider_->setObjectName("angle-slider");
  angle_slider_->setAccessibleName(tr("Least angle of edges to select"));
  angle_slider_->setRange(0, 180);
  angle_slider_->setValue(static_cast<int>(first_angle));
  angle_ = make_number_box(row, "angle", {0, 180, 1});
  angle_->setAccessibleName(tr("Least angle of edges to select"));
  angle_->setSuffix("°");
  angle_->setValue(first_angle);
  count_ = new QLabel(row);
  count_->setObjectName("angle-count");
  auto* tag = new QPushButton(tr("Sharp"), row);
  tag->setObjectName("tag-by-angle");
  tag->setToolTip(tr("Makes all edges sharp whose faces meet at a greater angle"));
  connect(angle_slider_, &QSlider::valueChanged, this, [this](int value) { choose_by_angle(value); });
  connect(angle_, &QDoubleSpinBox::valueChanged, this, &TagPanel::choose_by_angle);
  connect(tag, &QPushButton::clicked, this, [this] {
    const double degrees = angle_->value();
    mesh_.act([degrees](MeshTool& tool) { return tool.tags().tag_sharper_than(degrees); });
  });
  auto* name = new QLabel(tr("By angle"), row);
  name->setToolTip(tr("Drag: edges whose faces meet at a greater angle are selected and counted"));
  layout->addWidget(name);
  layout->addWidget(angle_slider_, 1);
  layout->addWidget(angle_);
  layout->addWidget(count_);
  layout->addWidget(tag);
  return row;
}

void TagPanel::choose_by_angle(double degrees) {
  {
    const QSignalBlocker quiet_slider(angle_slider_);
    const QSignalBlocker quiet_box(angle_);
    angle_slider_->setValue(static_cast<int>(degrees + 0.5));
    angle_->setValue(degrees);
  }
  const std::size_t count = mesh_.tool().tags().count_sharper_than(degrees);
  count_->setText(QString::number(count));
  if (mesh_.tool().selection().mode() != MeshMode::Edge) mesh_.set_mode(MeshMode::Edge);
  mesh_.act([degrees, count](MeshTool& tool) {
    return count == 0 ? tool.selection().select_none() : tool.selection().select_sharper_than(degrees);
  });
}

void TagPanel::follow(const ComponentSelection& selection) {
  MeshTool& tool = mesh_.tool();
  setEnabled(tool.editable().mesh() != nullptr);
  const bool edges =
      selection.node == tool.editable().node() && selection.kind == ComponentKind::Edge && !selection.empty();
  selected_->setText(selection.empty() ? tr("Sharpness") : elements(selection.kind, selection.elements.size()));
  sharpness_->setEnabled(!selection.empty());
  const bool known = edges && selection.elements.front() < tool.editable().edge_sharpness().size();
  sharpness_->show_sharpness(known ? tool.editable().edge_sharpness()[selection.elements.front()] : 0);
}

}  // namespace croquis::app
