// SPDX-License-Identifier: GPL-3.0-or-later
// What lists show of sketches: the bodies of their solids, and strokes that belong to none.
#include <algorithm>
#include <map>
#include <set>

#include "app/panels/finding_elements.h"
#include "app/tools/silhouette/bodies.h"
#include "app/tools/silhouette/silhouette_tool.h"
#include "croquis/operators/inflate_result.h"

namespace croquis::app {
namespace {

/// The bodies of the solid that the object's second node is.
std::vector<Body> bodies_in(const Studio& studio, const WorkObject& object, const Drawing& drawing) {
  if (object.chain.size() < 2) return {};
  const auto result = studio.result(object.chain[1]);
  return bodies_of(drawing, result.get());
}

QString joined(const std::vector<std::string>& texts) {
  QStringList list;
  for (const std::string& text : texts) list << QString::fromStdString(text);
  return list.join(", ");
}

ObjectRow row_of(const Body& body) {
  const auto count = body.strokes.size();
  const QString info =
      count == 1 ? SilhouetteTool::tr("1 stroke") : SilhouetteTool::tr("%1 strokes").arg(qulonglong(count));
  return {body.name, info, joined(body.strokes), body.strokes, true, true, {}};
}

}  // namespace

std::vector<ObjectRow> SilhouetteTool::rows(const WorkObject& object, NodeId node) const {
  const auto drawing =
      node == object.chain.front() ? source_of<Drawing>(studio().session().document().find(node)) : nullptr;
  std::vector<ObjectRow> rows;
  if (!drawing) return rows;
  const auto result = object.chain.size() < 2 ? nullptr : studio().result(object.chain[1]);
  const InflateResult* inflated = result_of<InflateResult>(result.get());
  std::map<std::string, silhouette::StrokeKind> kinds;
  if (inflated != nullptr) kinds.insert(inflated->kinds.begin(), inflated->kinds.end());
  std::set<std::string> used;
  for (const Body& body : bodies_in(studio(), object, *drawing)) {
    rows.push_back(row_of(body));
    used.insert(body.strokes.begin(), body.strokes.end());
  }
  for (const Stroke& stroke : drawing->strokes) {
    const QString name = QString::fromStdString(stroke.id);
    if (used.contains(stroke.id)) continue;
    const auto kind = kinds.find(stroke.id);
    const bool on_surface = kind != kinds.end() && kind->second != silhouette::StrokeKind::Ignored;
    rows.push_back(
        {name, kind == kinds.end() ? QString() : word_of(kind->second), name, {stroke.id}, on_surface, true, {}});
  }
  return rows;
}

bool SilhouetteTool::choose_parts(NodeId node, const std::vector<std::string>& parts) {
  if (!source_of<Drawing>(studio().session().document().find(node))) return false;
  Selection selection;
  for (const std::string& stroke : parts) selection.push_back({node, stroke});
  studio().session().select(std::move(selection));
  return true;
}

QString SilhouetteTool::owner_of(const NodeFinding& found) const {
  const WorkObject* object = studio().object(found.node);
  const auto drawing =
      object == nullptr ? nullptr : source_of<Drawing>(studio().session().document().find(object->chain.front()));
  if (!drawing) return {};
  const std::vector<Body> bodies = bodies_in(studio(), *object, *drawing);
  if (bodies.size() < 2 && studio().objects().size() < 2) return {};
  const Body* body = body_with(bodies, strokes_of(found.finding));
  return body == nullptr ? QString() : body->name;
}

}  // namespace croquis::app
