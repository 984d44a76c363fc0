// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <functional>
#include <optional>

#include "app/studio/studio.h"
#include "app/tools/mesh/mesh_overlay.h"
#include "app/views/object_picker.h"
#include "croquis/tools/mesh/mesh_tool.h"
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

  /// The next action, in words and keys. @param offer for the selected object, while nothing else is to be said
  QString help(const QString& offer) const;

  /// What is drawn over a view, beside the overlay: handles, and the box of a gesture in it.
  void add_handles_to(render::Scene& scene, int view);

  /// The edge whose sharpness stands beside the pointer, with that text and its place in the view; none else.
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
  void choose_objects(std::vector<NodeId> nodes, bool add);
  void hover(const PointerEvent& event);

  Studio& studio_;
  Viewport& views_;
  MeshTool tool_;
  PenInput pen_;
  MeshOverlay overlay_;
  ObjectPicker objects_;
  int gesture_view_ = 0;
  std::optional<Vec2> object_press_;  ///< in object mode: where the press was, pixels
  std::optional<PickBox> object_box_;
  std::optional<HoveredValue> hovered_value_;
};

}  // namespace croquis::app
