// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/cage/cage_limbs.h"

#include <algorithm>
#include <bitset>
#include <cmath>
#include <numbers>
#include <tuple>
#include <utility>

#include <Eigen/Eigenvalues>

#include "algorithms/silhouette/skeleton/axis_graph.h"
#include "algorithms/silhouette/skeleton/triangle_corners.h"
#include "croquis/geometry/polyline.h"

namespace croquis::silhouette {
namespace {

/// A branch is left out when all of it lies within so many of its half widths of the middle of its foot.
constexpr double branch_reach = 1.5;
constexpr int cap_steps = 8;
/// A limb between junctions that is shorter than so many rings has none: the junctions become one.
constexpr double least_rings = 0.5;
/// Where rims are as round as a ring they have as many vertices, about.
constexpr double round_spacing = 0.5;
constexpr std::size_t least_tip_rings = 2;   // one cut before the tip
constexpr std::size_t least_blob_rings = 8;  // a ball then has about as many vertices round one way as the other
constexpr std::size_t least_loop = 3;        // vertices of a closed line

double around(double distance, double length) { return distance < 0 ? distance + length : distance; }

/// Follows limbs through the triangulation of the contours' points.
class LimbFinder {
 public:
  LimbFinder(const LabelledFigure& figure, const ImmersedTriangulation& immersed, double spacing, LimbedRegion& region)
      : figure_(figure),
        immersed_(immersed),
        open_(open_edges(immersed, figure.points, branch_reach)),
        spacing_(spacing),
        region_(region),
        seen_(3 * open_.size(), false) {}

  void find() {
    for (Index t = 0; t < open_.size(); ++t) {
      if (open_[t].count() == 3) region_.junctions.push_back(t);
    }
    for (const std::size_t ways : {3U, 1U, 2U}) {
      for (Index gate = 0; gate < seen_.size(); ++gate) {
        const Index t = gate / 3;
        if (open_[t].count() == ways && open_[t][gate % 3] && !seen_[gate]) follow(gate);
      }
    }
    add_blobs();
  }

 private:
  const Vec2& point(Index vertex) const { return figure_.points[immersed_.planar_vertex[vertex]]; }

  Index contour_of(Index vertex) const {
    const auto after = std::ranges::upper_bound(immersed_.first_vertex, vertex);
    return static_cast<Index>(after - immersed_.first_vertex.begin()) - 1;
  }

  double rim_place(Index vertex) const {
    const Index contour = contour_of(vertex);
    const RimLine& rim = region_.rims[contour];
    return rim.at[rim.walked(vertex - immersed_.first_vertex[contour])];
  }

  Index beyond(Index gate) const {
    const Index t = gate / 3, other = immersed_.neighbours[t][gate % 3];
    return 3 * other + corner_across(immersed_.neighbours, other, t);
  }

  /// From a triangle out through the edge opposite to a corner.
  std::pair<Index, Index> left_and_right(Index gate) const {
    const std::array<Index, 3>& corners = immersed_.triangles[gate / 3];
    return {corners[previous(gate % 3)], corners[next(gate % 3)]};
  }

  double half_width(Index gate) const {
    const auto [left, right] = left_and_right(gate);
    return (point(left) - point(right)).norm() / 2;
  }

  void follow(Index gate) {
    const auto [left, right] = left_and_right(gate);
    CageLimb limb;
    limb.left_rim = contour_of(left);
    limb.right_rim = contour_of(right);
    limb.chords.push_back({rim_place(left), rim_place(right)});
    limb.along.push_back(0);
    const Index start = gate;
    const auto end_of = [&](Index at) { return open_[at / 3].count() == 3 ? LimbEnd::Junction : LimbEnd::Tip; };
    for (;;) {
      seen_[gate] = true;
      const Index entry = beyond(gate);
      seen_[entry] = true;
      if (open_[entry / 3].count() != 2) {
        limb.ends = {end_of(start), end_of(entry)};
        limb.gates = {start, entry};
        break;
      }
      const Index t = entry / 3;
      const Index out = 3 * t + (open_[t][next(entry % 3)] ? next(entry % 3) : previous(entry % 3));
      add_chord(gate, out, limb);
      gate = out;
      if (gate == start) {
        limb.ends = {LimbEnd::Loop, LimbEnd::Loop};
        break;
      }
    }
    measure(limb);
    for (const bool at_end : {false, true}) {
      if (limb.ends[at_end] == LimbEnd::Tip) add_tip(at_end, half_width(at_end ? gate : start), limb);
    }
    count_rings(limb);
    region_.limbs.push_back(std::move(limb));
  }

  void add_chord(Index from, Index to, CageLimb& limb) const {
    const auto [left, right] = left_and_right(to);
    const auto [old_left, old_right] = left_and_right(from);
    const double right_step = around(rim_place(right) - rim_place(old_right), region_.rims[limb.right_rim].length);
    const double left_step = around(rim_place(old_left) - rim_place(left), region_.rims[limb.left_rim].length);
    const LimbCut& last = limb.chords.back();
    limb.chords.push_back({last.left - left_step, last.right + right_step});
    limb.along.push_back((half_width(from) + half_width(to)) / 2);
  }

  /// From the radii between chords to rings: the mean of both sides counts, more where one of them is much longer over
  /// about a radius, less where a limb is straight.
  void measure(CageLimb& limb) const {
    constexpr double straight = 0.8, longer_side = 0.65;
    const std::vector<double> radius = limb.along;
    const std::vector<LimbCut>& chords = limb.chords;
    const auto mean = [&](std::size_t a, std::size_t b) {
      return (chords[b].right - chords[a].right + chords[a].left - chords[b].left) / 2;
    };
    for (std::size_t i = 1; i < chords.size(); ++i) {
      std::size_t low = i - 1, high = i;
      while (low > 0 && mean(low, i) < radius[i]) --low;
      while (high + 1 < chords.size() && mean(i - 1, high) < radius[i]) ++high;
      const double longer = std::max(chords[high].right - chords[low].right, chords[low].left - chords[high].left);
      const double factor = std::max(straight, longer_side * longer / std::max(mean(low, high), 1e-300));
      limb.along[i] = limb.along[i - 1] + factor * mean(i - 1, i) / (spacing_ * radius[i]);
    }
  }

  /// The place of a rim between a chord's ends that is farthest out, of nearly equal ones the middle one.
  static double tip_between(const RimLine& rim, double from, double length) {
    constexpr int tried = 64;
    constexpr double preference = 0.3;  // for the middle
    const Vec2 middle = (rim.place_at(from) + rim.place_at(from + length)) / 2;
    double best = 0, most = -1;
    for (int k = 1; k < tried; ++k) {
      const double part = static_cast<double>(k) / tried, aside = 2 * part - 1;
      const double far = (rim.place_at(from + part * length) - middle).norm() * (1 - preference * aside * aside);
      if (far > most) std::tie(best, most) = std::pair(part * length, far);
    }
    return best;
  }

  /// Leads the chords on until they end in the rim's tip.
  void add_tip(bool at_end, double radius, CageLimb& limb) const {
    const RimLine& rim = region_.rims[limb.right_rim];
    const LimbCut last = at_end ? limb.chords.back() : limb.chords.front();
    const double first = at_end ? last.right : last.left;
    double length = std::fmod((at_end ? last.left : last.right) - first, rim.length);
    if (length <= 0) length += rim.length;
    const double tip = tip_between(rim, first, length);
    std::vector<LimbCut> chords;
    for (int k = 1; k <= cap_steps; ++k) {
      const double part = static_cast<double>(k) / cap_steps;
      const double rising = part * tip, falling = part * (length - tip);
      chords.push_back(at_end ? LimbCut{last.left - falling, last.right + rising}
                              : LimbCut{last.left + rising, last.right - falling});
    }
    const double rings = length / (2 * std::min(spacing_, round_spacing) * radius);
    std::vector<double> steps(chords.size(), rings / cap_steps);
    insert(at_end, chords, steps, limb);
  }

  static void insert(bool at_end, std::vector<LimbCut>& chords, const std::vector<double>& steps, CageLimb& limb) {
    if (at_end) {
      limb.chords.insert(limb.chords.end(), chords.begin(), chords.end());
      for (const double step : steps) limb.along.push_back(limb.along.back() + step);
      return;
    }
    std::ranges::reverse(chords);
    limb.chords.insert(limb.chords.begin(), chords.begin(), chords.end());
    std::vector<double> along{0};
    for (const double step : steps) along.push_back(along.back() + step);
    for (std::size_t i = 1; i < limb.along.size(); ++i) along.push_back(along[steps.size()] + limb.along[i]);
    limb.along = std::move(along);
  }

  void count_rings(CageLimb& limb) const {
    const bool is_body = limb.ends == std::array{LimbEnd::Junction, LimbEnd::Junction};
    const double length = limb.along.back() * (is_body ? std::max(spacing_ / round_spacing, 1.0) : 1);
    limb.rings = length < least_rings ? 0 : std::max<std::size_t>(1, static_cast<std::size_t>(std::lround(length)));
    const bool has_tip = std::ranges::count(limb.ends, LimbEnd::Tip) > 0;
    const bool is_whole = limb.ends == std::array{LimbEnd::Tip, LimbEnd::Tip};
    if (has_tip) limb.rings = std::max(limb.rings, is_whole ? least_blob_rings : least_tip_rings);
    if (limb.ends[0] == LimbEnd::Loop) limb.rings = std::max(limb.rings, least_loop);
  }

  /// What is round all over has no chords: it is cut across its longer axis, or from top to bottom.
  void add_blobs() {
    std::vector<bool> has_limb(region_.rims.size(), false);
    for (const CageLimb& limb : region_.limbs) has_limb[limb.left_rim] = has_limb[limb.right_rim] = true;
    for (Index t = 0; t < open_.size(); ++t) {
      if (open_[t].none()) continue;
      for (const Index vertex : immersed_.triangles[t]) has_limb[contour_of(vertex)] = true;
    }
    for (Index c = 0; c < region_.rims.size(); ++c) {
      if (!has_limb[c]) region_.limbs.push_back(blob(c));
    }
  }

  CageLimb blob(Index contour) const {
    const RimLine& rim = region_.rims[contour];
    const auto [from, to] = axis_of(rim);
    const double rising = around(to - from, rim.length), falling = rim.length - rising;
    CageLimb limb;
    limb.left_rim = limb.right_rim = contour;
    limb.ends = {LimbEnd::Tip, LimbEnd::Tip};
    const double radius = std::sqrt(std::abs(signed_area(rim.points)) / std::numbers::pi);
    for (int k = 0; k <= 2 * cap_steps; ++k) {
      const double part = static_cast<double>(k) / (2 * cap_steps);
      limb.chords.push_back({from - part * falling, from + part * rising});
      limb.along.push_back(part * rim.length / (2 * std::min(spacing_, round_spacing) * radius));
    }
    count_rings(limb);
    return limb;
  }

  /// Both ends of the longer axis.
  static std::pair<double, double> axis_of(const RimLine& rim) {
    constexpr double least_longer = 1.1;
    Vec2 centre = Vec2::Zero();
    for (const Vec2& place : rim.points) centre += place / static_cast<double>(rim.points.size());
    Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
    for (const Vec2& place : rim.points) spread += (place - centre) * (place - centre).transpose();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(spread);
    Vec2 axis = Vec2::UnitY();
    if (axes.eigenvalues()[1] > least_longer * least_longer * axes.eigenvalues()[0]) axis = axes.eigenvectors().col(1);
    std::array<Index, 2> ends{0, 0};
    for (Index i = 0; i < rim.points.size(); ++i) {
      const double far = axis.dot(rim.points[i] - centre);
      if (far < axis.dot(rim.points[ends[0]] - centre)) ends[0] = i;
      if (far > axis.dot(rim.points[ends[1]] - centre)) ends[1] = i;
    }
    return {rim.at[ends[0]], rim.at[ends[1]]};
  }

  const LabelledFigure& figure_;
  const ImmersedTriangulation& immersed_;
  std::vector<std::bitset<3>> open_;
  double spacing_;
  LimbedRegion& region_;
  std::vector<bool> seen_;
};

/// A rim with fewer cuts than a closed line needs gets more.
void keep_holes_open(LimbedRegion& region) {
  std::vector<std::size_t> vertices(region.rims.size(), 0);
  for (const CageLimb& limb : region.limbs) {
    for (const Index rim : {limb.left_rim, limb.right_rim}) vertices[rim] += limb.rings;
  }
  for (CageLimb& limb : region.limbs) {
    const bool same = limb.ends[0] == LimbEnd::Junction && limb.gates[0] / 3 == limb.gates[1] / 3;
    const bool few = std::min(vertices[limb.left_rim], vertices[limb.right_rim]) < least_loop;
    if (few || same) limb.rings = std::max(limb.rings, least_loop);
  }
}

}  // namespace

Index RimLine::walked(Index position) const {
  const auto count = static_cast<Index>(points.size());
  return side > 0 || position == 0 ? position : count - position;
}

Index RimLine::segment_at(double place) const {
  const double rest = around(std::fmod(place, length), length);
  const auto after = std::ranges::upper_bound(at, rest);
  return static_cast<Index>(std::max<std::ptrdiff_t>(after - at.begin(), 1)) - 1;
}

Vec2 RimLine::place_at(double place) const {
  const double rest = around(std::fmod(place, length), length);
  const Index from = segment_at(place), to = from + 1 < points.size() ? from + 1 : 0;
  const double step = (to == 0 ? length : at[to]) - at[from];
  const double part = step > 0 ? std::clamp((rest - at[from]) / step, 0.0, 1.0) : 0;
  return (1 - part) * points[from] + part * points[to];
}

std::vector<RimLine> rim_lines(const LabelledFigure& figure) {
  std::vector<RimLine> rims;
  for (Index c = 0; c < figure.contours.size(); ++c) {
    RimLine& rim = rims.emplace_back();
    rim.points = contour_points(figure, c);
    rim.side = figure.contours[c].side;
    if (rim.side < 0) std::reverse(rim.points.begin() + 1, rim.points.end());
    for (std::size_t i = 0; i < rim.points.size(); ++i) {
      rim.at.push_back(rim.length);
      rim.length += (rim.points[i + 1 < rim.points.size() ? i + 1 : 0] - rim.points[i]).norm();
    }
  }
  return rims;
}

LimbedRegion limbed_region(const LabelledFigure& figure, const ImmersedTriangulation& immersed, double spacing) {
  LimbedRegion region;
  region.rims = rim_lines(figure);
  region.triangles = immersed.triangles.size();
  LimbFinder(figure, immersed, spacing, region).find();
  keep_holes_open(region);
  return region;
}

namespace {

/// A limb's chord anywhere along it; a loop goes on for ever.
LimbCut cut_at(const LimbedRegion& region, const CageLimb& limb, double along) {
  LimbCut shift;
  if (limb.ends[0] == LimbEnd::Loop) {
    const double turns = std::floor(along / limb.along.back());
    along -= turns * limb.along.back();
    shift = {-turns * region.rims[limb.left_rim].length, turns * region.rims[limb.right_rim].length};
  }
  const auto after = std::ranges::upper_bound(limb.along, along);
  const auto to = std::clamp<std::ptrdiff_t>(after - limb.along.begin(), 1, std::ssize(limb.along) - 1);
  const auto end = static_cast<std::size_t>(to);
  const double step = limb.along[end] - limb.along[end - 1];
  const double part = step > 0 ? std::clamp((along - limb.along[end - 1]) / step, 0.0, 1.0) : 0;
  const LimbCut &a = limb.chords[end - 1], &b = limb.chords[end];
  return {shift.left + (1 - part) * a.left + part * b.left, shift.right + (1 - part) * a.right + part * b.right};
}

}  // namespace

std::vector<LimbCut> ring_cuts(const LimbedRegion& region, const CageLimb& limb) {
  // Chords of a triangulation have common ends: a mean over a ring, and a share of even steps, part them.
  constexpr int samples = 8;
  constexpr double even_share = 0.15;
  const double length = limb.along.back();
  const LimbCut &first = limb.chords.front(), &last = limb.chords.back();
  std::vector<LimbCut> cuts;
  for (std::size_t k = 0; k <= limb.rings; ++k) {
    const double part = static_cast<double>(k) / static_cast<double>(limb.rings), middle = part * length;
    const bool loops = limb.ends[0] == LimbEnd::Loop;
    const double ring = length / static_cast<double>(limb.rings);
    const double reach = loops ? ring : std::min({ring, middle, length - middle});
    LimbCut mean;
    for (int s = -samples; s <= samples; ++s) {
      const LimbCut cut = cut_at(region, limb, middle + reach * s / samples);
      mean.left += cut.left / (2 * samples + 1);
      mean.right += cut.right / (2 * samples + 1);
    }
    const double share = loops ? 0 : even_share;
    cuts.push_back({(1 - share) * mean.left + share * ((1 - part) * first.left + part * last.left),
                    (1 - share) * mean.right + share * ((1 - part) * first.right + part * last.right)});
  }
  return cuts;
}

}  // namespace croquis::silhouette
