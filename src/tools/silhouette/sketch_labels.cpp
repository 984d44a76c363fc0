// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/silhouette/sketch_labels.h"

namespace croquis {
namespace {

std::string named(const std::string& id) { return id.starts_with("stroke ") ? id : "stroke " + id; }

}  // namespace

std::string strokes_label(const std::string& verb, const std::vector<std::string>& ids) {
  return verb + ' ' + (ids.size() == 1 ? named(ids.front()) : std::to_string(ids.size()) + " strokes");
}

std::string point_label(const std::string& id) { return "Drag a point of " + named(id); }

std::string setting_label(const recorded::StrokeReading& setting) {
  const std::string stroke = named(setting.stroke);
  if (setting.in_front_of) return "Bring " + stroke + " in front of " + named(*setting.in_front_of);
  if (setting.kind == silhouette::StrokeKind::Visible) return "Find what " + stroke + " is";
  if (setting.kind) return "Make " + stroke + " a " + silhouette::to_string(*setting.kind);
  return "Set thickness of " + stroke;
}

}  // namespace croquis
