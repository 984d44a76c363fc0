// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "app/tools/mesh/mesh_interaction.h"

class QDoubleSpinBox;
class QLabel;
class QPushButton;
class QSlider;

namespace croquis::app {

class SharpnessField;

/// Sharpness of what is selected as a number, and edges chosen by their angle with their count while one drags.
class TagPanel : public QWidget {
  Q_OBJECT

 public:
  TagPanel(MeshInteraction& mesh, QWidget* parent);

  /// After the document or the selection has changed.
  void follow(const ComponentSelection& selection);

  /// Chooses the edges whose faces meet at a greater angle. @param degrees 0..180
  void choose_by_angle(double degrees);

 private:
  QWidget* make_angle_row();

  MeshInteraction& mesh_;
  QLabel* selected_;
  SharpnessField* sharpness_;
  QSlider* angle_slider_;
  QDoubleSpinBox* angle_;
  QLabel* count_;
};

}  // namespace croquis::app
