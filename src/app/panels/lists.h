// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAction>
#include <QListWidget>
#include <functional>
#include <string>
#include <vector>

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

}  // namespace croquis::app
