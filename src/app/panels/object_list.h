// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTreeWidget>
#include <set>
#include <string>
#include <vector>

#include "app/studio/studio.h"

namespace croquis::app {

/// All objects: the parts of the sketch's solid with the strokes that made them, strokes that belong to none, and the
/// meshes with an eye, a name that can be edited, their number of faces, and below them their patches.
class ObjectList : public QTreeWidget {
  Q_OBJECT

 public:
  explicit ObjectList(QWidget* parent = nullptr);

  void show_objects(Studio& studio);

  /// The object of the row; 0 for parts of the sketch.
  static NodeId node_of(const QTreeWidgetItem* row);

  /// The name of the row's set of faces; empty where it is none.
  static std::string set_of(const QTreeWidgetItem* row);

 signals:
  void strokes_chosen(const std::vector<std::string>& strokes);
  void objects_chosen(const std::vector<croquis::NodeId>& nodes);
  void sets_chosen(croquis::NodeId node, const std::vector<std::string>& names);
  void renamed(croquis::NodeId node, const std::string& name);
  void shown(croquis::NodeId node, bool visible);
  void removed(croquis::NodeId node);

 protected:
  void contextMenuEvent(QContextMenuEvent* event) override;

 private:
  void add_sketch(const Studio& studio);
  void add_mesh(const StudioObject& object, bool selected, Studio& studio);
  void add_sets(QTreeWidgetItem* row, const StudioObject& object, Studio& studio);
  QTreeWidgetItem* add_row(const QString& name, const QString& info);
  void take_click(QTreeWidgetItem* row);
  void take_change(QTreeWidgetItem* row, int column);

  std::set<NodeId> opened_;  ///< objects whose patches are listed one by one
};

}  // namespace croquis::app
