// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <functional>
#include <optional>

#include "app/studio/studio.h"
#include "app/tools/mesh/mesh_overlay.h"
#include "app/views/object_picker.h"
#include "croquis/tools/mesh/mesh_tool.h"
#include "croquis/tools/objects/object_mover.h"
#include "croquis/tools/pointer/pen.h"

namespace croquis::app {

class Viewport;

/// Work on meshes: pen and mouse events of any view pick objects and their elements, move and tag them.
class MeshInteraction : public QObject {
  Q_OBJECT

 public:
  /// @param views outlive this
  MeshInteraction(Studio& studio, Viewport& views, QObject* parent);

  MeshTool& tool() { return tool_; }
  const MeshTool& tool() const { return tool_; }

  /// Runs one of the tool's functions; what it did is recorded, what it lost or refused is reported.
  void act(const std::function<Verdict(MeshTool&)>& work);

  void set_mode(MeshMode mode);
  void set_handles(MeshHandles handles);

  /// An event of a view, its place in that view's pixels.
  void take(const PointerEvent& event);
  void leave();

  bool down() const { return pen_.down(); }
  bool abandon();  ///< gives up the gesture under way, or the loop cut. @return false when there was neither

  /// A click or drag between places of the model, as a recording has it. @param clicks 2 for a double click
  void replay(int view, const Vec3& from, const Vec3& to, const Modifiers& modifiers, int clicks);

  /// Shows what is there after the document or the selection has changed.
  void follow();

  const MeshOverlay& overlay() const { return overlay_; }

  /// What is picked are objects, and the pointer moves these.
  bool picks_objects() const { return tool_.selection().mode() == MeshMode::Object; }

  /// Only the smooth surface is wanted, also while elements are picked; a mode that picks them shows the cage again.
  bool cage_hidden() const { return cage_hidden_; }
  void hide_cage(bool hidden);

  /// The next action, in words and keys. @param offer for the selected object, while nothing else is to be said
  QString help(const QString& offer) const;

  /// What is drawn over a view: tags and elements, handles, and the box of a gesture in it.
  /// @param with_handles the tool works there
  void add_to(render::Scene& scene, int view, bool with_handles);

  /// What stands beside the pointer, and its place in the view: the sharpness of the edge there, or what a drag has
  /// done.
  struct HoveredValue {
    int view = 0;
    Vec2 pixel = Vec2::Zero();
    QString text;
  };
  const std::optional<HoveredValue>& hovered_value() const { return hovered_value_; }

 signals:
  void changed();       ///< what is drawn over the views
  void mode_changed();  ///< mode or handles
  void committed(const croquis::recorded::Step& step);
  void told(const QString& sentence);  ///< empty: the message goes

 private:
  void feed(const PenStep& step);
  void feed(const MeshEvent& event, int view);
  void finish(Verdict verdict);
  void feed_object(const MeshEvent& event, int view);
  void choose_objects(std::vector<NodeId> nodes, const Modifiers& modifiers);
  ViewFrame frame_in(int view) const;
  void hover(const PointerEvent& event);
  const ManipulatorMotion* motion() const;  ///< of the drag of a handle under way; null without one

  Studio& studio_;
  Viewport& views_;
  MeshTool tool_;
  ObjectMover mover_;
  PenInput pen_;
  MeshOverlay overlay_;
  ObjectPicker objects_;
  bool cage_hidden_ = false;
  int gesture_view_ = 0;
  std::optional<Vec2> object_press_;  ///< in object mode: where the press was, pixels
  std::optional<PickBox> object_box_;
  std::optional<HoveredValue> hovered_value_;
};

}  // namespace croquis::app
