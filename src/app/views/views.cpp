// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/views/views.h"

#include <algorithm>
#include <utility>

#include "app/views/offscreen_pictures.h"
#include "app/views/own_space.h"
#include "app/views/render_color.h"
#include "app/window/language.h"
#include "croquis/base/error.h"

namespace croquis::app {
namespace {

constexpr int picture_height = 1600;

/// What a view is framed to where a tool has drawn in it: that, and the surfaces that are shown with it.
render::Bounds bounds_in(const Views& views, int view) {
  ObjectScenes::Wanted wanted;
  render::Bounds bounds;
  for (const Tool* tool : views.tools) {
    tool->adjust(wanted, view);
    bounds.add(tool->use_of(view).bounds);
  }
  bounds.add(render::bounds_of(views.objects.scene(wanted)));
  return bounds;
}

void add_place(render::Bounds& bounds, const Vec3& place) { bounds.add(to_glm(place)); }

/// Of the objects that are selected as wholes.
render::Bounds picked_bounds(const Studio& studio) {
  render::Bounds bounds;
  for (const NodeId node : picked(studio)) {
    const WorkObject& object = *studio.object(node);
    const Affine3 to_model = object.placement.map();
    for (const Vec3& own : object.shown() ? object.shown()->positions : std::vector<Vec3>()) {
      add_place(bounds, to_model(own));
    }
  }
  return bounds;
}

/// Of the faces that are selected by their names; empty without any.
render::Bounds chosen_bounds(Studio& studio) {
  render::Bounds bounds;
  for (const WorkObject& object : studio.objects()) {
    if (!object.visible) continue;
    const Affine3 to_model = object.placement.map();
    for (const Index face : studio.face_sets().selected(object, studio.session().selection())) {
      for (const Index vertex : object.mesh->face(face)) add_place(bounds, to_model(object.mesh->positions[vertex]));
    }
  }
  return bounds;
}

void frame_new_views(Views& views) {
  if (views.objects.surfaces().empty()) return;
  for (const int view : views.layout.shown()) {
    ViewPane& pane = views.layout.pane(view);
    bool& framed = views.framed[static_cast<std::size_t>(view)];
    if (framed || !pane.flat() || is_drawn_on(views, view)) continue;
    pane.frame(views.objects.scene({}));
    framed = pane.visible();
  }
}

/// @return whether an object has come, or what is made of a sketch has another shape, since the last call. While a
/// mesh is edited its view stays.
bool note_objects(Views& views) {
  std::map<NodeId, render::MeshItemPtr> now;
  bool news = false;
  for (const WorkObject& object : views.studio.objects()) {
    const NodeId key = object.begins_with_mesh ? object.chain.front() : object.node;
    const auto before = views.known.find(key);
    render::MeshItemPtr item = views.objects.surface_item(object.node);
    if (!item && before == views.known.end()) continue;
    news = news || before == views.known.end() || (object.cage == 0 && item && item != before->second);
    now[key] = item ? std::move(item) : before->second;
  }
  views.known = std::move(now);
  return news;
}

void keep_in_view(Views& views) {
  // Without a solid no view is worth keeping: the next one is shown as if it were the first.
  if (views.objects.surfaces().empty()) views.turned = false;
  if (any_down(views)) return;
  const bool news = note_objects(views);
  if (views.objects.surfaces().empty() || views.turned || !news) return;
  views.layout.resize(views.widget.size());
  show_scene(views);
}

void follow_load(Views& views) {
  for (int view = 0; view < view_count; ++view) {
    ViewPane& pane = views.layout.pane(view);
    if (view != SketchView) pane.camera = first_pane(pane.kind).camera;
  }
  views.framed = {};
  views.known.clear();
  views.turned = false;
  views.had_meshes = false;
}

void follow_document(Views& views) {
  views.objects.follow();
  for (Tool* tool : views.tools) tool->follow(Change::Document);
  const std::vector<WorkObject>& objects = views.studio.objects();
  const bool has_meshes =
      std::ranges::any_of(objects, [](const WorkObject& object) { return object.begins_with_mesh; });
  if (has_meshes && !views.had_meshes && !is_drawn_on(views, SketchView)) {
    // A document of meshes begins with the perspective view; Space shows the others.
    views.layout.arrange(Arrangement::Four, PerspectiveView);
    set_mode(views, select_mode);
  }
  if (!has_meshes && views.layout.alone() == PerspectiveView && objects.empty()) {
    views.layout.arrange(Arrangement::SketchAndSolid);
  }
  views.had_meshes = has_meshes;
  views.navigation.something_done();
  emit views.help_changed();
}

void follow_result(Views& views) {
  views.objects.follow();  // signals when it has changed: views are framed then
  for (Tool* tool : views.tools) tool->follow(Change::Result);
  emit views.changed();
  emit views.help_changed();
}

}  // namespace

Views::Views(Studio& shown, QWidget& around) : studio(shown), widget(around), objects(shown, nullptr) {
  for (const int view : {SketchView, TopView, SideView}) navigation.set_flat(view, true);
  layout.changed = [this] { lay_out(*this); };
  connect(&studio, &Studio::loaded, this, [this] { follow_load(*this); });
  connect(&studio, &Studio::changed, this, [this] { follow_document(*this); });
  connect(&studio, &Studio::result_changed, this, [this] { follow_result(*this); });
  connect(&objects, &ObjectScenes::changed, this, [this] {
    for (Tool* tool : tools) tool->follow(Change::Scenes);
    keep_in_view(*this);
    emit changed();
  });
}

void set_tools(Views& views, std::vector<Tool*> tools) {
  views.tools = std::move(tools);
  for (Tool* tool : views.tools) {
    QObject::connect(tool, &Tool::changed, &views, &Views::changed);
    QObject::connect(tool, &Tool::committed, &views, &Views::committed);
    QObject::connect(tool, &Tool::state_changed, &views, &Views::help_changed);
  }
  set_mode(views, views.mode);
}

void set_mode(Views& views, const QString& mode) {
  views.mode = mode;
  for (Tool* tool : views.tools) tool->set_mode(mode);
  show_cursor(views, views.under_pointer);
  emit views.changed();
  views.navigation.something_done();
  emit views.help_changed();
}

Tool* tool_in(const Views& views, int view) {
  const auto found = std::ranges::find_if(views.tools, [&](const Tool* tool) {
    const ViewUse use = tool->use_of(view);
    return use.works && (use.on_drawings || !is_drawn_on(views, view));
  });
  return found == views.tools.end() ? nullptr : *found;
}

bool is_drawn_on(const Views& views, int view) {
  return std::ranges::any_of(views.tools, [&](const Tool* tool) { return !tool->use_of(view).bounds.empty(); });
}

bool is_paper(const Views& views, int view) {
  return std::ranges::any_of(views.tools, [&](const Tool* tool) { return tool->use_of(view).paper; });
}

std::optional<Ink> ink_in(const Views& views) {
  for (const Tool* tool : views.tools) {
    if (auto ink = tool->state().ink) return ink;
  }
  return std::nullopt;
}

bool any_down(const Views& views) {
  return std::ranges::any_of(views.tools, [](const Tool* tool) { return tool->down(); });
}

bool abandon(const Views& views) {
  return std::ranges::any_of(views.tools, [](Tool* tool) { return tool->abandon(); });
}

QString help_of(const Views& views) {
  for (const NodeFinding& found : ink_in(views) ? std::vector<NodeFinding>() : findings_of(views.studio)) {
    if (found.finding.severity == Severity::Error) return localized(found.finding.message);
  }
  if (views.navigation.alt_swallowed()) {
    return Views::tr("Your desktop uses Alt: hold Super, or the key left of 1, and drag to rotate, pan and zoom");
  }
  const Tool* tool = tool_in(views, views.under_pointer);
  for (const int view : views.layout.shown()) {
    if (tool == nullptr) tool = tool_in(views, view);
  }
  return tool == nullptr ? QString() : tool->words().help;
}

QString help_topic_of(const Views& views) {
  const Tool* tool = tool_in(views, views.under_pointer);
  return tool == nullptr ? QString() : tool->help_topic;
}

void show_cursor(const Views& views, int view) {
  const Tool* tool = tool_in(views, view);
  views.widget.setCursor(tool == nullptr ? Qt::ArrowCursor : tool->use_of(view).cursor);
}

ViewFrame frame_of(const Views& views, int view) {
  render::Scene scene;
  scene.meshes = views.objects.surfaces();
  if (const WorkObject* object = views.studio.active()) {
    const PlacedPart part(scene, object->placement.map());
    scene.meshes.emplace_back(views.objects.cage_item(object->cage));
  }
  render::Bounds bounds = render::bounds_of(scene);
  if (bounds.empty()) bounds = {{-1, -1, -1}, {1, 1, 1}};
  return views.layout.pane(view).view_frame(bounds);
}

ViewFrame own_frame_of(const Views& views, int view) {
  const WorkObject* object = views.studio.active();
  return object == nullptr ? frame_of(views, view) : seen_from(frame_of(views, view), object->placement.map());
}

QPointF sketch_to_widget(const Views& views, const Vec2& place) {
  const ViewPane& pane = views.layout.pane(SketchView);
  const Vec2 pixel = pane.sketch_frame().to_pixel(place);
  return pane.rect.topLeft() + QPointF(pixel.x(), pixel.y());
}

QPointF model_to_widget(const Views& views, const Vec3& place, int view) {
  const auto seen = frame_of(views, view).project(place);
  const Vec2 pixel = seen ? seen->pixel : Vec2(0, 0);
  return views.layout.pane(view).rect.topLeft() + QPointF(pixel.x(), pixel.y());
}

void move_camera(Views& views, int view, const CameraMotion& motion) {
  if (view == PerspectiveView) look_through(views, 0);
  views.layout.pane(view).move(motion);
}

void move_view(Views& views, const CameraMotion& motion) {
  // Compared views have one camera.
  const int view = motion.view == ComparisonView ? PerspectiveView : motion.view;
  move_camera(views, view, motion);
  views.turned = views.turned || view == PerspectiveView;
  emit views.camera_moved(view);
  if (view == PerspectiveView) emit views.camera_moved(ComparisonView);
}

void look_through(Views& views, NodeId first) {
  if (first == views.through) return;
  views.through = first;
  emit views.changed(PerspectiveView);
  emit views.changed(ComparisonView);
  emit views.look_through_changed();
}

std::optional<SceneCamera> looked_through(const Views& views) {
  return views.through == 0 ? std::nullopt : scene_camera(views.studio, views.through);
}

void lay_out(Views& views) {
  views.layout.resize(views.widget.size());
  views.clear = true;
  frame_new_views(views);
  emit views.changed();
}

void toggle_layout(Views& views) { views.layout.show_alone(views.layout.alone() < 0 ? views.under_pointer : -1); }

void frame_all(Views& views) {
  lay_out(views);
  for (const int view : views.layout.shown()) {
    ViewPane& pane = views.layout.pane(view);
    if (is_drawn_on(views, view)) {
      pane.frame(bounds_in(views, view));
    } else if (view == SketchView && views.objects.surfaces().empty()) {
      pane.camera = first_pane(render::NamedView::Front).camera;
    } else {
      pane.frame(views.objects.scene({}));
    }
  }
  views.turned = false;
  emit views.changed();
}

void frame_selection(Views& views) {
  if (!views.layout.pane(views.under_pointer).visible()) views.under_pointer = views.layout.shown().front();
  frame_selection_in(views, views.under_pointer);
}

void frame_selection_in(Views& views, int view) {
  ViewPane& pane = views.layout.pane(view);
  if (!pane.visible()) return;
  const Tool* tool = tool_in(views, view);
  if (const auto selected = tool == nullptr ? std::nullopt : tool->selection_frame(view)) {
    if (selected->facing) pane.turn_to(*selected->facing);
    pane.frame(selected->bounds);
    views.turned = views.turned || selected->stays;
  } else if (const render::Bounds chosen = chosen_bounds(views.studio); !chosen.empty()) {
    pane.frame(chosen);
    views.turned = true;
  } else if (const render::Bounds picked = picked_bounds(views.studio); !picked.empty()) {
    pane.frame(picked);
  } else {
    pane.frame(views.objects.scene({}));
  }
  emit views.changed();
}

void show_scene(Views& views) {
  const render::Scene scene = views.objects.scene({});
  ViewPane& pane = views.layout.pane(PerspectiveView);
  if (!pane.fits(scene)) pane.frame(scene);
}

void export_picture(OffscreenPictures& pictures, const Views& views, const QString& path) {
  const ViewPane& pane = views.layout.pane(PerspectiveView);
  const double aspect = pane.visible() ? pane.rect.width() / pane.rect.height() : 1;
  const QSize size(static_cast<int>(picture_height * aspect), picture_height);
  if (!pictures.draw(views.objects.surfaces(), pane.camera, render::RenderOptions{}, size).save(path, "PNG")) {
    throw Error(make_error(Category::Io, "E_WRITE", "\"" + path.toStdString() + "\" can't be written"));
  }
}

}  // namespace croquis::app
