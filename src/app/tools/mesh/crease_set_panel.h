// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <functional>
#include <string>

#include "app/tools/mesh/mesh_interaction.h"

class QTreeWidget;
class QTreeWidgetItem;
class QPushButton;

namespace croquis::app {

class SharpnessField;

/// The named sets of tagged edges and pins of the mesh that is worked on: made from the selection, renamed, given a
/// sharpness, selected, merged, removed.
class CreaseSetPanel : public QWidget {
  Q_OBJECT

 public:
  CreaseSetPanel(MeshInteraction& mesh, QWidget* parent);

  /// After the document or the selection has changed.
  void follow();

 private:
  QWidget* make_buttons();
  QPushButton* add_button(QWidget* row, const QString& name, const QString& text, const QString& tip,
                          std::function<void()> work);
  std::string chosen() const;  ///< the name of the first chosen set; empty for none
  void merge();

  MeshInteraction& mesh_;
  QTreeWidget* sets_;
  SharpnessField* sharpness_;
};

}  // namespace croquis::app
