// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <array>

#include "app/studio/studio.h"

class QCheckBox;
class QDoubleSpinBox;
class QLabel;

namespace croquis::app {

/// Where the active object stands, as numbers: the middle of its box, its rotation in degrees, and its size along its
/// own axes.
class PlacementFields : public QWidget {
  Q_OBJECT

 public:
  explicit PlacementFields(QWidget* parent = nullptr);

  /// Of the active object; hidden without one that has a mesh.
  void follow(const Studio& studio);

 signals:
  /// People gave a number another value.
  void placed(croquis::NodeId object, const croquis::Placement& placement);

 private:
  enum Row { Position, Rotation, Size };

  void edit(Row row, int axis, double value);
  Vec3 shown_in(Row row) const;

  NodeId object_ = 0;
  Placement placement_;
  std::array<Vec3, 2> box_{};  ///< in the object's own space
  std::array<std::array<QDoubleSpinBox*, 3>, 3> boxes_{};
  std::array<QLabel*, 3> labels_{};
  QCheckBox* evenly_;
};

}  // namespace croquis::app
