// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/hole_filling/continuation/crease_field.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "algorithms/hole_filling/continuation/crease_angle.h"
#include "algorithms/hole_filling/continuation/known_surface.h"
#include "algorithms/hole_filling/continuation/smooth_sides.h"
#include "croquis/base/error.h"

namespace croquis::hole_filling {
namespace {

using Node = CreaseField::Node;
using Tree = std::vector<Node>;

constexpr double least_side_reach = 6;  // × edge
constexpr std::size_t most_known = 4000;
constexpr std::size_t most_sides = 5;           // the number of trees grows as the factorial
constexpr std::size_t most_side_centres = 120;  // per side
constexpr double first_spacing = 0.7;           // of centres, × edge
constexpr double side_spacing_slope = 0.25;     // by how much it grows per distance from the rim
constexpr double side_spacing_growth = 1.2;
constexpr std::size_t most_samples = 1000;

/// Places in the side's list: none nearer to another than the spacing there.
std::vector<std::size_t> spread(const KnownSurface& known, const SmoothSide& side) {
  for (double scale = first_spacing;; scale *= side_spacing_growth) {
    std::vector<std::size_t> taken;
    for (std::size_t i = 0; i < side.vertices.size() && taken.size() <= most_side_centres; ++i) {
      const Vec3& place = known.mesh.positions[side.vertices[i]];
      const double least = std::max(scale * known.edge, side_spacing_slope * known.distance[side.vertices[i]]);
      if (std::all_of(taken.begin(), taken.end(), [&](std::size_t j) {
            return (known.mesh.positions[side.vertices[j]] - place).squaredNorm() >= least * least;
          }))
        taken.push_back(i);
    }
    if (taken.size() <= most_side_centres) return taken;
  }
}

std::shared_ptr<const implicit::LocalFit> fit_of(const KnownSurface& known, const SmoothSide& side,
                                                 const ImplicitOptions& options) {
  implicit::Constraints constraints;
  for (const std::size_t i : spread(known, side)) {
    constraints.positions.push_back(known.mesh.positions[side.vertices[i]]);
    constraints.gradients.push_back(side.normals[i]);
  }
  implicit::FitOptions how;
  how.value_smoothing = options.value_smoothing;
  how.gradient_smoothing = options.gradient_smoothing;
  how.spacing = known.edge;
  try {
    return std::make_shared<const implicit::LocalFit>(constraints, how);
  } catch (const Error&) {
    return nullptr;
  }
}

/// All trees over the sides of a set (bits).
std::vector<Tree> trees_over(unsigned sides) {
  const unsigned lowest = sides & (~sides + 1);
  if (sides == lowest) {
    Node leaf;
    while ((1U << static_cast<unsigned>(leaf.side + 1)) <= sides) ++leaf.side;
    return {{leaf}};
  }
  std::vector<Tree> trees;
  for (unsigned part = (sides - 1) & sides; part > 0; part = (part - 1) & sides) {
    if ((part & lowest) == 0) continue;  // each split once
    for (const Tree& first : trees_over(part)) {
      for (const Tree& second : trees_over(sides & ~part)) {
        for (const bool is_greater : {true, false}) {
          Tree tree = first;
          for (Node node : second) {
            if (node.side < 0) {
              node.first += first.size();
              node.second += first.size();
            }
            tree.push_back(node);
          }
          tree.push_back({-1, is_greater, first.size() - 1, tree.size() - 1});
          trees.push_back(std::move(tree));
        }
      }
    }
  }
  return trees;
}

CreaseField::Value value_of(const Tree& tree, std::span<const double> sides) {
  std::array<CreaseField::Value, 2 * most_sides> values;
  for (std::size_t i = 0; i < tree.size(); ++i) {
    const Node& node = tree[i];
    if (node.side >= 0) {
      const auto side = static_cast<std::size_t>(node.side);
      values[i] = {sides[side], side};
    } else {
      const auto &a = values[node.first], &b = values[node.second];
      values[i] = (a.value > b.value) == node.is_greater ? a : b;
    }
  }
  return values[tree.size() - 1];
}

}  // namespace

CreaseField::Value CreaseField::value(const Vec3& point) const {
  std::vector<double> values;
  for (const auto& fit : fits_) values.push_back(fit->value(point));
  return value_of(tree_, values);
}

implicit::Field CreaseField::field() const {
  return [own = *this](std::span<const Vec3> points, std::span<double> values, std::span<Vec3> gradients) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Value found = own.value(points[i]);
      values[i] = found.value;
      if (!gradients.empty()) gradients[i] = own.fits_[found.side]->gradient(points[i]);
    }
  };
}

bool creases_run_in(const HoleSite& site) {
  const SurfaceView& view = site.analysis->view;
  const double cosine = crease_cosine(site);
  std::size_t ends = 0;
  for (const Index id : site.holes) {
    for (const Index rim_corner : site.analysis->holes[id].corners) {
      const Index pivot = view.origin(rim_corner);
      for (Index edge = SurfaceView::previous(rim_corner); view.has_opposite(edge);) {
        const Index other = view.opposite[edge];
        if (!is_smooth(triangle_normal(site, edge / 3), triangle_normal(site, other / 3), cosine) && ++ends == 2)
          return true;
        edge = view.other_edge_at(other, pivot);
      }
    }
  }
  return false;
}

std::optional<CreaseField> fit_sides(const HoleSite& site, const ImplicitOptions& options, double most_residual) {
  const KnownSurface known = known_surface(site, options.reach, least_side_reach, most_known);
  const std::vector<SmoothSide> sides = smooth_sides(known);
  if (sides.size() < 2 || sides.size() > most_sides) return std::nullopt;
  std::vector<std::shared_ptr<const implicit::LocalFit>> fits;
  for (const SmoothSide& side : sides) {
    fits.push_back(fit_of(known, side, options));
    if (!fits.back()) return std::nullopt;
  }
  std::vector<std::vector<double>> samples;  // values of all sides, per place
  std::size_t count = 0;
  for (const SmoothSide& side : sides) count += side.vertices.size();
  for (const SmoothSide& side : sides) {
    for (std::size_t i = 0; i < side.vertices.size(); i += count / most_samples + 1) {
      samples.emplace_back();
      for (const auto& fit : fits) samples.back().push_back(fit->value(known.mesh.positions[side.vertices[i]]));
    }
  }
  Tree best;
  double least = most_residual * known.edge * static_cast<double>(samples.size());
  for (const Tree& tree : trees_over((1U << sides.size()) - 1)) {
    double sum = 0;
    for (const auto& values : samples) sum += std::abs(value_of(tree, values).value);
    if (!(sum < least)) continue;
    least = sum;
    best = tree;
  }
  if (best.empty()) return std::nullopt;
  return CreaseField(std::move(fits), std::move(best));
}

}  // namespace croquis::hole_filling
