// SPDX-License-Identifier: GPL-3.0-or-later
// Recorded steps of perspective drawings, and what replays can expect of them.
#include "app/replay/replay_lookup.h"
#include "app/tools/perspective/perspective_drawing_tool.h"
#include "croquis/tools/perspective/perspective_steps.h"

namespace croquis::app {
namespace {

const PerspectiveResult& required_result(const SheetInteraction& sheet) {
  if (sheet.result() == nullptr) refuse_replay("Nothing was found in the drawing yet");
  return *sheet.result();
}

}  // namespace

std::vector<const recorded::StepKind*> PerspectiveDrawingTool::steps() const {
  return recorded::perspective_steps().kinds();
}

bool PerspectiveDrawingTool::replay(const recorded::Step& step) {
  PerspectiveTool& tool = sheet_.tool();
  if (studio().sheet_node() == 0) host().action("new-perspective")->trigger();
  if (const auto* stroke = step.as<recorded::SheetStroke>()) {
    stroke->erases ? tool.erase(stroke->points, stroke->scale)
                   : tool.draw(stroke->points, stroke->scale, stroke->group, stroke->role, stroke->groups);
  } else if (const auto* drag = step.as<recorded::SheetDrag>()) {
    tool.drag(drag->stroke, drag->point, drag->by, drag->alone);
  } else if (const auto* aim = step.as<recorded::SheetAim>()) {
    tool.aim(aim->axis, aim->at);
  } else if (const auto* setting = step.as<recorded::SheetSetting>()) {
    tool.set(setting->strokes, setting->setting);
  } else if (const auto* removal = step.as<recorded::SheetDelete>()) {
    tool.remove(removal->strokes);
  } else if (const auto* point = step.as<recorded::SheetPoint>()) {
    tool.set_known_point(point->known);
  } else if (const auto* length = step.as<recorded::SheetLength>()) {
    tool.set_known_length(length->stroke, length->length);
  } else if (const auto* camera = step.as<recorded::SheetCamera>()) {
    tool.set_camera(camera->field_of_view, camera->principal_point);
  } else if (const auto* sheet = step.as<recorded::SheetSize>()) {
    tool.set_sheet(sheet->size);
  } else if (const auto* unit = step.as<recorded::SheetUnit>()) {
    tool.set_unit(unit->unit);
  } else if (const auto* faces = step.as<recorded::SheetFaces>()) {
    tool.choose_faces(faces->required, faces->forbidden);
  } else if (const auto* choice = step.as<recorded::SheetChoice>()) {
    tool.choose(choice->list, choice->item, choice->on);
  } else if (const auto* mirror = step.as<recorded::SheetMirror>()) {
    tool.complete_mirrored(mirror->plane, mirror->strokes);
  } else {
    return false;
  }
  return true;
}

Expectations PerspectiveDrawingTool::expectations() {
  Expectations own;
  own.counts["perspective-strokes"] = [this](const std::string&) { return sheet_.drawing().strokes.size(); };
  own.counts["perspective-faces"] = [this](const std::string&) { return required_result(sheet_).faces.size(); };
  own.counts["perspective-open"] = [this](const std::string&) { return required_result(sheet_).open_strokes.size(); };
  own.counts["perspective-closed"] = [this](const std::string&) -> std::size_t {
    return required_result(sheet_).closed ? 1 : 0;
  };
  own.counts["perspective-mode"] = [this](const std::string&) {
    return static_cast<std::size_t>(required_result(sheet_).mode);
  };
  own.counts["perspective-fixes"] = [this](const std::string&) { return required_result(sheet_).fixes.size(); };
  own.ranges["perspective-residual"] = [this](const std::string&) {
    std::pair<double, double> range(1e300, 0);
    for (const PerspectiveStrokeResult& stroke : required_result(sheet_).strokes) {
      if (!stroke.residual) continue;
      range.first = std::min(range.first, *stroke.residual);
      range.second = std::max(range.second, *stroke.residual);
    }
    return range;
  };
  return own;
}

}  // namespace croquis::app
