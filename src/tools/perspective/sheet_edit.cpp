// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/perspective/sheet_edit.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "croquis/base/error.h"
#include "croquis/base/limits.h"
#include "croquis/base/text.h"
#include "croquis/tools/perspective/pen_strokes.h"
#include "croquis/tools/perspective/perspective_steps.h"
#include "croquis/tools/perspective/sheet_units.h"
#include "croquis/tools/strokes/stroke_source.h"

namespace croquis {
namespace {

/// "Move stroke s3", "Erase 2 strokes".
std::string named_label(const std::string& verb, const std::vector<std::string>& ids) {
  return verb + ' ' + (ids.size() == 1 ? "stroke " + ids.front() : std::to_string(ids.size()) + " strokes");
}

/// What a change of strokes is called.
std::string verb_of(const StrokeSetting& setting) {
  if (setting.group && *setting.group != StrokeGroup::Unknown) {
    const std::string axis(1, "xyz"[axis_of(*setting.group)]);
    return is_parallel(*setting.group) ? "Lay along " + axis + ":" : "Lay across " + axis + ":";
  }
  if (setting.role) return *setting.role == StrokeRole::Construction ? "Make construction lines:" : "Make edges:";
  for (const StrokeField& field : stroke_fields) {
    const auto given = setting.fields.find(field.name);
    if (given == setting.fields.end()) continue;
    return given->second == decltype(given->second)(false) ? field.verb_off : field.verb;
  }
  return "Change";
}

// ---- Strokes

SheetEdit erased(PerspectiveDrawing drawing, const recorded::SheetStroke& stroke, const SheetContext& context) {
  std::vector<std::string> ids;
  const double radius = context.options.eraser_pixels * stroke.scale;
  for (std::size_t i = 0; i < stroke.points.size(); ++i) {
    const Vec2& from = stroke.points[i == 0 ? 0 : i - 1];
    for (std::string& id : strokes_touched(drawing, from, stroke.points[i], radius)) {
      if (!contains(ids, id)) ids.push_back(std::move(id));
    }
  }
  const bool changed = remove_strokes(drawing, ids);
  return {std::move(drawing), named_label("Erase", ids), changed};
}

SheetEdit edited(PerspectiveDrawing drawing, const recorded::SheetStroke& stroke, const SheetContext& context) {
  if (stroke.erases) return erased(std::move(drawing), stroke, context);
  PenStrokeOptions options;
  options.units_per_pixel = stroke.scale;
  options.snap_pixels = context.options.snap_pixels;
  options.group = stroke.group;
  options.groups = stroke.groups;
  options.plane = context.plane;
  options.role = stroke.role;
  options.solved = context.solved;
  const std::vector<std::string> ids = draw_strokes(drawing, stroke.points, options);
  // What was guessed now depends on what is known by now; a replay may know less, or more.
  recorded::SheetStroke known = stroke;
  known.groups.clear();
  for (const std::string& id : stroke.group ? std::vector<std::string>() : ids)
    known.groups.push_back(find_stroke(drawing, id)->group);
  return {std::move(drawing), named_label("Draw", ids), !ids.empty(), std::move(known)};
}

SheetEdit edited(PerspectiveDrawing drawing, const recorded::SheetDelete& removal, const SheetContext&) {
  const bool changed = remove_strokes(drawing, removal.strokes);
  return {std::move(drawing), named_label("Delete", removal.strokes), changed};
}

SheetEdit edited(PerspectiveDrawing drawing, const recorded::SheetDrag& drag, const SheetContext& context) {
  if (drag.point) {
    drag_point(drawing, drag.stroke, *drag.point, drag.by, drag.alone);
    return {std::move(drawing), "Drag a point of stroke " + drag.stroke};
  }
  const std::vector<std::string> alone = {drag.stroke};
  const std::vector<std::string>& ids = contains(context.selected, drag.stroke) ? context.selected : alone;
  move_strokes(drawing, ids, drag.by);
  return {std::move(drawing), named_label("Move", ids)};
}

SheetEdit edited(PerspectiveDrawing drawing, const recorded::SheetAim& aim, const SheetContext&) {
  const bool changed = aim_lines(drawing, aim.axis, aim.at);
  return {std::move(drawing), "Drag a vanishing point", changed};
}

SheetEdit edited(PerspectiveDrawing drawing, const recorded::SheetSetting& set, const SheetContext&) {
  set_strokes(drawing, set.strokes, set.setting);
  return {std::move(drawing), named_label(verb_of(set.setting), set.strokes),
          !set.strokes.empty() && set.setting.any()};
}

SheetEdit edited(PerspectiveDrawing drawing, const recorded::SheetMirror& mirror, const SheetContext& context) {
  recorded::SheetMirror known = mirror;
  if (known.strokes.empty()) {
    if (context.solved == nullptr) refuse_input("The drawing has no places in space yet; correct its lines first.");
    known.strokes = mirrored_strokes(drawing, *context.solved, mirror.plane);
  }
  const std::vector<std::string> ids = add_mirrored(drawing, known.strokes);
  return {std::move(drawing), named_label("Mirror", ids), !ids.empty(), std::move(known)};
}

// ---- What is known

SheetEdit edited(PerspectiveDrawing drawing, const recorded::SheetPoint& set, const SheetContext&) {
  if (set.known && !(are_usable_numbers(set.known->at) && are_usable_numbers(set.known->point)))
    refuse_input("The known point needs finite coordinates; type other ones.");
  drawing.known_point = set.known;
  return {std::move(drawing), set.known ? "Set the known point" : "Forget the known point"};
}

SheetEdit edited(PerspectiveDrawing drawing, const recorded::SheetLength& set, const SheetContext&) {
  set_length(drawing, set.stroke, set.length);
  return {std::move(drawing), (set.length ? "Set the length of stroke " : "Forget the length of stroke ") + set.stroke};
}

/// Known lengths keep their size.
SheetEdit edited(PerspectiveDrawing drawing, const recorded::SheetUnit& set, const SheetContext&) {
  if (!set.unit.empty() && metres_of_unit(set.unit) == 0)
    refuse_input("The unit \"" + set.unit + "\" isn't known; choose mm, cm, m or in.");
  const bool changed = drawing.unit != set.unit;
  const double before = metres_of_unit(drawing.unit), after = metres_of_unit(set.unit);
  const double scale = before > 0 && after > 0 ? before / after : 1;
  for (KnownLength& known : drawing.known_lengths) known.length *= scale;
  if (drawing.known_point) drawing.known_point->point *= scale;
  drawing.unit = set.unit;
  return {std::move(drawing), "Set the unit", changed};
}

SheetEdit edited(PerspectiveDrawing drawing, const recorded::SheetCamera& set, const SheetContext&) {
  if (set.field_of_view && !(*set.field_of_view > 0 && *set.field_of_view < std::numbers::pi))
    refuse_input("The field of view lies between 0 and 180 degrees; type another one.");
  drawing.field_of_view = set.field_of_view;
  drawing.principal_point = set.principal_point;
  return {std::move(drawing), "Set the camera"};
}

/// Strokes keep their places.
SheetEdit edited(PerspectiveDrawing drawing, const recorded::SheetSize& set, const SheetContext&) {
  if (!(are_usable_numbers(set.size) && set.size.minCoeff() > 0))
    refuse_input("The sheet needs a width and a height above 0; type other ones.");
  const bool changed = drawing.image_size != set.size;
  drawing.image_size = set.size;
  return {std::move(drawing), "Set the sheet's size", changed};
}

/// By the function for the step's struct.
template <class... Steps>
std::optional<SheetEdit> edited_by_one_of(const PerspectiveDrawing& drawing, const recorded::Step& step,
                                          const SheetContext& context) {
  std::optional<SheetEdit> edit;
  const auto attempt = [&](const auto* own) {
    if (own != nullptr) edit = edited(drawing, *own, context);
  };
  (attempt(step.as<Steps>()), ...);
  return edit;
}

// ---- Lists of the operation

/// Puts items on a list, and takes others off.
void change_list(Node& operation, const std::string& list, const std::vector<std::string>& add,
                 const std::vector<std::string>& take) {
  std::vector<std::string> items = items_in(&operation, list);
  std::erase_if(items, [&](const std::string& item) { return contains(take, item); });
  for (const std::string& item : add) {
    if (!contains(items, item)) items.push_back(item);
  }
  std::string text;
  for (const std::string& item : items) text += (text.empty() ? "" : ";") + item;
  operation.parameters.erase(list);
  if (!items.empty()) operation.parameters[list] = text;
}

}  // namespace

std::optional<SheetEdit> edited_by(const PerspectiveDrawing& drawing, const recorded::Step& step,
                                   const SheetContext& context) {
  using namespace recorded;
  return edited_by_one_of<SheetStroke, SheetDelete, SheetDrag, SheetAim, SheetSetting, SheetMirror, SheetPoint,
                          SheetLength, SheetUnit, SheetCamera, SheetSize>(drawing, step, context);
}

std::optional<OperationEdit> edited_by(const Node& operation, const recorded::Step& step) {
  OperationEdit edit{operation, {}};
  if (const auto* choice = step.as<recorded::SheetChoice>()) {
    edit.label = choice->list == "sharp"    ? "Keep an edge sharp"
                 : choice->list == "ignore" ? "Leave a stroke out"
                                            : "Choose a face";
    if (!choice->on) edit.label += " no longer";
    edit.changed = contains(items_in(&operation, choice->list), choice->item) != choice->on;
    const std::vector<std::string> items = {choice->item};
    change_list(edit.operation, choice->list, choice->on ? items : std::vector<std::string>(), items);
  } else if (const auto* faces = step.as<recorded::SheetFaces>()) {
    edit.label = "Choose faces";
    change_list(edit.operation, "faces", faces->required, faces->forbidden);
    change_list(edit.operation, "no-faces", faces->forbidden, faces->required);
    edit.changed = edit.operation.parameters != operation.parameters;
  } else {
    return std::nullopt;
  }
  return edit;
}

std::vector<std::string> items_in(const Node* operation, const std::string& list) {
  if (operation == nullptr) return {};
  const auto found = operation->parameters.find(list);
  if (found == operation->parameters.end()) return {};
  const std::string* text = std::get_if<std::string>(&found->second);
  if (text == nullptr) return {};
  const std::vector<std::string_view> items = text_parts(*text, ";");
  return {items.begin(), items.end()};
}

void refuse_input(const std::string& sentence) { throw Error(make_error(Category::Usage, "E_INPUT", sentence)); }

}  // namespace croquis
