// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QOpenGLWidget>
#include <QTimer>
#include <array>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "app/studio/studio.h"
#include "app/tools/tool.h"
#include "app/views/ink_sheet.h"
#include "app/views/marking_menu.h"
#include "app/views/object_scenes.h"
#include "app/views/pointer_events.h"
#include "app/views/view_chips.h"
#include "app/views/view_pane.h"
#include "croquis/render/renderer.h"
#include "croquis/tools/pointer/navigation.h"

namespace croquis::app {

class OffscreenPictures;

/// All views in one widget with one OpenGL context. Takes pen, mouse, touch and wheel, passes them to navigation or to
/// the tool that works in the view, and draws the surfaces of objects and what the tools show.
class Viewport : public QOpenGLWidget {
  Q_OBJECT

 public:
  using View = app::View;
  using enum app::View;

  Viewport(Studio& studio, QWidget* parent);
  ~Viewport() override;

  /// Before anything is shown. @param tools outlive this
  void set_tools(std::vector<Tool*> tools);

  /// What the pointer does: the id of a tool's mode.
  void set_mode(const QString& mode);
  const QString& mode() const { return mode_; }

  /// The tool that pointer events of a view go to, or null: then plain drags rotate it.
  Tool* tool_in(int view) const;

  MarkingMenu& marking_menu() { return marking_menu_; }

  /// As people do: a tool that holds the view's camera lets go of it.
  void move_camera(int view, const CameraMotion& motion);

  /// How tools see the model in a view.
  ViewFrame frame_of(int view) const;
  /// The same for those that work in the space of the active object.
  ViewFrame own_frame_of(int view) const;

  /// A tool has put something of its own there.
  bool is_drawn_on(int view) const;

  void set_look(MeshLook look);
  void set_flat(bool flat);
  void set_zebra(bool zebra);  ///< stripes that show how smoothly surfaces meet

  void frame_all();
  void frame_selection();
  void frame_selection_in(int view);

  /// The view under the pointer alone, or the views of the arrangement again.
  void toggle_layout();
  void arrange(Arrangement arrangement);
  void show_alone(int view);

  /// Where the borders between the views lie, as shares of the widget.
  QPointF pane_shares() const;
  void set_pane_shares(const QPointF& shares);
  /// The share of the view at the left, as long as nobody has moved the border.
  void suggest_share(double across);

  /// Holds the perspective view at the camera of the object that begins with that node, until somebody rotates, pans or
  /// zooms it; 0: frees it, and it stays where it is.
  void look_through(NodeId first);
  /// The camera that the perspective view is held at, as soon as the object has one.
  std::optional<SceneCamera> looked_through() const;
  NodeId look_through_node() const { return through_; }

  /// The perspective view shows the whole scene, if it doesn't already.
  void show_scene();

  /// Gives up the gesture under way. @return false when there was none
  bool abandon();

  /// The window itself was moved: by Alt and a drag, the desktop may keep them for itself.
  void note_window_moved();

  /// The next action, in words and keys.
  QString help() const;
  /// The heading of the manual about the tool that works in the view under the pointer.
  QString help_topic() const;

  /// What draws: the driver's own words.
  QString graphics();

  /// What is shown as the perspective view shows it, in a large picture. @throws Error
  void export_picture(OffscreenPictures& pictures, const QString& path) const;

  ViewPane& pane(int view) { return layout_.pane(view); }
  const PaneLayout& panes() const { return layout_; }
  ObjectScenes& objects() { return objects_; }
  const ObjectScenes& objects() const { return objects_; }

  void redraw(int view);
  void redraw_all();

  /// Draws the finer picture now instead of after a pause.
  void settle_now() { settle(true); }

  /// Every item of what is shown has been made and sent to the graphics card.
  bool settled() const;

  /// Where a place of the sketch plane, or of the model in a view, is seen, in the widget's logical pixels.
  QPointF sketch_to_widget(const Vec2& place) const;
  QPointF model_to_widget(const Vec3& place, int view) const;

  /// Milliseconds from the last input event to the end of the frame that showed it, and how often frames were drawn.
  double last_latency_ms() const { return latency_ms_; }
  int frames() const { return frames_; }

  /// How often a view was drawn whole: not where it would have looked as before.
  int pictures_drawn(int view) const { return states_[static_cast<std::size_t>(view)].drawn_count; }

  /// Of surfaces, in the picture of a view as it is.
  std::size_t triangles_drawn(int view) const { return states_[static_cast<std::size_t>(view)].triangles; }

 signals:
  void help_changed();

  /// The perspective view is held at another camera, or free.
  void look_through_changed();

  /// A gesture changed the document or the selection.
  void committed(const croquis::recorded::Step& step);

 protected:
  void initializeGL() override;
  void resizeGL(int width, int height) override;
  void paintGL() override;
  bool event(QEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void tabletEvent(QTabletEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void leaveEvent(QEvent* event) override;

 private:
  /// All that the pixels of a view depend on.
  struct Picture {
    render::Scene scene;
    render::RenderOptions options;
    render::Camera camera;
    QRectF rect;
    bool fine = false;

    bool operator==(const Picture&) const = default;
  };

  struct PaneState {
    bool drawn = false;   ///< its pixels are still right: most events change one view alone
    bool fine = false;    ///< drawn in full quality
    bool moving = false;  ///< its camera is: large meshes are drawn with fewer triangles
    int drawn_count = 0;
    std::size_t triangles = 0;       ///< drawn last
    std::optional<Picture> picture;  ///< that its pixels show, where it is whole
  };

  void connect_parts();
  struct LateMove {
    PointerEvent event;
    QPointF place;
  };

  double seconds() const { return static_cast<double>(clock_.nsecsElapsed()) * 1e-9; }
  void take(const PointerEvent& event, const QPointF& place, std::uint64_t stamp);
  void take_in_time(PointerEvent event, const QPointF& place);
  void take_late_move();
  bool take_key(QKeyEvent& event);
  void hold_camera();
  void forget_swallowed_alt();
  void show_tooltip(const QString& sentence, const QPointF& place);
  bool any_down() const;
  bool is_paper(int view) const;
  render::Bounds bounds_in(int view) const;
  render::Bounds picked_bounds() const;
  std::optional<SelectionFrame> selection_in(int view) const;
  std::optional<Ink> ink() const;
  void connect_tool(Tool& tool);
  void open_marking_menu(const QPointF& place);
  bool take_marking_key(const QKeyEvent& event);
  bool take_marking(const PointerEvent& event, const QPointF& place);
  bool drag_border(const PointerEvent& event, const QPointF& place);
  bool navigate(const PointerEvent& event);
  void show_cursor(int view);

  void follow_document();
  void follow_result();
  void follow_load();
  void note_busy(bool busy);
  /// @return whether an object has come, or what is made of a sketch has another shape, since the last call. While a
  /// mesh is edited its view stays.
  bool note_objects();
  void keep_in_view();
  void redraw_moved(int view);
  void settle(bool fine);
  void after_layout();
  void frame_new_views();

  bool draw_ink();
  void draw_views();
  bool draw_view(int view);
  render::PixelRect place_of(const ViewPane& pane) const;
  render::Scene scene_of(int view);
  render::RenderOptions options_of(int view, bool fine) const;
  void place_chips();

  Studio& studio_;
  PaneLayout layout_;
  Navigation navigation_;
  ObjectScenes objects_;
  ViewChips chips_;
  MarkingMenu marking_menu_;
  bool marking_by_key_ = false;  ///< it is open while a key is held, and follows the pointer
  QPointF pointer_at_;           ///< logical pixels of the widget
  std::vector<Tool*> tools_;
  std::unique_ptr<render::Renderer> renderer_;
  std::array<PaneState, view_count> states_;
  InkSheet sheet_;
  int sheet_view_ = SketchView;  ///< that the sheet shows
  QString mode_ = first_mode;
  MeshLook look_ = MeshLook::Shaded;
  bool zebra_ = false;
  double suggested_share_ = even_share;
  NodeId through_ = 0;  ///< the first node of the object whose camera holds the perspective view
  int grabbed_ = -1;    ///< the view that the gesture under way began in, or -1
  int under_pointer_ = SketchView;
  PaneLayout::Border dragged_border_;
  bool shows_tooltip_ = false;
  bool turned_ = false;                    ///< the user moved the perspective view: it isn't framed by itself any more
  bool had_meshes_ = false;                ///< a document's first mesh sets the views up
  std::array<bool, view_count> framed_{};  ///< flat views show what there is when they are first seen
  std::map<NodeId, render::MeshItemPtr> known_;  ///< objects that note_objects() has reported, as they were
  bool clear_ = true;                            ///< the views lie elsewhere: what is between them is painted again
  bool uploading_ = false;                       ///< some view waits for the graphics card
  QTimer settle_;                                ///< after a pause the views are drawn once more, finer
  QTimer patience_;                              ///< what is out of date for longer is shown faded
  QTimer long_press_;                            ///< a pen that rests opens the marking menu
  QPointF pressed_at_;
  bool stale_ = false;
  bool affordable_ = true;  ///< the last fine frame was quick enough to go unnoticed
  QElapsedTimer clock_;
  EventClock event_clock_;
  std::optional<LateMove> late_move_;  ///< a newer one may make it needless
  double input_time_ms_ = -1;
  double latency_ms_ = 0;
  int frames_ = 0;
};

}  // namespace croquis::app
