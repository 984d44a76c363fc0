// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointF>
#include <QRectF>
#include <QSizeF>
#include <QString>
#include <array>
#include <functional>
#include <optional>
#include <vector>

#include "app/studio/studio.h"
#include "croquis/geometry/camera.h"
#include "croquis/render/camera.h"
#include "croquis/render/camera_motion.h"
#include "croquis/render/scene.h"
#include "croquis/tools/pointer/navigation.h"
#include "croquis/tools/pointer/view_frame.h"
#include "croquis/tools/strokes/sketch_event.h"

namespace croquis::app {

/// The views of the window, by their places in lists.
enum View { SketchView = 0, PerspectiveView = 1, TopView = 2, SideView = 3, ComparisonView = 4 };
inline constexpr int view_count = 5;

/// One view of the window: a camera and the rectangle of the widget that it fills.
struct ViewPane {
  render::NamedView kind = render::NamedView::Perspective;
  render::Camera camera;
  QRectF rect;  ///< logical pixels of the widget, y down; empty while hidden

  bool flat() const { return kind != render::NamedView::Perspective; }  ///< never rotates
  glm::dvec2 size() const { return {rect.width(), rect.height()}; }
  bool visible() const { return rect.width() >= 1 && rect.height() >= 1; }

  /// Of the view that looks along -z.
  SketchFrame sketch_frame() const;

  /// How tools see the model. @param bounds of what is to lie between the near and the far plane
  ViewFrame view_frame(const render::Bounds& bounds) const;

  void move(const CameraMotion& motion);

  /// The whole scene is seen, and not much smaller than it could be.
  bool fits(const render::Scene& scene) const;

  /// Where what faces that way (unit) is seen too much from the side or from behind, looks at it from its front.
  void turn_to(const Vec3& facing);

  /// Shows the box; the whole of a scene as close as it fits.
  void frame(const render::Bounds& bounds);
  void frame(const render::Scene& scene);
};

/// The view as it is before anything is framed: flat ones show one unit a pixel.
ViewPane first_pane(render::NamedView kind);

constexpr double even_share = 0.5;  ///< of the views' width, for each of two

/// Which views stand beside each other.
enum class Arrangement {
  SketchAndSolid,  ///< the sketch, the perspective view
  Four,            ///< top, perspective; front, side
  Compare          ///< the perspective view twice, with the same camera: another scheme in the second one
};

/// Where the window's views lie: one alone, or several with borders that can be dragged.
class PaneLayout {
 public:
  PaneLayout();

  ViewPane& pane(int view) { return panes_[static_cast<std::size_t>(view)]; }
  const ViewPane& pane(int view) const { return panes_[static_cast<std::size_t>(view)]; }

  /// Logical pixels of the widget.
  void resize(const QSizeF& size);

  /// Called after the following have changed the layout.
  std::function<void()> changed = [] {};

  Arrangement arrangement() const { return arrangement_; }
  /// Shows all of its views, or one of them alone.
  void arrange(Arrangement arrangement, int alone = -1);

  /// The view that fills the widget, or -1.
  int alone() const { return alone_; }
  void show_alone(int view);  ///< -1: all views of the arrangement

  std::vector<int> shown() const;

  /// The view at a place of the widget; the nearest one on a border.
  int view_at(const QPointF& place) const;

  /// What of the borders lies at a place: they can be dragged one by one, or both where they cross.
  struct Border {
    bool across = false;  ///< the upright one, which parts left from right
    bool down = false;
    bool any() const { return across || down; }
  };
  Border border_at(const QPointF& place) const;
  /// Without a call of `changed`: it happens at every move of the pointer.
  void drag_border(const Border& border, const QPointF& place);

  /// Shares of the left and of the upper views that people chose; what can't be dragged to becomes the nearest that
  /// can.
  QPointF shares() const { return {across_ == suggested_ ? even_share : across_, down_}; }
  void set_shares(const QPointF& shares);
  /// The share of the left views, as long as nobody has moved the border.
  void suggest_share(double across);

 private:
  void lay_out();
  void share(const QPointF& shares);

  std::array<ViewPane, view_count> panes_;
  QSizeF size_{1, 1};
  Arrangement arrangement_ = Arrangement::SketchAndSolid;
  int alone_ = -1;
  double across_ = even_share;  ///< share of the left views
  double down_ = even_share;    ///< share of the upper views
  double suggested_ = even_share;
};

/// A camera that some step of an object gives: views can be held at it.
struct SceneCamera {
  NodeId node = 0;             ///< the first one of the object's chain
  QString name;                ///< of the object
  Camera camera;               ///< in the space of the views
  Vec2 origin = Vec2::Zero();  ///< upper left corner of its picture, px
  double depth = 1;            ///< before the eye, of the middle of what was found; > 0

  /// The view's camera that shows the whole picture as large as it fits into the pane, with whatever lies before it.
  render::Camera in(const ViewPane& pane) const;

  /// A place of the picture at that depth before the eye.
  glm::dvec3 before_the_eye(const Vec2& place) const;
};

/// Of all objects, in their order.
std::vector<SceneCamera> scene_cameras(const Studio& studio);

/// Of the object that begins with that node.
std::optional<SceneCamera> scene_camera(const Studio& studio, NodeId first);

}  // namespace croquis::app
