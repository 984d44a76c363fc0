// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/surface/sheet_basis.h"

#include <algorithm>
#include <utility>

#include "algorithms/silhouette/stage.h"
#include "algorithms/silhouette/surface/rim_chord.h"
#include "algorithms/silhouette/surface/sheet_surface.h"

namespace croquis::silhouette {
namespace {

/// A vertex' rows in the operator, the factorisation and the vectors: seven neighbours, five times that of fill.
constexpr std::size_t bytes_per_vertex = 1000;

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
  return {std::move(sheets),  std::move(nodes),   std::move(op), std::move(extension),
          std::move(upright), std::move(objects), figure.unit};
}

std::vector<Index> objects_of_vertices(const SheetBasis& basis) {
  std::vector<Index> objects(basis.sampling.lifted.planar_vertex.size(), 0);
  for (std::size_t m = 0; m < basis.objects.size(); ++m) {
    for (const Index v : basis.sampling.lifted.triangles[m]) objects[v] = basis.objects[m];
  }
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
