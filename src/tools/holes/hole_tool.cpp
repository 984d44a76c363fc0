// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/tools/holes/hole_tool.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>
#include <utility>

#include "croquis/base/error.h"
#include "tools/holes/hole_scene.h"

namespace croquis {
namespace {

enum class Gesture { None, Press, Box, Pull };

std::string action_of(const Modifiers& modifiers) {
  if (modifiers.shift) return modifiers.ctrl ? "add" : "toggle";
  return modifiers.ctrl ? "remove" : "select";
}

std::vector<Index> sorted(std::vector<Index> holes) {
  std::sort(holes.begin(), holes.end());
  holes.erase(std::unique(holes.begin(), holes.end()), holes.end());
  return holes;
}

/// @param before, holes sorted
std::vector<Index> chosen(const std::vector<Index>& before, const std::vector<Index>& holes,
                          const std::string& action) {
  std::vector<Index> after;
  const auto into = std::back_inserter(after);
  if (action == "add")
    std::set_union(before.begin(), before.end(), holes.begin(), holes.end(), into);
  else if (action == "remove")
    std::set_difference(before.begin(), before.end(), holes.begin(), holes.end(), into);
  else if (action == "toggle")
    std::set_symmetric_difference(before.begin(), before.end(), holes.begin(), holes.end(), into);
  else
    after = holes;
  return after;
}

bool has_hole(const std::vector<Index>& holes, Index hole) {
  return std::binary_search(holes.begin(), holes.end(), hole);
}

}  // namespace

struct HoleTool::State {
  explicit State(const HoleToolOptions& wanted) : options(wanted), scene(wanted) {}

  Verdict begin(const MeshEvent& event);
  void go_on(const MeshEvent& event);
  Verdict finish();
  Verdict give_up();
  void end_gesture();
  void start_pull();
  Verdict click();
  Verdict click_on(const HoleHover& under, const Modifiers& modifiers, bool again);
  Verdict choose(std::vector<Index> holes, const std::string& action);
  Verdict commit(recorded::Step step);
  void require(const std::vector<Index>& holes) const;

  HoleToolOptions options;
  HoleScene scene;
  std::vector<Index> filled;
  std::vector<Index> selected;
  HolePreview preview;
  std::optional<recorded::Step> done;

  Gesture gesture = Gesture::None;
  MeshEvent start;           ///< that began the gesture
  Vec2 last = Vec2::Zero();  ///< where the pointer is
  HoleHover pressed;         ///< what it was pressed on
  std::optional<PatchDrag> drag;
  std::optional<MeshEvent> last_click;
};

// ---- Gestures

Verdict HoleTool::State::begin(const MeshEvent& event) {
  give_up();
  start = event;
  last = event.pixel;
  pressed = scene.at(event.frame, event.pixel);
  gesture = Gesture::Press;
  return Verdict::Continue;
}

void HoleTool::State::go_on(const MeshEvent& event) {
  last = event.pixel;
  if (gesture == Gesture::Press && (last - start.pixel).norm() > options.drag_pixels) {
    const bool pulls = pressed.place && !start.modifiers.ctrl;
    gesture = pulls ? Gesture::Pull : Gesture::Box;
    preview.hovered = {};
    if (pulls) start_pull();
  }
  if (gesture == Gesture::Box) preview.box = PickBox::spanned(start.pixel, last);
  if (gesture == Gesture::Pull) preview.pull->to = drag->to(last);
}

void HoleTool::State::start_pull() {
  PatchPull pull;
  pull.hole = pressed.holes.front();
  if (pressed.part == HolePart::Handle) pull.handle = pressed.handle;
  pull.from = pull.to = *pressed.place;
  pull.normal = scene.normal_at(pressed, start.frame);
  pull.along_normal = start.modifiers.shift;
  drag.emplace(start.frame, start.pixel, pull.from, pull.along_normal ? std::optional(pull.normal) : std::nullopt);
  preview.pull = pull;
}

Verdict HoleTool::State::finish() {
  const Gesture finished = gesture;
  if (finished == Gesture::Press) return click();
  const std::optional<PatchPull> pull = preview.pull;
  end_gesture();
  if (finished == Gesture::Pull) return pull->from == pull->to ? Verdict::Revert : commit(pull->as_step());
  if (finished != Gesture::Box) return Verdict::Continue;
  return choose(scene.in_box(start.frame, PickBox::spanned(start.pixel, last)), action_of(start.modifiers));
}

Verdict HoleTool::State::give_up() {
  if (gesture == Gesture::None) return Verdict::Continue;
  end_gesture();
  return Verdict::Revert;
}

void HoleTool::State::end_gesture() {
  gesture = Gesture::None;
  preview = {};
  drag.reset();
}

Verdict HoleTool::State::click() {
  const HoleHover under = std::exchange(pressed, {});
  end_gesture();
  const bool again = last_click && start.time - last_click->time <= options.double_click_seconds &&
                     (start.pixel - last_click->pixel).norm() <= options.drag_pixels;
  last_click = again ? std::nullopt : std::optional(start);
  return click_on(under, start.modifiers, again && start.modifiers == Modifiers{});
}

Verdict HoleTool::State::click_on(const HoleHover& under, const Modifiers& modifiers, bool again) {
  const std::string action = action_of(modifiers);
  if (under.part == HolePart::Handle && action == "remove")
    return commit(recorded::HolePoint{under.holes.front(), under.place, std::nullopt, {}});
  if (under.holes.empty()) return action == "select" ? choose({}, action) : Verdict::Continue;
  if (!again) return choose(under.holes, action);
  const bool all_filled =
      std::all_of(under.holes.begin(), under.holes.end(), [&](Index hole) { return has_hole(filled, hole); });
  return commit(recorded::HoleChoice{under.holes, all_filled ? "leave" : "fill", {}});
}

// ---- Selection

Verdict HoleTool::State::choose(std::vector<Index> holes, const std::string& action) {
  holes = sorted(std::move(holes));
  std::vector<Index> after = chosen(selected, holes, action);
  if (after == selected) return Verdict::Continue;
  selected = std::move(after);
  return commit(recorded::HoleChoice{std::move(holes), action, {}});
}

Verdict HoleTool::State::commit(recorded::Step step) {
  done = std::move(step);
  return Verdict::Commit;
}

void HoleTool::State::require(const std::vector<Index>& holes) const {
  Findings findings;
  for (const Index hole : holes) {
    if (scene.rim(hole) != nullptr) continue;
    const std::string id = std::to_string(hole);
    findings.push_back(make_error(Category::Usage, "E_INPUT", "The scan has no hole " + id,
                                  {numbered_subject(SubjectKind::Hole, hole)}));
  }
  if (!findings.empty()) throw Error(std::move(findings));
}

// ---- The tool

HoleTool::HoleTool(HoleToolOptions options) : state_(std::make_unique<State>(options)) {}
HoleTool::~HoleTool() = default;
HoleTool::HoleTool(HoleTool&&) noexcept = default;
HoleTool& HoleTool::operator=(HoleTool&&) noexcept = default;

void HoleTool::set_rims(std::vector<HoleRim> rims) {
  state_->end_gesture();
  state_->last_click.reset();
  state_->scene.set_rims(std::move(rims));
  std::erase_if(state_->selected, [&](Index hole) { return rim(hole) == nullptr; });
}

const std::vector<HoleRim>& HoleTool::rims() const { return state_->scene.rims(); }
const HoleRim* HoleTool::rim(Index hole) const { return state_->scene.rim(hole); }
void HoleTool::set_filled(std::vector<Index> holes) { state_->filled = sorted(std::move(holes)); }
bool HoleTool::is_filled(Index hole) const { return has_hole(state_->filled, hole); }
void HoleTool::set_patches(std::vector<HolePatchView> patches) { state_->scene.set_patches(std::move(patches)); }
void HoleTool::set_handles(std::vector<PatchHandle> handles) { state_->scene.handles = std::move(handles); }
const std::vector<PatchHandle>& HoleTool::handles() const { return state_->scene.handles; }
void HoleTool::set_sight(HoleSight sight) { state_->scene.set_sight(std::move(sight)); }

Verdict HoleTool::handle(const MeshEvent& event) {
  State& state = *state_;
  if (event.kind == PenStep::Kind::Cancel) return state.give_up();
  if (event.kind == PenStep::Kind::Begin) return event.pixel.allFinite() ? state.begin(event) : state.give_up();
  if (state.gesture == Gesture::None) return Verdict::Continue;
  if (event.pixel.allFinite() && event.pixel != state.last) state.go_on(event);
  return event.kind == PenStep::Kind::End ? state.finish() : Verdict::Continue;
}

bool HoleTool::active() const { return state_->gesture != Gesture::None; }

bool HoleTool::hover(const Vec2& pixel, const ViewFrame& frame) {
  if (active() || !pixel.allFinite()) return false;
  HoleHover now = state_->scene.at(frame, pixel);
  const bool changed = now != state_->preview.hovered;
  state_->preview.hovered = std::move(now);
  return changed;
}

bool HoleTool::leave() {
  if (active()) return false;
  const bool changed = state_->preview.hovered != HoleHover{};
  state_->preview = {};
  return changed;
}

const HolePreview& HoleTool::preview() const { return state_->preview; }
const std::optional<recorded::Step>& HoleTool::done() const { return state_->done; }
const std::vector<HolePin>& HoleTool::pins(const ViewFrame& frame) { return state_->scene.pins(frame); }

const std::vector<Index>& HoleTool::selected() const { return state_->selected; }
bool HoleTool::is_selected(Index hole) const { return has_hole(state_->selected, hole); }

Verdict HoleTool::select(std::vector<Index> holes) {
  std::erase_if(holes, [&](Index hole) { return rim(hole) == nullptr; });
  return state_->choose(std::move(holes), "select");
}

Verdict HoleTool::select_all() {
  std::vector<Index> all;
  for (const HoleRim& each : rims()) all.push_back(each.id);
  return select(std::move(all));
}

Verdict HoleTool::replay(const recorded::HoleChoice& step) {
  state_->require(step.holes);
  if (step.action == "fill" || step.action == "leave") return state_->commit(step);
  return state_->choose(step.holes, step.action);
}

Verdict HoleTool::replay(const recorded::HolePoint& step) {
  state_->require({step.hole});
  return state_->commit(step);
}

std::vector<Vec3> moved_through(std::vector<Vec3> through, const recorded::HolePoint& step, double reach) {
  auto meant = through.end();
  double nearest = reach;
  for (auto place = through.begin(); step.from && place != through.end(); ++place) {
    const double distance = (*place - *step.from).norm();
    if (!(distance <= nearest) || (meant != through.end() && distance == nearest)) continue;
    meant = place;
    nearest = distance;
  }
  if (meant != through.end()) {
    if (step.to)
      *meant = *step.to;
    else
      through.erase(meant);
  } else if (step.to) {
    through.push_back(*step.to);
  }
  return through;
}

}  // namespace croquis
