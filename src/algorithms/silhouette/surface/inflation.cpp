// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/surface/inflation.h"

#include <algorithm>
#include <cmath>

#include "algorithms/silhouette/surface/rim_chord.h"
#include "algorithms/silhouette/surface/sheet_operator.h"
#include "algorithms/silhouette/surface/swept_limbs.h"
#include "algorithms/silhouette/surface/thickness.h"

namespace croquis::silhouette {
namespace {

Eigen::VectorXd node_radii(const Skeleton& skeleton) {
  Eigen::VectorXd radii(static_cast<Eigen::Index>(skeleton.nodes.size()));
  for (Eigen::Index n = 0; n < radii.size(); ++n) radii[n] = skeleton.nodes[static_cast<std::size_t>(n)].radius;
  return radii;
}

Eigen::VectorXd node_depths(const Skeleton& skeleton) {
  Eigen::VectorXd depths(static_cast<Eigen::Index>(skeleton.nodes.size()));
  for (Eigen::Index n = 0; n < depths.size(); ++n) depths[n] = skeleton.nodes[static_cast<std::size_t>(n)].z;
  return depths;
}

/// Half of the edges at each node; a lone node stands for its radius.
Eigen::VectorXd node_lengths(const Skeleton& skeleton) {
  Eigen::VectorXd lengths = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(skeleton.nodes.size()));
  for (const auto& [a, b] : skeleton.edges) {
    const double half = (skeleton.nodes[b].position - skeleton.nodes[a].position).norm() / 2;
    lengths[a] += half;
    lengths[b] += half;
  }
  for (Eigen::Index n = 0; n < lengths.size(); ++n) {
    if (lengths[n] <= 0) lengths[n] = skeleton.nodes[static_cast<std::size_t>(n)].radius;
  }
  return lengths;
}

MidSurfaceData mid_surface_data(const Skeleton& skeleton, std::vector<LiftedPlace> nodes,
                                const std::vector<StackedPair>& pairs, const DepthOptions& options) {
  MidSurfaceData data;
  data.nodes = std::move(nodes);
  data.node_z = node_depths(skeleton);
  data.node_length = node_lengths(skeleton);
  data.pairs = pairs;
  data.scale = skeleton.scale;
  data.gap = options.minimum_gap * skeleton.scale;
  return data;
}

Eigen::VectorXd values_at(const std::vector<LiftedPlace>& places, const Eigen::VectorXd& values) {
  Eigen::VectorXd result(static_cast<Eigen::Index>(places.size()));
  for (std::size_t n = 0; n < places.size(); ++n) result[static_cast<Eigen::Index>(n)] = value_at(places[n], values);
  return result;
}

}  // namespace

InflatedSheets inflate_sheets(const LabelledFigure& figure, const Skeleton& skeleton, const DepthOptions& options,
                              Progress& progress) {
  InflatedSheets sheets;
  Progress sampling = progress.step("sample sheets", 0.3);
  sheets.sampling = sample_sheets(figure, skeleton, sampling);
  sheets.pairs = stacked_pairs(sheets.sampling);
  const std::vector<LiftedPlace> nodes = locate_nodes(figure, skeleton, sheets.sampling);

  Progress thickening = progress.step("thickness", 0.2);
  const SheetOperator op = make_sheet_operator(sheets.sampling);
  const Eigen::VectorXd radii = node_radii(skeleton);
  const NodeExtension extension(op, nodes, radii);
  Eigen::VectorXd upright = sheet_thickness(sheets.sampling, op, skeleton, nodes, extension, thickening);
  flatten_to_rim_chords(sheets.sampling, upright);

  Progress raising = progress.step("mid-surface", 0.25);
  MidSurface mid_surface(op, mid_surface_data(skeleton, nodes, sheets.pairs, options));
  const auto tilted = [&](const SweptLimbs& limbs) -> Eigen::VectorXd {
    return upright.cwiseProduct(extension.extend(limbs.tilt).cwiseMax(1));
  };
  const Eigen::VectorXd depths = node_depths(skeleton);
  const MidSurfaceResult first = mid_surface.solve(tilted(swept_limbs(skeleton, depths)), raising);

  Progress tilting = progress.step("tilt", 0.25);
  const SweptLimbs limbs = swept_limbs(skeleton, values_at(nodes, first.z));
  mid_surface.move_nodes(depths + limbs.lift);
  sheets.thickness = tilted(limbs);
  const MidSurfaceResult second = mid_surface.solve(sheets.thickness, tilting);

  sheets.z = second.z;
  sheets.iterations = std::max(first.iterations, second.iterations);
  sheets.residual = std::max(first.residual, second.residual);
  return sheets;
}

}  // namespace croquis::silhouette
