// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <functional>

#include "app/panels/panel.h"
#include "app/studio/studio.h"
#include "app/tools/holes/hole_interaction.h"
#include "app/tools/holes/surface_check.h"

class QAction;
class QComboBox;
class QLabel;
class QPushButton;

namespace croquis::app {

/// "About 9 s and 1.1 GB": what remeshing a scan costs with the parameters of a `fill` operation, before it begins.
QString estimate_sentence(const Studio& studio, const Node& node, const PolyMesh& scan);

class HoleTable;
class SizeSlider;

/// The holes of the active object, what can be done with them and how patches are made.
class HolePanel : public Panel {
  Q_OBJECT

 public:
  /// @param action finds the window's actions by name: buttons do what menus and keys do
  HolePanel(Studio& studio, HoleInteraction& holes, const std::function<QAction*(const QString&)>& action);

  const SurfaceCheck& check() const { return check_; }
  HoleTable& table() { return *table_; }
  SizeSlider& sizes() { return *sizes_; }

 signals:
  void frame_wanted();  ///< of what is selected

 private:
  using Action = std::function<QAction*(const QString&)>;
  bool is_there() const;  ///< the object worked on has the operation
  void make_head();
  void make_buttons(const Action& action);
  void make_sizes();
  void make_way();
  void make_shape();
  void make_mode();
  void follow_head();
  void follow_sizes();
  void follow_estimate();
  void follow_check();

  Studio& studio_;
  HoleInteraction& holes_;
  SurfaceCheck check_;
  QLabel* summary_;
  QLabel* checked_;
  HoleTable* table_;
  SizeSlider* sizes_;
  QPushButton* fill_sizes_ = nullptr;
  QComboBox* mode_ = nullptr;
  QLabel* estimate_ = nullptr;
  QPushButton* start_ = nullptr;
};

}  // namespace croquis::app
