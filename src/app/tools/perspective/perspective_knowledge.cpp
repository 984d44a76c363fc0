// SPDX-License-Identifier: GPL-3.0-or-later
// What people tell the perspective tool: known coordinates and lengths at the pen, sets of faces, parameters.
#include "app/panels/number_box.h"
#include "app/tools/perspective/alternative_faces.h"
#include "app/tools/perspective/perspective_drawing_tool.h"
#include "app/views/viewport.h"
#include "croquis/tools/perspective/sheet_units.h"
#include "croquis/tools/recording/general_steps.h"

namespace croquis::app {
namespace {

QString number(double value) { return number_words(value, 6); }

QString with_unit(const QString& title, const std::string& unit) {
  return unit.empty() ? title : title + " (" + QString::fromStdString(unit) + ")";
}

}  // namespace

QPointF PerspectiveDrawingTool::widget_place(const Vec2& sheet) const {
  return host().viewport().sketch_to_widget({sheet.x(), -sheet.y()});
}

void PerspectiveDrawingTool::ask_point(const Vec2& at) {
  const auto& known = sheet_.drawing().known_point;
  const Vec3 point = known ? known->point : Vec3(Vec3::Zero());
  const QString text = number(point.x()) + ' ' + number(point.y()) + ' ' + number(point.z());
  entry_->ask(widget_place(at), with_unit(tr("x y z"), sheet_.drawing().unit), text, [this, at](const QString& typed) {
    const auto read = read_point(typed.toStdString(), sheet_.drawing().unit);
    if (!read) return false;
    return host().attempt([&] { do_and_record(sheet_.tool().set_known_point(KnownPoint{at, *read})); });
  });
  emit state_changed();
}

/// An empty field forgets the length.
void PerspectiveDrawingTool::ask_length(const std::string& stroke) {
  const PerspectiveStroke* drawn = find_stroke(sheet_.drawing(), stroke);
  if (drawn == nullptr) return;
  sheet_.tool().select({stroke});
  QString text;
  for (const KnownLength& known : sheet_.drawing().known_lengths) {
    if (known.stroke == stroke) text = number(known.length);
  }
  const QString title = with_unit(tr("Length of %1").arg(QString::fromStdString(stroke)), sheet_.drawing().unit);
  entry_->ask(widget_place(middle_of_stroke(*drawn)), title, text, [this, stroke](const QString& typed) {
    const auto read = read_length(typed.toStdString(), sheet_.drawing().unit);
    if (!read && !typed.trimmed().isEmpty()) return false;
    return host().attempt([&] { do_and_record(sheet_.tool().set_known_length(stroke, read)); });
  });
  emit state_changed();
}

/// Of the stroke that is selected, else of the one that is clicked next.
void PerspectiveDrawingTool::begin_known_length() {
  const std::vector<std::string> ids = sheet_.tool().selected();
  if (ids.size() == 1) return ask_length(ids.front());
  sheet_.pick(SheetInteraction::Pick::Length);
}

void PerspectiveDrawingTool::add_alternative_to(render::Scene& scene, int view) const {
  const auto& hovered = chips_.alternatives().hovered();
  const PerspectiveResult* result = sheet_.result();
  if (!hovered || result == nullptr || *hovered >= result->alternatives.size()) return;
  const FaceDifference difference = difference_of(*result, result->alternatives[*hovered]);
  const auto on_sheet = [&](const Vec3& point) { return on_sketch_plane(result->camera.project(point)); };
  const Node* node = studio().session().document().find(sheet_.tool().operation_node());
  const WorkObject* object = studio().active();
  const Affine3 stands = object == nullptr ? Affine3() : object->placement.map();
  const Affine3 placement = node == nullptr ? Affine3() : composed(stands, node->transform);
  const auto in_space = [&](const Vec3& point) {
    const Vec3 place = placement(point);
    return glm::dvec3(place.x(), place.y(), place.z());
  };
  const FromSpace place = has_view(view) ? FromSpace(on_sheet) : FromSpace(in_space);
  for (const render::LineItemPtr& item : difference_items(*result, difference, place)) scene.lines.emplace_back(item);
}

void PerspectiveDrawingTool::take_alternative(std::size_t alternative) {
  const PerspectiveResult* result = sheet_.result();
  if (result == nullptr || alternative >= result->alternatives.size()) return;
  const FaceDifference difference = difference_of(*result, result->alternatives[alternative]);
  host().attempt(
      [&] { do_and_record(sheet_.tool().choose_faces(names_of(difference.added), names_of(difference.removed))); });
}

/// Of the operation; one undo step, recorded.
void PerspectiveDrawingTool::set_parameter(const std::string& name, const ParameterValue& value) {
  const NodeId node = sheet_.tool().operation_node();
  if (node == 0) return;
  studio().set_parameter(node, name, value, false);
  const Node* edited = studio().session().document().find(node);
  if (edited != nullptr) host().record(recorded::Set{edited->name, name, value});
}

}  // namespace croquis::app
