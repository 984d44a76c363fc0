// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/object_names.h"

#include <QObject>
#include <algorithm>
#include <set>

#include "app/panels/finding_elements.h"
#include "croquis/operators/inflate_result.h"

namespace croquis::app {
namespace {

/// The name that the drawing gives to what these strokes make, or empty: then it is called by its first stroke.
std::string given_name(const Drawing& drawing, const std::string& name) {
  const bool given = std::ranges::any_of(drawing.strokes, [&](const Stroke& stroke) { return stroke.object == name; });
  return given ? name : std::string();
}

bool is_about(const Body& body, const std::vector<std::string>& strokes) {
  return std::ranges::any_of(strokes,
                             [&](const std::string& stroke) { return std::ranges::count(body.strokes, stroke) > 0; });
}

/// Bodies and meshes; a drawing without a solid counts as one.
std::size_t count_named_objects(const Studio& studio, const std::vector<Body>& bodies) {
  const std::size_t drawn = studio.drawing().strokes.empty() ? 0 : std::max<std::size_t>(bodies.size(), 1);
  const auto meshes = std::ranges::count_if(
      studio.objects(), [&](const StudioObject& object) { return object.node != studio.solid_node(); });
  return drawn + static_cast<std::size_t>(meshes);
}

}  // namespace

std::vector<Body> bodies_of(const Studio& studio) {
  const auto result = studio.result();
  const InflateResult* inflated = result_of<InflateResult>(result.get());
  std::vector<Body> bodies;
  if (inflated == nullptr) return bodies;
  for (const InflatedObject& object : inflated->objects) {
    Body body;
    body.strokes = object.strokes;
    const std::string given = given_name(studio.drawing(), object.name);
    body.name =
        given.empty() ? QObject::tr("Body %1").arg(bodies.size() + 1) : QString::fromStdString(readable_name(given));
    bodies.push_back(std::move(body));
  }
  return bodies;
}

QString shown_name(const StudioObject& object) { return QString::fromStdString(readable_name(object.name)); }

QString owner_of(const Studio& studio, const NodeFinding& found) {
  const StudioObject* object = studio.object(found.node);
  if (object == nullptr) return {};
  const std::vector<Body> bodies = bodies_of(studio);
  if (count_named_objects(studio, bodies) < 2) return {};
  if (found.node != studio.solid_node()) return shown_name(*object);
  const std::vector<std::string> strokes = strokes_of(found.finding);
  const auto body = std::ranges::find_if(bodies, [&](const Body& b) { return is_about(b, strokes); });
  return body == bodies.end() ? QObject::tr("Sketch") : body->name;
}

std::string document_name(const Studio& studio) {
  const StudioObject* object = studio.active();
  if (object == nullptr || object->node == studio.solid_node()) return QObject::tr("Sketch").toStdString();
  return object->name;
}

}  // namespace croquis::app
