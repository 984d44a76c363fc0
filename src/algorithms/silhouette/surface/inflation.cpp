// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/surface/inflation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "algorithms/silhouette/sampling/rims.h"
#include "algorithms/silhouette/skeleton/rest_depths.h"
#include "algorithms/silhouette/stage.h"
#include "croquis/base/error.h"
#include "croquis/geometry/disjoint_sets.h"

namespace croquis::silhouette {
namespace {

/// In L, and in u (two steps of the grid that a file may round to): how far an attached object's front stays before the
/// other's. Without it the two would meet in whole faces.
constexpr double front_margin = 0.02;

/// Of a gap, and added to it: room for triangles of their own for every sheet, see SheetMesh.
constexpr double spare_gap = 0.1;

/// In L, and in parts of a thickness: less makes no difference that could be seen, or that a file keeps.
constexpr double negligible = 1e-9;

/// u: ten steps of the grid that a file may round to.
constexpr double coincidence = 0.1;

constexpr double max_tilt = 2;     // a limb that points at the viewer would otherwise become a spike
constexpr int balls_per_edge = 4;  // nodes are a third of a radius apart

/// What the balls over one place reach.
struct Heights {
  double top;
  double bottom;
  double level;  ///< top of the same balls, all at height 0
};

/// Adds the balls along an edge. @return whether the last one still covers the place
bool add_edge(const SkeletonNode& a, const SkeletonNode& b, const std::array<double, 2>& z, const Vec2& place,
              Heights& heights) {
  bool covered = false;
  for (int i = 1; i <= balls_per_edge; ++i) {
    const double part = static_cast<double>(i) / balls_per_edge;
    const double radius = (1 - part) * a.radius + part * b.radius;
    const double square = radius * radius - ((1 - part) * a.position + part * b.position - place).squaredNorm();
    covered = square > 0;
    if (!covered) continue;
    const double height = std::sqrt(square);
    const double middle = (1 - part) * z[0] + part * z[1];
    heights.top = std::max(heights.top, middle + height);
    heights.bottom = std::min(heights.bottom, middle - height);
    heights.level = std::max(heights.level, height);
  }
  return covered;
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

/// The surface between nodes may be thicker than the balls at them, and reach beyond the last one: how much farther
/// each object rests from the sketch plane for that, at every node.
Eigen::VectorXd node_shifts(const Skeleton& skeleton, const MidSurfaceData& data, const std::vector<Index>& objects,
                            const Eigen::VectorXd& thickness, const DepthSettings& settings, Progress& progress) {
  ObjectBounds bounds;
  for (const StackedPair& pair : data.pairs) {
    const std::pair ends(objects[pair.upper], objects[pair.lower]);
    if (ends.first == ends.second) continue;
    const double reach = pair.attached() ? attached_distance(1, thickness[pair.upper], thickness[pair.lower]) : 0;
    bounds[ends].widen({least_distance(data, pair, thickness), reach});
  }
  const std::vector<double> rest = rest_depths(skeleton, bounds, settings, progress);
  Eigen::VectorXd shifts(data.node_z.size());
  for (Eigen::Index n = 0; n < shifts.size(); ++n) {
    const Index object = skeleton.nodes[static_cast<std::size_t>(n)].object;
    shifts[n] = rest[object] - (object < skeleton.rest.size() ? skeleton.rest[object] : 0);
  }
  return shifts;
}

MidSurfaceData mid_surface_data(const Skeleton& skeleton, const SheetBasis& basis, const DepthSettings& settings) {
  const std::vector<Index>& objects = basis.vertex_objects;
  MidSurfaceData data;
  data.nodes = basis.nodes;
  data.node_z.resize(static_cast<Eigen::Index>(skeleton.nodes.size()));
  for (Index n = 0; n < skeleton.nodes.size(); ++n) data.node_z[n] = skeleton.nodes[n].z;
  data.node_length = node_lengths(skeleton);
  data.scale = skeleton.scale;
  data.gap = (1 + spare_gap) * settings.options.minimum_gap * skeleton.scale;
  data.stiffness = Eigen::VectorXd::Ones(static_cast<Eigen::Index>(objects.size()));
  const std::vector<double> by_object = settings.equally_stiff ? std::vector<double>{} : row_stiffness(skeleton);
  for (std::size_t v = 0; v < objects.size(); ++v) {
    if (objects[v] < by_object.size()) data.stiffness[static_cast<Eigen::Index>(v)] = by_object[objects[v]];
  }
  // Thin parts press on rims: a wide one keeps its shape over its own radius rather than over L.
  data.bending = data.stiffness.cwiseMax(1);
  data.pairs = stacked_pairs(basis.sampling, basis.objects, settings.attachments);
  for (StackedPair& pair : data.pairs) {
    pair.resting = settings.attachments.resting(objects[pair.upper], objects[pair.lower]);
  }
  data.resting_gap = (1 + spare_gap) * std::min(data.gap, resting_gap(skeleton.scale, basis.unit));
  if (settings.attachments.any(Hold::Joined)) data.front_margin = front_margin * std::max(skeleton.scale, basis.unit);
  return data;
}

/// Moves the backs of attached sheets until no point of one lies closer than this below or above another's front or
/// back: where surfaces almost meet in a vertex of the common triangulation, their union is too thin.
/// Fronts stay. A later pass can only meet what an earlier one moved, once per sheet of a stack.
void clear_coincidences(double distance, InflatedSheets& sheets) {
  constexpr int max_passes = 10;
  bool moved = true;
  for (int pass = 0; moved && pass < max_passes; ++pass) {
    moved = false;
    for (const StackedPair& pair : sheets.pairs) {
      if (!pair.attached() || sheets.sampling.lifted.on_boundary[pair.upper]) continue;
      for (const double height : {sheets.front(pair.lower), sheets.back(pair.lower)}) {
        // Half of it again, so that what was cleared counts as clear.
        const double deeper = sheets.back(pair.upper) - height + 1.5 * distance;
        if (std::abs(sheets.back(pair.upper) - height) >= distance) continue;
        sheets.z[pair.upper] -= deeper / 2;
        sheets.thickness[pair.upper] += deeper / 2;
        moved = true;
      }
    }
  }
}

/// What rests sinks into what lies below, which makes room for it: a hollow whose ground follows the upper one's back,
/// with room for triangles of their own for both.
void make_hollows(double gap, InflatedSheets& sheets) {
  constexpr double room = 0.03;  // of the upper one's half thickness
  for (const StackedPair& pair : sheets.pairs) {
    if (!pair.resting || sheets.sampling.lifted.on_boundary[pair.lower]) continue;
    double& z = sheets.z[pair.lower];
    double& thickness = sheets.thickness[pair.lower];
    const double back = sheets.back(pair.upper);
    const double deepest = std::min(back - gap, z + (1 - 2 * deepest_hollow) * thickness);
    const double ground = std::max(back - 2 * gap - room * sheets.thickness[pair.upper], deepest);
    const double sunk = std::max(z + thickness - ground, 0.0);
    z -= sunk / 2;
    thickness -= sunk / 2;
  }
}

bool is_negligible(const Eigen::VectorXd& changes) {
  return changes.size() == 0 || changes.lpNorm<Eigen::Infinity>() <= negligible;
}

/// Thickness per lifted vertex with the nodes' tilt.
Eigen::VectorXd tilted_thickness(const SheetBasis& basis, const DepthSettings& settings, const Eigen::VectorXd& tilt) {
  Eigen::VectorXd thickness = Eigen::VectorXd::Ones(basis.upright.size());
  if (!is_negligible(tilt.array() - 1)) thickness = basis.extension.extend(tilt).cwiseMax(1);
  for (Eigen::Index v = 0; v < thickness.size(); ++v) {
    const double factor = settings.thickness_of(basis.vertex_objects[static_cast<std::size_t>(v)]);
    thickness[v] = factored_thickness(basis, v, factor * thickness[v]);
  }
  return thickness;
}

/// The middle of sheets that are as thick as they are now.
void solve_middle(const SheetBasis& basis, MidSurface& middle, InflatedSheets& sheets, Progress& progress) {
  const MidSurfaceResult result = middle.solve(sheets.thickness, progress);
  sheets.z = result.z;
  sheets.iterations = std::max(sheets.iterations, result.iterations);
  sheets.residual = std::max(sheets.residual, result.residual);
  for (std::size_t v = 0; v < basis.vertex_objects.size(); ++v) {
    const Index object = basis.vertex_objects[v];
    if (object >= sheets.uncertainty.size()) sheets.uncertainty.resize(object + 1, 0);
    double& most = sheets.uncertainty[object];
    most = std::max(most, result.uncertainty[static_cast<Eigen::Index>(v)]);
  }
}

}  // namespace

SweptLimbs swept_limbs(const Skeleton& skeleton, const Eigen::VectorXd& node_z) {
  const std::vector<std::vector<Index>> neighbours = skeleton.neighbours();
  std::vector<Index> last_seen(skeleton.nodes.size(), no_index);  // per node, the node whose walk met it last
  std::vector<Index> queue;
  SweptLimbs limbs{Eigen::VectorXd(node_z.size()), Eigen::VectorXd(node_z.size())};
  for (Index n = 0; n < skeleton.nodes.size(); ++n) {
    const SkeletonNode& centre = skeleton.nodes[n];
    Heights heights{node_z[n] + centre.radius, node_z[n] - centre.radius, centre.radius};
    queue.assign(1, n);
    last_seen[n] = n;
    // Only balls that the skeleton leads to count: others above the same place belong to other sheets.
    for (std::size_t head = 0; head < queue.size(); ++head) {
      const Index from = queue[head];
      for (const Index to : neighbours[from]) {
        const bool covered =
            add_edge(skeleton.nodes[from], skeleton.nodes[to], {node_z[from], node_z[to]}, centre.position, heights);
        if (!covered || last_seen[to] == n) continue;
        last_seen[to] = n;
        queue.push_back(to);
      }
    }
    limbs.tilt[n] = std::clamp((heights.top - heights.bottom) / (2 * heights.level), 1.0, max_tilt);
    limbs.lift[n] = (heights.top + heights.bottom) / 2 - node_z[n];
  }
  return limbs;
}

InflatedSheets raise_sheets(const Skeleton& skeleton, const SheetBasis& basis, const DepthSettings& settings,
                            Progress& progress) {
  MidSurfaceData data = mid_surface_data(skeleton, basis, settings);
  InflatedSheets sheets;
  sheets.sampling = basis.sampling;
  sheets.pairs = data.pairs;
  sheets.gap = data.gap / (1 + spare_gap);
  sheets.resting_gap = data.resting_gap / (1 + spare_gap);

  // As thick as the skeleton's own depths give.
  Progress raising = progress.step("mid-surface", 0.6);
  const Eigen::VectorXd tilt = swept_limbs(skeleton, data.node_z).tilt;
  sheets.thickness = tilted_thickness(basis, settings, tilt);
  data.node_z += node_shifts(skeleton, data, basis.vertex_objects, sheets.thickness, settings, raising);
  MidSurface middle(basis.op, data);
  solve_middle(basis, middle, sheets, raising);

  // As thick as the depths that came of it give. Where these are the same there is nothing to solve again.
  Progress tilting = progress.step("tilt", 0.4);
  Eigen::VectorXd heights(data.node_z.size());
  for (Index n = 0; n < basis.nodes.size(); ++n) heights[n] = value_at(basis.nodes[n], sheets.z);
  const SweptLimbs limbs = swept_limbs(skeleton, heights);
  if (!is_negligible(limbs.lift / skeleton.scale) || !is_negligible(limbs.tilt - tilt)) {
    data.node_z += limbs.lift;
    middle.move_nodes(data.node_z);
    sheets.thickness = tilted_thickness(basis, settings, limbs.tilt);
    solve_middle(basis, middle, sheets, tilting);
  }

  const Draping draping = drape_sheets(skeleton, basis, settings, data, sheets, tilting);
  if (!draping.objects.empty()) {
    std::vector<Index> nodes;
    for (Index n = 0; n < skeleton.nodes.size(); ++n) {
      if (std::ranges::binary_search(draping.objects, skeleton.nodes[n].object)) nodes.push_back(n);
    }
    for (const Index n : nodes) data.node_z[n] = 0;
    middle.move_nodes(data.node_z);
    middle.set_shape(draping.z);
    solve_middle(basis, middle, sheets, tilting);
    for (const Index n : nodes) sheets.lowered_nodes.emplace_back(n, value_at(basis.nodes[n], sheets.z));
  }
  if (settings.attachments.any(Hold::Joined)) clear_coincidences(coincidence * basis.unit, sheets);
  make_hollows(data.resting_gap, sheets);
  return sheets;
}

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
