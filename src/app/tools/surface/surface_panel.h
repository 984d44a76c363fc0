// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <array>
#include <functional>
#include <optional>
#include <string>

#include "app/tools/surface/network_interaction.h"

class QAction;
class QBoxLayout;
class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QGroupBox;
class QLabel;

namespace croquis::app {

/// What is selected of a network, in numbers: patches, curves with their slopes, points; and how well the surfaces keep
/// to it all.
class SurfacePanel : public QWidget {
  Q_OBJECT

 public:
  /// @param action finds the window's actions by name: buttons do what menus and keys do
  SurfacePanel(NetworkInteraction& network, const std::function<QAction*(const QString&)>& action);

  /// After the document, a result or the selection has changed.
  void follow();

 private:
  /// Of a patch along the selected curve.
  struct SlopeRow {
    QWidget* row = nullptr;
    QLabel* title = nullptr;
    QDoubleSpinBox* magnitude = nullptr;
    SlopeTip shown;
  };

  void make_faces(QBoxLayout* column);
  void make_curves(QBoxLayout* column);
  void make_points(QBoxLayout* column);
  void make_buttons(QBoxLayout* column, const std::function<QAction*(const QString&)>& action);
  void follow_faces(const NetworkElements& selected);
  void follow_curves(const NetworkElements& selected);
  void follow_points(const NetworkElements& selected);
  void follow_slopes();
  QString quality_text() const;
  std::vector<std::string> faces_meant() const;
  void set_faces(const FaceSetting& setting);
  void set_points(const PointSetting& setting);
  void tell_point(std::size_t axis, double value);
  void tell_normal();
  const PointAttribute* first_point() const;
  const InnerCurve* first_inner(const NetworkElements& selected) const;

  NetworkInteraction& network_;
  bool following_ = false;
  QGroupBox* faces_;
  QComboBox* mode_;
  QDoubleSpinBox* fullness_;
  QComboBox* domain_;
  QGroupBox* curves_;
  QComboBox* join_;
  QComboBox* profile_;
  std::array<SlopeRow, 2> slopes_;
  QGroupBox* points_;
  std::array<QDoubleSpinBox*, 3> place_{};
  QDoubleSpinBox* radius_;
  QComboBox* tip_;
  QCheckBox* has_normal_;
  std::array<QDoubleSpinBox*, 3> normal_{};
  QLabel* quality_;
};

}  // namespace croquis::app
