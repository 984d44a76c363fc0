// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <functional>

#include "app/studio/studio.h"
#include "croquis/geometry/component_kind.h"
#include "croquis/tools/recording/recording.h"

class QAction;
class QWidget;

namespace croquis::app {

class Viewport;

/// The window, as its tools know it.
class ToolHost {
 public:
  virtual ~ToolHost() = default;

  virtual Studio& studio() = 0;
  virtual Viewport& viewport() = 0;

  /// The action of that name, or null: what menus, keys and replays share.
  virtual QAction* action(const QString& name) const = 0;

  /// What the pointer does: the id of a tool's mode.
  virtual void set_mode(const QString& mode) = 0;

  /// Runs something that may throw; shows its findings below the views.
  virtual bool attempt(const std::function<void()>& work) = 0;

  /// The views are there, not the start page.
  virtual bool shows_views() const = 0;

  /// Beside the help line.
  virtual void add_status_widget(QWidget& widget) = 0;

  /// Selects elements of the active object's mesh, in the mode for them. @return false where no tool can
  virtual bool pick(ComponentKind kind, const std::vector<Index>& elements) = 0;

  /// What the pointer picks are elements of a mesh, not objects.
  virtual bool picks_elements() const = 0;

  /// Selects faces by the names of their sets. @throws Error (E_INPUT) when the object has no such set
  virtual void select_face_sets(NodeId node, const std::vector<std::string>& names) = 0;

  virtual void tell(const QString& sentence) = 0;
  virtual void show_message(const Findings& findings) = 0;

  /// Waits until what is shown is finished, as replays do. @throws Error (E_LIMIT)
  virtual void wait_until_settled() = 0;

  /// An empty sketch in the views.
  virtual void start_sketch() = 0;

  /// Begins to open a file as File > Open does.
  virtual void open_file(const QString& path) = 0;

  /// Another document in the views, where people don't keep theirs. @return false: they do
  virtual bool start_with(Document document) = 0;

  /// Appends a step to the recording, when one is made.
  virtual void record(const recorded::Step& step) = 0;

  /// Panels, actions and the help line show what is there now.
  virtual void refresh() = 0;

  /// What the tools offer for an object that is selected, in words and keys; of the first that offers something.
  virtual QString offer_for(const WorkObject& object) const = 0;
};

}  // namespace croquis::app
