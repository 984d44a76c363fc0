// SPDX-License-Identifier: GPL-3.0-or-later
// Triangulations that are the least of all by some measure, found by dynamic programming.
#include <algorithm>
#include <cstddef>
#include <numeric>
#include <tuple>
#include <utility>

#include <Eigen/Core>

#include "algorithms/hole_filling/triangulation/cancel_check.h"
#include "algorithms/hole_filling/triangulation/triangulations.h"

namespace croquis::hole_filling {
namespace {

constexpr double impossible_cost = std::numeric_limits<double>::infinity();

/// The triangles of a polygon's triangulation, each from the chord that it was chosen for to its apex and on to the
/// chords behind.
/// @param size of the polygon
/// @param apex_of the point between i and k that the triangle on the chord (i, k) has
template <typename ApexOf>
Triangles triangles_of_apexes(std::size_t size, ApexOf&& apex_of) {
  Triangles triangles;
  std::vector<std::pair<std::size_t, std::size_t>> pending = {{0, size - 1}};
  while (!pending.empty()) {
    const auto [i, k] = pending.back();
    pending.pop_back();
    if (k - i < 2) continue;
    const std::size_t j = apex_of(i, k);
    triangles.push_back({static_cast<Index>(i), static_cast<Index>(j), static_cast<Index>(k)});
    pending.emplace_back(i, j);
    pending.emplace_back(j, k);
  }
  return triangles;
}

double sum_of_squares(double x, double y, double z) { return x * x + y * y + z * z; }

/// The places in `joined` and in a loop that are nearest to each other. Quadratic.
std::pair<std::size_t, Index> shortest_bridge(const RimPolygon& rims, const std::vector<Index>& joined, Index begin,
                                              Index end) {
  std::pair<std::size_t, Index> best{0, begin};
  double shortest = impossible_cost;
  for (std::size_t i = 0; i < joined.size(); ++i) {
    for (Index point = begin; point < end; ++point) {
      const double squared = (rims.points[joined[i]] - rims.points[point]).squaredNorm();
      if (!(squared < shortest) || rims.is_blocked(joined[i], point)) continue;
      shortest = squared;
      best = {i, point};
    }
  }
  return best;
}

/// So many points have 1.3 million triangles.
constexpr std::size_t most_points_for_all = 200;

/// 1 - cos of angles that count as none (0.0001 degrees): rounding must not decide on flat rims.
constexpr double least_bend = 1e-12;

double bend_between(const Vec3& a, const Vec3& b) {
  const double bend = 1 - a.dot(b);
  return bend < least_bend ? 0 : bend;
}

/// All triangles on the sides that no candidate has: the points' Delaunay tetrahedra need not hold every side.
void add_on_missing_sides(Index size, Triangles& candidates) {
  std::vector<char> is_met(size, 0);  // the side from a point to the next
  for (const auto& [i, j, k] : candidates) {
    if (i + 1 == j) is_met[i] = 1;
    if (j + 1 == k) is_met[j] = 1;
    if (i == 0 && k + 1 == size) is_met[k] = 1;
  }
  for (Index side = 0; side < size; ++side) {
    const Index other = side + 1 == size ? 0 : side + 1;
    for (Index apex = 0; apex < size && is_met[side] == 0; ++apex) {
      if (apex == side || apex == other) continue;
      candidates.push_back({side, other, apex});
      std::ranges::sort(candidates.back());
    }
  }
}

Triangles all_triangles(Index size) {
  Triangles result;
  for (Index i = 0; i < size; ++i) {
    for (Index j = i + 1; j < size; ++j) {
      for (Index k = j + 1; k < size; ++k) result.push_back({i, j, k});
    }
  }
  return result;
}

/// The triangulation of candidates that folds least: of the polygon's parts from i to k, of longer and longer ones.
std::optional<Triangles> folding_least(const RimPolygon& polygon, std::span<const Vec3> beyond, Triangles candidates,
                                       const Progress& progress) {
  using Weight = std::pair<double, double>;  // the sum over edges of 1 - cos, then the cost
  const std::size_t size = polygon.points.size();
  std::vector<Weight> weight(size * size, {impossible_cost, impossible_cost});
  std::vector<Index> apex(size * size, no_index);
  const auto at = [&](std::size_t i, std::size_t k) { return i * size + k; };
  for (std::size_t i = 0; i + 1 < size; ++i) weight[at(i, i + 1)] = {0, 0};
  const auto normal_of = [&](Index i, Index j, Index k) -> Vec3 {
    const Vec3& from = polygon.points[i];
    return (polygon.points[j] - from).cross(polygon.points[k] - from).normalized();
  };
  const auto bend_beyond = [&](Index side, const Vec3& normal) {
    return beyond.empty() ? 0 : bend_between(normal, beyond[side]);
  };
  // Between a triangle on the chord from i to k and the part's own there, or the face beyond a side.
  const auto bend_at = [&](Index i, Index k, const Vec3& normal) {
    const Index own = apex[at(i, k)];
    return own == no_index ? bend_beyond(i, normal) : bend_between(normal, normal_of(i, own, k));
  };
  CancelCheck cancel(progress);
  std::ranges::sort(candidates, {}, [](const Triangle& t) { return std::tuple(t[2] - t[0], t[0], t[1]); });
  for (const auto& [i, j, k] : candidates) {
    cancel.step();
    const bool is_last = k - i + 1 == size;
    const Weight &before = weight[at(i, j)], &after = weight[at(j, k)];
    const double own = triangle_cost(polygon.points[i], polygon.points[j], polygon.points[k]);
    const double cost = before.second + after.second + own;
    if (cost == impossible_cost || (!is_last && polygon.is_blocked(i, k))) continue;
    const Vec3 normal = normal_of(i, j, k);
    const double last = is_last ? bend_beyond(k, normal) : 0;
    const double bend = before.first + after.first + bend_at(i, j, normal) + bend_at(j, k, normal) + last;
    if (!(Weight(bend, cost) < weight[at(i, k)])) continue;
    weight[at(i, k)] = {bend, cost};
    apex[at(i, k)] = j;
  }
  if (apex[at(0, size - 1)] == no_index) return std::nullopt;
  return triangles_of_apexes(size, [&](std::size_t i, std::size_t k) { return apex[at(i, k)]; });
}

constexpr std::size_t most_states = 4'000'000;

/// Two chains of points to be joined, each closed: its first point comes again at its end. The left one runs along its
/// rim, the right one against it. Edges join (i, j) = left[i], right[j]; a step along either side adds a triangle.
struct Band {
  const RimPolygon& rims;
  std::vector<Index> left, right;
  BandCost cost;

  std::size_t rows() const { return left.size(); }
  std::size_t columns() const { return right.size(); }
  Triangle along_left(std::size_t i, std::size_t j) const { return {left[i], left[i + 1], right[j]}; }
  Triangle along_right(std::size_t i, std::size_t j) const { return {left[i], right[j + 1], right[j]}; }

  double squared_length(std::size_t i, std::size_t j) const {
    return (rims.points[left[i]] - rims.points[right[j]]).squaredNorm();
  }

  /// Of going on to the edge (i, j) over a triangle. The first edge comes again at the end.
  double cost_of(const Triangle& t, std::size_t i, std::size_t j) const {
    const bool is_end = i + 1 == rows() && j + 1 == columns();
    if (rims.is_blocked(left[i], right[j]) && !is_end) return impossible_cost;
    const double area = triangle_cost(rims.points[t[0]], rims.points[t[1]], rims.points[t[2]]);
    return cost == BandCost::Area || area == impossible_cost ? area : squared_length(i, j);
  }
};

/// cost(i,j) = min(cost(i-1,j), cost(i,j-1)) + the triangle.
std::optional<Triangles> cheapest_band(const Band& band, Progress& progress) {
  const std::size_t rows = band.rows(), columns = band.columns();
  std::vector<double> best(rows * columns, impossible_cost);
  std::vector<std::uint8_t> came_along_left(rows * columns, 0);
  best[0] = 0;
  for (std::size_t i = 0; i < rows; ++i) {
    progress.check();
    for (std::size_t j = 0; j < columns; ++j) {
      const std::size_t at = i * columns + j;
      if (i > 0) best[at] = best[at - columns] + band.cost_of(band.along_left(i - 1, j), i, j);
      came_along_left[at] = best[at] < impossible_cost ? 1 : 0;
      if (j == 0) continue;
      const double other = best[at - 1] + band.cost_of(band.along_right(i, j - 1), i, j);
      if (!(other < best[at]) && !(i == 0)) continue;
      best[at] = other;
      came_along_left[at] = 0;
    }
  }
  if (!(best.back() < impossible_cost)) return std::nullopt;
  Triangles triangles;
  std::size_t i = rows - 1, j = columns - 1;
  while (i + j > 0) {
    const bool on_left = came_along_left[i * columns + j] != 0;
    --(on_left ? i : j);
    triangles.push_back(on_left ? band.along_left(i, j) : band.along_right(i, j));
  }
  return triangles;
}

/// Going on with the shorter edge each time.
std::optional<Triangles> greedy_band(const Band& band) {
  const std::size_t rows = band.rows(), columns = band.columns();
  Triangles triangles;
  std::size_t i = 0, j = 0;
  while (i + j + 2 < rows + columns) {
    const double on_left = i + 1 < rows ? band.cost_of(band.along_left(i, j), i + 1, j) : impossible_cost;
    const double on_right = j + 1 < columns ? band.cost_of(band.along_right(i, j), i, j + 1) : impossible_cost;
    if (on_left == impossible_cost && on_right == impossible_cost) return std::nullopt;
    const bool goes_left =
        on_right == impossible_cost ||
        (on_left < impossible_cost && band.squared_length(i + 1, j) <= band.squared_length(i, j + 1));
    triangles.push_back(goes_left ? band.along_left(i, j) : band.along_right(i, j));
    ++(goes_left ? i : j);
  }
  return triangles;
}

}  // namespace

MinimalTriangulations::MinimalTriangulations(const RimPolygon& rims, std::vector<Index> order)
    : rims_(rims),
      order_(std::move(order)),
      size_(order_.size()),
      between_(size_, 0),
      squares_(size_, 0),
      flat_(size_, 0),
      cost_(size_ * size_, impossible_cost),
      apex_(size_ * size_, 0) {
  for (const Index point : order_) {
    for (std::size_t axis = 0; axis < 3; ++axis)
      points_[axis].push_back(rims.points[point][static_cast<Eigen::Index>(axis)]);
  }
  for (std::size_t i = 0; i + 1 < size_; ++i) cost_[at(i, i + 1)] = cost_[at(i + 1, i)] = 0;
}

std::optional<Triangles> MinimalTriangulations::next(Progress& progress) {
  has_grown_.assign(size_ * size_, 0);
  for (std::size_t span = 2; span < size_; ++span) {
    progress.check();
    for (std::size_t i = 0; i + span < size_; ++i) {
      const std::size_t part = at(i, i + span);
      const double before = cost_[part];
      if (!is_first_ && !may_have_changed(i, i + span)) continue;
      choose_apex(i, i + span);
      has_grown_[part] = cost_[part] > before ? 1 : 0;
    }
  }
  is_first_ = false;
  if (size_ < 3 || !(cost_[at(0, size_ - 1)] < impossible_cost)) return std::nullopt;
  Triangles triangles = triangles_of_apexes(size_, [&](std::size_t i, std::size_t k) { return apex_[at(i, k)]; });
  for (Triangle& t : triangles) {
    for (Index& corner : t) corner = order_[corner];
  }
  return triangles;
}

/// Costs only grow as more triangles are avoided: where the best triangle is neither avoided nor costs more than
/// before, it is still the best.
bool MinimalTriangulations::may_have_changed(std::size_t i, std::size_t k) const {
  const std::size_t j = apex_[at(i, k)];
  if (cost_[at(i, k)] == impossible_cost) return false;
  return has_grown_[at(i, j)] != 0 || has_grown_[at(j, k)] != 0 || is_avoided(i, j, k);
}

/// Sides of the polygon may be edges of the mesh, chords must not be.
bool MinimalTriangulations::may_join(std::size_t i, std::size_t k) const {
  if (k == i + 1 || (i == 0 && k + 1 == size_)) return true;
  return order_[i] != order_[k] && !rims_.is_blocked(order_[i], order_[k]);
}

bool MinimalTriangulations::is_avoided(std::size_t i, std::size_t j, std::size_t k) const {
  if (rims_.avoided.empty()) return false;
  Triangle triangle = {order_[i], order_[j], order_[k]};
  std::ranges::sort(triangle);
  return std::ranges::binary_search(rims_.avoided, triangle);
}

/// Those from i over each point between them to k, bit by bit as triangle_cost has them. Plain loops over arrays: done
/// two or four at a time.
void MinimalTriangulations::measure_triangles(std::size_t i, std::size_t k) {
  const double *x = points_[0].data(), *y = points_[1].data(), *z = points_[2].data();
  const double x0 = x[i], y0 = y[i], z0 = z[i];
  const double cx = x[k] - x0, cy = y[k] - y0, cz = z[k] - z0;
  const double c_square = sum_of_squares(cx, cy, cz);
  double *areas = between_.data(), *squares = squares_.data(), *flat = flat_.data();
#pragma GCC ivdep
  for (std::size_t j = i + 1; j < k; ++j) {
    const double bx = x[j] - x0, by = y[j] - y0, bz = z[j] - z0;
    areas[j] = sum_of_squares(by * cz - bz * cy, bz * cx - bx * cz, bx * cy - by * cx);
    const double b_square = sum_of_squares(bx, by, bz), a_square = sum_of_squares(cx - bx, cy - by, cz - bz);
    const double two = b_square < c_square ? c_square : b_square;
    flat[j] = least_flatness * (two < a_square ? a_square : two);
    squares[j] = b_square + c_square + a_square;
  }
  Eigen::Map<Eigen::ArrayXd> twice_areas(&between_[i + 1], static_cast<Eigen::Index>(k - i - 1));
  twice_areas = twice_areas.sqrt();
  for (std::size_t j = i + 1; j < k; ++j)
    between_[j] = between_[j] > flat_[j] ? between_[j] + edge_weight * squares_[j] : impossible_cost;
}

void MinimalTriangulations::choose_apex(std::size_t i, std::size_t k) {
  if (!may_join(i, k)) return;
  measure_triangles(i, k);
  const double* before = &cost_[at(i, 0)];
  const double* after = &cost_[at(k, 0)];
  double best = impossible_cost;
  for (std::size_t j = i + 1; j < k; ++j) {
    const double total = before[j] + after[j] + between_[j];
    if (!(total < best) || is_avoided(i, j, k)) continue;
    best = total;
    apex_[at(i, k)] = static_cast<std::uint32_t>(j);
  }
  cost_[at(i, k)] = cost_[at(k, i)] = best;
}

std::vector<Index> bridged_order(const RimPolygon& rims) {
  std::vector<Index> joined(rims.loop_ends.front());
  std::iota(joined.begin(), joined.end(), Index{0});
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

std::optional<Triangles> dihedral_triangulation(const RimPolygon& polygon, std::span<const Vec3> beyond,
                                                Triangles candidates, Progress& progress) {
  const auto size = static_cast<Index>(polygon.points.size());
  if (size < 3) return std::nullopt;
  progress.check();
  add_on_missing_sides(size, candidates);
  auto triangles = folding_least(polygon, beyond, std::move(candidates), progress);
  if (triangles || size > most_points_for_all) return triangles;
  progress.check();
  return folding_least(polygon, beyond, all_triangles(size), progress);
}

std::optional<Triangles> band_triangulation(const RimPolygon& rims, BandCost cost, Progress& progress) {
  if (rims.loop_count() != 2) return std::nullopt;
  const Index first = rims.loop_ends[0], second = rims.loop_ends[1] - first;
  std::vector<Index> outer(first);
  std::iota(outer.begin(), outer.end(), Index{0});
  const auto [a, b] = shortest_bridge(rims, outer, first, rims.loop_ends[1]);
  Band band{rims, {}, {}, cost};
  for (Index i = 0; i <= first; ++i) band.left.push_back((static_cast<Index>(a) + i) % first);
  for (Index j = 0; j <= second; ++j) band.right.push_back(first + (b - first + second - j % second) % second);
  return band.rows() * band.columns() > most_states ? greedy_band(band) : cheapest_band(band, progress);
}

}  // namespace croquis::hole_filling
