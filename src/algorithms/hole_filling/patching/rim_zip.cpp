// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/hole_filling/patching/rim_zip.h"

#include <algorithm>
#include <limits>

#include <Eigen/Geometry>

#include "algorithms/hole_filling/triangulation/band_triangulation.h"
#include "croquis/implicit/point_tree.h"

namespace croquis::hole_filling {
namespace {

using Triangle = std::array<Index, 3>;

constexpr double most_turned_over = 0.1;  // of the strip's area
constexpr double longest_ways = 2;        // from one side to the other, × the shortest there are

/// Both sides as the rims of a patch: the right one the other way round.
RimPolygon as_rims(const ZipSides& sides) {
  RimPolygon rims;
  rims.points = sides.left;
  rims.points.insert(rims.points.end(), sides.right.rbegin(), sides.right.rend());
  rims.loop_ends = {static_cast<Index>(sides.left.size()), static_cast<Index>(rims.points.size())};
  return rims;
}

/// Whether edges lead elsewhere than to what is near on the other side.
bool is_twisted(const ZipSides& sides, const std::vector<Triangle>& strip) {
  const auto first_right = static_cast<Index>(sides.left.size());
  std::vector<Vec3> places = sides.left;
  places.insert(places.end(), sides.right.begin(), sides.right.end());
  std::vector<double> way(places.size(), std::numeric_limits<double>::infinity());
  for (const Triangle& t : strip) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Index a = t[i], b = t[(i + 1) % 3];
      if ((a < first_right) == (b < first_right)) continue;
      const double length = (places[a] - places[b]).norm();
      way[a] = std::min(way[a], length);
      way[b] = std::min(way[b], length);
    }
  }
  const implicit::PointTree left(sides.left), right(sides.right);
  double taken = 0, shortest = 0;
  for (Index v = 0; v < places.size(); ++v) {
    const Vec3& other = v < first_right ? sides.right[right.nearest(places[v])] : sides.left[left.nearest(places[v])];
    taken += way[v];
    shortest += (other - places[v]).norm();
  }
  return !(taken <= longest_ways * shortest);
}

bool turns_over(const ZipSides& sides, const std::vector<Triangle>& strip) {
  const auto first_right = static_cast<Index>(sides.left.size());
  const auto place = [&](Index v) { return v < first_right ? sides.left[v] : sides.right[v - first_right]; };
  const auto normal = [&](Index v) {
    return v < first_right ? sides.left_normals[v] : sides.right_normals[v - first_right];
  };
  double area = 0, turned_over = 0;
  for (const auto& [a, b, c] : strip) {
    const Vec3 twice_area = (place(b) - place(a)).cross(place(c) - place(a));
    area += twice_area.norm();
    if (twice_area.dot(normal(a) + normal(b) + normal(c)) < 0) turned_over += twice_area.norm();
  }
  return turned_over > most_turned_over * area;
}

}  // namespace

std::optional<std::vector<Triangle>> zip(const ZipSides& sides, Progress& progress) {
  const RimPolygon rims = as_rims(sides);
  auto strip = band_triangulation(rims, BandCost::Length, progress);
  if (!strip) return std::nullopt;
  const auto first_right = static_cast<Index>(sides.left.size());
  const auto last = static_cast<Index>(rims.points.size() - 1);
  for (Triangle& t : *strip) {
    for (Index& v : t) v = v < first_right ? v : first_right + (last - v);
  }
  if (is_twisted(sides, *strip) || turns_over(sides, *strip)) return std::nullopt;
  return strip;
}

}  // namespace croquis::hole_filling
