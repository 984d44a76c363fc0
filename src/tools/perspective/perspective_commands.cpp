// SPDX-License-Identifier: GPL-3.0-or-later
// The commands of the perspective tool: what its gestures, panels and recordings do to the document.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "croquis/base/error.h"
#include "croquis/base/limits.h"
#include "croquis/base/text.h"
#include "croquis/tools/perspective/pen_strokes.h"
#include "croquis/tools/perspective/perspective_steps.h"
#include "croquis/tools/perspective/perspective_tool.h"
#include "croquis/tools/perspective/sheet_units.h"
#include "croquis/tools/strokes/stroke_source.h"
#include "tools/perspective/perspective_labels.h"

namespace croquis {
namespace {

[[noreturn]] void refuse_input(const std::string& sentence) {
  throw Error(make_error(Category::Usage, "E_INPUT", sentence));
}

/// Items that ';' separates.
std::vector<std::string> items_of(const std::string& list) {
  const std::vector<std::string_view> items = text_parts(list, ";");
  return {items.begin(), items.end()};
}

std::string joined(const std::vector<std::string>& items) {
  std::string list;
  for (const std::string& item : items) list += (list.empty() ? "" : ";") + item;
  return list;
}

std::vector<std::string> items_in(const Node* operation, const std::string& list) {
  if (operation == nullptr) return {};
  const auto found = operation->parameters.find(list);
  if (found == operation->parameters.end()) return {};
  const std::string* text = std::get_if<std::string>(&found->second);
  return text == nullptr ? std::vector<std::string>() : items_of(*text);
}

/// What a change of strokes is called.
std::string verb_of(const StrokeSetting& setting) {
  if (setting.group && *setting.group != StrokeGroup::Unknown) {
    const std::string axis(1, "xyz"[axis_of(*setting.group)]);
    return is_parallel(*setting.group) ? "Lay along " + axis + ":" : "Lay across " + axis + ":";
  }
  if (setting.role) return *setting.role == StrokeRole::Construction ? "Make construction lines:" : "Make edges:";
  if (setting.hidden) return *setting.hidden ? "Hide" : "Show";
  if (setting.link) return *setting.link ? "Link pieces by" : "Unlink";
  if (setting.start_lock || setting.end_lock) return "Lock the ends of";
  return "Change";
}

}  // namespace

Affine3 upright_placement() {
  Affine3 placement;
  placement.linear << 1, 0, 0, 0, 0, 1, 0, -1, 0;
  return placement;
}

Document add_perspective_drawing(const Document& document, PerspectiveDrawing drawing,
                                 const PerspectiveToolOptions& options) {
  Node operation;
  operation.transform = upright_placement();
  return with_stroke_source(document, std::make_shared<const PerspectiveDrawing>(std::move(drawing)), options,
                            std::move(operation));
}

PerspectiveDrawing empty_sheet(const Vec2& size) {
  PerspectiveDrawing drawing;
  drawing.image_size = size;
  return drawing;
}

// ---- The document

NodeId PerspectiveTool::node() const { return source_node<PerspectiveDrawing>(session_.document(), node_); }

std::shared_ptr<const PerspectiveDrawing> PerspectiveTool::drawing() const {
  return source_of<PerspectiveDrawing>(session_.document().find(node()));
}

NodeId PerspectiveTool::operation_node() const { return operation_on(session_.document(), node(), options_.port); }

PerspectiveDrawing PerspectiveTool::drawing_or_empty() const {
  const auto now = drawing();
  return now ? *now : empty_sheet(options_.sheet);
}

PerspectiveDrawing PerspectiveTool::required() const {
  const auto now = drawing();
  if (!now) refuse_input("There is no drawing in perspective; begin one first.");
  return *now;
}

Document PerspectiveTool::with_drawing(PerspectiveDrawing drawing) const {
  const Document document =
      node() == 0 ? add_perspective_drawing(session_.document(), drawing_or_empty(), options_) : session_.document();
  NodeId own = node();
  for (const auto& one : document.nodes()) {
    if (own == 0 && source_of<PerspectiveDrawing>(one.get()) != nullptr) own = one->id;
  }
  Node edited = *document.find(own);
  edited.source = std::make_shared<const PerspectiveDrawing>(std::move(drawing));
  return document.with(std::move(edited));
}

Verdict PerspectiveTool::commit(const std::string& label, PerspectiveDrawing drawing, recorded::Step step) {
  done_ = std::move(step);
  session_.edit(label, with_drawing(std::move(drawing)));
  return Verdict::Commit;
}

// ---- Strokes

Verdict PerspectiveTool::draw(const std::vector<Vec2>& places, double units_per_pixel, std::optional<StrokeGroup> group,
                              StrokeRole role, const std::vector<StrokeGroup>& groups) {
  give_up();
  PerspectiveDrawing edited = drawing_or_empty();
  PenStrokeOptions options;
  options.units_per_pixel = units_per_pixel;
  options.snap_pixels = options_.snap_pixels;
  options.group = group;
  options.groups = groups;
  options.plane = last_plane_;
  options.role = role;
  options.solved = solved_.get();
  const std::vector<std::string> ids = draw_strokes(edited, places, options);
  if (ids.empty()) return Verdict::Revert;
  recorded::SheetStroke step{places, group, role, false, units_per_pixel, {}};
  // What was guessed now depends on what is known by now; a replay may know less, or more.
  for (const std::string& id : group ? std::vector<std::string>() : ids)
    step.groups.push_back(find_stroke(edited, id)->group);
  return commit(named_label("Draw", ids), std::move(edited), std::move(step));
}

Verdict PerspectiveTool::erase(const std::vector<Vec2>& path, double units_per_pixel) {
  give_up();
  const auto now = drawing();
  if (!now || path.empty()) return Verdict::Revert;
  std::vector<std::string> ids;
  for (std::size_t i = 0; i < path.size(); ++i) {
    const Vec2& from = path[i == 0 ? 0 : i - 1];
    for (std::string& id : strokes_touched(*now, from, path[i], options_.eraser_pixels * units_per_pixel)) {
      if (std::ranges::find(ids, id) == ids.end()) ids.push_back(std::move(id));
    }
  }
  PerspectiveDrawing edited = *now;
  if (!remove_strokes(edited, ids)) return Verdict::Revert;
  return commit(named_label("Erase", ids), std::move(edited),
                recorded::SheetStroke{path, {}, StrokeRole::Edge, true, units_per_pixel, {}});
}

Verdict PerspectiveTool::remove(const std::vector<std::string>& ids) {
  give_up();
  PerspectiveDrawing edited = required();
  if (!remove_strokes(edited, ids)) return Verdict::Continue;
  return commit(named_label("Delete", ids), std::move(edited), recorded::SheetDelete{ids});
}

Verdict PerspectiveTool::delete_selected() {
  const std::vector<std::string> ids = selected();
  return ids.empty() ? Verdict::Continue : remove(ids);
}

Verdict PerspectiveTool::drag(const std::string& stroke, std::optional<std::size_t> point, const Vec2& by, bool alone) {
  give_up();
  PerspectiveDrawing edited = required();
  std::vector<std::string> ids = selected();
  if (std::ranges::find(ids, stroke) == ids.end()) ids = {stroke};
  if (point) {
    drag_point(edited, stroke, *point, by, alone);
  } else {
    move_strokes(edited, ids, by);
  }
  return commit(point ? "Drag a point of " + stroke_name(stroke) : named_label("Move", ids), std::move(edited),
                recorded::SheetDrag{stroke, point, by, alone});
}

Verdict PerspectiveTool::aim(int axis, const Vec2& at) {
  give_up();
  PerspectiveDrawing edited = required();
  if (!aim_lines(edited, axis, at)) return Verdict::Continue;
  return commit("Drag a vanishing point", std::move(edited), recorded::SheetAim{axis, at});
}

Verdict PerspectiveTool::set(const std::vector<std::string>& ids, const StrokeSetting& setting) {
  give_up();
  if (ids.empty() || !setting.any()) return Verdict::Continue;
  PerspectiveDrawing edited = required();
  set_strokes(edited, ids, setting);
  return commit(named_label(verb_of(setting), ids), std::move(edited), recorded::SheetSetting{ids, setting});
}

// ---- What is known

Verdict PerspectiveTool::set_known_point(const std::optional<KnownPoint>& known) {
  give_up();
  PerspectiveDrawing edited = required();
  if (known && !(are_usable_numbers(known->at) && are_usable_numbers(known->point)))
    refuse_input("The known point needs finite coordinates; type other ones.");
  edited.known_point = known;
  return commit(known ? "Set the known point" : "Forget the known point", std::move(edited),
                recorded::SheetPoint{known});
}

Verdict PerspectiveTool::set_known_length(const std::string& stroke, std::optional<double> length) {
  give_up();
  PerspectiveDrawing edited = required();
  set_length(edited, stroke, length);
  return commit((length ? "Set the length of " : "Forget the length of ") + stroke_name(stroke), std::move(edited),
                recorded::SheetLength{stroke, length});
}

Verdict PerspectiveTool::set_unit(const std::string& unit) {
  give_up();
  PerspectiveDrawing edited = required();
  if (!unit.empty() && metres_of_unit(unit) == 0)
    refuse_input("The unit \"" + unit + "\" isn't known; choose mm, cm, m or in.");
  if (edited.unit == unit) return Verdict::Continue;
  const double before = metres_of_unit(edited.unit), after = metres_of_unit(unit);
  const double scale = before > 0 && after > 0 ? before / after : 1;
  for (KnownLength& known : edited.known_lengths) known.length *= scale;
  if (edited.known_point) edited.known_point->point *= scale;
  edited.unit = unit;
  return commit("Set the unit", std::move(edited), recorded::SheetUnit{unit});
}

Verdict PerspectiveTool::set_camera(std::optional<double> field_of_view, const std::optional<Vec2>& principal_point) {
  give_up();
  if (field_of_view && !(*field_of_view > 0 && *field_of_view < std::numbers::pi))
    refuse_input("The field of view lies between 0 and 180 degrees; type another one.");
  PerspectiveDrawing edited = required();
  edited.field_of_view = field_of_view;
  edited.principal_point = principal_point;
  return commit("Set the camera", std::move(edited), recorded::SheetCamera{field_of_view, principal_point});
}

Verdict PerspectiveTool::set_sheet(const Vec2& size) {
  give_up();
  if (!(are_usable_numbers(size) && size.minCoeff() > 0))
    refuse_input("The sheet needs a width and a height above 0; type other ones.");
  PerspectiveDrawing edited = required();
  if (edited.image_size == size) return Verdict::Continue;
  edited.image_size = size;
  return commit("Set the sheet's size", std::move(edited), recorded::SheetSize{size});
}

// ---- Lists of the operation

bool PerspectiveTool::is_chosen(const std::string& list, const std::string& item) const {
  const std::vector<std::string> items = items_in(session_.document().find(operation_node()), list);
  return std::ranges::find(items, item) != items.end();
}

Verdict PerspectiveTool::choose(const std::string& list, const std::string& item, bool on) {
  give_up();
  const Node* operation = session_.document().find(operation_node());
  if (operation == nullptr) refuse_input("Nothing is made of the drawing; add the step that makes a solid of it.");
  if (is_chosen(list, item) == on) return Verdict::Continue;
  std::vector<std::string> items = items_in(operation, list);
  std::erase(items, item);
  if (on) items.push_back(item);
  Node edited = *operation;
  edited.parameters.erase(list);
  if (!items.empty()) edited.parameters[list] = joined(items);
  done_ = recorded::SheetChoice{list, item, on};
  const std::string step = list == "sharp"    ? "Keep an edge sharp"
                           : list == "ignore" ? "Leave a stroke out"
                                              : "Choose a face";
  session_.edit(on ? step : step + " no longer", session_.document().with(std::move(edited)));
  return Verdict::Commit;
}

Verdict PerspectiveTool::choose_faces(const std::vector<std::string>& required,
                                      const std::vector<std::string>& forbidden) {
  give_up();
  const Node* operation = session_.document().find(operation_node());
  if (operation == nullptr) refuse_input("Nothing is made of the drawing; add the step that makes a solid of it.");
  Node edited = *operation;
  const auto change = [&](const std::string& list, const std::vector<std::string>& add,
                          const std::vector<std::string>& take) {
    std::vector<std::string> items = items_in(operation, list);
    std::erase_if(items, [&](const std::string& item) { return std::ranges::find(take, item) != take.end(); });
    for (const std::string& item : add) {
      if (std::ranges::find(items, item) == items.end()) items.push_back(item);
    }
    edited.parameters.erase(list);
    if (!items.empty()) edited.parameters[list] = joined(items);
  };
  change("faces", required, forbidden);
  change("no-faces", forbidden, required);
  if (edited.parameters == operation->parameters) return Verdict::Continue;
  done_ = recorded::SheetFaces{required, forbidden};
  session_.edit("Choose faces", session_.document().with(std::move(edited)));
  return Verdict::Commit;
}

Verdict PerspectiveTool::complete_mirrored(const MirrorPlane& plane, std::vector<PerspectiveStroke> strokes) {
  give_up();
  PerspectiveDrawing edited = required();
  if (strokes.empty()) {
    if (!solved_) refuse_input("The drawing has no places in space yet; correct its lines first.");
    strokes = mirrored_strokes(edited, *solved_, plane);
  }
  const std::vector<std::string> ids = add_mirrored(edited, strokes);
  if (ids.empty()) return Verdict::Continue;
  return commit(named_label("Mirror", ids), std::move(edited), recorded::SheetMirror{plane, std::move(strokes)});
}

}  // namespace croquis
