// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/replay/expectations.h"

#include "app/replay/replay_lookup.h"
#include "app/window/main_window.h"
#include "croquis/geometry/mesh_topology.h"

namespace croquis::app {
namespace {

/// Objects that are shown; one that is made of several counts as these.
std::size_t count_objects(MainWindow& window) {
  std::size_t count = 0;
  for (const WorkObject& object : window.studio().objects()) {
    std::size_t parts = object.visible;
    for (const auto& tool : window.tools()) parts = tool->parts_of(object).value_or(parts);
    count += parts;
  }
  return count;
}

}  // namespace

void Expectations::add(Expectations other) {
  for (auto& [name, count] : other.counts) counts[name] = std::move(count);
  for (auto& [name, range] : other.ranges) ranges[name] = std::move(range);
}

Expectations expectations_of(MainWindow& window) {
  Expectations all;
  auto& counts = all.counts;
  Studio& studio = window.studio();
  counts["objects"] = [&window](const std::string&) { return count_objects(window); };
  counts["findings"] = [&studio](const std::string&) { return studio.findings().size(); };
  counts["selected"] = [&studio](const std::string&) { return studio.session().components().elements.size(); };
  const auto of_mesh = [&studio](auto count) {
    return [&studio, count](const std::string& node) { return count(*object_named(studio, node).shown()); };
  };
  counts["vertices"] = of_mesh([](const PolyMesh& mesh) { return mesh.vertex_count(); });
  counts["faces"] = of_mesh([](const PolyMesh& mesh) { return mesh.face_count(); });
  counts["edges"] = of_mesh([](const PolyMesh& mesh) { return MeshTopology(mesh).edge_count(); });
  counts["sharp-edges"] = of_mesh([](const PolyMesh& mesh) { return mesh.tags.creases.size(); });
  for (const auto& tool : window.tools()) all.add(tool->expectations());
  return all;
}

}  // namespace croquis::app
