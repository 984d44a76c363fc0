// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/items/polygon_triangulation.h"

#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace croquis::render {
namespace {

/// Looks along the area vector: polygons run counter-clockwise.
class Flattening {
 public:
  explicit Flattening(const glm::dvec3& area) {
    const glm::dvec3 size = glm::abs(area);
    const int drop = size.x > size.y && size.x > size.z ? 0 : size.y > size.z ? 1 : 2;
    x_ = (drop + 1) % 3;
    y_ = (drop + 2) % 3;
    if (area[drop] < 0) std::swap(x_, y_);
  }
  glm::dvec2 operator()(const glm::dvec3& corner) const { return {corner[x_], corner[y_]}; }

 private:
  int x_ = 0, y_ = 0;
};

std::vector<glm::dvec2> flattened(std::span<const glm::dvec3> polygon) {
  const Flattening flat(area_vector(polygon));
  std::vector<glm::dvec2> plane;
  plane.reserve(polygon.size());
  for (const glm::dvec3& corner : polygon) plane.push_back(flat(corner));
  return plane;
}

double turn(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

bool is_inside(const glm::dvec2& p, const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
  return turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0;
}

/// Whether a quad's first corner is an ear, which it is in nearly all: no more has to be looked at.
bool starts_with_ear(std::span<const glm::dvec3> quad) {
  const Flattening flat(glm::cross(quad[2] - quad[0], quad[3] - quad[1]));
  const glm::dvec2 a = flat(quad[3]), b = flat(quad[0]), c = flat(quad[1]), other = flat(quad[2]);
  return turn(a, b, c) > 0 && !is_inside(other, a, b, c);
}

class EarCutter {
 public:
  explicit EarCutter(std::vector<glm::dvec2> points) : points_(std::move(points)), remaining_(points_.size()) {
    std::iota(remaining_.begin(), remaining_.end(), Index{0});
  }

  std::vector<std::array<Index, 3>> cut() {
    std::vector<std::array<Index, 3>> triangles;
    triangles.reserve(points_.size() - 2);
    std::size_t start = 0;
    while (remaining_.size() > 3) {
      const std::size_t tip = find_tip(start);
      triangles.push_back(ear(tip));
      remaining_.erase(remaining_.begin() + static_cast<std::ptrdiff_t>(tip));
      // Going on behind the cut spreads the triangles instead of fanning them from one corner.
      start = tip % remaining_.size();
    }
    triangles.push_back({remaining_[0], remaining_[1], remaining_[2]});
    return triangles;
  }

 private:
  std::array<Index, 3> ear(std::size_t tip) const {
    const std::size_t count = remaining_.size();
    return {remaining_[(tip + count - 1) % count], remaining_[tip], remaining_[(tip + 1) % count]};
  }

  /// The first ear from `start`; without one (the polygon crosses itself) the flattest corner, so that it ends.
  std::size_t find_tip(std::size_t start) const {
    std::size_t flattest = start;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t step = 0; step < remaining_.size(); ++step) {
      const std::size_t tip = (start + step) % remaining_.size();
      const auto [a, b, c] = ear(tip);
      const double area = turn(points_[a], points_[b], points_[c]);
      if (area > 0 && is_free(a, b, c)) return tip;
      if (std::abs(area) < least) {
        least = std::abs(area);
        flattest = tip;
      }
    }
    return flattest;
  }

  bool is_free(Index a, Index b, Index c) const {
    for (const Index other : remaining_) {
      const glm::dvec2& p = points_[other];
      // Corners at the same place (a hole joined by a bridge) do not stand in the way.
      if (p == points_[a] || p == points_[b] || p == points_[c]) continue;
      if (is_inside(p, points_[a], points_[b], points_[c])) return false;
    }
    return true;
  }

  std::vector<glm::dvec2> points_;
  std::vector<Index> remaining_;
};

}  // namespace

glm::dvec3 area_vector(std::span<const glm::dvec3> polygon) {
  glm::dvec3 sum(0);
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
    sum += glm::cross(polygon[i] - polygon[0], polygon[i + 1] - polygon[0]);
  }
  return 0.5 * sum;
}

std::vector<std::array<Index, 3>> triangulate_polygon(std::span<const glm::dvec3> polygon) {
  if (polygon.size() == 3) return {{0, 1, 2}};
  if (polygon.size() == 4 && starts_with_ear(polygon)) return {{3, 0, 1}, {1, 2, 3}};
  return EarCutter(flattened(polygon)).cut();
}

}  // namespace croquis::render
