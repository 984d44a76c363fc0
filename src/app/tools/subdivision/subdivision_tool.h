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
  QString title() const;  ///< "catmull-clark"
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
  std::string shown_value_;
  QString title_;
  std::unique_ptr<LiveNode> live_;
};

// The subdivision of the active object, as keys and menus change it: an operation between its cage and what is seen,
// so nothing is lost. Everything but what keys 1 to 3 show is one step of the history.

/// Shows the cage, both, or the smooth surface; for all but the cage the object gets the operation if it has none.
void show_smooth(Studio& studio, ChainView view);

/// Of the active object; -1 where it isn't subdivided.
int shown_level(const Studio& studio);

/// One level finer or coarser, within what the operation allows.
void change_level(Studio& studio, int by);

/// Gives the operation's parameter another value. @return whether there is such an operation
bool set_smoothing(Studio& studio, const std::string& parameter, const ParameterValue& value);

/// What is computed, a level or a scan with filled holes, becomes a mesh of its own, with its tags and patches; the old
/// object is hidden.
/// @throws Error (E_EMPTY) when nothing computed is seen, or it isn't finished
void freeze_level(Studio& studio);

enum class KeptShape { Faces, Outline };

/// Makes the active object's selected faces stay as they are on every level, or only their outline, by tags and pins;
/// bent faces are cut into triangles first. One step of the history.
/// @return what had to be done to the faces
/// @throws Error (E_EMPTY) when no faces are selected
Findings keep_selected_faces(Studio& studio, KeptShape kept);

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
