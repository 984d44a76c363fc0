// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <QObject>
#include <QTableWidget>
#include <array>
#include <memory>
#include <string>
#include <vector>

#include "app/studio/studio.h"
#include "app/tools/tool.h"
#include "app/views/object_scenes.h"

class QAction;
class QMenu;

namespace croquis::app {

/// The chains of sharp edges of a subdivided object: how long they are, whether they close, and between which angles
/// the surface folds along them. Its rows choose them.
class ChainTable : public QTableWidget {
  Q_OBJECT

 public:
  explicit ChainTable(QWidget* parent = nullptr);

  /// @param object may be null or have no chains
  void show_chains(const WorkObject* object);

  /// "5 creases, 1 pin" of the object; empty for none.
  static QString summary(const WorkObject* object);

  /// The tagged edges of the cage that a chain of the table descends from, by their vertices.
  std::vector<std::array<Index, 2>> cage_edges(int chain) const;

 signals:
  void chain_chosen(int chain);  ///< 0-based

 private:
  std::vector<std::vector<std::array<Index, 2>>> cage_edges_;  ///< per row
};

/// The active object's operation with one parameter changed, kept evaluated beside it: the same cage, another scheme.
/// Nothing of it is in the document.
class Comparison : public QObject {
  Q_OBJECT

 public:
  Comparison(Studio& studio, QThreadPool& threads, QObject* parent);

  bool shown() const { return shown_; }
  void show(bool shown);

  /// @param parameter of the operation, a Choice. @param value one of its choices
  void choose(const std::string& parameter, const std::string& value);

  /// The object in whose place this stands; 0 when there is none to compare with.
  NodeId object() const { return object_; }
  const render::MeshItemPtr& item() const { return item_.item(); }
  const QString& title() const { return title_; }  ///< "catmull-clark"
  bool busy() const { return shown_ && ((live_ && live_->busy()) || item_.busy()); }

  /// After the document has changed.
  void follow();

 signals:
  void changed();

 private:
  void take();

  Studio& studio_;
  LiveItem item_;
  bool shown_ = false;
  std::string parameter_ = "scheme";
  std::string value_;  ///< empty: another one than the object's
  NodeId object_ = 0;
  QString title_;
  std::unique_ptr<LiveNode> live_;
};

/// The level of subdivision of the active object that is shown; -1 where it isn't subdivided.
int shown_level(const Studio& studio);

/// Subdivision: cages become smooth surfaces, of this or that scheme, side by side.
class SubdivisionTool final : public Tool {
  Q_OBJECT

 public:
  explicit SubdivisionTool(ToolHost& host);

  Comparison& comparison() { return comparison_; }

  void make_actions(ActionList& actions) override;
  void make_panels(PanelDocks& panels) override;
  void make_replays(Replays& replays) override;
  void refresh() override;
  void follow(Change change) override;

  ViewUse use_of(int view) const override;
  ToolWords words() const override { return {.status = ChainTable::summary(studio().active())}; }
  ToolState state() const override { return {.busy = comparison_.busy()}; }
  QString offer() const override;
  void adjust(ObjectScenes::Wanted& wanted, int view) const override;

 private:
  void make_scheme_actions(ActionList& actions, QMenu* schemes, QMenu* compared);
  void compare(bool shown);  ///< another scheme's result beside the active object, or no longer
  void select_chain(int chain);

  Comparison comparison_;
  QList<QAction*> actions_;  ///< that need a mesh
  ChainTable* chains_ = nullptr;
};

}  // namespace croquis::app
