// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "app/tools/tool.h"
#include "croquis/edits/edit.h"
#include "croquis/tools/mesh/mesh_tool.h"

class QMenu;
class QPushButton;
class QToolBar;

namespace croquis::app {

class MeshEditingTool;

/// Files don't name their units: a mesh in metres is a dot in a sketch. An action gives it the size of the rest, and a
/// button below the views offers that for what was added.
class ScaleOffer {
 public:
  ScaleOffer(ToolHost& host, ActionList& actions, QMenu* menu);

  /// The active object was added; the button comes where it is far larger or smaller than the rest.
  void offer();

  /// After the document or the active object has changed.
  void follow();

 private:
  ToolHost& host_;
  QPushButton* button_;
  std::size_t offered_at_ = 0;  ///< steps of the history when it was; another step takes the offer back
  NodeId offered_ = 0;          ///< the object that was added
};

/// The actions of work on meshes that are enabled, checked or shown by what is there.
struct MeshActions {
  QList<QAction*> of_mesh;  ///< that need a mesh to work on
  std::map<MeshMode, QAction*> modes;
  std::vector<std::pair<QAction*, EditDescription>> edits;  ///< that have no action of their own
  QToolBar* bar = nullptr;
  std::unique_ptr<ScaleOffer> scale;
};

/// Does a step of the mesh tool, where there is a mesh.
void take_step(MeshEditingTool& tool, const recorded::Step& step);

/// A named set of the selected edges or vertices.
void make_crease_set(MeshEditingTool& tool);

/// What replays can do with meshes.
void add_mesh_replays(Replays& replays, MeshEditingTool& mesh, Studio& studio);

/// Which of them are enabled and checked now.
void refresh_mesh_actions(const MeshActions& made, MeshTool& tool, ToolHost& host, bool picks_elements);

MeshActions make_mesh_actions(MeshEditingTool& tool, ToolHost& host, ActionList& actions);

}  // namespace croquis::app
