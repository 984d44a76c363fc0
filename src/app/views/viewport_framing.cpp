// SPDX-License-Identifier: GPL-3.0-or-later
// What the cameras of the views are set to: when asked, and when there is something new to be seen.
#include <utility>

#include "app/views/render_color.h"
#include "app/views/viewport.h"

namespace croquis::app {

void Viewport::look_through(NodeId first) {
  if (first == through_) return;
  through_ = first;
  redraw(PerspectiveView);
  redraw(ComparisonView);
  emit look_through_changed();
}

std::optional<SceneCamera> Viewport::looked_through() const {
  return through_ == 0 ? std::nullopt : scene_camera(studio_, through_);
}

void Viewport::frame_all() {
  after_layout();
  for (const int view : layout_.shown()) {
    if (is_drawn_on(view)) {
      layout_.pane(view).frame(bounds_in(view));
    } else if (view == SketchView && objects_.surfaces().empty()) {
      layout_.pane(view).camera = first_pane(render::NamedView::Front).camera;
    } else {
      layout_.pane(view).frame(objects_.scene({}));
    }
  }
  turned_ = false;
  redraw_all();
}

void Viewport::frame_selection() {
  if (!layout_.pane(under_pointer_).visible()) under_pointer_ = layout_.shown().front();
  frame_selection_in(under_pointer_);
}

void Viewport::frame_selection_in(int view) {
  ViewPane& pane = layout_.pane(view);
  if (!pane.visible()) return;
  if (const auto selected = selection_in(view)) {
    if (selected->facing) pane.turn_to(*selected->facing);
    pane.frame(selected->bounds);
    turned_ = turned_ || selected->stays;
  } else if (const render::Bounds chosen = objects_.chosen_bounds(); !chosen.empty()) {
    pane.frame(chosen);
    turned_ = true;
  } else if (const render::Bounds picked = picked_bounds(); !picked.empty()) {
    pane.frame(picked);
  } else {
    pane.frame(objects_.scene({}));
  }
  redraw_all();
}

/// Of the objects that are selected as wholes.
render::Bounds Viewport::picked_bounds() const {
  render::Bounds bounds;
  for (const NodeId node : picked(studio_)) {
    const WorkObject& object = *studio_.object(node);
    const Affine3 to_model = object.placement.map();
    for (const Vec3& own : object.shown() ? object.shown()->positions : std::vector<Vec3>()) {
      const Vec3 place = to_model(own);
      bounds.add(to_glm(place));
    }
  }
  return bounds;
}

/// What a view is framed to where a tool has drawn in it: that, and the surfaces that are shown with it.
render::Bounds Viewport::bounds_in(int view) const {
  ObjectScenes::Wanted wanted;
  render::Bounds bounds;
  for (const Tool* tool : tools_) {
    tool->adjust(wanted, view);
    bounds.add(tool->use_of(view).bounds);
  }
  bounds.add(render::bounds_of(objects_.scene(wanted)));
  return bounds;
}

std::optional<SelectionFrame> Viewport::selection_in(int view) const {
  const Tool* tool = tool_in(view);
  return tool == nullptr ? std::nullopt : tool->selection_frame(view);
}

void Viewport::frame_new_views() {
  if (objects_.surfaces().empty()) return;
  for (const int view : layout_.shown()) {
    bool& framed = framed_[static_cast<std::size_t>(view)];
    if (framed || !layout_.pane(view).flat() || is_drawn_on(view)) continue;
    layout_.pane(view).frame(objects_.scene({}));
    framed = layout_.pane(view).visible();
  }
}

bool Viewport::note_objects() {
  std::map<NodeId, render::MeshItemPtr> now;
  bool news = false;
  for (const WorkObject& object : studio_.objects()) {
    const NodeId key = object.begins_with_mesh ? object.chain.front() : object.node;
    const auto before = known_.find(key);
    render::MeshItemPtr item = objects_.surface_item(object.node);
    if (!item && before == known_.end()) continue;
    news = news || before == known_.end() || (object.cage == 0 && item && item != before->second);
    now[key] = item ? std::move(item) : before->second;
  }
  known_ = std::move(now);
  return news;
}

void Viewport::keep_in_view() {
  // Without a solid no view is worth keeping: the next one is shown as if it were the first.
  if (objects_.surfaces().empty()) turned_ = false;
  if (any_down()) return;
  const bool news = note_objects();
  if (objects_.surfaces().empty() || turned_ || !news) return;
  const render::Scene scene = objects_.scene({});
  layout_.resize(QSizeF(width(), height()));
  ViewPane& pane = layout_.pane(PerspectiveView);
  if (!pane.fits(scene)) pane.frame(scene);
}

}  // namespace croquis::app
