// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/hole_interaction.h"

#include <algorithm>
#include <utility>

#include "app/filling.h"
#include "app/mesh_overlay.h"
#include "croquis/base/error.h"

namespace croquis::app {
namespace {

std::vector<HolePatchView> patch_views(const PatchSurface& patches, const std::vector<HoleRow>& rows) {
  std::map<std::int32_t, HolePatchView> views;
  for (const HoleRow& row : rows) {
    if (row.patch) views.try_emplace(static_cast<std::int32_t>(*row.patch)).first->second.hole = row.id;
  }
  const PolyMesh& mesh = *patches.mesh;
  struct Place {
    std::int32_t patch = -1;
    Index index = no_index;
  };
  std::vector<Place> places(mesh.vertex_count());  // in the patch that asked last: few share a vertex
  auto view = views.end();
  for (std::size_t face = 0; face < mesh.face_count(); ++face) {
    const std::int32_t patch = patches.patch[face];
    if (view == views.end() || view->first != patch) view = views.find(patch);
    if (view == views.end() || mesh.face(face).size() != 3) continue;
    std::array<Index, 3> triangle{};
    for (std::size_t k = 0; k < 3; ++k) {
      const Index vertex = mesh.face(face)[k];
      if (places[vertex].patch != patch) {
        places[vertex] = {patch, static_cast<Index>(view->second.positions.size())};
        view->second.positions.push_back(mesh.positions[vertex]);
      }
      triangle[k] = places[vertex].index;
    }
    view->second.triangles.push_back(triangle);
  }
  std::vector<HolePatchView> list;
  for (auto& [patch, seen] : views) list.push_back(std::move(seen));
  return list;
}

}  // namespace

HoleInteraction::HoleInteraction(Studio& studio, ObjectScenes& scenes, std::function<ViewFrame(int)> frame_of,
                                 QObject* parent)
    : QObject(parent),
      studio_(studio),
      scenes_(scenes),
      frame_of_(std::move(frame_of)),
      preview_(studio, scenes.threads(), nullptr),
      sight_(nullptr) {
  connect(&preview_, &PatchPreview::changed, this, [this] {
    show_patches();
    emit changed();
  });
  connect(&sight_, &HoleSightMaker::changed, this, [this] {
    tool_.set_sight(sight_.sight());
    emit changed();
  });
}

void HoleInteraction::set_active(bool active) {
  if (active_ == active) return;
  active_ = active;
  follow();
  emit holes_changed();
}

const HoleRow* HoleInteraction::row(Index hole) const {
  const auto found = std::find_if(rows_.begin(), rows_.end(), [&](const HoleRow& row) { return row.id == hole; });
  return found == rows_.end() ? nullptr : &*found;
}

std::shared_ptr<const PolyMesh> HoleInteraction::scan() const {
  const StudioObject* object = studio_.active();
  const Node* operation = node();
  if (object == nullptr || operation == nullptr || operation->inputs.empty()) return nullptr;
  const Link& from = operation->inputs.begin()->second;
  if (from.node == object->cage) return object->cage_mesh;
  // What comes from another operation was computed on the way: it is at hand.
  Progress progress;
  const auto before = studio_.evaluator().evaluate(studio_.session().document(), from.node, Quality::Final, progress);
  const auto found = before->outputs.find(from.output);
  const auto* mesh =
      found == before->outputs.end() ? nullptr : std::get_if<std::shared_ptr<const PolyMesh>>(&found->second);
  return mesh == nullptr ? nullptr : *mesh;
}

const Node* HoleInteraction::node() const { return filling_node(studio_); }

std::vector<Index> HoleInteraction::filled() const {
  std::vector<Index> holes;
  for (const HoleRow& row : rows_) {
    if (row.state == HoleState::Filled) holes.push_back(row.id);
  }
  return holes;
}

std::vector<Index> HoleInteraction::open_of(const std::vector<Index>& holes) const {
  std::vector<Index> open;
  for (const Index hole : with_islands(rows_, holes)) {
    const HoleRow* found = row(hole);
    if (found != nullptr && found->state == HoleState::Open) open.push_back(hole);
  }
  return open;
}

// ---- What is there

void HoleInteraction::follow() {
  const Node* operation = active_ ? node() : nullptr;
  const StudioObject* object = operation == nullptr ? nullptr : studio_.active();
  take_result(object);
  preview_.show(operation == nullptr ? 0 : operation->id, open_of(tool_.selected()));
  preview_.follow();
  if (!tool_.active()) show_handles();
  overlay_.follow(tool_, rows_);
  emit changed();
}

void HoleInteraction::take_result(const StudioObject* object) {
  const NodeId now = object == nullptr ? 0 : object->node;
  const auto result = object == nullptr ? nullptr : object->result;
  if (result == shown_ && now == shown_node_) return;
  const bool other_object = now != shown_node_;
  shown_ = result;
  shown_node_ = now;
  rows_ = hole_rows(object);
  sight_.follow(result ? scan() : nullptr);
  const auto rims = result ? result->outputs.find("rims") : Values::const_iterator();
  if (other_object || !result) tool_.select_none();
  if (!result || rims == result->outputs.end())
    tool_.set_rims({});
  else if (!tool_.active())
    tool_.set_rims(rims_from_lines(*std::get<std::shared_ptr<const PolyMesh>>(rims->second)));
  tool_.set_filled(filled());
  tool_.set_sight(sight_.sight());
  show_patches();
  emit holes_changed();
}

void HoleInteraction::show_patches() {
  std::vector<HolePatchView> views;
  if (const PatchSurface* patches = scenes_.patches(shown_node_)) views = patch_views(*patches, rows_);
  if (preview_.patches().mesh) {
    for (HolePatchView& view : patch_views(preview_.patches(), preview_.rows())) views.push_back(std::move(view));
  }
  tool_.set_patches(std::move(views));
}

void HoleInteraction::show_handles() {
  std::vector<PatchHandle> handles;
  const Node* operation = active_ ? node() : nullptr;
  if (operation != nullptr) {
    attempt([&] {
      const HolePlan plan(studio_, *operation);
      for (const Index hole : tool_.selected()) {
        const HoleRow* found = row(hole);
        for (const Vec3& place : plan.wish(hole).through) {
          handles.push_back({hole, place, found == nullptr ? Vec3(Vec3::UnitZ()) : found->normal});
        }
      }
    });
  }
  tool_.set_handles(std::move(handles));
}

void HoleInteraction::selection_moved() {
  follow();
  emit holes_changed();
}

void HoleInteraction::add_to(render::Scene& scene, int view) {
  if (!active_) return;
  if (preview_.item()) {
    scene.meshes.emplace_back(preview_.item(), render::Emphasis{}, render::MeshStyle::translucent());
  }
  overlay_.add_to(scene);
  const auto& box = tool_.preview().box;
  if (box && view == gesture_view_) add_box(*box, frame_of_(view), scene);
}

// ---- Selection

void HoleInteraction::select(std::vector<Index> holes) {
  if (tool_.select(std::move(holes)) != Verdict::Commit) return;
  if (tool_.done()) emit committed(*tool_.done());
  selection_moved();
}

void HoleInteraction::select_all() {
  std::vector<Index> holes;
  for (const HoleRow& row : rows_) holes.push_back(row.id);
  select(std::move(holes));
}

void HoleInteraction::select_by_size(double diameter) {
  std::vector<Index> holes;
  for (const HoleRow& row : rows_) {
    if (!row.is_border() && row.state != HoleState::Filled && row.diameter <= diameter) holes.push_back(row.id);
  }
  select(std::move(holes));
}

// ---- Changes

void HoleInteraction::attempt(const std::function<void()>& work) {
  try {
    work();
  } catch (const Error& error) {
    QStringList sentences;
    for (const Finding& finding : error.findings()) sentences << QString::fromStdString(finding.message);
    emit told(sentences.join(" "));
  }
}

std::string HoleInteraction::target() const {
  const std::vector<Index>& chosen = tool_.selected();
  if (chosen.empty()) return "all holes";
  const std::string numbers = numbers_of({chosen.begin(), chosen.end()}).toStdString();
  return (chosen.size() == 1 ? "hole " : "holes ") + numbers;
}

void HoleInteraction::edit(const std::string& label, const ParameterValues& values, bool dragging, bool recorded) {
  const Node* operation = node();
  if (operation == nullptr) return;
  const std::string name = operation->name;
  ParameterValues changed;
  for (const auto& [parameter, value] : values) {
    if (dragged_.contains(parameter) || filling_value(studio_, *operation, parameter) != value) {
      changed[parameter] = value;
    }
  }
  Document document = with_values(studio_, *operation, values);
  Session& session = studio_.session();
  const bool in_drag = dragging || dragging_;
  if (dragging && !dragging_) session.begin_drag(label);
  for (const auto& [parameter, value] : changed) dragged_.insert(parameter);
  dragging_ = dragging;
  if (!in_drag)
    session.edit(label, std::move(document));
  else
    session.drag(std::move(document));
  if (dragging) return;
  if (in_drag) session.end_drag();
  dragged_.clear();
  if (!recorded) return;
  for (const auto& [parameter, value] : changed) emit committed(recorded::Set{name, parameter, value});
}

void HoleInteraction::change_plan(const std::string& label, const std::function<void(HolePlan&)>& change,
                                  bool recorded) {
  const Node* operation = node();
  if (operation == nullptr) return;
  attempt([&] {
    HolePlan plan(studio_, *operation);
    change(plan);
    edit(label, plan.values(), false, recorded);
  });
}

void HoleInteraction::fill_selected() {
  const std::vector<Index> holes = tool_.selected();
  if (holes.empty()) return emit told(tr("No hole is selected: click one in the list or in a view"));
  change_plan("Fill " + target(), [&](HolePlan& plan) { plan.fill(with_islands(rows_, holes)); });
}

void HoleInteraction::fill_all(const std::string& select) {
  const std::string what = select == "all-but-largest" ? "all but the largest hole"
                           : select == "inner"         ? "all inner holes"
                                                       : "all holes";
  change_plan("Fill " + what, [&](HolePlan& plan) { plan.fill_all(select); });
}

void HoleInteraction::fill_up_to(double diameter) {
  change_plan("Fill holes up to " + measure(diameter).toStdString(),
              [&](HolePlan& plan) { plan.fill_all("inner", diameter); });
}

void HoleInteraction::reopen_selected() {
  const std::vector<Index> holes = tool_.selected();
  if (holes.empty()) return emit told(tr("No hole is selected: click one in the list or in a view"));
  change_plan("Reopen " + target(), [&](HolePlan& plan) { plan.reopen(with_islands(rows_, holes)); });
}

void HoleInteraction::bridge_selected() {
  const std::vector<Index> holes = tool_.selected();
  if (holes.size() < 2) return emit told(tr("Select two rims to bridge: click one, then Shift+click the other"));
  const std::string label = holes.size() == 2
                                ? "Bridge holes " + std::to_string(holes[0]) + " and " + std::to_string(holes[1])
                                : "Bridge " + target();
  change_plan(label, [&](HolePlan& plan) { plan.bridge(holes); });
}

void HoleInteraction::clear_handles() {
  const std::vector<Index> holes = tool_.selected();
  const std::vector<Index> now_filled = filled();
  change_plan("Clear handles of " + target(),
              [&](HolePlan& plan) { plan.change(holes, now_filled, [](HoleWish& wish) { wish.through.clear(); }); });
}

// ---- The way patches are made

HoleInteraction::Way HoleInteraction::way() const {
  Way way;
  const Node* operation = node();
  if (operation == nullptr) return way;
  const auto value = [&](const char* name) { return filling_value(studio_, *operation, name); };
  const auto text = [&](const char* name) {
    const ParameterValue found = value(name);
    return std::holds_alternative<std::string>(found) ? std::get<std::string>(found) : std::string();
  };
  way.fairness = text("fairness");
  way.kernel = text("kernel");
  if (const auto bulge = value("bulge"); std::holds_alternative<double>(bulge)) way.bulge = std::get<double>(bulge);
  if (const auto trim = value("trim-rim"); std::holds_alternative<std::int64_t>(trim)) {
    way.trim_rim = static_cast<int>(std::get<std::int64_t>(trim));
  }
  if (tool_.selected().empty()) return way;
  try {
    const HoleWish wish = HolePlan(studio_, *operation).wish(tool_.selected().front());
    if (!wish.fairness.empty()) way.fairness = wish.fairness;
    if (!wish.kernel.empty()) way.kernel = wish.kernel;
    way.bulge = wish.bulge.value_or(way.bulge);
    way.trim_rim = static_cast<int>(wish.trim_rim.value_or(way.trim_rim));
  } catch (const Error&) {
    return way;  // the operation says what is wrong
  }
  return way;
}

void HoleInteraction::change_way(const std::string& label, const std::string& parameter, const ParameterValue& value,
                                 const std::function<void(HoleWish&)>& change, bool dragging) {
  const Node* operation = node();
  if (operation == nullptr) return;
  const std::string full = label + " of " + target();
  if (tool_.selected().empty()) return edit(full, {{parameter, value}}, dragging, true);
  const std::vector<Index> holes = tool_.selected();
  attempt([&] {
    HolePlan plan(studio_, *operation);
    plan.change(holes, filled(), change);
    edit(full, plan.values(), dragging, true);
  });
}

void HoleInteraction::set_fairness(const std::string& fairness) {
  change_way("Way " + fairness, "fairness", fairness, [&](HoleWish& wish) { wish.fairness = fairness; });
}

void HoleInteraction::set_kernel(const std::string& kernel) {
  change_way("Kernel " + kernel, "kernel", kernel, [&](HoleWish& wish) { wish.kernel = kernel; });
}

void HoleInteraction::set_bulge(double bulge, bool dragging) {
  change_way(
      "Bulge", "bulge", bulge, [&](HoleWish& wish) { wish.bulge = bulge; }, dragging);
}

void HoleInteraction::set_trim(int rings) {
  change_way("Trim rim", "trim-rim", std::int64_t{rings}, [&](HoleWish& wish) { wish.trim_rim = rings; });
}

void HoleInteraction::set_mode(const std::string& mode) {
  edit(mode == "remesh" ? "Make the model anew" : "Fill by patches", {{"mode", mode}}, false, true);
}

// ---- The hand

void HoleInteraction::take(const PointerEvent& event) {
  for (const PenStep& step : pen_.handle(event)) feed(step);
  if (!pen_.down()) hover(event);
}

void HoleInteraction::feed(const PenStep& step) {
  gesture_view_ = step.view;
  const MeshEvent event{step.kind, step.sample.position, step.modifiers, frame_of_(step.view), step.sample.time};
  attempt([&] { finish(tool_.handle(event)); });
  follow_pull();
  overlay_.follow_hover(tool_);
  emit changed();
}

void HoleInteraction::hover(const PointerEvent& event) {
  if (event.action == PointerEvent::Action::Leave) return leave();
  gesture_view_ = event.view;
  if (!tool_.hover(event.position, frame_of_(event.view))) return;
  overlay_.follow_hover(tool_);
  emit changed();
}

void HoleInteraction::leave() {
  if (!tool_.leave()) return;
  overlay_.follow_hover(tool_);
  emit changed();
}

bool HoleInteraction::abandon() {
  if (!pen_.down()) return false;
  for (const PenStep& step : pen_.cancel()) feed(step);
  return true;
}

void HoleInteraction::follow_pull() {
  const auto& pull = tool_.preview().pull;
  const Node* operation = node();
  if (!pull || operation == nullptr) {
    if (std::exchange(dragging_, false)) studio_.session().cancel_drag();
    dragged_.clear();
    pulled_.reset();
    return;
  }
  attempt([&] {
    if (!pulled_) pulled_ = HolePlan(studio_, *operation);
    HolePlan plan = *pulled_;
    const std::vector<Index> hole{pull->hole};
    plan.change(hole, filled(), [&](HoleWish& wish) { wish.through = moved_through(wish.through, pull->as_step()); });
    edit("Shape hole " + std::to_string(pull->hole), plan.values(), true, false);
  });
}

void HoleInteraction::finish(Verdict verdict) {
  if (verdict != Verdict::Commit || !tool_.done()) return;
  const recorded::Step done = *tool_.done();
  if (const auto* choice = std::get_if<recorded::HoleChoice>(&done)) apply(*choice);
  if (const auto* point = std::get_if<recorded::HolePoint>(&done)) apply(*point);
  emit committed(done);
}

void HoleInteraction::apply(const recorded::HoleChoice& step) {
  if (step.action == "fill") {
    const std::string name = (step.holes.size() == 1 ? "hole " : "holes ") +
                             numbers_of({step.holes.begin(), step.holes.end()}).toStdString();
    change_plan(
        "Fill " + name, [&](HolePlan& plan) { plan.fill(with_islands(rows_, step.holes)); }, false);
  } else if (step.action == "leave") {
    const std::string name = (step.holes.size() == 1 ? "hole " : "holes ") +
                             numbers_of({step.holes.begin(), step.holes.end()}).toStdString();
    change_plan(
        "Reopen " + name, [&](HolePlan& plan) { plan.reopen(with_islands(rows_, step.holes)); }, false);
  }
  selection_moved();
}

void HoleInteraction::apply(const recorded::HolePoint& step) {
  const Node* operation = node();
  if (operation == nullptr) return;
  HolePlan plan = pulled_ ? *pulled_ : HolePlan(studio_, *operation);
  pulled_.reset();
  const std::vector<Index> hole{step.hole};
  plan.change(hole, filled(), [&](HoleWish& wish) { wish.through = moved_through(wish.through, step); });
  edit("Shape hole " + std::to_string(step.hole), plan.values(), false, false);
}

void HoleInteraction::replay(const recorded::HoleChoice& step) {
  follow();
  finish(tool_.replay(step));
}

void HoleInteraction::replay(const recorded::HolePoint& step) {
  follow();
  finish(tool_.replay(step));
}

QString HoleInteraction::help() const {
  if (tool_.preview().pull) return tr("The patch goes through here · Shift moves it in and out · Escape gives it up");
  if (rows_.empty()) return shown_ ? tr("This mesh has no holes") : tr("Looking for holes …");
  const std::vector<Index>& chosen = tool_.selected();
  if (chosen.empty()) {
    return tr("Click a hole to see its patch, double click to fill it · drag a box · Shift+F fills all inner ones");
  }
  if (!open_of(chosen).empty()) {
    return tr("Enter fills what is previewed · drag the patch to shape it · F frames · Shift adds, Ctrl takes away");
  }
  return tr("Delete opens it again · drag the patch to shape it · F frames · Ctrl+Z undoes");
}

}  // namespace croquis::app
