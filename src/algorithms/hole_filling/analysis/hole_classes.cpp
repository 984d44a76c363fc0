// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/hole_filling/analysis/hole_classes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "algorithms/hole_filling/triangulation/rim_plane.h"
#include "croquis/hole_filling/hole_groups.h"

namespace croquis::hole_filling {
namespace {

/// A sheet's border: its longest rim, of a diameter above this share of the sheet's diagonal.
constexpr double border_diameter = 0.5;

/// An open cross-section, as the base of a statue: above this share of the component's diagonal, …
constexpr double section_diameter = 0.25;
/// … and faces that lead straight on out of its plane within this angle on average, however ragged or bent the rim is,
/// but for rims that have no plane (× diameter); …
constexpr double section_tilt = 25 * std::numbers::pi / 180;
constexpr double section_planarity = 0.2;
/// … or within this angle, where the rim is so flat as only a cut is: a torn rim goes half an edge to and fro along the
/// faces. × diameter, and × mean edge × cosine of their angle
constexpr double cut_tilt = 60 * std::numbers::pi / 180;
constexpr double flat_planarity = 0.02;
constexpr double cut_planarity = 0.35;

/// A slit's width is this many mean edges at most (its area over its length) …
constexpr double slit_width = 1.5;
/// … and so long that there and back is nearly all of its perimeter.
constexpr double slit_length = 0.42;

/// An island lies this near to the plane of the hole around it, × the hole's diameter.
constexpr double island_height = 0.5;

/// Rims of a tunnel look at each other within this angle, differ at most so much in size, and aren't further apart than
/// the larger diameter.
constexpr double tunnel_angle = 40 * std::numbers::pi / 180;
constexpr double tunnel_ratio = 2;

class Classifier {
 public:
  Classifier(const PolyMesh& mesh, const HoleAnalysisOptions& options, HoleAnalysis& analysis)
      : mesh_(mesh), options_(options), analysis_(analysis), is_outer_(analysis.holes.size()) {
    for (const Hole& hole : analysis.holes) is_outer_[hole.id] = is_open_section(hole);
    for (const Index hole : longest_rims()) is_outer_[hole] = is_outer_[hole] || is_border(analysis.holes[hole]);
  }

  void run() {
    for (Hole& hole : analysis_.holes) hole.kind = alone(hole);
    const auto pairs = near_pairs(mesh_, analysis_.holes);
    for (const auto& [a, b] : pairs) join_if_island(a, b);
    for (const auto& [a, b] : pairs) join_if_tunnel(a, b);
  }

 private:
  std::vector<Hole>& holes() { return analysis_.holes; }

  std::vector<Index> longest_rims() const {
    std::vector<Index> longest(analysis_.component_area.size(), no_index);
    for (const Hole& hole : analysis_.holes) {
      Index& known = longest[hole.component];
      if (known == no_index || analysis_.holes[known].perimeter < hole.perimeter) known = hole.id;
    }
    std::erase(longest, no_index);
    return longest;
  }

  bool is_border(const Hole& hole) const {
    return hole.diameter > border_diameter * analysis_.component_diagonal[hole.component] ||
           hole.area > analysis_.component_area[hole.component];
  }

  bool is_open_section(const Hole& hole) const {
    const bool is_wide = hole.diameter > section_diameter * analysis_.component_diagonal[hole.component];
    if (!is_wide) return false;
    if (hole.conormal_tilt < section_tilt) return hole.planarity < section_planarity;
    return hole.conormal_tilt < cut_tilt && is_cut_flat(hole);
  }

  static bool is_cut_flat(const Hole& hole) {
    return hole.planarity < flat_planarity &&
           hole.planarity * hole.diameter < cut_planarity * std::cos(hole.conormal_tilt) * mean_edge(hole);
  }

  static double mean_edge(const Hole& hole) { return hole.perimeter / static_cast<double>(hole.vertices.size()); }

  bool is_slit(const Hole& hole) const {
    return hole.diameter > slit_length * hole.perimeter && hole.area < slit_width * mean_edge(hole) * hole.diameter;
  }

  HoleClass alone(const Hole& hole) const {
    if (is_outer_[hole.id]) return HoleClass::Outer;
    if (hole.shares_vertex) return HoleClass::BowTie;
    if (hole.vertices.size() <= options_.small_edges) return HoleClass::Small;
    return is_slit(hole) ? HoleClass::Slit : HoleClass::Simple;
  }

  void join(Hole& a, Hole& b, HoleClass kind) {
    a.kind = b.kind = kind;
    a.companions.push_back(b.id);
    b.companions.push_back(a.id);
  }

  /// The border of one component in a hole of another.
  void join_if_island(Index a, Index b) {
    const bool b_is_smaller = holes()[b].diameter < holes()[a].diameter;
    Hole& hole = holes()[b_is_smaller ? a : b];
    Hole& island = holes()[b_is_smaller ? b : a];
    if (!is_outer_[island.id] || is_outer_[hole.id] || hole.component == island.component) return;
    if (!island.companions.empty() || !are_compatible(hole, island) || !surrounds(hole, island)) return;
    join(hole, island, HoleClass::Islands);
  }

  bool surrounds(const Hole& hole, const Hole& island) const {
    std::vector<Vec3> rim;
    for (auto vertex = hole.vertices.rbegin(); vertex != hole.vertices.rend(); ++vertex)
      rim.push_back(mesh_.positions[*vertex]);
    const RimPlane plane = plane_of_rim(rim);
    if (std::abs(plane.normal.dot(island.centre - plane.centre)) > island_height * hole.diameter) return false;
    const Vec2 at = plane.project(island.centre);
    double turn = 0;
    for (std::size_t i = 0; i < rim.size(); ++i) {
      const Vec2 from = plane.project(rim[i]) - at;
      const Vec2 to = plane.project(rim[i + 1 == rim.size() ? 0 : i + 1]) - at;
      turn += std::atan2(cross(from, to), from.dot(to));
    }
    return std::abs(turn) > std::numbers::pi;
  }

  void join_if_tunnel(Index i, Index k) {
    Hole& a = holes()[i];
    Hole& b = holes()[k];
    if (a.component == b.component || !a.companions.empty() || !b.companions.empty()) return;
    const Vec3 gap = b.centre - a.centre;
    const double larger = std::max(a.diameter, b.diameter);
    if (larger > tunnel_ratio * std::min(a.diameter, b.diameter) || !(gap.norm() < larger)) return;
    const double limit = std::cos(tunnel_angle);
    const Vec3 direction = gap.normalized();
    const bool facing = a.conormal.dot(direction) > limit && b.conormal.dot(-direction) > limit &&
                        std::abs(a.normal.dot(direction)) > limit && std::abs(b.normal.dot(direction)) > limit;
    if (facing) join(a, b, HoleClass::Tunnel);
  }

  const PolyMesh& mesh_;
  const HoleAnalysisOptions& options_;
  HoleAnalysis& analysis_;
  std::vector<bool> is_outer_;  ///< by shape alone: also of pieces that turn out to be islands
};

}  // namespace

void classify_holes(const PolyMesh& mesh, const HoleAnalysisOptions& options, HoleAnalysis& analysis) {
  Classifier(mesh, options, analysis).run();
}

}  // namespace croquis::hole_filling
