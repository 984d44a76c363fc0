// SPDX-License-Identifier: GPL-3.0-or-later
// What becomes of holes, and how their patches are made: all that changes the operation's parameters.
#include <algorithm>
#include <utility>

#include "app/panels/number_box.h"
#include "app/tools/action_rows.h"
#include "app/tools/holes/hole_plan.h"
#include "app/tools/holes/scan_holes.h"
#include "app/views/viewport.h"
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

std::string label_up_to(double diameter) { return "Fill holes up to " + number_words(diameter).toStdString(); }

std::string words_for(const recorded::HoleWay& way) {
  const std::string what = way.fairness ? "Method " + *way.fairness
                           : way.kernel ? "Kernel " + *way.kernel
                           : way.bulge  ? "Bulge"
                                        : "Trim rim";
  return what + " of " + words_for(way.holes);
}

void set_values(const recorded::HoleWay& way, HoleRequest& own) {
  if (way.fairness) own.fairness = fairness_named(*way.fairness);  // "auto": as for all
  if (way.kernel) own.kernel = kernel_named(*way.kernel);
  if (way.bulge) own.bulge = *way.bulge;
  if (way.trim_rim) own.trim_rim = static_cast<int>(*way.trim_rim);
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

/// Changes the plan of the operation: one step of the history.
/// @param besides other parameters
void change_plan(ScanHoles& holes, const std::string& label, const std::function<void(HolePlan&)>& change,
                 const ParameterValues& besides = {}) {
  const Node* operation = holes.node();
  if (operation == nullptr) return;
  holes.attempt([&] {
    HolePlan plan(holes.studio(), *operation);
    change(plan);
    ParameterValues values = plan.values();
    values.insert(besides.begin(), besides.end());
    holes.edit(label, values, false);
  });
}

/// What is open after a selection was filled: of inner holes, what is filled already stays.
std::vector<Index> open_after(const ScanHoles& holes, hole_filling::Selection select, std::span<const Index> named) {
  std::vector<Index> open;
  for (const HoleRow& row : holes.rows) {
    const bool stays_filled = select == hole_filling::Selection::Inner && row.state == FillAction::Fill;
    if (!stays_filled && !std::ranges::binary_search(named, row.id)) open.push_back(row.id);
  }
  return open;
}

/// @param limit the operation's own parameter; 0 for no limit
void fill_named(ScanHoles& holes, const std::string& label, hole_filling::Selection select, double limit) {
  const std::vector<Index> named = limit > 0 ? named_rows(holes.rows, select, limit) : named_rows(holes.rows, select);
  const std::vector<Index> open = open_after(holes, select, named);
  std::vector<Index> kept;  // filled before, though the selection doesn't name them
  for (const HoleRow& row : holes.rows) {
    const bool is_left = std::ranges::binary_search(named, row.id) || std::ranges::binary_search(open, row.id);
    if (!is_left) kept.push_back(row.id);
  }
  const auto fill_named = [&](HolePlan& plan) {
    plan.fill_all(select, open);
    plan.fill(kept);
  };
  change_plan(holes, label, fill_named, {{"max-diameter", limit}});
}

void apply(ScanHoles& holes, const recorded::HoleChoice& step) {
  if (step.up_to) {
    fill_named(holes, label_up_to(*step.up_to), hole_filling::Selection::Inner, *step.up_to);
  } else if (step.action == "fill") {
    change_plan(holes, "Fill " + words_for(step.holes), [&](HolePlan& plan) {
      // Where a bridge couldn't be made, each rim gets a patch of its own.
      plan.part_bridges(holes_in_state(holes, step.holes, FillAction::Failed));
      plan.fill(with_islands(holes.rows, step.holes));
    });
  } else if (step.action == "leave") {
    change_plan(holes, "Reopen " + words_for(step.holes),
                [&](HolePlan& plan) { plan.reopen(with_islands(holes.rows, step.holes)); });
  }
  holes.follow_selection();
}

/// The patch of a hole goes through a place. @param drags as a part of a drag
void pull(ScanHoles& holes, HolePlan plan, const recorded::HolePoint& step, bool drags) {
  const std::vector<Index> hole{step.hole};
  plan.change(hole, holes.filled(), [&](HoleRequest& own) { own.through = moved_through(own.through, step); });
  holes.edit("Shape hole " + std::to_string(step.hole), plan.values(), drags);
}

void apply(ScanHoles& holes, const recorded::HolePoint& step) {
  const Node* operation = holes.node();
  if (operation == nullptr) return;
  HolePlan plan = holes.pulled ? *holes.pulled : HolePlan(holes.studio(), *operation);
  holes.pulled.reset();
  pull(holes, std::move(plan), step, false);
}

void finish(ScanHoles& holes, Verdict verdict) {
  if (verdict != Verdict::Commit || !holes.tool.done()) return;
  const recorded::Step done = *holes.tool.done();
  if (const auto* choice = done.as<recorded::HoleChoice>()) apply(holes, *choice);
  if (const auto* point = done.as<recorded::HolePoint>()) apply(holes, *point);
  emit holes.owner.committed(done);
}

void follow_pull(ScanHoles& holes) {
  const auto& pulls = holes.tool.preview().pull;
  const Node* operation = holes.node();
  if (!pulls || operation == nullptr) {
    if (std::exchange(holes.dragging, false)) holes.studio().session().cancel_drag();
    holes.pulled.reset();
    return;
  }
  holes.attempt([&] {
    if (!holes.pulled) holes.pulled = HolePlan(holes.studio(), *operation);
    pull(holes, *holes.pulled, pulls->as_step(), true);
  });
}

/// @param hole none: of holes for which nothing of their own is set
PatchMethod method_of(const ScanHoles& holes, std::optional<Index> hole) {
  PatchMethod method;
  const Node* operation = holes.node();
  if (operation == nullptr) return method;
  method.fairness = text_parameter(holes, "fairness");
  method.kernel = text_parameter(holes, "kernel");
  const auto value = [&](const char* name) { return filling_value(holes.studio(), *operation, name); };
  if (const auto bulge = value("bulge"); std::holds_alternative<double>(bulge)) method.bulge = std::get<double>(bulge);
  if (const auto trim = value("trim-rim"); std::holds_alternative<std::int64_t>(trim)) {
    method.trim_rim = static_cast<int>(std::get<std::int64_t>(trim));
  }
  if (!hole) return method;
  try {
    const HoleRequest own = HolePlan(holes.studio(), *operation).request(*hole);
    if (own.fairness) method.fairness = name_of(*own.fairness);
    if (own.kernel) method.kernel = name_of(*own.kernel);
    method.bulge = own.bulge.value_or(method.bulge);
    method.trim_rim = own.trim_rim.value_or(method.trim_rim);
  } catch (const Error&) {
    return method;  // the operation reports the error
  }
  return method;
}

bool is_made_so(const ScanHoles& holes, const recorded::HoleWay& step) {
  const auto has = [&](std::optional<Index> hole) {
    const PatchMethod now = method_of(holes, hole);
    return step.fairness.value_or(now.fairness) == now.fairness && step.kernel.value_or(now.kernel) == now.kernel &&
           step.bulge.value_or(now.bulge) == now.bulge && step.trim_rim.value_or(now.trim_rim) == now.trim_rim;
  };
  return step.holes.empty() ? has(std::nullopt) : std::ranges::all_of(step.holes, has);
}

void change_method(ScanHoles& holes, const recorded::HoleWay& step, bool drags) {
  const Node* operation = holes.node();
  const bool in_drag = drags || holes.dragging;
  if (operation == nullptr || (!in_drag && is_made_so(holes, step))) return;
  holes.attempt([&] {
    ParameterValues values = values_of(step);
    if (!step.holes.empty()) {
      HolePlan plan(holes.studio(), *operation);
      plan.change(step.holes, holes.filled(), [&](HoleRequest& own) { set_values(step, own); });
      values = plan.values();
    }
    holes.edit(words_for(step), values, drags);
    if (!drags) emit holes.owner.committed(step);
  });
}

/// Another value for all holes, recorded.
void set_parameter(ScanHoles& holes, const std::string& label, const std::string& name, const std::string& value) {
  const Node* operation = holes.node();
  if (operation == nullptr) return;
  const std::string node = operation->name;
  holes.edit(label, {{name, value}}, false);
  emit holes.owner.committed(recorded::Set{node, name, value});
}

/// Applies a step to the selected holes.
void choose_for_selected(ScanHoles& holes, const char* action) {
  if (holes.selected().empty())
    return holes.host.say(QObject::tr("No hole is selected: click one in the list or in a view"));
  apply(holes, recorded::HoleChoice{holes.selected(), action});
}

void fill_selected(ScanHoles& holes) { choose_for_selected(holes, "fill"); }

/// One is open, or belongs to a bridge that couldn't be made.
bool can_fill_selected(const ScanHoles& holes) {
  if (!open_of_selected(holes).empty()) return true;
  const std::vector<Index> failed = holes_in_state(holes, holes.selected(), FillAction::Failed);
  const Node* operation = holes.node();
  if (failed.empty() || operation == nullptr) return false;
  try {
    const HolePlan plan(holes.studio(), *operation);
    return std::ranges::any_of(failed, [&](Index hole) { return plan.is_bridged(hole); });
  } catch (const Error&) {
    return true;  // filling reports the error
  }
}

/// @param select one of the parameter's choices; of "inner", nothing that is filled is opened
void fill_all(ScanHoles& holes, const std::string& select) {
  const std::string what = select == "all-but-largest" ? "Fill all but the largest hole"
                           : select == "inner"         ? "Fill all inner holes"
                           : select == "none"          ? "Reopen all holes"
                                                       : "Fill all holes";
  fill_named(holes, what, parse_selection(select), 0);
}

/// It would change something, or that isn't known yet.
bool can_fill_all(const ScanHoles& holes, const std::string& select) {
  const bool is_known = holes.shown && !holes.shown->failed;
  if (holes.rows.empty()) return !is_known;
  const hole_filling::Selection selection = parse_selection(select);
  const std::vector<Index> open = open_after(holes, selection, named_rows(holes.rows, selection));
  return std::ranges::any_of(holes.rows, [&](const HoleRow& row) {
    return std::ranges::binary_search(open, row.id) != (row.state == FillAction::Leave);
  });
}

void bridge_selected(ScanHoles& holes) {
  const std::vector<Index> chosen = holes.selected();
  if (chosen.size() < 2)
    return holes.host.say(QObject::tr("Select two rims to bridge: click one, then Shift+click the other"));
  const std::string label = chosen.size() == 2
                                ? "Bridge holes " + std::to_string(chosen[0]) + " and " + std::to_string(chosen[1])
                                : "Bridge " + words_for(chosen);
  change_plan(holes, label, [&](HolePlan& plan) { plan.bridge(chosen); });
}

/// Of the selected holes.
void clear_handles(ScanHoles& holes) {
  const std::vector<Index> chosen = holes.selected();
  const std::vector<Index> filled = holes.filled();
  change_plan(holes, "Clear handles of " + words_for(chosen),
              [&](HolePlan& plan) { plan.change(chosen, filled, [](HoleRequest& own) { own.through.clear(); }); });
}

std::vector<ActionRow> hole_actions(ScanHoles& holes) {
  const auto tr = [](const char* text) { return QObject::tr(text); };
  const auto run = [&holes](auto work) { return [&holes, work] { work(holes); }; };
  const auto fill = [&holes](const char* select) { return [&holes, select] { fill_all(holes, select); }; };
  const auto method = [&holes](const char* name) { return [&holes, name] { set_method(holes, {.fairness = name}); }; };
  constexpr Recorded named = Recorded::AsAction;
  // Enter comes from the views and the list alone: lines of text need it themselves.
  return {{},
          {"fill-selected", tr("Fill selected") + "\t" + tr("Enter"), {}, run(fill_selected), {}, named},
          {"reopen-selected", tr("Reopen selected") + "\t" + tr("Del"), {}, run(reopen_selected), {}, named},
          {"bridge-holes", tr("Bridge selected rims"), {QKeySequence("B")}, run(bridge_selected), {}, named},
          {},
          {"fill-inner", tr("Fill all inner"), {QKeySequence("Shift+F")}, fill("inner"), {}, named},
          {"fill-all-but-largest",
           tr("Fill all but the largest"),
           {QKeySequence("Ctrl+Shift+F")},
           fill("all-but-largest"),
           {},
           named},
          {"fill-all", tr("Fill all, borders too"), {}, fill("all"), {}, named},
          {"reopen-all", tr("Reopen all"), {}, fill("none"), {}, named},
          {},
          {"clear-handles", tr("Clear handles of patches"), {}, run(clear_handles), {}, named},
          {"way-auto", tr("Method: automatic"), {}, method("auto")},
          {"way-rbf", tr("Method: continue the surface"), {}, method("rbf")},
          {"way-smooth", tr("Method: continue its slope"), {}, method("smooth")},
          {"way-flat", tr("Method: flat"), {}, method("flat")},
          {}};
}

}  // namespace

// ---- What becomes of holes

void reopen_selected(ScanHoles& holes) { choose_for_selected(holes, "leave"); }

void fill_up_to(ScanHoles& holes, double diameter) {
  fill_named(holes, label_up_to(diameter), hole_filling::Selection::Inner, diameter);
  holes.follow_selection();
  emit holes.owner.committed(recorded::HoleChoice{{}, "fill", {}, diameter});
}

// ---- How patches are made

PatchMethod method_of_selected(const ScanHoles& holes) {
  return method_of(holes, holes.selected().empty() ? std::nullopt : std::optional(holes.selected().front()));
}

void set_method(ScanHoles& holes, recorded::HoleWay change, bool drags) {
  change.holes = holes.selected();
  change_method(holes, change, drags);
}

std::string text_parameter(const ScanHoles& holes, const std::string& name) {
  const Node* operation = holes.node();
  const ParameterValue value =
      operation == nullptr ? ParameterValue(std::string()) : filling_value(holes.studio(), *operation, name);
  const auto* text = std::get_if<std::string>(&value);
  return text == nullptr ? std::string() : *text;
}

void set_preset(ScanHoles& holes, const std::string& preset) {
  if (preset != text_parameter(holes, "preset"))
    set_parameter(holes, "Preset " + preset + " of all holes", "preset", preset);
}

void set_mode(ScanHoles& holes, const std::string& mode) {
  set_parameter(holes, mode == "remesh" ? remesh_label : "Fill by patches", "mode", mode);
}

void cancel_remeshing(ScanHoles& holes) {
  if (text_parameter(holes, "mode") != "remesh") return;
  const std::vector<std::string> steps = holes.studio().session().undo_labels();
  if (steps.empty() || steps.back() != remesh_label) return set_mode(holes, "patch");
  holes.studio().session().undo();
  emit holes.owner.committed(recorded::Action{"undo"});
}

// ---- Gestures and recorded steps

void take_gesture(ScanHoles& holes, const MeshEvent& event) {
  holes.attempt([&] { finish(holes, holes.tool.handle(event)); });
  follow_pull(holes);
}

void replay(ScanHoles& holes, const recorded::Step& step) {
  holes.follow();
  finish(holes, holes.tool.take(step));
}

void replay(ScanHoles& holes, const recorded::HoleWay& step) {
  holes.follow();
  for (const Index hole : step.holes) {
    if (holes.row(hole) == nullptr) {
      throw Error(make_error(Category::Malformed, "E_INPUT", "There is no hole " + std::to_string(hole)));
    }
  }
  change_method(holes, step, false);
}

// ---- Actions

QList<QAction*> add_hole_actions(ScanHoles& holes, ActionList& actions, QMenu* menu) {
  return add_rows(actions, menu, hole_actions(holes));
}

void refresh_hole_actions(const ScanHoles& holes, const QList<QAction*>& actions) {
  ToolHost& host = holes.host;
  const bool works = holes.works();
  const std::vector<Index>& selected = holes.selected();
  for (QAction* action : actions) action->setEnabled(works);
  const bool any_closed = std::ranges::any_of(selected, [&](Index hole) {
    const HoleRow* row = holes.row(hole);
    return row == nullptr || row->state != FillAction::Leave;
  });
  const auto enable = [&](const char* name, bool on) { host.action(name)->setEnabled(works && on); };
  enable("fill-selected", works && can_fill_selected(holes));
  enable("reopen-selected", any_closed);
  for (const auto& [name, select] : {std::pair{"fill-inner", "inner"},
                                     {"fill-all-but-largest", "all-but-largest"},
                                     {"fill-all", "all"},
                                     {"reopen-all", "none"}})
    enable(name, works && can_fill_all(holes, select));
  enable("clear-handles", !holes.tool.handles().empty());
  enable("bridge-holes", selected.size() > 1);
  host.action("holes")->setEnabled(can_fill(holes.studio()));
  if (works) host.action("delete")->setEnabled(!selected.empty());
}

void frame_holes(ScanHoles& holes) {
  holes.host.record(recorded::Action{"frame-selection"});
  frame_selection(holes.host.views());
}

}  // namespace croquis::app
