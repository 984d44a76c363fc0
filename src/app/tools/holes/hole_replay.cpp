// SPDX-License-Identifier: GPL-3.0-or-later
// Recorded steps of work on holes, and what replays can expect of them.
#include <algorithm>
#include <set>

#include "app/replay/replay_lookup.h"
#include "app/tools/holes/hole_filling_tool.h"
#include "croquis/tools/holes/hole_steps.h"

namespace croquis::app {
namespace {

/// Those that are open or failed.
std::size_t count_open_holes(const WorkObject& object) {
  const auto rows = hole_rows(object.result.get());
  return static_cast<std::size_t>(
      std::ranges::count_if(rows, [](const HoleRow& row) { return row.state != HoleState::Filled; }));
}

std::size_t count_patches(const WorkObject& object) {
  std::set<Index> numbers;
  for (const HoleRow& row : hole_rows(object.result.get())) {
    if (row.patch && row.state == HoleState::Filled) numbers.insert(*row.patch);
  }
  return numbers.size();
}

}  // namespace

std::vector<const recorded::StepKind*> HoleFillingTool::steps() const {
  return {&recorded::step_kind<recorded::HoleChoice>(), &recorded::step_kind<recorded::HoleWay>(),
          &recorded::step_kind<recorded::HolePoint>()};
}

template <class HoleStep>
void HoleFillingTool::replay_on_holes(const HoleStep& step) {
  if (!step.node.empty()) studio().set_active(object_named(studio(), step.node).node);
  if (!holes_.active()) refuse_replay("No holes are being worked on: the action \"holes\" opens them");
  host().wait_until_settled();  // their numbers are known once they have been found
  holes_.replay(step);
}

bool HoleFillingTool::replay(const recorded::Step& step) {
  if (const auto* choice = step.as<recorded::HoleChoice>()) {
    replay_on_holes(*choice);
  } else if (const auto* way = step.as<recorded::HoleWay>()) {
    replay_on_holes(*way);
  } else if (const auto* point = step.as<recorded::HolePoint>()) {
    replay_on_holes(*point);
  } else {
    return false;
  }
  return true;
}

Expectations HoleFillingTool::expectations() {
  Expectations own;
  own.counts["holes"] = [this](const std::string& node) { return count_open_holes(object_named(studio(), node)); };
  own.counts["patches"] = [this](const std::string& node) { return count_patches(object_named(studio(), node)); };
  own.counts["selected"] = [this](const std::string&) {
    return holes_.active() ? holes_.selected().size() : studio().session().components().elements.size();
  };
  return own;
}

}  // namespace croquis::app
