// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tools/holes/hole_interaction.h"

#include <QMetaObject>
#include <algorithm>
#include <utility>

#include "app/views/own_space.h"
#include "croquis/base/error.h"

namespace croquis::app {
namespace {

/// What lies so little before a hole's middle is its own rim, seen from the side. Share of the distance to the eye.
constexpr double slack = 0.01;

bool is_seen(MeshPicker& picker, const ViewFrame& frame, const Vec3& place) {
  const auto projected = frame.project(place);
  if (!projected) return false;
  const Ray ray = frame.ray(projected->pixel);
  const auto met = picker.face_under(ray);
  return !met || met->distance >= (1 - slack) * (place - ray.origin).dot(ray.direction);
}

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

/// By the sign of the volume that its faces see from the middle.
bool is_inside_out(const PolyMesh& mesh) {
  Vec3 middle = Vec3::Zero();
  for (const Vec3& place : mesh.positions) middle += place / static_cast<double>(mesh.vertex_count());
  double volume = 0;
  for (std::size_t face = 0; face < mesh.face_count(); ++face) {
    const auto corners = mesh.face(face);
    const Vec3 first = mesh.positions[corners[0]] - middle;
    for (std::size_t k = 2; k < corners.size(); ++k) {
      const Vec3 second = mesh.positions[corners[k - 1]] - middle, third = mesh.positions[corners[k]] - middle;
      volume += first.dot(second.cross(third));
    }
  }
  return volume < 0;
}

}  // namespace

HoleSightMaker::HoleSightMaker(QObject* parent) : QObject(parent) { thread_.setMaxThreadCount(1); }

HoleSightMaker::~HoleSightMaker() { thread_.waitForDone(); }

void HoleSightMaker::follow(const std::shared_ptr<const PolyMesh>& scan) {
  if (scan == scan_) return;
  scan_ = scan;
  picker_.reset();
  if (!scan) return;
  thread_.start([this, scan] {
    const auto picker = std::make_shared<MeshPicker>(scan);
    picker->prepare();
    QMetaObject::invokeMethod(
        this,
        [this, scan, picker] {
          if (scan != scan_) return;
          picker_ = picker;
          emit changed();
        },
        Qt::QueuedConnection);
  });
}

HoleSight HoleSightMaker::sight() const {
  if (!picker_) return {};
  return [picker = picker_](const ViewFrame& frame, const Vec3& place) { return is_seen(*picker, frame, place); };
}

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
  const FillResult* found = result_of<FillResult>(shown_.get());
  return found == nullptr ? nullptr : found->scan;
}

const Node* HoleInteraction::node() const { return filling_node(studio_); }

std::vector<Index> HoleInteraction::filled() const {
  std::vector<Index> holes;
  for (const HoleRow& row : rows_) {
    if (row.state == FillAction::Fill) holes.push_back(row.id);
  }
  return holes;
}

std::vector<Index> HoleInteraction::open_of(const std::vector<Index>& holes) const {
  std::vector<Index> open;
  for (const Index hole : with_islands(rows_, holes)) {
    const HoleRow* found = row(hole);
    if (found != nullptr && found->state == FillAction::Leave) open.push_back(hole);
  }
  return open;
}

// ---- What is there

void HoleInteraction::follow() {
  const Node* operation = active_ ? node() : nullptr;
  take_result(operation);
  preview_.show(operation == nullptr ? 0 : operation->id, open_of(tool_.selected()));
  preview_.follow();
  if (!tool_.active()) show_handles();
  overlay_.follow(tool_, rows_);
  emit changed();
}

/// Of a step within a chain, its own result; the views show the end of the chain.
void HoleInteraction::take_result(const Node* operation) {
  const WorkObject* object = operation == nullptr ? nullptr : studio_.active();
  const NodeId now = operation == nullptr ? 0 : operation->id;
  const auto result = object == nullptr ? nullptr : object->node == now ? object->result : studio_.result(now);
  if (result == shown_ && now == shown_node_) return;
  const bool other_object = now != shown_node_;
  shown_ = result;
  shown_node_ = now;
  rows_ = hole_rows(result.get());
  sight_.follow(scan());
  const auto rims = result ? result->outputs.find("rims") : Values::const_iterator();
  if (other_object || !result) tool_.select_none();
  if (!result || rims == result->outputs.end())
    tool_.set_rims({});
  else if (!tool_.active())
    tool_.set_rims(rims_from_lines(rims->second.get<PolyMesh>()));
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
        for (const Vec3& place : plan.request(hole).through) {
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
  const WorkObject* object = studio_.active();
  if (!active_ || object == nullptr) return;
  const PlacedPart part(scene, object->placement.map());
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

void HoleInteraction::select_by_size(double diameter) { select(open_up_to(diameter)); }

std::vector<Index> HoleInteraction::open_up_to(double diameter) const {
  std::vector<Index> holes = named_rows(rows_, hole_filling::Selection::Inner, diameter);
  std::erase_if(holes, [&](Index hole) { return row(hole)->state != FillAction::Leave; });
  return holes;
}

// ---- Pointer events

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
    pulled_.reset();
    return;
  }
  attempt([&] {
    if (!pulled_) pulled_ = HolePlan(studio_, *operation);
    HolePlan plan = *pulled_;
    const std::vector<Index> hole{pull->hole};
    plan.change(hole, filled(),
                [&](HoleRequest& request) { request.through = moved_through(request.through, pull->as_step()); });
    edit("Shape hole " + std::to_string(pull->hole), plan.values(), true);
  });
}

void HoleInteraction::finish(Verdict verdict) {
  if (verdict != Verdict::Commit || !tool_.done()) return;
  const recorded::Step done = *tool_.done();
  if (const auto* choice = done.as<recorded::HoleChoice>()) apply(*choice);
  if (const auto* point = done.as<recorded::HolePoint>()) apply(*point);
  emit committed(done);
}

void HoleInteraction::replay(const recorded::HoleChoice& step) {
  follow();
  finish(tool_.replay(step));
}

void HoleInteraction::replay(const recorded::HolePoint& step) {
  follow();
  finish(tool_.replay(step));
}

void HoleInteraction::replay(const recorded::HoleWay& step) {
  follow();
  for (const Index hole : step.holes) {
    if (row(hole) == nullptr) {
      throw Error(make_error(Category::Malformed, "E_INPUT", "There is no hole " + std::to_string(hole)));
    }
  }
  change_way(step, false);
}

std::optional<Vec3> HoleInteraction::selection_facing() const {
  constexpr double one_direction = 0.7;  // length of the mean
  const auto whole = scan();
  const std::vector<Index>& chosen = tool_.selected();
  if (!whole || chosen.empty()) return std::nullopt;
  Vec3 sum = Vec3::Zero();
  for (const Index hole : chosen) {
    if (const HoleRow* found = row(hole)) sum += found->normal;
  }
  if (sum.norm() < one_direction * static_cast<double>(chosen.size())) return std::nullopt;
  return (is_inside_out(*whole) ? -1 : 1) * sum.normalized();
}

QString HoleInteraction::help() const {
  if (node() == nullptr) return tr("O looks for the holes of this mesh");
  if (tool_.preview().pull) return tr("The patch goes through here · Shift moves it in and out · Escape gives it up");
  if (rows_.empty()) return shown_ ? tr("This mesh has no holes") : tr("Looking for holes …");
  const std::vector<Index>& chosen = tool_.selected();
  if (chosen.empty()) {
    return tr("Click a hole to see its patch, double click to fill it · drag a box · Shift+F fills all inner ones");
  }
  if (!open_of(chosen).empty()) {
    return tr("Enter fills what is previewed · drag the patch to shape it · F frames · Shift adds, Ctrl takes away");
  }
  if (failed_of(chosen).size() == chosen.size()) {
    return tr("No method gave a valid patch here: try another method, a bulge or trimming · Delete leaves it open");
  }
  return tr("Delete opens it again · drag the patch to shape it · F frames · Ctrl+Z undoes");
}

}  // namespace croquis::app
