// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/hole_filling/triangulation/minimal_triangulation.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <utility>

#include <Eigen/Core>

#include "algorithms/hole_filling/triangulation/apex_table.h"
#include "algorithms/hole_filling/triangulation/cancel_check.h"
#include "algorithms/hole_filling/triangulation/triangle_cost.h"

namespace croquis::hole_filling {
namespace {

constexpr double no_area = std::numeric_limits<double>::infinity();

/// The costs of many triangles on one edge, bit by bit those of triangle_cost.
class TriangleCosts {
 public:
  void add(const Vec3& point) {
    for (std::size_t axis = 0; axis < 3; ++axis) points_[axis].push_back(point[static_cast<Eigen::Index>(axis)]);
    areas_.push_back(0);
    squares_.push_back(0);
    flat_.push_back(0);
  }

  /// Of the triangles from i over each point between them to k. Valid until the next call.
  std::span<const double> costs(std::size_t i, std::size_t k) {
    const auto size = static_cast<Eigen::Index>(k - i - 1);
    measure(i, k);
    Eigen::Map<Eigen::ArrayXd> areas(&areas_[i + 1], size);
    areas = areas.sqrt();
    for (std::size_t j = i + 1; j < k; ++j)
      areas_[j] = areas_[j] > flat_[j] ? areas_[j] + edge_weight * squares_[j] : no_area;
    return areas_;
  }

 private:
  /// Squared areas (twice) and sums of squared edges. Plain loops over arrays: done two or four at a time.
  void measure(std::size_t i, std::size_t k) {
    const double *x = points_[0].data(), *y = points_[1].data(), *z = points_[2].data();
    const double x0 = x[i], y0 = y[i], z0 = z[i];
    const double cx = x[k] - x0, cy = y[k] - y0, cz = z[k] - z0;
    const double c_square = square(cx, cy, cz);
    double *areas = areas_.data(), *squares = squares_.data(), *flat = flat_.data();
#pragma GCC ivdep
    for (std::size_t j = i + 1; j < k; ++j) {
      const double bx = x[j] - x0, by = y[j] - y0, bz = z[j] - z0;
      areas[j] = square(by * cz - bz * cy, bz * cx - bx * cz, bx * cy - by * cx);
      const double b_square = square(bx, by, bz), a_square = square(cx - bx, cy - by, cz - bz);
      const double two = b_square < c_square ? c_square : b_square;
      flat[j] = least_flatness * (two < a_square ? a_square : two);
      squares[j] = b_square + c_square + a_square;
    }
  }

  static double square(double x, double y, double z) { return x * x + y * y + z * z; }

  std::array<std::vector<double>, 3> points_;   ///< per axis
  std::vector<double> areas_, squares_, flat_;  ///< per point between
};

/// The places in `joined` and in a loop that are nearest to each other.
std::pair<std::size_t, Index> shortest_bridge(const RimPolygon& rims, const std::vector<Index>& joined, Index begin,
                                              Index end) {
  std::pair<std::size_t, Index> best{0, begin};
  double shortest = no_area;
  for (std::size_t i = 0; i < joined.size(); ++i) {
    for (Index point = begin; point < end; ++point) {
      const double squared = (rims.points[joined[i]] - rims.points[point]).squaredNorm();
      if (squared < shortest && !rims.is_blocked(joined[i], point)) {
        shortest = squared;
        best = {i, point};
      }
    }
  }
  return best;
}

}  // namespace

class MinimalTriangulations::Table {
 public:
  Table(const RimPolygon& rims, std::vector<Index> order)
      : rims_(rims),
        order_(std::move(order)),
        size_(order_.size()),
        cost_(size_ * size_, no_area),
        apex_(size_ * size_, 0) {
    for (const Index point : order_) corners_.add(rims.points[point]);
  }

  bool is_filled() const { return cost_[at(0, 1)] == 0; }

  /// @return whether there is a triangulation
  bool fill(Progress& progress) {
    for (std::size_t i = 0; i + 1 < size_; ++i) cost_[at(i, i + 1)] = cost_[at(i + 1, i)] = 0;
    for (std::size_t span = 2; span < size_; ++span) {
      progress.check();
      for (std::size_t i = 0; i + span < size_; ++i) choose_apex(i, i + span);
    }
    return cost_[at(0, size_ - 1)] < no_area;
  }

  /// After more triangles are avoided. Costs only grow by that: where the best triangle is neither avoided nor costs
  /// more than before, it is still the best. @return as fill
  bool update(Progress& progress) {
    grown_.assign(size_ * size_, 0);
    for (std::size_t span = 2; span < size_; ++span) {
      progress.check();
      for (std::size_t i = 0; i + span < size_; ++i) {
        const std::size_t k = i + span, j = apex_[at(i, k)];
        const double before = cost_[at(i, k)];
        if (before == no_area) continue;
        if (grown_[at(i, j)] == 0 && grown_[at(j, k)] == 0 && !is_avoided(i, j, k)) continue;
        choose_apex(i, k);
        grown_[at(i, k)] = cost_[at(i, k)] > before ? 1 : 0;
      }
    }
    return cost_[at(0, size_ - 1)] < no_area;
  }

  std::vector<std::array<Index, 3>> triangles() const {
    auto result = triangles_of_apexes(size_, [&](std::size_t i, std::size_t k) { return apex_[at(i, k)]; });
    for (std::array<Index, 3>& t : result) {
      for (Index& corner : t) corner = order_[corner];
    }
    return result;
  }

 private:
  std::size_t at(std::size_t i, std::size_t k) const { return i * size_ + k; }

  /// Sides of the polygon may be edges of the mesh, chords must not be.
  bool may_join(std::size_t i, std::size_t k) const {
    if (k == i + 1 || (i == 0 && k + 1 == size_)) return true;
    return order_[i] != order_[k] && !rims_.is_blocked(order_[i], order_[k]);
  }

  bool is_avoided(std::size_t i, std::size_t j, std::size_t k) const {
    if (rims_.avoided.empty()) return false;
    std::array<Index, 3> triangle = {order_[i], order_[j], order_[k]};
    std::sort(triangle.begin(), triangle.end());
    return std::binary_search(rims_.avoided.begin(), rims_.avoided.end(), triangle);
  }

  void choose_apex(std::size_t i, std::size_t k) {
    if (!may_join(i, k)) return;
    const std::span<const double> triangles = corners_.costs(i, k);
    const double* before = &cost_[at(i, 0)];
    const double* after = &cost_[at(k, 0)];
    double best = no_area;
    for (std::size_t j = i + 1; j < k; ++j) {
      const double total = before[j] + after[j] + triangles[j];
      if (!(total < best) || is_avoided(i, j, k)) continue;
      best = total;
      apex_[at(i, k)] = static_cast<std::uint32_t>(j);
    }
    cost_[at(i, k)] = cost_[at(k, i)] = best;
  }

  const RimPolygon& rims_;
  std::vector<Index> order_;
  std::size_t size_;
  TriangleCosts corners_;
  std::vector<double> cost_;         ///< of the part from i to k, at (i, k) and (k, i): both are read row by row
  std::vector<std::uint32_t> apex_;  ///< the third corner of the triangle on (i, k)
  std::vector<char> grown_;          ///< whether the cost is higher than before the update
};

MinimalTriangulations::MinimalTriangulations(const RimPolygon& rims, std::vector<Index> order)
    : table_(std::make_unique<Table>(rims, std::move(order))) {}

MinimalTriangulations::~MinimalTriangulations() = default;

std::optional<std::vector<std::array<Index, 3>>> MinimalTriangulations::next(Progress& progress) {
  const bool is_found = table_->is_filled() ? table_->update(progress) : table_->fill(progress);
  if (!is_found) return std::nullopt;
  return table_->triangles();
}

std::optional<std::vector<std::array<Index, 3>>> minimal_triangulation(const RimPolygon& rims,
                                                                       std::span<const Index> order,
                                                                       Progress& progress) {
  if (order.size() < 3) return std::nullopt;
  return MinimalTriangulations(rims, {order.begin(), order.end()}).next(progress);
}

std::vector<Index> bridged_order(const RimPolygon& rims) {
  std::vector<Index> joined;
  for (Index point = 0; point < rims.loop_ends.front(); ++point) joined.push_back(point);
  for (std::size_t loop = 1; loop < rims.loop_count(); ++loop) {
    const Index begin = rims.loop_ends[loop - 1];
    const Index end = rims.loop_ends[loop];
    const auto [place, landing] = shortest_bridge(rims, joined, begin, end);
    std::vector<Index> detour;
    for (Index step = 0; step <= end - begin; ++step)
      detour.push_back(begin + (landing - begin + step) % (end - begin));
    // Loops that share a vertex are joined there, without a bridge there and back.
    if (rims.points[joined[place]] == rims.points[landing])
      detour.erase(detour.begin());
    else
      detour.push_back(joined[place]);
    joined.insert(joined.begin() + static_cast<std::ptrdiff_t>(place) + 1, detour.begin(), detour.end());
  }
  return joined;
}

}  // namespace croquis::hole_filling
