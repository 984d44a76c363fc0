// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/surface/inflation.h"

#include <algorithm>
#include <cmath>

#include "algorithms/silhouette/surface/swept_limbs.h"

namespace croquis::silhouette {
namespace {

/// In L, and in u (two steps of the grid that a file may round to): how far an attached object's front stays before the
/// other's. Without it the two would meet in whole faces.
constexpr double front_margin = 0.02;

/// u: ten steps of the grid that a file may round to.
constexpr double coincidence = 0.1;

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

MidSurfaceData mid_surface_data(const Skeleton& skeleton, std::vector<LiftedPlace> nodes, const DepthOptions& options) {
  MidSurfaceData data;
  data.nodes = std::move(nodes);
  data.node_z = node_depths(skeleton);
  data.node_length = node_lengths(skeleton);
  data.scale = skeleton.scale;
  data.gap = options.minimum_gap * skeleton.scale;
  return data;
}

/// Per lifted vertex.
Eigen::VectorXd vertex_stiffness(const LiftedTriangulation& lifted, const std::vector<Index>& objects,
                                 const std::vector<RowStiffness>& object_stiffness) {
  Eigen::VectorXd stiffness = Eigen::VectorXd::Ones(static_cast<Eigen::Index>(lifted.planar_vertex.size()));
  for (std::size_t m = 0; m < objects.size(); ++m) {
    if (objects[m] >= object_stiffness.size()) continue;
    for (const Index v : lifted.triangles[m]) stiffness[v] = object_stiffness[objects[m]].all;
  }
  return stiffness;
}

/// What may sink into what, and how hard each object is to move.
void add_attachments(const Skeleton& skeleton, const SheetBasis& basis, const Attachments& attachments,
                     MidSurfaceData& data) {
  data.pairs = stacked_pairs(basis.sampling, basis.objects, attachments);
  data.stiffness = vertex_stiffness(basis.sampling.lifted, basis.objects, row_stiffness(skeleton, attachments));
  // Limbs press on rims: a wide body keeps its shape over its own radius rather than over L.
  data.bending = data.stiffness.cwiseMax(1);
  data.front_margin = front_margin * std::max(skeleton.scale, basis.unit);
}

/// Moves the backs of attached sheets until no point of one lies closer than this below or above another's front or
/// back: where surfaces almost meet in a vertex of the common triangulation, their union is too thin.
/// Fronts stay. A later pass can only meet what an earlier one moved, once per sheet of a stack.
void clear_coincidences(double distance, InflatedSheets& sheets) {
  constexpr int max_passes = 10;
  const auto front = [&](Index v) { return sheets.z[v] + sheets.thickness[v]; };
  const auto back = [&](Index v) { return sheets.z[v] - sheets.thickness[v]; };
  bool moved = true;
  for (int pass = 0; moved && pass < max_passes; ++pass) {
    moved = false;
    for (const StackedPair& pair : sheets.pairs) {
      if (!pair.attached() || sheets.sampling.lifted.on_boundary[pair.upper]) continue;
      for (const double height : {front(pair.lower), back(pair.lower)}) {
        // Half of it again, so that what was cleared counts as clear.
        const double deeper = back(pair.upper) - height + 1.5 * distance;
        if (std::abs(back(pair.upper) - height) >= distance) continue;
        sheets.z[pair.upper] -= deeper / 2;
        sheets.thickness[pair.upper] += deeper / 2;
        moved = true;
      }
    }
  }
}

Eigen::VectorXd values_at(const std::vector<LiftedPlace>& places, const Eigen::VectorXd& values) {
  Eigen::VectorXd result(static_cast<Eigen::Index>(places.size()));
  for (std::size_t n = 0; n < places.size(); ++n) result[static_cast<Eigen::Index>(n)] = value_at(places[n], values);
  return result;
}

}  // namespace

InflatedSheets raise_sheets(const Skeleton& skeleton, const SheetBasis& basis, const DepthSettings& settings,
                            Progress& progress) {
  InflatedSheets sheets;
  sheets.sampling = basis.sampling;
  Progress raising = progress.step("mid-surface", 0.6);
  MidSurfaceData data = mid_surface_data(skeleton, basis.nodes, settings.options);
  data.pairs = stacked_pairs(sheets.sampling);
  if (!settings.attachments.empty()) {
    add_attachments(skeleton, basis, settings.attachments, data);
  }
  sheets.pairs = data.pairs;
  MidSurface mid_surface(basis.op, std::move(data));
  const auto tilted = [&](const SweptLimbs& limbs) -> Eigen::VectorXd {
    return basis.upright.cwiseProduct(basis.extension.extend(limbs.tilt).cwiseMax(1));
  };
  const Eigen::VectorXd depths = node_depths(skeleton);
  const MidSurfaceResult first = mid_surface.solve(tilted(swept_limbs(skeleton, depths)), raising);

  Progress tilting = progress.step("tilt", 0.4);
  const SweptLimbs limbs = swept_limbs(skeleton, values_at(basis.nodes, first.z));
  mid_surface.move_nodes(depths + limbs.lift);
  sheets.thickness = tilted(limbs);
  const MidSurfaceResult second = mid_surface.solve(sheets.thickness, tilting);

  sheets.z = second.z;
  if (!settings.attachments.empty()) clear_coincidences(coincidence * basis.unit, sheets);
  sheets.iterations = std::max(first.iterations, second.iterations);
  sheets.residual = std::max(first.residual, second.residual);
  sheets.uncertainty = std::max(first.uncertainty, second.uncertainty);
  return sheets;
}

InflatedSheets inflate_sheets(const LabelledFigure& figure, const Skeleton& skeleton, const DepthSettings& settings,
                              Progress& progress) {
  Progress preparing = progress.step("sample sheets", 0.5);
  const SheetBasis basis = make_sheet_basis(figure, skeleton, Quality::Final, preparing);
  Progress raising = progress.step("mid-surface", 0.5);
  return raise_sheets(skeleton, basis, settings, raising);
}

}  // namespace croquis::silhouette
