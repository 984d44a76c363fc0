// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tools/holes/scan_holes.h"

#include <algorithm>
#include <utility>

#include "app/views/viewport.h"
#include "app/window/language.h"
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

}  // namespace

ScanHoles::ScanHoles(Tool& tool_of_window, ToolHost& window)
    : owner(tool_of_window), host(window), preview(window.studio(), window.viewport().objects().threads(), nullptr) {
  QObject::connect(&preview, &PatchPreview::changed, &owner, [this] {
    show_patches();
    emit owner.changed();
  });
}

const HoleRow* ScanHoles::row(Index hole) const {
  const auto found = std::ranges::find(rows, hole, &HoleRow::id);
  return found == rows.end() ? nullptr : &*found;
}

std::shared_ptr<const PolyMesh> ScanHoles::scan() const {
  const FillResult* found = result_of<FillResult>(shown.get());
  return found == nullptr ? nullptr : found->scan;
}

std::vector<Index> ScanHoles::filled() const {
  std::vector<Index> holes;
  for (const HoleRow& row : rows) {
    if (row.state == FillAction::Fill) holes.push_back(row.id);
  }
  return holes;
}

void ScanHoles::select(std::vector<Index> holes) {
  if (tool.select(std::move(holes)) != Verdict::Commit) return;
  if (tool.done()) emit owner.committed(*tool.done());
  follow_selection();
}

// ---- What is there

void ScanHoles::follow() {
  const Node* operation = active ? node() : nullptr;
  take_result(operation);
  preview.show(operation == nullptr ? 0 : operation->id, open_of_selected(*this));
  preview.follow();
  if (!tool.active()) show_handles();
  overlay.follow(tool, rows);
  emit owner.changed();
}

void ScanHoles::follow_selection() {
  follow();
  emit owner.state_changed();
}

/// Of a step within a chain, its own result; the views show the end of the chain.
void ScanHoles::take_result(const Node* operation) {
  const WorkObject* object = operation == nullptr ? nullptr : studio().active();
  const NodeId now = operation == nullptr ? 0 : operation->id;
  const auto result = object == nullptr ? nullptr : object->node == now ? object->result : studio().result(now);
  if (result == shown && now == shown_node) return;
  const bool other_object = now != shown_node;
  shown = result;
  shown_node = now;
  rows = hole_rows(result.get());
  follow_sight();
  const auto rims = result ? result->outputs.find("rims") : Values::const_iterator();
  if (other_object || !result) tool.select({});
  if (!result || rims == result->outputs.end())
    tool.set_rims({});
  else if (!tool.active())
    tool.set_rims(rims_from_lines(rims->second.get<PolyMesh>()));
  tool.set_filled(filled());
  show_patches();
  emit owner.state_changed();
}

/// Before it is known, and without a scan, nothing hides anything.
void ScanHoles::follow_sight() {
  const auto now = scan();
  if (now == sight_scan) return;
  sight_scan = now;
  sight.reset();
  tool.set_sight({});
  sight_job.cancel();
  if (!now) return;
  const auto prepare = [now](Progress&) {
    auto picker = std::make_shared<MeshPicker>(now);
    picker->prepare();
    return picker;
  };
  sight_job.start(prepare, [this](const std::optional<std::shared_ptr<MeshPicker>>& made) {
    sight = made.value_or(nullptr);
    if (!sight) return;
    tool.set_sight(
        [picker = sight](const ViewFrame& frame, const Vec3& place) { return is_seen(*picker, frame, place); });
    emit owner.changed();
  });
}

void ScanHoles::show_patches() {
  std::vector<HolePatchView> views;
  if (const PatchSurface* patches = host.viewport().objects().patches(shown_node)) views = patch_views(*patches, rows);
  if (preview.patches().mesh) {
    for (HolePatchView& view : patch_views(preview.patches(), preview.rows())) views.push_back(std::move(view));
  }
  tool.set_patches(std::move(views));
}

void ScanHoles::show_handles() {
  std::vector<PatchHandle> handles;
  const Node* operation = active ? node() : nullptr;
  if (operation != nullptr) {
    attempt([&] {
      const HolePlan plan(studio(), *operation);
      for (const Index hole : selected()) {
        const HoleRow* found = row(hole);
        for (const Vec3& place : plan.request(hole).through) {
          handles.push_back({hole, place, found == nullptr ? Vec3(Vec3::UnitZ()) : found->normal});
        }
      }
    });
  }
  tool.set_handles(std::move(handles));
}

void ScanHoles::attempt(const std::function<void()>& work) {
  try {
    work();
  } catch (const Error& error) {
    QStringList sentences;
    for (const Finding& finding : error.findings()) sentences << localized(finding.message);
    host.say(sentences.join(" "));
  }
}

void ScanHoles::edit(const std::string& label, const ParameterValues& values, bool drags) {
  const Node* operation = node();
  if (operation == nullptr) return;
  Document document = with_values(studio(), *operation, values);
  Session& session = studio().session();
  const bool in_drag = drags || dragging;
  if (drags && !dragging) session.begin_drag(label);
  dragging = drags;
  if (!in_drag) return session.edit(label, std::move(document));
  session.drag(std::move(document));
  if (!drags) session.end_drag();
}

std::vector<Index> holes_in_state(const ScanHoles& holes, std::vector<Index> some, FillAction state) {
  std::erase_if(some, [&](Index hole) {
    const HoleRow* row = holes.row(hole);
    return row == nullptr || row->state != state;
  });
  return some;
}

std::vector<Index> open_of_selected(const ScanHoles& holes) {
  return holes_in_state(holes, with_islands(holes.rows, holes.selected()), FillAction::Leave);
}

std::vector<Index> open_up_to(const ScanHoles& holes, double diameter) {
  return holes_in_state(holes, named_rows(holes.rows, hole_filling::Selection::Inner, diameter), FillAction::Leave);
}

}  // namespace croquis::app
