// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/surface/inflation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "algorithms/silhouette/sampling/rim_radius.h"
#include "algorithms/silhouette/skeleton/rest_depths.h"
#include "algorithms/silhouette/surface/draping.h"

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

MidSurfaceData mid_surface_data(const Skeleton& skeleton, const SheetBasis& basis, const std::vector<Index>& objects,
                                const DepthSettings& settings) {
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
  if (!settings.attachments.empty()) data.front_margin = front_margin * std::max(skeleton.scale, basis.unit);
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

Eigen::VectorXd values_at(const std::vector<LiftedPlace>& places, const Eigen::VectorXd& values) {
  Eigen::VectorXd result(static_cast<Eigen::Index>(places.size()));
  for (std::size_t n = 0; n < places.size(); ++n) result[static_cast<Eigen::Index>(n)] = value_at(places[n], values);
  return result;
}

bool is_negligible(const Eigen::VectorXd& changes) {
  return changes.size() == 0 || changes.lpNorm<Eigen::Infinity>() <= negligible;
}

/// Raises the sheets of one figure: flat parts first, then with the thickness of their tilt, then what rests laid down.
class SheetRaiser {
 public:
  SheetRaiser(const Skeleton& skeleton, const SheetBasis& basis, const DepthSettings& settings)
      : skeleton_(skeleton),
        basis_(basis),
        settings_(settings),
        objects_(basis.vertex_objects),
        data_(mid_surface_data(skeleton, basis, objects_, settings)) {
    sheets_.sampling = basis.sampling;
    sheets_.pairs = data_.pairs;
    sheets_.gap = data_.gap / (1 + spare_gap);
    sheets_.resting_gap = data_.resting_gap / (1 + spare_gap);
  }

  /// Sheets as thick as the skeleton's own depths tell.
  void raise(Progress& progress) {
    tilt_ = swept_limbs(skeleton_, data_.node_z).tilt;
    sheets_.thickness = tilted(tilt_);
    data_.node_z += node_shifts(skeleton_, data_, objects_, sheets_.thickness, settings_, progress);
    mid_surface_.emplace(basis_.op, data_);
    solve(progress);
  }

  /// As thick as the depths tell that came of it. Where these are the same there is nothing to solve again.
  void tilt(Progress& progress) {
    const SweptLimbs limbs = swept_limbs(skeleton_, values_at(basis_.nodes, sheets_.z));
    if (is_negligible(limbs.lift / skeleton_.scale) && is_negligible(limbs.tilt - tilt_)) return;
    data_.node_z += limbs.lift;
    mid_surface_->move_nodes(data_.node_z);
    sheets_.thickness = tilted(limbs.tilt);
    solve(progress);
  }

  /// Lays down what rests on others.
  void drape(Progress& progress) {
    if (settings_.attachments.resting_pairs().empty()) return;
    const Draping draping = drape_sheets(skeleton_, basis_, settings_, data_, sheets_, progress);
    if (draping.objects.empty()) return;
    std::vector<Index> nodes;
    for (Index n = 0; n < skeleton_.nodes.size(); ++n) {
      if (std::binary_search(draping.objects.begin(), draping.objects.end(), skeleton_.nodes[n].object))
        nodes.push_back(n);
    }
    for (const Index n : nodes) data_.node_z[n] = 0;
    mid_surface_->move_nodes(data_.node_z);
    mid_surface_->set_shape(draping.z);
    solve(progress);
    for (const Index n : nodes) sheets_.lowered_nodes.emplace_back(n, value_at(basis_.nodes[n], sheets_.z));
  }

  InflatedSheets take() {
    if (!settings_.attachments.empty()) clear_coincidences(coincidence * basis_.unit, sheets_);
    make_hollows(data_.resting_gap, sheets_);
    return std::move(sheets_);
  }

 private:
  /// Thickness per lifted vertex with the nodes' tilt.
  Eigen::VectorXd tilted(const Eigen::VectorXd& tilt) const {
    Eigen::VectorXd thickness = Eigen::VectorXd::Ones(basis_.upright.size());
    if (!is_negligible(tilt.array() - 1)) thickness = basis_.extension.extend(tilt).cwiseMax(1);
    for (Eigen::Index v = 0; v < thickness.size(); ++v) {
      const double factor = settings_.thickness_of(objects_[static_cast<std::size_t>(v)]);
      thickness[v] = factored_thickness(basis_, v, factor * thickness[v]);
    }
    return thickness;
  }

  void solve(Progress& progress) {
    const MidSurfaceResult result = mid_surface_->solve(sheets_.thickness, progress);
    sheets_.z = result.z;
    sheets_.iterations = std::max(sheets_.iterations, result.iterations);
    sheets_.residual = std::max(sheets_.residual, result.residual);
    for (std::size_t v = 0; v < objects_.size(); ++v) {
      if (objects_[v] >= sheets_.uncertainty.size()) sheets_.uncertainty.resize(objects_[v] + 1, 0);
      double& most = sheets_.uncertainty[objects_[v]];
      most = std::max(most, result.uncertainty[static_cast<Eigen::Index>(v)]);
    }
  }

  const Skeleton& skeleton_;
  const SheetBasis& basis_;
  const DepthSettings& settings_;
  const std::vector<Index>& objects_;  ///< per lifted vertex
  MidSurfaceData data_;
  Eigen::VectorXd tilt_;  ///< per node, that the sheets were raised with
  std::optional<MidSurface> mid_surface_;
  InflatedSheets sheets_;
};

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
  Progress raising = progress.step("mid-surface", 0.6);
  SheetRaiser raiser(skeleton, basis, settings);
  raiser.raise(raising);
  Progress tilting = progress.step("tilt", 0.4);
  raiser.tilt(tilting);
  raiser.drape(tilting);
  return raiser.take();
}

InflatedSheets inflate_sheets(const LabelledFigure& figure, const Skeleton& skeleton, const DepthSettings& settings,
                              Progress& progress) {
  Progress preparing = progress.step("sample sheets", 0.5);
  const SheetBasis basis =
      make_sheet_basis(figure, skeleton, Quality::Final, thin_objects(settings.thickness), preparing);
  Progress raising = progress.step("mid-surface", 0.5);
  return raise_sheets(skeleton, basis, settings, raising);
}

}  // namespace croquis::silhouette
