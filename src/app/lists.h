// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QListWidget>

#include "croquis/base/finding.h"
#include "croquis/document/evaluator.h"
#include "croquis/geometry/drawing.h"
#include "croquis/session/selection.h"

namespace croquis::app {

/// The solid's objects with the strokes that made them; strokes that belong to none come last.
class ObjectList : public QListWidget {
  Q_OBJECT

 public:
  explicit ObjectList(QWidget* parent = nullptr);

  /// @param evaluation may be null
  void show_objects(const Drawing& drawing, const Evaluation* evaluation, const Selection& selection);

 signals:
  void strokes_chosen(const std::vector<std::string>& strokes);
};

/// What is wrong with the drawing, one sentence a row.
class FindingsList : public QListWidget {
  Q_OBJECT

 public:
  explicit FindingsList(QWidget* parent = nullptr);

  void show_findings(const Findings& findings);

 signals:
  /// The strokes that the chosen sentence is about.
  void strokes_chosen(const std::vector<std::string>& strokes);
};

/// The steps that can be undone, the newest at the bottom, and those that can be redone, greyed.
class HistoryList : public QListWidget {
  Q_OBJECT

 public:
  explicit HistoryList(QWidget* parent = nullptr);

  void show_history(const std::vector<std::string>& done, const std::vector<std::string>& undone);

 signals:
  /// Somebody wants the document as it was after that many steps.
  void step_chosen(int steps);
};

}  // namespace croquis::app
