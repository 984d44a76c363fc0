// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tools/silhouette/part_names.h"

#include <QObject>
#include <algorithm>
#include <map>

#include "croquis/operators/part_roles.h"
#include "croquis/tools/silhouette/stroke_setting.h"
#include "croquis/workspace/object_names.h"

namespace croquis::app {
namespace {

QString role_word(PartRole role) {
  switch (role) {
    case PartRole::None: break;
    case PartRole::Body: return QObject::tr("Body");
    case PartRole::Head: return QObject::tr("Head");
    case PartRole::Ear: return QObject::tr("Ear");
    case PartRole::Eye: return QObject::tr("Eye");
    case PartRole::Arm: return QObject::tr("Arm");
    case PartRole::Leg: return QObject::tr("Leg");
    case PartRole::Tail: return QObject::tr("Tail");
  }
  return QObject::tr("Part");
}

/// One by its word, two by their sides, more by numbers from left to right.
QString numbered(const QString& word, std::size_t place, std::size_t count) {
  if (count == 1) return word;
  if (count > 2) return QObject::tr("%1 %2").arg(word).arg(place + 1);
  return place == 0 ? QObject::tr("Left %1").arg(word.toLower()) : QObject::tr("Right %1").arg(word.toLower());
}

}  // namespace

std::vector<QString> part_names(const Drawing& drawing, const InflateResult& inflated) {
  const std::vector<PartPlace> shapes = part_roles(drawing, inflated);
  std::map<PartRole, std::vector<std::size_t>> alike;
  for (std::size_t i = 0; i < shapes.size(); ++i) alike[shapes[i].role].push_back(i);
  std::vector<QString> names(shapes.size());
  for (auto& [role, parts] : alike) {
    std::ranges::sort(parts, {}, [&](std::size_t part) { return shapes[part].middle.x(); });
    for (std::size_t i = 0; i < parts.size(); ++i) {
      names[parts[i]] = role == PartRole::None ? QObject::tr("Part %1").arg(parts[i] + 1)
                                               : numbered(role_word(role), i, parts.size());
    }
  }
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    const InflatedObject& object = inflated.objects[i];
    const bool given =
        std::ranges::any_of(drawing.strokes, [&](const Stroke& stroke) { return stroke.object == object.name; });
    if (given) names[i] = QString::fromStdString(readable_name(object.name));
    for (const std::string& stroke : object.strokes) {
      const std::string title = title_of(drawing, stroke);
      if (!title.empty()) names[i] = QString::fromStdString(title);
    }
  }
  return names;
}

}  // namespace croquis::app
