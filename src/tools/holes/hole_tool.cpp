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

/// @throws Error (E_INPUT) naming each hole that isn't there
void require_holes(const HoleScene& scene, const std::vector<Index>& holes) {
  Findings findings;
  for (const Index hole : holes) {
    if (scene.rim(hole) != nullptr) continue;
    findings.push_back(make_error(Category::Usage, "E_INPUT", "The scan has no hole " + std::to_string(hole),
                                  {numbered_subject(SubjectKind::Hole, hole)}));
  }
  if (!findings.empty()) throw Error(std::move(findings));
}

}  // namespace

/// A gesture under way.
struct HoleGesture {
  enum class Kind { Press, Box, Pull };

  Kind kind = HoleGesture::Kind::Press;
  MeshEvent start;           ///< that began it
  Vec2 last = Vec2::Zero();  ///< where the pointer is
  HoleHover pressed;         ///< what it was pressed on
  std::optional<PatchDrag> drag;

  PickBox box() const { return PickBox::spanned(start.pixel, last); }
};

HoleTool::HoleTool(HoleToolOptions options) : options_(options), scene_(std::make_unique<HoleScene>(options)) {}
HoleTool::~HoleTool() = default;
HoleTool::HoleTool(HoleTool&&) noexcept = default;
HoleTool& HoleTool::operator=(HoleTool&&) noexcept = default;

// ---- What it works on

void HoleTool::set_rims(std::vector<HoleRim> rims) {
  gesture_.reset();
  preview_ = {};
  last_click_.reset();
  scene_->set_rims(std::move(rims));
  std::erase_if(selected_, [&](Index hole) { return rim(hole) == nullptr; });
}

const std::vector<HoleRim>& HoleTool::rims() const { return scene_->rims(); }
const HoleRim* HoleTool::rim(Index hole) const { return scene_->rim(hole); }
void HoleTool::set_filled(std::vector<Index> holes) { filled_ = sorted(std::move(holes)); }
void HoleTool::set_patches(std::vector<HolePatchView> patches) { scene_->set_patches(std::move(patches)); }
void HoleTool::set_handles(std::vector<PatchHandle> handles) { scene_->handles = std::move(handles); }
const std::vector<PatchHandle>& HoleTool::handles() const { return scene_->handles; }
void HoleTool::set_sight(HoleSight sight) { scene_->set_sight(std::move(sight)); }
const std::vector<HolePin>& HoleTool::pins(const ViewFrame& frame) { return scene_->pins(frame); }

// ---- Gestures

Verdict HoleTool::handle(const MeshEvent& event) {
  const bool is_finite = event.pixel.allFinite();
  const bool begins = event.kind == PenStep::Kind::Begin;
  if (event.kind == PenStep::Kind::Cancel || (begins && !is_finite)) return give_up();
  if (begins) {
    give_up();
    gesture_ = std::make_unique<HoleGesture>(
        HoleGesture{HoleGesture::Kind::Press, event, event.pixel, scene_->at(event.frame, event.pixel), {}});
    return Verdict::Continue;
  }
  if (!gesture_) return Verdict::Continue;
  if (is_finite && event.pixel != gesture_->last) go_on(event);
  return event.kind == PenStep::Kind::End ? finish() : Verdict::Continue;
}

void HoleTool::go_on(const MeshEvent& event) {
  HoleGesture& now = *gesture_;
  now.last = event.pixel;
  if (now.kind == HoleGesture::Kind::Press && (now.last - now.start.pixel).norm() > options_.drag_pixels) {
    now.kind = now.pressed.place && !now.start.modifiers.ctrl ? HoleGesture::Kind::Pull : HoleGesture::Kind::Box;
    preview_.hovered = {};
  }
  if (now.kind == HoleGesture::Kind::Box) preview_.box = now.box();
  if (now.kind != HoleGesture::Kind::Pull) return;
  if (!now.drag) {
    PatchPull pull;
    pull.hole = now.pressed.holes.front();
    if (now.pressed.part == HolePart::Handle) pull.handle = now.pressed.handle;
    pull.from = *now.pressed.place;
    pull.normal = scene_->normal_at(now.pressed, now.start.frame);
    pull.along_normal = now.start.modifiers.shift;
    now.drag.emplace(now.start.frame, now.start.pixel, pull.from,
                     pull.along_normal ? std::optional(pull.normal) : std::nullopt);
    preview_.pull = pull;
  }
  preview_.pull->to = now.drag->to(now.last);
}

Verdict HoleTool::give_up() {
  if (!gesture_) return Verdict::Continue;
  gesture_.reset();
  preview_ = {};
  return Verdict::Revert;
}

Verdict HoleTool::finish() {
  const std::unique_ptr<const HoleGesture> gesture = std::exchange(gesture_, nullptr);
  const std::optional<PatchPull> pull = std::exchange(preview_, {}).pull;
  const MeshEvent& start = gesture->start;
  const std::string action = action_of(start.modifiers);
  if (gesture->kind == HoleGesture::Kind::Pull)
    return pull->from == pull->to ? Verdict::Revert : commit(pull->as_step());
  if (gesture->kind == HoleGesture::Kind::Box) return choose(scene_->in_box(start.frame, gesture->box()), action);
  const HoleHover& under = gesture->pressed;
  const bool again = last_click_ && start.time - last_click_->time <= options_.double_click_seconds &&
                     (start.pixel - last_click_->pixel).norm() <= options_.drag_pixels;
  last_click_ = again ? std::nullopt : std::optional(start);
  if (under.part == HolePart::Handle && action == "remove")
    return commit(recorded::HolePoint{under.holes.front(), under.place, std::nullopt, {}});
  if (under.holes.empty()) return action == "select" ? choose({}, action) : Verdict::Continue;
  if (!again || start.modifiers != Modifiers{}) return choose(under.holes, action);
  const bool all_filled = std::ranges::all_of(under.holes, [&](Index hole) { return is_filled(hole); });
  return commit(recorded::HoleChoice{under.holes, all_filled ? "leave" : "fill", {}});
}

bool HoleTool::hover(const Vec2& pixel, const ViewFrame& frame) {
  if (active() || !pixel.allFinite()) return false;
  HoleHover now = scene_->at(frame, pixel);
  const bool changed = now != preview_.hovered;
  preview_.hovered = std::move(now);
  return changed;
}

bool HoleTool::leave() {
  if (active()) return false;
  return std::exchange(preview_, {}).hovered != HoleHover{};
}

// ---- Selection

Verdict HoleTool::choose(std::vector<Index> holes, const std::string& action) {
  holes = sorted(std::move(holes));
  std::vector<Index> after = chosen(selected_, holes, action);
  if (after == selected_) return Verdict::Continue;
  selected_ = std::move(after);
  return commit(recorded::HoleChoice{std::move(holes), action, {}});
}

Verdict HoleTool::commit(recorded::Step step) {
  done_ = std::move(step);
  return Verdict::Commit;
}

Verdict HoleTool::select(std::vector<Index> holes) {
  std::erase_if(holes, [&](Index hole) { return rim(hole) == nullptr; });
  return choose(std::move(holes), "select");
}

Verdict HoleTool::take(const recorded::Step& step) {
  const auto* choice = step.as<recorded::HoleChoice>();
  const auto* point = step.as<recorded::HolePoint>();
  if (choice == nullptr && point == nullptr)
    throw Error(make_error(Category::Usage, "E_INPUT", "This step is none of the hole tool."));
  require_holes(*scene_, choice ? choice->holes : std::vector<Index>{point->hole});
  const bool selects = choice && choice->action != "fill" && choice->action != "leave";
  return selects ? choose(choice->holes, choice->action) : commit(step);
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
