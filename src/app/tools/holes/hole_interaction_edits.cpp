// SPDX-License-Identifier: GPL-3.0-or-later
// What becomes of holes, and how their patches are made: all that changes the operation's parameters.
#include <algorithm>
#include <utility>

#include "app/tools/holes/hole_interaction.h"
#include "app/tools/holes/hole_plan.h"
#include "croquis/base/error.h"
#include "croquis/tools/recording/general_steps.h"

namespace croquis::app {
namespace {

const std::string remesh_label = "Remesh";

/// "hole 3", "holes 1, 4"; "all holes" for none.
std::string words_for(const std::vector<Index>& holes) {
  if (holes.empty()) return "all holes";
  const std::string numbers = numbers_of({holes.begin(), holes.end()}).toStdString();
  return (holes.size() == 1 ? "hole " : "holes ") + numbers;
}

std::string label_up_to(double diameter) { return "Fill holes up to " + measure(diameter).toStdString(); }

std::string words_for(const recorded::HoleWay& way) {
  const std::string what = way.fairness ? "Method " + *way.fairness
                           : way.kernel ? "Kernel " + *way.kernel
                           : way.bulge  ? "Bulge"
                                        : "Trim rim";
  return what + " of " + words_for(way.holes);
}

void apply(const recorded::HoleWay& way, HoleRequest& request) {
  if (way.fairness) request.fairness = fairness_named(*way.fairness);  // "auto": as for all
  if (way.kernel) request.kernel = kernel_named(*way.kernel);
  if (way.bulge) request.bulge = *way.bulge;
  if (way.trim_rim) request.trim_rim = static_cast<int>(*way.trim_rim);
}

/// Its values as parameters of all holes.
ParameterValues values_of(const recorded::HoleWay& way) {
  ParameterValues values;
  if (way.fairness) values["fairness"] = *way.fairness;
  if (way.kernel) values["kernel"] = *way.kernel;
  if (way.bulge) values["bulge"] = *way.bulge;
  if (way.trim_rim) values["trim-rim"] = *way.trim_rim;
  return values;
}

}  // namespace

void HoleInteraction::attempt(const std::function<void()>& work) {
  try {
    work();
  } catch (const Error& error) {
    QStringList sentences;
    for (const Finding& finding : error.findings()) sentences << QString::fromStdString(finding.message);
    emit told(sentences.join(" "));
  }
}

void HoleInteraction::edit(const std::string& label, const ParameterValues& values, bool dragging) {
  const Node* operation = node();
  if (operation == nullptr) return;
  Document document = with_values(studio_, *operation, values);
  Session& session = studio_.session();
  const bool in_drag = dragging || dragging_;
  if (dragging && !dragging_) session.begin_drag(label);
  dragging_ = dragging;
  if (!in_drag) return session.edit(label, std::move(document));
  session.drag(std::move(document));
  if (!dragging) session.end_drag();
}

void HoleInteraction::change_plan(const std::string& label, const std::function<void(HolePlan&)>& change,
                                  const ParameterValues& besides) {
  const Node* operation = node();
  if (operation == nullptr) return;
  attempt([&] {
    HolePlan plan(studio_, *operation);
    change(plan);
    ParameterValues values = plan.values();
    values.insert(besides.begin(), besides.end());
    edit(label, values, false);
  });
}

// ---- What becomes of holes

void HoleInteraction::fill_selected() {
  const std::vector<Index> holes = tool_.selected();
  if (holes.empty()) return emit told(tr("No hole is selected: click one in the list or in a view"));
  apply(recorded::HoleChoice{holes, "fill"});
}

std::vector<Index> HoleInteraction::failed_of(const std::vector<Index>& holes) const {
  std::vector<Index> failed;
  for (const Index hole : holes) {
    const HoleRow* found = row(hole);
    if (found != nullptr && found->state == FillAction::Failed) failed.push_back(hole);
  }
  return failed;
}

bool HoleInteraction::can_fill_selected() const {
  if (!open_of(tool_.selected()).empty()) return true;
  const std::vector<Index> failed = failed_of(tool_.selected());
  const Node* operation = node();
  if (failed.empty() || operation == nullptr) return false;
  try {
    const HolePlan plan(studio_, *operation);
    return std::any_of(failed.begin(), failed.end(), [&](Index hole) { return plan.is_bridged(hole); });
  } catch (const Error&) {
    return true;  // filling reports the error
  }
}

void HoleInteraction::fill_all(const std::string& select) {
  const std::string what = select == "all-but-largest" ? "Fill all but the largest hole"
                           : select == "inner"         ? "Fill all inner holes"
                           : select == "none"          ? "Reopen all holes"
                                                       : "Fill all holes";
  fill_named(what, parse_selection(select), 0);
}

std::vector<Index> HoleInteraction::open_after(hole_filling::Selection select, std::span<const Index> named) const {
  std::vector<Index> open;
  for (const HoleRow& row : rows_) {
    const bool stays_filled = select == hole_filling::Selection::Inner && row.state == FillAction::Fill;
    if (!stays_filled && !std::ranges::binary_search(named, row.id)) open.push_back(row.id);
  }
  return open;
}

bool HoleInteraction::can_fill_all(const std::string& select) const {
  const bool is_known = shown_ && !shown_->failed;
  if (rows_.empty()) return !is_known;
  const hole_filling::Selection selection = parse_selection(select);
  const std::vector<Index> open = open_after(selection, named_rows(rows_, selection));
  return std::ranges::any_of(rows_, [&](const HoleRow& row) {
    return std::ranges::binary_search(open, row.id) != (row.state == FillAction::Leave);
  });
}

void HoleInteraction::fill_named(const std::string& label, hole_filling::Selection select, double limit) {
  const std::vector<Index> named = limit > 0 ? named_rows(rows_, select, limit) : named_rows(rows_, select);
  const std::vector<Index> open = open_after(select, named);
  std::vector<Index> kept;  // filled before, though the selection doesn't name them
  for (const HoleRow& row : rows_) {
    const bool is_left = std::ranges::binary_search(named, row.id) || std::ranges::binary_search(open, row.id);
    if (!is_left) kept.push_back(row.id);
  }
  const auto fill_named = [&](HolePlan& plan) {
    plan.fill_all(select, open);
    plan.fill(kept);
  };
  change_plan(label, fill_named, {{"max-diameter", limit}});
}

void HoleInteraction::fill_up_to(double diameter) {
  fill_named(label_up_to(diameter), hole_filling::Selection::Inner, diameter);
  selection_moved();
  emit committed(recorded::HoleChoice{{}, "fill", {}, diameter});
}

void HoleInteraction::reopen_selected() {
  const std::vector<Index> holes = tool_.selected();
  if (holes.empty()) return emit told(tr("No hole is selected: click one in the list or in a view"));
  apply(recorded::HoleChoice{holes, "leave"});
}

void HoleInteraction::bridge_selected() {
  const std::vector<Index> holes = tool_.selected();
  if (holes.size() < 2) return emit told(tr("Select two rims to bridge: click one, then Shift+click the other"));
  const std::string label = holes.size() == 2
                                ? "Bridge holes " + std::to_string(holes[0]) + " and " + std::to_string(holes[1])
                                : "Bridge " + words_for(holes);
  change_plan(label, [&](HolePlan& plan) { plan.bridge(holes); });
}

void HoleInteraction::clear_handles() {
  const std::vector<Index> holes = tool_.selected();
  const std::vector<Index> now_filled = filled();
  change_plan("Clear handles of " + words_for(holes), [&](HolePlan& plan) {
    plan.change(holes, now_filled, [](HoleRequest& request) { request.through.clear(); });
  });
}

void HoleInteraction::apply(const recorded::HoleChoice& step) {
  if (step.up_to) {
    fill_named(label_up_to(*step.up_to), hole_filling::Selection::Inner, *step.up_to);
  } else if (step.action == "fill") {
    change_plan("Fill " + words_for(step.holes), [&](HolePlan& plan) {
      // Where a bridge couldn't be made, each rim gets a patch of its own.
      plan.part_bridges(failed_of(step.holes));
      plan.fill(with_islands(rows_, step.holes));
    });
  } else if (step.action == "leave") {
    change_plan("Reopen " + words_for(step.holes),
                [&](HolePlan& plan) { plan.reopen(with_islands(rows_, step.holes)); });
  }
  selection_moved();
}

void HoleInteraction::apply(const recorded::HolePoint& step) {
  const Node* operation = node();
  if (operation == nullptr) return;
  HolePlan plan = pulled_ ? *pulled_ : HolePlan(studio_, *operation);
  pulled_.reset();
  const std::vector<Index> hole{step.hole};
  plan.change(hole, filled(), [&](HoleRequest& request) { request.through = moved_through(request.through, step); });
  edit("Shape hole " + std::to_string(step.hole), plan.values(), false);
}

// ---- How patches are made

HoleInteraction::Way HoleInteraction::way() const {
  const std::vector<Index>& chosen = tool_.selected();
  return way_of(chosen.empty() ? std::nullopt : std::optional(chosen.front()));
}

HoleInteraction::Way HoleInteraction::way_of(std::optional<Index> hole) const {
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
  if (!hole) return way;
  try {
    const HoleRequest request = HolePlan(studio_, *operation).request(*hole);
    if (request.fairness) way.fairness = name_of(*request.fairness);
    if (request.kernel) way.kernel = name_of(*request.kernel);
    way.bulge = request.bulge.value_or(way.bulge);
    way.trim_rim = request.trim_rim.value_or(way.trim_rim);
  } catch (const Error&) {
    return way;  // the operation reports the error
  }
  return way;
}

bool HoleInteraction::is_made_so(const recorded::HoleWay& step) const {
  const auto has = [&](std::optional<Index> hole) {
    const Way now = way_of(hole);
    return step.fairness.value_or(now.fairness) == now.fairness && step.kernel.value_or(now.kernel) == now.kernel &&
           step.bulge.value_or(now.bulge) == now.bulge && step.trim_rim.value_or(now.trim_rim) == now.trim_rim;
  };
  if (step.holes.empty()) return has(std::nullopt);
  return std::all_of(step.holes.begin(), step.holes.end(), has);
}

void HoleInteraction::change_way(const recorded::HoleWay& step, bool dragging) {
  const Node* operation = node();
  const bool in_drag = dragging || dragging_;
  if (operation == nullptr || (!in_drag && is_made_so(step))) return;
  attempt([&] {
    ParameterValues values = values_of(step);
    if (!step.holes.empty()) {
      HolePlan plan(studio_, *operation);
      plan.change(step.holes, filled(), [&](HoleRequest& request) { app::apply(step, request); });
      values = plan.values();
    }
    edit(words_for(step), values, dragging);
    if (!dragging) emit committed(step);
  });
}

void HoleInteraction::set_way(const WayChange& change, bool dragging) {
  change_way({tool_.selected(), change.fairness, change.kernel, change.bulge, change.trim_rim, {}}, dragging);
}

std::string HoleInteraction::preset() const {
  const Node* operation = node();
  return operation == nullptr ? std::string() : std::get<std::string>(filling_value(studio_, *operation, "preset"));
}

void HoleInteraction::set_preset(const std::string& preset) {
  const Node* operation = node();
  if (operation == nullptr || preset == this->preset()) return;
  const std::string name = operation->name;
  edit("Preset " + preset + " of all holes", {{"preset", preset}}, false);
  emit committed(recorded::Set{name, "preset", preset});
}

void HoleInteraction::set_mode(const std::string& mode) {
  const Node* operation = node();
  if (operation == nullptr) return;
  const std::string name = operation->name;
  edit(mode == "remesh" ? remesh_label : "Fill by patches", {{"mode", mode}}, false);
  emit committed(recorded::Set{name, "mode", mode});
}

void HoleInteraction::cancel() {
  const Node* operation = node();
  if (operation == nullptr) return;
  if (filling_value(studio_, *operation, "mode") != ParameterValue(std::string("remesh"))) return;
  const std::vector<std::string> steps = studio_.session().undo_labels();
  if (steps.empty() || steps.back() != remesh_label) return set_mode("patch");
  studio_.session().undo();
  emit committed(recorded::Action{"undo"});
}

}  // namespace croquis::app
