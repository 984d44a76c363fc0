// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <functional>

#include "app/tools/holes/hole_interaction.h"
#include "app/tools/holes/surface_check.h"

class QAction;
class QBoxLayout;
class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QPushButton;
class QSlider;
class QSpinBox;

namespace croquis::app {

class HoleTable;
class SizeSlider;

/// The holes of the active object, what can be done with them and how patches are made.
class HolePanel : public QWidget {
  Q_OBJECT

 public:
  /// @param action finds the window's actions by name: buttons do what menus and keys do
  HolePanel(Studio& studio, HoleInteraction& holes, std::function<QAction*(const QString&)> action, QWidget* parent);

  /// After the document, a result or the selection has changed.
  void follow();

  const SurfaceCheck& check() const { return check_; }
  HoleTable& table() { return *table_; }
  SizeSlider& sizes() { return *sizes_; }

 signals:
  void frame_wanted();  ///< of what is selected

 private:
  void make_head(QBoxLayout* column);
  void make_buttons(QBoxLayout* column);
  void make_sizes(QBoxLayout* column);
  void make_preset(QBoxLayout* column);
  void make_way(QBoxLayout* column);
  void make_shape(QBoxLayout* column);
  void make_mode(QBoxLayout* column);
  QPushButton* action_button(const QString& action, const QString& text, QBoxLayout* row);
  void follow_sizes();
  void follow_way();
  void follow_mode();
  void follow_check();

  Studio& studio_;
  HoleInteraction& holes_;
  std::function<QAction*(const QString&)> action_;
  SurfaceCheck check_;
  QLabel* summary_;
  QLabel* checked_;
  HoleTable* table_;
  SizeSlider* sizes_;
  QPushButton* fill_sizes_;
  QComboBox* preset_;
  QLabel* way_of_;
  QComboBox* fairness_;
  QComboBox* kernel_;
  QSlider* bulge_slider_;
  QDoubleSpinBox* bulge_;
  QSpinBox* trim_;
  QComboBox* mode_;
  QLabel* estimate_;
  QPushButton* start_;
};

}  // namespace croquis::app
