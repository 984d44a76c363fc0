// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/geometry/polygon_cut.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <queue>
#include <tuple>

#include <Eigen/Geometry>

#include "croquis/geometry/polygon_area.h"
#include "croquis/geometry/predicates.h"

namespace croquis {
namespace {

constexpr double equal_lengths = 1e-3;  // relative, of squared lengths
constexpr double flat_share = 1e-6;     // of a quad's area: a part below has none
constexpr double flat_sine = 1e-4;      // of the turn at a corner: an ear below is a sliver

/// How good an ear is; less is better.
struct Ear {
  bool avoided;
  int fault;        ///< 0: sound, 1: a sliver, 2: not inside the polygon
  int length;       ///< of its diagonal, rounded on a scale of logarithms
  Index low, high;  ///< the diagonal's vertices
  Index tip;        ///< a corner
  Index version;

  auto key() const { return std::tie(avoided, fault, length, low, high, tip); }
  bool operator>(const Ear& other) const { return key() > other.key(); }
};

class EarCutting {
 public:
  EarCutting(std::span<const Vec3> positions, std::span<const Index> polygon,
             const std::function<bool(Index, Index)>& avoid)
      : positions_(positions),
        polygon_(polygon),
        avoid_(avoid),
        next_(polygon.size()),
        previous_(polygon.size()),
        version_(polygon.size(), 0) {
    const Vec3 normal = area_normal(positions, polygon).normalized();
    const Vec3 u = normal.isZero() || !normal.allFinite() ? Vec3::Zero() : normal.unitOrthogonal();
    const Vec3 v = normal.cross(u);
    const auto count = static_cast<Index>(polygon.size());
    for (Index i = 0; i < count; ++i) {
      const Vec3 offset = place(i) - place(0);
      flat_.emplace_back(offset.dot(u), offset.dot(v));
      next_[i] = i + 1 == count ? 0 : i + 1;
      previous_[i] = i == 0 ? count - 1 : i - 1;
      scale_ += (place(i) - place(previous_[i] % count)).squaredNorm();
    }
    for (Index i = 0; i < count; ++i) {
      if (turn(i) <= 0) reflex_.push_back(i);
    }
    for (Index i = 0; i < count; ++i) offer(i);
  }

  std::vector<std::array<Index, 3>> run() {
    std::vector<std::array<Index, 3>> triangles;
    while (triangles.size() + 2 < polygon_.size()) {
      const Ear ear = ears_.top();
      ears_.pop();
      if (ear.version != version_[ear.tip]) continue;
      const Index before = previous_[ear.tip], after = next_[ear.tip];
      triangles.push_back({before, ear.tip, after});
      next_[before] = after;
      previous_[after] = before;
      ++version_[ear.tip];
      std::erase_if(reflex_, [&](Index i) { return i == ear.tip || ((i == before || i == after) && turn(i) > 0); });
      offer(before);
      offer(after);
    }
    return triangles;
  }

 private:
  const Vec3& place(Index corner) const { return positions_[polygon_[corner]]; }

  int turn(Index corner) const { return orientation(flat_[previous_[corner]], flat_[corner], flat_[next_[corner]]); }

  /// Only corners that turn to the right, or not at all, can be the first to enter an ear.
  bool is_free(const Vec2& a, const Vec2& b, const Vec2& c) const {
    const Vec2 low = a.cwiseMin(b).cwiseMin(c), high = a.cwiseMax(b).cwiseMax(c);
    return std::ranges::none_of(reflex_, [&](Index other) {
      const Vec2& p = flat_[other];
      if ((p.array() < low.array()).any() || (p.array() > high.array()).any()) return false;
      if (p == a || p == b || p == c) return false;  // where a bridge leads to a hole
      return orientation(a, b, p) >= 0 && orientation(b, c, p) >= 0 && orientation(c, a, p) >= 0;
    });
  }

  int fault_of(Index tip) const {
    const Vec2 &a = flat_[previous_[tip]], &b = flat_[tip], &c = flat_[next_[tip]];
    if (turn(tip) <= 0 || !is_free(a, b, c)) return 2;
    return cross(b - a, c - b) > flat_sine * (b - a).norm() * (c - b).norm() ? 0 : 1;
  }

  void offer(Index tip) {
    const Index before = previous_[tip], after = next_[tip];
    const double ratio = (place(after) - place(before)).squaredNorm() / scale_;
    const int length = ratio > 0 ? static_cast<int>(std::lround(std::log(ratio) / equal_lengths)) : 0;
    const auto [low, high] = std::minmax(polygon_[before], polygon_[after]);
    ears_.push({avoid_ && avoid_(low, high), fault_of(tip), length, low, high, tip, ++version_[tip]});
  }

  std::span<const Vec3> positions_;
  std::span<const Index> polygon_;
  const std::function<bool(Index, Index)>& avoid_;
  std::vector<Vec2> flat_;
  double scale_ = 0;  ///< the sides' squared lengths
  std::vector<Index> next_, previous_, version_, reflex_;
  std::priority_queue<Ear, std::vector<Ear>, std::greater<>> ears_;
};

}  // namespace

std::size_t quad_cut(std::span<const Vec3> positions, std::span<const Index> quad) {
  const Vec3 &a = positions[quad[0]], &b = positions[quad[1]], &c = positions[quad[2]], &d = positions[quad[3]];
  const Vec3 first = c - a, second = d - b;
  const Vec3 normal = first.cross(second);
  // The share of the area that a diagonal cuts off on one side; both sides are positive where it lies inside.
  const double area = normal.squaredNorm();
  const double beside_first = (b - a).cross(first).dot(normal), beside_second = (c - b).cross(second).dot(normal);
  const auto is_inside = [&](double part) { return part > flat_share * area && part < (1 - flat_share) * area; };
  if (is_inside(beside_first) != is_inside(beside_second)) return is_inside(beside_first) ? 0 : 1;
  const double difference = first.squaredNorm() - second.squaredNorm();
  if (std::abs(difference) > equal_lengths * std::max(first.squaredNorm(), second.squaredNorm()))
    return difference < 0 ? 0 : 1;
  return std::min(quad[0], quad[2]) <= std::min(quad[1], quad[3]) ? 0 : 1;
}

std::vector<std::array<Index, 3>> polygon_cut(std::span<const Vec3> positions, std::span<const Index> polygon,
                                              const std::function<bool(Index, Index)>& avoid) {
  return EarCutting(positions, polygon, avoid).run();
}

MeshTriangles mesh_triangles(std::span<const Vec3> positions, const PolyMesh& mesh) {
  MeshTriangles result;
  result.corners.reserve(mesh.corners.size());
  result.faces.reserve(mesh.corners.size());
  for (Index f = 0; f < mesh.face_count(); ++f) {
    const Index first = mesh.face_offsets[f];
    visit_triangles(positions, mesh.face(f), [&](const std::array<Index, 3>& t) {
      result.corners.push_back({first + t[0], first + t[1], first + t[2]});
      result.faces.push_back(f);
    });
  }
  return result;
}

}  // namespace croquis
