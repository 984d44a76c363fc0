// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <QWidget>
#include <array>
#include <map>
#include <optional>
#include <vector>

#include "app/studio/studio.h"
#include "app/tools/tool.h"
#include "app/views/object_scenes.h"
#include "app/views/view_pane.h"
#include "croquis/tools/pointer/navigation.h"

namespace croquis::app {

class OffscreenPictures;

/// What the views of a widget show: where they lie, what their cameras see, the surfaces of objects, and the tools.
/// Plain data, and functions of it; what draws it follows its signals.
class Views : public QObject {
  Q_OBJECT

 public:
  Views(Studio& shown, QWidget& around);

  Studio& studio;
  QWidget& widget;  ///< that they fill
  PaneLayout layout;
  ObjectScenes objects;
  std::vector<Tool*> tools;
  QString mode = first_mode;  ///< what the pointer does: the id of a tool's mode
  MeshLook look = MeshLook::Shaded;
  bool zebra = false;  ///< stripes that show how smoothly surfaces meet
  int under_pointer = SketchView;
  Navigation navigation;
  NodeId through = 0;       ///< the first node of the object whose camera holds the perspective view, until it is moved
  bool turned = false;      ///< the user moved the perspective view: it isn't framed by itself any more
  bool clear = true;        ///< the views lie elsewhere: what is between them is painted again
  bool had_meshes = false;  ///< a document's first mesh sets the views up
  std::array<bool, view_count> framed{};        ///< flat views show what there is when they are first seen
  std::map<NodeId, render::MeshItemPtr> known;  ///< objects as they were when it was last asked whether some are new

 signals:
  void changed(int view = every_view);  ///< has to be drawn again; of ink_alone only the ink
  void camera_moved(int view);          ///< and moves on: it is drawn with fewer triangles meanwhile
  void help_changed();
  void look_through_changed();  ///< the perspective view is held at another camera, or free

  /// A gesture changed the document or the selection.
  void committed(const croquis::recorded::Step& step);
};

// ---- The tools

/// Before anything is shown. @param tools outlive the views
void set_tools(Views& views, std::vector<Tool*> tools);
void set_mode(Views& views, const QString& mode);

/// The tool that pointer events of a view go to, or null: then plain drags rotate it.
Tool* tool_in(const Views& views, int view);
/// A tool has put something of its own there.
bool is_drawn_on(const Views& views, int view);
/// Drawn as a sheet of paper.
bool is_paper(const Views& views, int view);
/// Of the stroke under way.
std::optional<Ink> ink_in(const Views& views);

/// A gesture is under way.
bool any_down(const Views& views);
/// Gives up the gesture under way. @return false when there was none
bool abandon(const Views& views);

/// The next action, in words and keys.
QString help_of(const Views& views);
/// The heading of the manual about the tool that works in the view under the pointer.
QString help_topic_of(const Views& views);

/// The cursor of the tool that works in a view.
void show_cursor(const Views& views, int view);

// ---- Cameras

/// How tools see the model in a view.
ViewFrame frame_of(const Views& views, int view);
/// The same for those that work in the space of the active object.
ViewFrame own_frame_of(const Views& views, int view);

/// Where a place of the sketch plane, or of the model in a view, is seen, in the widget's logical pixels.
QPointF sketch_to_widget(const Views& views, const Vec2& place);
QPointF model_to_widget(const Views& views, const Vec3& place, int view);

/// As people do: a tool that holds the view's camera lets go of it.
void move_camera(Views& views, int view, const CameraMotion& motion);
/// The same by hand: the view isn't framed by itself any more.
void move_view(Views& views, const CameraMotion& motion);

/// Holds the perspective view at the camera of the object that begins with that node, until somebody rotates, pans or
/// zooms it; 0: frees it, and it stays where it is.
void look_through(Views& views, NodeId first);
/// The camera that the perspective view is held at, as soon as the object has one.
std::optional<SceneCamera> looked_through(const Views& views);

/// After the widget has got another size, or the layout has changed.
void lay_out(Views& views);
/// The view under the pointer alone, or the views of the arrangement again.
void toggle_layout(Views& views);
void frame_all(Views& views);
/// What is selected, in the view under the pointer.
void frame_selection(Views& views);
void frame_selection_in(Views& views, int view);
/// The perspective view shows the whole scene, if it doesn't already.
void show_scene(Views& views);

/// What is shown as the perspective view shows it, in a large picture. @throws Error
void export_picture(OffscreenPictures& pictures, const Views& views, const QString& path);

}  // namespace croquis::app
