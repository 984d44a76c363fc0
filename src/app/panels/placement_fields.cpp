// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/placement_fields.h"

#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <array>

#include "app/panels/number_box.h"
#include "app/panels/number_keys.h"

namespace croquis::app {
namespace {

constexpr int least_width = 52;  // three of them beside their title
constexpr double farthest = 1e12;

}  // namespace

PlacementFields::PlacementFields(QWidget* parent) : QWidget(parent), evenly_(new QCheckBox(tr("Keep proportions"))) {
  setObjectName("placement");
  auto* grid = new QGridLayout(this);
  grid->setVerticalSpacing(3);
  grid->setHorizontalSpacing(4);
  const std::array names{"position", "rotation", "size"};
  const std::array tips{tr("Where the middle of its box is: x, y, z"),
                        tr("Degrees about x, then y, then z, around its middle"),
                        tr("How far it reaches along its own x, y and z")};
  for (int row = 0; row < 3; ++row) {
    const auto at = static_cast<std::size_t>(row);
    labels_[at] = new QLabel(this);
    labels_[at]->setToolTip(tips[at]);
    grid->addWidget(labels_[at], row, 0);
    for (int axis = 0; axis < 3; ++axis) {
      const QString name = QString("%1-%2").arg(names[at]).arg(QChar('x' + axis));
      QDoubleSpinBox* box = make_number_box(this, name, {-farthest, farthest, 2});
      box->setMinimumWidth(least_width);
      box->setButtonSymbols(QAbstractSpinBox::NoButtons);
      share_keys(box);
      connect(box, &QDoubleSpinBox::valueChanged, this,
              [this, row, axis](double value) { edit(static_cast<Row>(row), axis, value); });
      boxes_[at][static_cast<std::size_t>(axis)] = box;
      grid->addWidget(box, row, 1 + axis);
    }
  }
  evenly_->setObjectName("size-evenly");
  evenly_->setToolTip(tr("A size along one axis changes the others by the same factor"));
  grid->addWidget(evenly_, 3, 1, 1, 3);
}

Vec3 PlacementFields::shown_in(Row row) const {
  if (row == Position) return placement_.map()((box_[0] + box_[1]) / 2);
  return row == Rotation ? placement_.rotation : Vec3(placement_.scale.cwiseProduct(box_[1] - box_[0]));
}

void PlacementFields::follow(const Studio& studio) {
  const WorkObject* object = studio.active();
  const BoundingBox box = object == nullptr ? std::nullopt : studio.own_bounds(*object);
  setVisible(box.has_value());
  if (!box) return;
  object_ = object->node;
  placement_ = object->placement;
  box_ = *box;
  const QString unit = QString::fromStdString(studio.unit());
  labels_[Position]->setText(unit.isEmpty() ? tr("Position") : tr("Position, %1").arg(unit));
  labels_[Rotation]->setText(tr("Rotation, °"));
  labels_[Size]->setText(unit.isEmpty() ? tr("Size") : tr("Size, %1").arg(unit));
  for (const Row row : {Position, Rotation, Size}) {
    const Vec3 numbers = shown_in(row);
    for (int axis = 0; axis < 3; ++axis) {
      QDoubleSpinBox* field = boxes_[row][static_cast<std::size_t>(axis)];
      const QSignalBlocker quiet(field);
      field->setValue(numbers(axis));
      field->setEnabled(row != Size || numbers(axis) > 0);
    }
  }
}

void PlacementFields::edit(Row row, int axis, double value) {
  Placement changed = placement_;
  const Vec3 middle = (box_[0] + box_[1]) / 2;
  if (row == Position) {
    changed.position(axis) += value - shown_in(Position)(axis);
  } else if (row == Rotation) {
    changed.rotation(axis) = value;
  } else if (value > 0) {
    const double factor = value / shown_in(Size)(axis);
    for (int k = 0; k < 3; ++k) {
      if (evenly_->isChecked() && k != axis) changed.scale(k) *= factor;
    }
    changed.scale(axis) = value / (box_[1] - box_[0])(axis);
  }
  if (row != Position) changed = with_point_kept(changed, placement_, middle);
  emit placed(object_, changed);
}

}  // namespace croquis::app
