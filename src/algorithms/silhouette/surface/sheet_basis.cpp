// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/surface/sheet_basis.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "algorithms/silhouette/sampling/rim_distance.h"
#include "algorithms/silhouette/sampling/rim_radius.h"
#include "algorithms/silhouette/stage.h"
#include "croquis/base/error.h"
#include "croquis/geometry/disjoint_sets.h"

namespace croquis::silhouette {
namespace {

/// A vertex' rows in the operator, the factorisation and the vectors: seven neighbours, five times that of fill.
constexpr std::size_t bytes_per_vertex = 1000;

/// Nearer to the rim, in parts of the first row's depth, the chord would be too thin for rounded numbers.
constexpr double least_part_of_row = 0.05;

/// Lays places between the rim and its first row of points onto the chord between the two.
///
/// Contours of other sheets bring points of any depth there. On the round section they would stand out beside the rim's
/// other triangles, which span from the rim to the row.
/// @param thickness per lifted vertex, upright: without tilt
void flatten_to_rim_chords(const SheetSampling& sheets, Eigen::VectorXd& thickness) {
  const RimDistances rim = rim_distances(sheets, greatest_first_row());
  for (Index v = 0; v < rim.nearest.size(); ++v) {
    if (rim.nearest[v] == no_index || rim.distance[v] <= 0) continue;
    // Near the rim the section rises like the root of the depth, the chord in proportion to it.
    const double row = rim.edges[rim.nearest[v]].first_row;
    thickness[v] *= std::sqrt(std::clamp(rim.distance[v] / row, least_part_of_row, 1.0));
  }
}

}  // namespace

SheetBasis make_sheet_basis(const LabelledFigure& figure, const Skeleton& skeleton, Quality quality,
                            std::span<const Index> thin, Progress& progress) {
  Progress sampling = progress.step("sample sheets", 0.6);
  SheetSampling sheets = sample_sheets(figure, skeleton, sampling, quality, thin);
  std::vector<LiftedPlace> nodes = locate_nodes(figure, skeleton, sheets);

  Progress thickening = progress.step("thickness", 0.4);
  SheetOperator op = make_sheet_operator(sheets);
  NodeExtension extension(op, nodes, skeleton);
  Eigen::VectorXd upright = sheet_thickness(sheets, op, skeleton, nodes, extension, thickening);
  flatten_to_rim_chords(sheets, upright);
  std::vector<Index> objects = objects_of_triangles(figure, sheets);
  std::vector<Index> vertex_objects(op.position.size(), 0);
  for (std::size_t m = 0; m < objects.size(); ++m) {
    for (const Index v : sheets.lifted.triangles[m]) vertex_objects[v] = objects[m];
  }
  return {std::move(sheets),  std::move(nodes),          std::move(op), std::move(extension), std::move(upright),
          std::move(objects), std::move(vertex_objects), figure.unit};
}

std::vector<Index> objects_of_triangles(const LabelledFigure& figure, const SheetSampling& sheets) {
  const LiftedTriangulation& lifted = sheets.lifted;
  DisjointSets components(lifted.triangles.size());
  for (Index m = 0; m < lifted.triangles.size(); ++m) {
    for (const Index next : lifted.neighbours[m]) {
      if (next != no_index) components.unite(m, next);
    }
  }
  const std::vector<Index> component = components.take_roots();
  std::vector<Index> objects(lifted.triangles.size(), no_index);
  for (Index m = 0; m < objects.size(); ++m) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      if (lifted.neighbours[m][corner] != no_index) continue;
      const Index piece = sheets.planar.constraints[lifted.planar_triangle[m]][corner];
      const Index owner = figure.contours[sheets.pieces[piece].contour].object;
      Index& object = objects[component[m]];
      if (object != no_index && object != owner) {
        throw Error(make_error(Category::Internal, "E_INTERNAL", "Contours of two objects bound one surface"));
      }
      object = owner;
    }
  }
  for (Index m = 0; m < objects.size(); ++m) objects[m] = objects[component[m]];  // roots are the lowest
  return objects;
}

double factored_thickness(const SheetBasis& basis, Eigen::Index vertex, double factor) {
  const double upright = basis.upright[vertex];
  return std::max(factor * upright, std::min(upright, least_half_thickness * basis.unit));
}

std::size_t bytes_of(const SheetBasis& basis) {
  return bytes_of(basis.sampling) + bytes_per_vertex * basis.op.position.size() +
         basis.nodes.size() * sizeof(LiftedPlace);
}

}  // namespace croquis::silhouette
