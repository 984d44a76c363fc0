// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/surface/inflation.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "algorithms/silhouette/skeleton/rest_depths.h"
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

std::vector<Index> objects_of_vertices(const SheetBasis& basis) {
  std::vector<Index> objects(basis.sampling.lifted.planar_vertex.size(), 0);
  for (std::size_t m = 0; m < basis.objects.size(); ++m) {
    for (const Index v : basis.sampling.lifted.triangles[m]) objects[v] = basis.objects[m];
  }
  return objects;
}

Eigen::VectorXd vertex_stiffness(const Skeleton& skeleton, const std::vector<Index>& objects) {
  const std::vector<double> by_object = row_stiffness(skeleton);
  Eigen::VectorXd stiffness = Eigen::VectorXd::Ones(static_cast<Eigen::Index>(objects.size()));
  for (std::size_t v = 0; v < objects.size(); ++v) {
    if (objects[v] < by_object.size()) stiffness[static_cast<Eigen::Index>(v)] = by_object[objects[v]];
  }
  return stiffness;
}

Eigen::VectorXd thickness_factors(const DepthSettings& settings, const std::vector<Index>& objects) {
  Eigen::VectorXd factors(static_cast<Eigen::Index>(objects.size()));
  for (std::size_t v = 0; v < objects.size(); ++v)
    factors[static_cast<Eigen::Index>(v)] = settings.thickness_of(objects[v]);
  return factors;
}

/// The surface between nodes may be thicker than the balls at them, and reach beyond the last one: how much farther
/// each object rests from the sketch plane for that, at every node.
Eigen::VectorXd node_shifts(const Skeleton& skeleton, const MidSurfaceData& data, const std::vector<Index>& objects,
                            const Eigen::VectorXd& thickness, const DepthSettings& settings, Progress& progress) {
  ObjectBounds bounds;
  for (const StackedPair& pair : data.pairs) {
    const std::pair ends(objects[pair.upper], objects[pair.lower]);
    if (ends.first == ends.second) continue;
    double& bound = bounds[ends];
    bound = std::max(bound, least_distance(data, pair, thickness));
  }
  const std::vector<double> rest = rest_depths(skeleton, bounds, settings, progress);
  Eigen::VectorXd shifts(data.node_z.size());
  for (Eigen::Index n = 0; n < shifts.size(); ++n) {
    const Index object = skeleton.nodes[static_cast<std::size_t>(n)].object;
    shifts[n] = rest[object] - (object < skeleton.rest.size() ? skeleton.rest[object] : 0);
  }
  return shifts;
}

MidSurfaceData mid_surface_data(const Skeleton& skeleton, const SheetBasis& basis, const std::vector<Index>& objects,
                                const DepthSettings& settings) {
  MidSurfaceData data;
  data.nodes = basis.nodes;
  data.node_z = node_depths(skeleton);
  data.node_length = node_lengths(skeleton);
  data.scale = skeleton.scale;
  data.gap = settings.options.minimum_gap * skeleton.scale;
  data.stiffness = vertex_stiffness(skeleton, objects);
  // Thin parts press on rims: a wide one keeps its shape over its own radius rather than over L.
  data.bending = data.stiffness.cwiseMax(1);
  const bool joined = !settings.attachments.empty();
  data.pairs =
      joined ? stacked_pairs(basis.sampling, basis.objects, settings.attachments) : stacked_pairs(basis.sampling);
  for (StackedPair& pair : data.pairs) {
    pair.resting = settings.attachments.resting(objects[pair.upper], objects[pair.lower]);
  }
  data.resting_gap = std::min(data.gap, resting_gap(skeleton.scale, basis.unit));
  if (joined) data.front_margin = front_margin * std::max(skeleton.scale, basis.unit);
  return data;
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
  const std::vector<Index> objects = objects_of_vertices(basis);
  MidSurfaceData data = mid_surface_data(skeleton, basis, objects, settings);
  sheets.pairs = data.pairs;
  const auto tilted = [&](const SweptLimbs& limbs) -> Eigen::VectorXd {
    return thickness_factors(settings, objects)
        .cwiseProduct(basis.upright.cwiseProduct(basis.extension.extend(limbs.tilt).cwiseMax(1)));
  };
  const Eigen::VectorXd unmoved = tilted(swept_limbs(skeleton, data.node_z));
  const Eigen::VectorXd depths = data.node_z + node_shifts(skeleton, data, objects, unmoved, settings, raising);
  data.node_z = depths;
  MidSurface mid_surface(basis.op, std::move(data));
  const MidSurfaceResult first = mid_surface.solve(unmoved, raising);

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
