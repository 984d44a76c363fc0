// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/figure/paneling.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <tuple>

#include "croquis/geometry/disjoint_sets.h"

namespace croquis::silhouette {
namespace {

/// An arc seen from the side with more layers.
struct Step {
  Index more = 0;   ///< face
  Index fewer = 0;  ///< face
  Index depth = 0;

  /// Layer on the other side, for any layer but the one that ends.
  Index across(Index layer) const { return layer < depth ? layer : layer - 1; }
};

class Gluer {
 public:
  Gluer(const Arrangement& arrangement, const Faces& faces, const std::vector<int>& layers,
        const std::vector<int>& depth)
      : arrangement_(arrangement), faces_(faces), layers_(layers), ends_(arc_ends(arrangement)) {
    for (Index arc = 0; arc < arrangement.arcs.size(); ++arc) {
      Step step{faces.left[arc], faces.right[arc], static_cast<Index>(depth[arc])};
      if (layers[step.more] < layers[step.fewer]) std::swap(step.more, step.fewer);
      steps_.push_back(step);
    }
    result_.first_panel.push_back(0);
    for (const int w : layers) result_.first_panel.push_back(result_.first_panel.back() + static_cast<Index>(w));
  }

  Paneling glue() {
    find_components();
    find_overlaps();
    return std::move(result_);
  }

 private:
  Index panel(Index face, Index layer) const { return result_.first_panel[face] + layer; }

  void find_components() {
    DisjointSets sets(result_.first_panel.back());
    for (const Step& step : steps_) {
      for (Index i = 0; i < static_cast<Index>(layers_[step.more]); ++i) {
        if (i != step.depth) sets.unite(panel(step.more, i), panel(step.fewer, step.across(i)));
      }
    }
    std::map<Index, Index> number;
    result_.component_of_contour.assign(arrangement_.contours.size(), no_index);
    for (Index arc = 0; arc < steps_.size(); ++arc) {
      const Index root = sets.root(panel(steps_[arc].more, steps_[arc].depth));
      const auto [entry, fresh] = number.try_emplace(root, result_.component_count);
      if (fresh) ++result_.component_count;
      Index& component = result_.component_of_contour[arrangement_.arcs[arc].contour];
      if (component != no_index && component != entry->second) result_.sound = false;
      component = entry->second;
    }
    for (Index p = 0; p < result_.first_panel.back(); ++p) result_.component.push_back(number.at(sets.root(p)));
  }

  /// Index of the pair of layers i above k in a face.
  Index pair(Index face, Index i, Index k) const { return first_pair_[face] + k * (k - 1) / 2 + i; }

  void find_overlaps() {
    first_pair_ = {0};
    for (const int w : layers_) first_pair_.push_back(first_pair_.back() + static_cast<Index>(w * (w - 1) / 2));
    DisjointSets sets(first_pair_.back());
    for (const Step& step : steps_) {
      for (Index k = 1; k < static_cast<Index>(layers_[step.more]); ++k) {
        for (Index i = 0; i < k; ++i) {
          if (i == step.depth || k == step.depth) continue;
          sets.unite(pair(step.more, i, k), pair(step.fewer, step.across(i), step.across(k)));
        }
      }
    }
    collect_overlaps(sets);
  }

  /// Of the two arcs of a contour at a crossing, the one inside the other contour's surface.
  const Step& covered_step(Index contour, Index position) const {
    const Step& before = steps_[ends_.before(contour, position)];
    const Step& after = steps_[ends_.after(contour, position)];
    return layers_[before.more] > layers_[after.more] ? before : after;
  }

  /// The sheets that end at a crossing lie above one another in one of the four faces around it: that pair of panels
  /// has a corner there.
  std::map<Index, std::vector<Index>> crossings_of_regions(DisjointSets& sets) const {
    std::map<Index, std::vector<Index>> crossings;
    for (Index k = 0; k < arrangement_.crossings.size(); ++k) {
      const ContourCrossing& crossing = arrangement_.crossings[k];
      const Step& a = covered_step(crossing.contour_a, crossing.position_a);
      const Step& b = covered_step(crossing.contour_b, crossing.position_b);
      const auto [above, below] = std::minmax(a.depth, b.depth);
      crossings[sets.root(pair(a.more, above, below))].push_back(k);
    }
    return crossings;
  }

  /// One overlap for each set of pairs, placed in the largest triangle it covers.
  void collect_overlaps(DisjointSets& sets) {
    std::vector<std::pair<double, Vec2>> largest(layers_.size(), {-1.0, Vec2::Zero()});
    const PlanarTriangulation& planar = faces_.triangulation;
    for (Index t = 0; t < planar.triangles.size(); ++t) {
      const auto& [a, b, c] = planar.triangles[t];
      const Points& p = arrangement_.points;
      const double area = cross(p[b] - p[a], p[c] - p[a]);
      auto& best = largest[faces_.of_triangle[t]];
      if (area > best.first) best = {area, (p[a] + p[b] + p[c]) / 3};
    }
    struct Region {
      double area = -1;
      PanelOverlap overlap;
    };
    std::map<Index, Region> regions;
    for (Index f = 0; f < layers_.size(); ++f) {
      for (Index k = 1; k < static_cast<Index>(layers_[f]); ++k) {
        for (Index i = 0; i < k; ++i) {
          Region& region = regions[sets.root(pair(f, i, k))];
          if (largest[f].first <= region.area) continue;
          region = {largest[f].first,
                    {largest[f].second, result_.component[panel(f, i)], result_.component[panel(f, k)], {}}};
        }
      }
    }
    for (auto& [root, crossings] : crossings_of_regions(sets)) {
      regions.at(root).overlap.crossings = std::move(crossings);
    }
    for (auto& [root, region] : regions) result_.overlaps.push_back(std::move(region.overlap));
    std::sort(result_.overlaps.begin(), result_.overlaps.end(), [](const PanelOverlap& a, const PanelOverlap& b) {
      return std::tuple(a.upper_component, a.lower_component, a.at.x(), a.at.y()) <
             std::tuple(b.upper_component, b.lower_component, b.at.x(), b.at.y());
    });
  }

  const Arrangement& arrangement_;
  const Faces& faces_;
  const std::vector<int>& layers_;
  ArcEnds ends_;
  std::vector<Step> steps_;        ///< per arc
  std::vector<Index> first_pair_;  ///< per face, one more at the end
  Paneling result_;
};

}  // namespace

Paneling glue_panels(const Arrangement& arrangement, const Faces& faces, const std::vector<int>& layers,
                     const std::vector<int>& depth) {
  return Gluer(arrangement, faces, layers, depth).glue();
}

int turning_number(const Points& points) {
  const std::size_t count = points.size();
  double turned = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const Vec2 before = points[(i + 1) % count] - points[i];
    const Vec2 after = points[(i + 2) % count] - points[(i + 1) % count];
    turned += std::atan2(cross(before, after), before.dot(after));
  }
  return static_cast<int>(std::lround(turned / (2 * std::numbers::pi)));
}

}  // namespace croquis::silhouette
