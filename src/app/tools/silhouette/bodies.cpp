// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tools/silhouette/bodies.h"

#include <QObject>
#include <algorithm>
#include <map>

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

/// Objects of a sketch that were joined are one body: of one colour, without lines where they meet.
std::shared_ptr<const PolyMesh> with_shells_as_objects(const std::shared_ptr<const PolyMesh>& mesh,
                                                       const std::vector<InflatedShell>& shells) {
  std::map<std::string, std::int32_t> shell_of;
  std::int32_t count = 0;
  for (const InflatedShell& shell : shells) {
    for (const std::string& name : shell.objects) shell_of[name] = count;
    ++count;
  }
  const AttributeChannel* objects = mesh->channel("object", Domain::Face);
  if (objects == nullptr || shell_of.size() == shells.size()) return mesh;
  auto painted = std::make_shared<PolyMesh>(*mesh);
  auto& labels = std::get<std::vector<std::int32_t>>(painted->channel("object", Domain::Face)->data);
  for (std::int32_t& label : labels) label = shell_of[objects->labels.at(static_cast<std::size_t>(label))];
  return painted;
}

}  // namespace

std::vector<Body> bodies_of(const Drawing& drawing, const Evaluation* solid) {
  const InflateResult* inflated = result_of<InflateResult>(solid);
  std::vector<Body> bodies;
  if (inflated == nullptr) return bodies;
  for (const InflatedObject& object : inflated->objects) {
    Body body;
    body.strokes = object.strokes;
    const std::string given = given_name(drawing, object.name);
    body.name =
        given.empty() ? QObject::tr("Body %1").arg(bodies.size() + 1) : QString::fromStdString(readable_name(given));
    bodies.push_back(std::move(body));
  }
  return bodies;
}

QString word_of(silhouette::StrokeKind kind) {
  switch (kind) {
    case silhouette::StrokeKind::Visible: break;
    case silhouette::StrokeKind::Hidden: return QObject::tr("Hidden line");
    case silhouette::StrokeKind::Contour: return QObject::tr("Outline");
    case silhouette::StrokeKind::Part: return QObject::tr("Part in front");
    case silhouette::StrokeKind::Hole: return QObject::tr("Hole");
    case silhouette::StrokeKind::Blob: return QObject::tr("Small shape");
    case silhouette::StrokeKind::Detail: return QObject::tr("Detail");
    case silhouette::StrokeKind::Scribble: return QObject::tr("Fur, hatching");
    case silhouette::StrokeKind::Tube: return QObject::tr("Tube");
    case silhouette::StrokeKind::Ignored: return QObject::tr("Left out");
  }
  return {};
}

const Body* body_with(const std::vector<Body>& bodies, const std::vector<std::string>& strokes) {
  const auto body = std::ranges::find_if(bodies, [&](const Body& b) { return is_about(b, strokes); });
  return body == bodies.end() ? nullptr : &*body;
}

LiveItem::Paint paint_of_bodies(const WorkObject& object) {
  const InflateResult* inflated = result_of<InflateResult>(object.result.get());
  if (inflated == nullptr) return nullptr;
  return [result = object.result, inflated](const std::shared_ptr<const PolyMesh>& mesh) {
    return with_shells_as_objects(mesh, inflated->shells);
  };
}

}  // namespace croquis::app
