// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/replay/replays.h"

#include <QAction>
#include <algorithm>
#include <cmath>

#include "app/replay/replay_player.h"
#include "app/views/viewport.h"
#include "app/window/main_window.h"
#include "croquis/base/error.h"
#include "croquis/geometry/mesh_topology.h"
#include "croquis/tools/recording/general_steps.h"

namespace croquis::app {
namespace {

constexpr double recorded_view_height = 1000;  // pixels in which motions are recorded

std::size_t count_visible(const Studio& studio) {
  return static_cast<std::size_t>(
      std::ranges::count_if(studio.objects(), [](const WorkObject& object) { return object.visible; }));
}

CameraMotion::Kind kind_of(const std::string& motion) {
  if (motion == "track") return CameraMotion::Kind::Track;
  return motion == "dolly" ? CameraMotion::Kind::Dolly : CameraMotion::Kind::Tumble;
}

MeshExport mesh_export_of(const recorded::File& step) {
  using Objects = MeshExport::Objects;
  const Objects objects = step.objects == "all"       ? Objects::All
                          : step.objects == "visible" ? Objects::Visible
                                                      : Objects::Picked;
  return {objects, step.unit};
}

void trigger(MainWindow& window, const recorded::Action& step) {
  QAction* action = window.action(QString::fromStdString(step.name));
  if (action == nullptr) refuse_replay("The window has no action \"" + step.name + "\"");
  // Nothing acts on what the start page hides.
  if (!action->isEnabled() && !window.shows_views()) show_views(window);
  if (!action->isEnabled()) refuse_replay("The action \"" + step.name + "\" can't be used now");
  action->trigger();
}

void use_file(MainWindow& window, const recorded::File& step) {
  const QString file = QString::fromStdString(step.file);
  if (step.verb == "open") {
    open_now(window.files(), file, step.replaces, step.traces ? PictureUse::Lines : PictureUse::Backdrop);
  } else if (step.verb == "save") {
    window.files().save(file);
  } else if (file.endsWith(".png")) {
    export_picture(window.parts().pictures, window.views(), file);
  } else if (file.endsWith(".svg") || (file.endsWith(".json") && window.studio().network_node() != 0)) {
    export_drawing(window.studio(), file);
  } else if (file.endsWith(".json")) {
    window.wait_until_settled();
    export_result(window.studio(), *result_exports(window.studio()).front(), file);
  } else if (is_step_path(step.file)) {
    window.wait_until_settled();
    export_step(window.studio(), file, window.files().step_export());
    window.wait_until_settled();
  } else {
    window.wait_until_settled();
    export_solid(window.studio(), file, mesh_export_of(step));
  }
}

void navigate(Views& views, const recorded::Navigate& step) {
  const int view = view_of(step.view);
  const ViewPane& pane = views.layout.pane(view);
  CameraMotion motion;
  motion.kind = kind_of(step.motion);
  motion.delta = step.by * (pane.rect.height() / recorded_view_height);
  motion.factor = std::exp((step.by.x() - step.by.y()) * NavigationOptions().dolly_per_pixel);
  motion.about = Vec2(pane.rect.width() / 2, pane.rect.height() / 2);
  move_camera(views, view, motion);
  emit views.changed();
}

void expect_count(const Replays& all, const recorded::Expect& step) {
  const auto found = all.counts.find(step.what);
  if (found == all.counts.end()) refuse_replay("The window can't count " + step.what);
  const std::size_t count = found->second(step.node);
  if (static_cast<std::int64_t>(count) == step.count) return;
  refuse_replay("Expected " + std::to_string(step.count) + " " + step.what + ", but there are " +
                std::to_string(count));
}

void expect_range(const Replays& all, const recorded::Expect& step) {
  constexpr double tolerance = 1e-3;  // degrees
  const auto found = all.ranges.find(step.what);
  if (found == all.ranges.end()) refuse_replay("The window can't measure " + step.what);
  const auto [least, greatest] = found->second(step.node);
  const double wanted_least = *step.value;
  const double wanted_greatest = step.to.value_or(wanted_least);
  if (std::abs(least - wanted_least) <= tolerance && std::abs(greatest - wanted_greatest) <= tolerance) return;
  refuse_replay("Expected angles from " + std::to_string(wanted_least) + " to " + std::to_string(wanted_greatest) +
                " degrees, but they are from " + std::to_string(least) + " to " + std::to_string(greatest));
}

/// The steps that belong to no tool.
void add_steps(MainWindow& window, Replays& all) {
  Studio& studio = window.studio();
  all.on<recorded::Action>([&window](const auto& step) { trigger(window, step); });
  all.on<recorded::Set>([&studio](const auto& step) {
    studio.set_parameter(node_named(studio, step.node), step.parameter, step.value, false);
  });
  all.on<recorded::Wait>([&window](const auto&) { window.wait_until_settled(); });
  all.on<recorded::Screenshot>(
      [&window](const auto& step) { save_window_picture(window, QString::fromStdString(step.file)); });
  all.on<recorded::File>([&window](const auto& step) { use_file(window, step); });
  all.on<recorded::Navigate>([&window](const auto& step) { navigate(window.views(), step); });
  all.on<recorded::Expect>([&window](const auto& step) {
    window.wait_until_settled();
    const Replays known = replays_of(window);
    step.value ? expect_range(known, step) : expect_count(known, step);
  });
  all.on<recorded::FaceSetChoice>([&window, &studio](const auto& step) {
    window.wait_until_settled();
    select_face_sets(window, object_named(studio, step.node).node, step.names);
  });
  all.on<recorded::NodeChoice>([&window, &studio](const auto& step) {
    std::vector<NodeId> nodes;
    for (const std::string& name : step.nodes) nodes.push_back(node_named(studio, name));
    select_nodes(window.studio(), nodes);
  });
  all.on<recorded::Place>([&studio](const auto& step) {
    std::vector<PlacedObject> placed;
    for (std::size_t i = 0; i < step.nodes.size(); ++i)
      placed.push_back({object_named(studio, step.nodes[i]).node, step.places[i]});
    place_objects(studio, placed);
  });
}

}  // namespace

Replays replays_of(MainWindow& window) {
  Replays all;
  auto& counts = all.counts;
  Studio& studio = window.studio();
  add_steps(window, all);
  counts["objects"] = [&studio](const std::string&) { return count_visible(studio); };
  counts["findings"] = [&studio](const std::string&) { return findings_of(studio).size(); };
  counts["selected"] = [&studio](const std::string&) { return studio.session().components().elements.size(); };
  const auto of_mesh = [&studio](auto count) {
    return [&studio, count](const std::string& node) { return count(*object_named(studio, node).shown()); };
  };
  counts["vertices"] = of_mesh([](const PolyMesh& mesh) { return mesh.vertex_count(); });
  counts["faces"] = of_mesh([](const PolyMesh& mesh) { return mesh.face_count(); });
  counts["edges"] = of_mesh([](const PolyMesh& mesh) { return MeshTopology(mesh).edge_count(); });
  counts["sharp-edges"] = of_mesh([](const PolyMesh& mesh) { return mesh.tags.creases.size(); });
  for (const auto& tool : window.tools()) tool->make_replays(all);
  return all;
}

void refuse_replay(const std::string& sentence) { throw Error(make_error(Category::Geometry, "E_REPLAY", sentence)); }

Modifiers modifiers_of(const std::vector<std::string>& names) {
  const auto has = [&](const char* name) { return std::find(names.begin(), names.end(), name) != names.end(); };
  return {has("shift"), has("ctrl"), has("alt"), has("super")};
}

int view_of(const std::string& name) {
  if (name.empty() || name == "sketch") return View::SketchView;
  const std::vector<std::string> names{"front", "perspective", "top", "side", "comparison"};
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) refuse_replay("There is no view \"" + name + "\"");
  return static_cast<int>(found - names.begin());
}

const WorkObject& object_named(const Studio& studio, const std::string& name) {
  const WorkObject* found = name.empty() ? studio.active() : nullptr;
  for (const WorkObject& object : studio.objects()) {
    const Node* node = studio.session().document().find(object.node);
    if (!name.empty() && (object.name == name || node->name == name)) found = &object;
  }
  if (found == nullptr) refuse_replay(name.empty() ? "There is no object" : "There is no object \"" + name + "\"");
  if (!found->shown()) refuse_replay("\"" + found->name + "\" has no mesh");
  return *found;
}

NodeId node_named(const Studio& studio, const std::string& name) {
  for (const auto& node : studio.session().document().nodes()) {
    if (node->name == name || node->operation == name) return node->id;
  }
  refuse_replay("The document has no node \"" + name + "\"");
}

}  // namespace croquis::app
