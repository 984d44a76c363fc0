// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <array>
#include <functional>
#include <optional>

#include "app/tools/perspective/sheet_interaction.h"

class QAction;
class QBoxLayout;
class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QProgressBar;
class QPushButton;
class QTreeWidget;

namespace croquis::app {

class SheetSizeField;

/// The groups of strokes, the camera that was found, what is known, and which lines miss their vanishing point.
class PerspectivePanel : public QWidget {
  Q_OBJECT

 public:
  /// @param action finds the window's actions by name: buttons do what menus and keys do
  PerspectivePanel(SheetInteraction& sheet, const std::function<QAction*(const QString&)>& action);

  /// After the document, a result or the selection has changed.
  void follow();

 signals:
  void known_point_wanted(const std::optional<croquis::KnownPoint>& known);
  void known_length_wanted(const std::string& stroke, std::optional<double> length);
  void field_of_view_wanted(std::optional<double> radians);
  void sheet_size_wanted(const croquis::Vec2& size);
  void stroke_wanted(const std::string& stroke);  ///< selected in the list
  void overlay_wanted(double opacity);
  void unit_wanted(const std::string& unit);
  void parameter_wanted(const std::string& name, const croquis::ParameterValue& value);  ///< of the operation

 private:
  void make_groups(QBoxLayout* column, const std::function<QAction*(const QString&)>& action);
  void make_camera(QBoxLayout* column);
  void make_mode(QBoxLayout* column);
  void make_overlay(QBoxLayout* column);
  void make_known(QBoxLayout* column);
  void make_length(QBoxLayout* column);
  void make_lines(QBoxLayout* column);
  void follow_camera();
  void follow_mode();
  void follow_known();
  void follow_size();
  void follow_lines();
  void tell_point();

  SheetInteraction& sheet_;
  SheetSizeField* sheet_size_;
  QLabel* camera_;
  QComboBox* mode_;
  QCheckBox* flip_;
  QComboBox* unit_;
  QLabel* size_;
  QProgressBar* deviation_;
  QDoubleSpinBox* field_;
  QPushButton* pick_;
  QPushButton* forget_;
  std::array<QDoubleSpinBox*, 3> point_{};
  QDoubleSpinBox* length_;
  QLabel* length_of_;
  QTreeWidget* lines_;
  bool following_ = false;
};

}  // namespace croquis::app
