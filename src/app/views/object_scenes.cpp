// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/views/object_scenes.h"

#include <QCoreApplication>
#include <QMetaObject>
#include <algorithm>
#include <utility>

#include "app/views/own_space.h"
#include "app/views/render_color.h"
#include "app/window/theme.h"
#include "croquis/base/error.h"

namespace croquis::app {
namespace {

constexpr std::size_t corners_at_once = 50'000;  // of more, making an item causes a visible delay

bool same_options(const render::MeshItemOptions& a, const render::MeshItemOptions& b) {
  return a.shading == b.shading && a.crease_angle == b.crease_angle;
}

render::MeshItemPtr made(const render::MeshItemPtr& previous, const std::shared_ptr<const PolyMesh>& mesh,
                         const render::MeshItemOptions& options, const LiveItem::Paint& paint) {
  try {
    return render::update_mesh_item(previous, paint ? *paint(mesh) : *mesh, options);
  } catch (const Error&) {
    return nullptr;  // what can't be drawn is reported where the mesh is made
  }
}

LiveItem::Paint patch_paint(PatchLook look) {
  return [look](const std::shared_ptr<const PolyMesh>& mesh) { return colored_whole(mesh, look); };
}

/// Exact normals of each face's corners, as operations give them that know the surface. Scans have normals of vertices.
bool has_own_normals(const PolyMesh& mesh) { return mesh.channel("normal", Domain::Corner) != nullptr; }

render::MeshItemOptions options_of(bool flat, bool own_normals) {
  render::MeshItemOptions options;
  options.shading = flat ? render::FaceShading::Flat : render::FaceShading::Smooth;
  options.use_normal_channel = !flat && own_normals;
  return options;
}

render::MeshStyle style_of(MeshLook look) {
  switch (look) {
    case MeshLook::Wire: return render::MeshStyle::wire_only();
    case MeshLook::ShadedWire: return render::MeshStyle::shaded_wire();
    case MeshLook::Shaded: break;
  }
  return render::MeshStyle::shaded();
}

}  // namespace

void LiveItem::show(const std::shared_ptr<const PolyMesh>& mesh, const render::MeshItemOptions& options,
                    const Paint& paint, int look) {
  const bool same = same_options(options_, options);
  if (mesh == wanted_ && same && look == look_) return;
  if (!same) {
    item_.reset();
    made_of_.reset();
  }
  wanted_ = mesh;
  options_ = options;
  paint_ = paint;
  look_ = look;
  if (!mesh || mesh->corners.size() <= corners_at_once) {
    item_ = mesh ? made(item_, mesh, options_, paint_) : nullptr;
    made_of_ = mesh;
    made_look_ = look;
  } else if (!making_) {
    begin();
  }
}

void LiveItem::begin() {
  making_ = true;
  threads_.start([this, alive = std::weak_ptr(alive_), mesh = wanted_, previous = item_, options = options_,
                  paint = paint_, look = look_] {
    const render::MeshItemPtr item = made(previous, mesh, options, paint);
    QMetaObject::invokeMethod(
        QCoreApplication::instance(),
        [this, alive, mesh, options, look, item] {
          if (!alive.expired()) take(mesh, options, look, item);
        },
        Qt::QueuedConnection);
  });
}

void LiveItem::take(const std::shared_ptr<const PolyMesh>& mesh, const render::MeshItemOptions& options, int look,
                    const render::MeshItemPtr& item) {
  making_ = false;
  if (!busy()) return;
  if (same_options(options, options_)) {
    item_ = item;
    made_of_ = mesh;
    made_look_ = look;
  }
  if (busy()) begin();
  emit ready();
}

ObjectScenes::ObjectScenes(Studio& studio, QObject* parent) : QObject(parent), studio_(studio) {
  threads_.setMaxThreadCount(2);
}

ObjectScenes::~ObjectScenes() { threads_.waitForDone(); }

ObjectScenes::Items& ObjectScenes::items_of(NodeId node) {
  Items& items = items_[node];
  if (items.surface) return items;
  for (auto* item : {&items.surface, &items.cage, &items.filling}) {
    *item = std::make_unique<LiveItem>(threads_);
    connect(item->get(), &LiveItem::ready, this, &ObjectScenes::changed);
  }
  return items;
}

void ObjectScenes::set_flat(bool flat) {
  flat_ = flat;
  follow();
}

void ObjectScenes::set_patch_look(PatchLook look) {
  if (patch_look_ == look) return;
  patch_look_ = look;
  follow();
}

const PatchSurface* ObjectScenes::patches(NodeId object) const {
  const auto items = items_.find(object);
  return items == items_.end() || !items->second.patches.mesh ? nullptr : &items->second.patches;
}

void ObjectScenes::follow_patches(const WorkObject& object, Items& items) {
  const auto filled = object.result && object.shown() == object.mesh ? object.mesh : nullptr;
  const bool is_new = filled != items.filled;
  if (is_new) items.patches = filled ? patches_of(*filled, object.cage_mesh.get()) : PatchSurface();
  if (is_new || items.filling_look != patch_look_) {
    items.filling_mesh = items.patches.completes ? colored(items.patches, patch_look_) : nullptr;
  }
  items.filled = filled;
  items.filling_look = patch_look_;
  items.filling->show(items.filling_mesh, options_of(flat_, true));
}

/// Which item shows them is only known when it is drawn: those of large meshes come later.
void ObjectScenes::highlight_chosen(const WorkObject& object, Items& items) const {
  const std::vector<Index> faces = studio_.face_sets().selected(object, studio_.session().selection());
  const bool apart = items.patches.completes;
  const LiveItem& live = apart ? *items.filling : *items.surface;
  const bool is_shown = live.item() != nullptr && live.mesh() == (apart ? items.filling_mesh : object.mesh);
  if (faces.empty() || !is_shown || object.shown() != object.mesh) {
    items.highlight.reset();
    return;
  }
  if (items.highlight && items.highlight->mesh == live.item() && items.chosen == faces) return;
  items.chosen = faces;
  std::vector<Index> own = faces;
  for (Index& face : own) face -= static_cast<Index>(apart ? object.cage_mesh->face_count() : 0);
  items.highlight = render::make_face_highlight(live.item(), own, with_own_alpha(colors::selected_face));
}

void ObjectScenes::follow() {
  std::set<NodeId> there;
  for (const WorkObject& object : studio_.objects()) {
    there.insert(object.node);
    if (!object.visible) continue;
    Items& items = items_of(object.node);
    follow_patches(object, items);
    // A scan stays as it is: only its patches, which are few, are prepared again.
    const auto surface = items.patches.completes ? object.cage_mesh : object.shown();
    items.shows_cage = surface == object.cage_mesh;
    const bool paints_patches = items.patches.mesh && !items.patches.completes && surface == items.filled;
    const LiveItem::Paint paint = paints_patches                       ? patch_paint(patch_look_)
                                  : surface == object.mesh && painter_ ? painter_(object)
                                                                       : nullptr;
    const bool own_normals = surface && !object.is_source() && has_own_normals(*surface);
    const int look = paints_patches ? static_cast<int>(patch_look_) : 0;
    items.surface->show(surface, options_of(flat_, own_normals), paint, look);
    // The cage's own item serves its wire; a cage that is shown as a surface has one already.
    items.cage->show(items.shows_cage ? nullptr : object.cage_mesh, {});
  }
  std::erase_if(items_, [&](const auto& entry) { return !there.contains(entry.first); });
  emit changed();
}

render::Scene ObjectScenes::scene(const Wanted& wanted) const {
  render::Scene scene;
  if (wanted.instead) scene.meshes.emplace_back(*wanted.instead, render::Emphasis{}, style_of(wanted.look));
  if (wanted.nothing || wanted.instead) return scene;
  const Selection& selection = studio_.session().selection();
  const auto is_selected = [&](const WorkObject& object) {
    return std::ranges::any_of(selection, [&](const SelectedItem& item) {
      return item.part.empty() && (item.node == object.node || item.node == object.cage);
    });
  };
  // A single object needs no colour of its own; its outline shows that it is selected.
  const auto seen = [](const WorkObject& object) { return object.visible && object.shown() != nullptr; };
  const bool several = std::ranges::count_if(studio_.objects(), seen) > 1;
  for (const WorkObject& object : studio_.objects()) {
    const auto items = items_.find(object.node);
    if (!object.visible || items == items_.end()) continue;
    if (wanted.only_with_cage && !object.begins_with_mesh) continue;
    const PlacedPart part(scene, object.placement.map());
    render::Emphasis emphasis;
    emphasis.stale = wanted.stale && object.result != nullptr;
    emphasis.selected = wanted.edited == 0 && several && is_selected(object);
    emphasis.outlined = wanted.edited == 0 && wanted.outlines && is_selected(object);
    render::MeshStyle style = style_of(wanted.look);
    const bool edited = object.cage != 0 && object.cage == wanted.edited;
    const bool cage_alone = object.shown() == object.cage_mesh;
    if (edited && cage_alone && wanted.look == MeshLook::Shaded) style = render::MeshStyle::shaded_wire();
    const bool replaced = object.node == wanted.replaced;
    scene.meshes.emplace_back(replaced ? wanted.by : items->second.surface->item(), emphasis, style);
    if (!replaced && items->second.filling->item()) {
      render::MeshStyle further = style;
      further.goes_on = true;
      scene.meshes.emplace_back(items->second.filling->item(), emphasis, further);
    }
    if (!replaced && !edited) {
      highlight_chosen(object, items->second);
      if (items->second.highlight) scene.highlights.push_back(items->second.highlight);
    }
    if (!cage_alone && ((edited && wanted.edited_cage) || object.view == ChainView::Both)) {
      const render::MeshStyle wire = render::MeshStyle::cage(to_color(colors::cage, 230));
      scene.meshes.emplace_back(cage_item(object.cage), render::Emphasis{}, wire);
    }
  }
  return scene;
}

std::vector<render::Shown<render::MeshItem>> ObjectScenes::surfaces() const {
  render::Scene scene;
  for (const WorkObject& object : studio_.objects()) {
    const auto items = items_.find(object.node);
    if (!object.visible || items == items_.end()) continue;
    const PlacedPart part(scene, object.placement.map());
    if (const auto& item = items->second.surface->item()) scene.meshes.emplace_back(item);
    if (const auto& item = items->second.filling->item()) scene.meshes.emplace_back(item);
  }
  return scene.meshes;
}

render::MeshItemPtr ObjectScenes::surface_item(NodeId object) const {
  const auto items = items_.find(object);
  return items == items_.end() ? nullptr : items->second.surface->item();
}

render::MeshItemPtr ObjectScenes::cage_item(NodeId cage) const {
  for (const WorkObject& object : studio_.objects()) {
    const auto items = items_.find(object.node);
    if (object.cage != cage || items == items_.end()) continue;
    return (items->second.shows_cage ? items->second.surface : items->second.cage)->item();
  }
  return nullptr;
}

bool ObjectScenes::busy() const {
  return std::ranges::any_of(items_, [](const auto& entry) {
    const Items& items = entry.second;
    return items.surface->busy() || items.cage->busy() || items.filling->busy();
  });
}

}  // namespace croquis::app
