// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/replay/expectations.h"

#include <algorithm>
#include <set>

#include "app/replay/replay_lookup.h"
#include "app/views/viewport.h"
#include "app/window/main_window.h"
#include "croquis/geometry/mesh_topology.h"

namespace croquis::app {
namespace {

/// Parts of the sketch's solid, and meshes that are shown.
std::size_t count_objects(const Studio& studio) {
  std::size_t count = 0;
  const auto result = studio.result();
  if (result && !result->failed) {
    const Report* details = report_of(result.get(), "details");
    if (details != nullptr) count += details->at("objects").as_array().size();
  }
  for (const StudioObject& object : studio.objects()) count += object.visible && object.node != studio.solid_node();
  return count;
}

std::size_t count_selected(MainWindow& window) {
  const HoleInteraction& holes = window.viewport().holes();
  return holes.active() ? holes.selected().size() : window.studio().session().components().elements.size();
}

/// Those that are open or failed.
std::size_t count_open_holes(const StudioObject& object) {
  const auto rows = hole_rows(&object);
  return static_cast<std::size_t>(
      std::count_if(rows.begin(), rows.end(), [](const HoleRow& row) { return row.state != HoleState::Filled; }));
}

std::size_t count_patches(const StudioObject& object) {
  std::set<Index> numbers;
  for (const HoleRow& row : hole_rows(&object)) {
    if (row.patch && row.state == HoleState::Filled) numbers.insert(*row.patch);
  }
  return numbers.size();
}

/// Of the chains of sharp edges, in degrees.
std::pair<double, double> dihedral_range(const StudioObject& object) {
  const Report* details = report_of(object.result.get(), "details");
  const Report* chains = details == nullptr ? nullptr : details->find("chains");
  if (chains == nullptr || chains->as_array().empty()) refuse_replay("There are no chains of sharp edges");
  double least = 360;
  double greatest = 0;
  for (const Report& chain : chains->as_array()) {
    least = std::min(least, chain.at("dihedral_min").as_number());
    greatest = std::max(greatest, chain.at("dihedral_max").as_number());
  }
  return {least, greatest};
}

/// A number of an object.
template <typename Count>
auto of_object(Count count) {
  return [count](MainWindow& window, const std::string& node) { return count(object_named(window.studio(), node)); };
}

Expectations make_expectations() {
  Expectations made;
  auto& counts = made.counts;
  counts["objects"] = [](MainWindow& window, const std::string&) { return count_objects(window.studio()); };
  counts["findings"] = [](MainWindow& window, const std::string&) { return window.studio().findings().size(); };
  counts["strokes"] = [](MainWindow& window, const std::string&) { return window.studio().drawing().strokes.size(); };
  counts["selected"] = [](MainWindow& window, const std::string&) { return count_selected(window); };
  counts["vertices"] = of_object([](const StudioObject& object) { return object.shown()->vertex_count(); });
  counts["faces"] = of_object([](const StudioObject& object) { return object.shown()->face_count(); });
  counts["edges"] = of_object([](const StudioObject& object) { return MeshTopology(*object.shown()).edge_count(); });
  counts["sharp-edges"] = of_object([](const StudioObject& object) { return object.shown()->tags.creases.size(); });
  counts["holes"] = of_object(count_open_holes);
  counts["patches"] = of_object(count_patches);
  made.ranges["dihedral"] = of_object(dihedral_range);
  return made;
}

}  // namespace

const Expectations& expectations() {
  static const Expectations made = make_expectations();
  return made;
}

}  // namespace croquis::app
