// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/edits/starting_line.h"

#include <cmath>
#include <utility>

#include "croquis/base/error.h"
#include "croquis/edits/apply_edits.h"
#include "croquis/geometry/bounds.h"

namespace croquis {
namespace {

constexpr int most_halvings = 10;

/// The diagonal of the box around the elements; of all vertices where that has no size.
double size_of(const PolyMesh& mesh, const MeshTopology& topology, const EditTarget& target) {
  const auto diagonal = [](const PolyMesh& part) {
    const BoundingBox box = bounds_of(part);
    return box ? ((*box)[1] - (*box)[0]).norm() : 0;
  };
  if (target.all) return diagonal(mesh);
  PolyMesh part;
  for (const Index vertex : converted(topology, target.kind, ComponentKind::Vertex, sorted_unique(target.elements))) {
    part.positions.push_back(mesh.positions[vertex]);
  }
  const double own = diagonal(part);
  return own > 0 ? own : diagonal(mesh);
}

/// Two digits, as people would type it.
double rounded(double value) {
  if (!(value > 0)) return 0;
  const double step = std::pow(10.0, std::floor(std::log10(value)) - 1);
  return std::round(value / step) * step;
}

bool is_refused(const PolyMesh& mesh, const MeshTopology& topology, const EditLine& line) {
  try {
    apply_edit(mesh, topology, line, all_edits());
  } catch (const Error&) {
    return true;
  }
  return false;
}

}  // namespace

EditLine starting_line(const PolyMesh& mesh, const MeshTopology& topology, const Edit& edit, EditTarget target) {
  const EditDescription description = edit.describe();
  EditLine line{description.id, std::move(target), {}};
  if (!description.start) return line;
  double value = rounded(description.start->share * size_of(mesh, topology, line.target));
  line.parameters[description.start->parameter] = value;
  for (int k = 0; k < most_halvings && is_refused(mesh, topology, line); ++k) {
    value = rounded(value / 2);
    line.parameters[description.start->parameter] = value;
  }
  return line;
}

}  // namespace croquis
