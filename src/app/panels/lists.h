// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAction>
#include <QListWidget>
#include <QTreeWidget>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "app/panels/object_names.h"
#include "app/studio/studio.h"

namespace croquis::app {

/// What is wrong with the drawing and the meshes, one sentence a row.
class FindingsList : public QListWidget {
  Q_OBJECT

 public:
  explicit FindingsList(QWidget* parent = nullptr);

  /// @param owner names the object that a finding is about, where that isn't clear
  /// @param fixes what can be done about a finding: rows of their own below it
  void show_findings(const std::vector<NodeFinding>& findings, const std::function<QString(const NodeFinding&)>& owner,
                     const std::function<std::vector<QAction*>(const NodeFinding&)>& fixes);

 protected:
  void paintEvent(QPaintEvent* event) override;  ///< with what belongs here while nothing is wrong

 signals:
  /// The user wants to see what this one is about.
  void finding_chosen(const croquis::NodeFinding& finding);
  void fix_chosen(const croquis::NodeFinding& finding, QAction* fix);

 private:
  struct Row {
    NodeFinding finding;
    QAction* fix = nullptr;  ///< of a row that offers one
  };
  std::vector<Row> rows_;
};

/// The steps that can be undone, the newest at the bottom, and those that can be redone, greyed.
class HistoryList : public QListWidget {
  Q_OBJECT

 public:
  explicit HistoryList(QWidget* parent = nullptr);

  void show_history(const std::vector<std::string>& done, const std::vector<std::string>& undone);

 signals:
  /// The user wants the document as it was after that many steps.
  void step_chosen(int steps);
};

/// All objects with their chains: a row for what is seen, with an eye, a name that can be edited and its size; below it
/// its parts, and its steps from the last one down to what it begins with, each with its state. Objects of a group
/// stand below one row, which is selected, hidden and renamed for all of them.
class ObjectList : public QTreeWidget {
  Q_OBJECT

 public:
  /// The rows of a node of the object, in its chain.
  using Parts = std::function<std::vector<ObjectRow>(const WorkObject& object, NodeId node)>;

  ObjectList(Parts parts, QWidget* parent);

  void show_objects(const Studio& studio);

  /// The object or step of the row.
  static NodeId node_of(const QTreeWidgetItem* row);

  /// The row is a step of its object's chain.
  static bool is_step(const QTreeWidgetItem* row);

  /// What is selected with the row; empty for objects and steps.
  static std::vector<std::string> parts_of(const QTreeWidgetItem* row);

 signals:
  void parts_chosen(croquis::NodeId node, const std::vector<std::string>& parts);
  void objects_chosen(const std::vector<croquis::NodeId>& nodes);
  void step_chosen(croquis::NodeId step);
  void step_enabled(croquis::NodeId step, bool enabled);
  void renamed(croquis::NodeId node, const std::string& name);
  void group_renamed(const std::string& group, const std::string& name);
  void shown(const std::vector<croquis::NodeId>& objects, bool visible);

  /// People want the actions of this object or step, at a place of the screen. It is selected already.
  void menu_wanted(croquis::NodeId node, bool step, const QPoint& at);

 protected:
  void contextMenuEvent(QContextMenuEvent* event) override;
  void paintEvent(QPaintEvent* event) override;  ///< with what belongs here while there are no objects

 private:
  QTreeWidgetItem* group_row(const std::string& group);
  void add_object(const WorkObject& object, const Studio& studio);
  std::vector<NodeId> objects_of(const QTreeWidgetItem* row) const;
  void add_steps(QTreeWidgetItem* row, const WorkObject& object, const Studio& studio);
  void add_parts(QTreeWidgetItem* below, const std::vector<ObjectRow>& rows, NodeId node, const Selection& selection);
  void take_click(QTreeWidgetItem* row);
  void take_change(QTreeWidgetItem* row, int column);
  void take_opening(QTreeWidgetItem* row, bool opened);
  void choose_parts(NodeId node);

  Parts parts_;
  std::map<QTreeWidgetItem*, std::function<void(const std::string&)>> renames_;  ///< of rows of parts
  std::set<std::pair<NodeId, QString>> turned_;  ///< rows that people opened or closed, other than they first are
};

}  // namespace croquis::app
