// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/strokes/covered_runs.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "algorithms/silhouette/strokes/segment_grid.h"
#include "croquis/geometry/polyline.h"

namespace croquis::silhouette {
namespace {

// Samples on the wrong side are moved to this share of the tremble on the right one.
constexpr double moved_share = 0.5;

struct SidedRun {
  double begin = 0;
  double end = 0;
  bool inside = false;
  double reach = 0;  ///< how far it gets away from the cover, counted up to twice the tremble
};

struct NearestPlace {
  double distance = std::numeric_limits<double>::infinity();
  Vec2 at = Vec2::Zero();
  Vec2 direction = Vec2::Zero();  ///< of the cover there, unit
};

class RunSearch {
 public:
  RunSearch(CleanLine& line, const CleanLine& cover, double tremble, double step)
      : line_(line), cover_(cover), tremble_(tremble), grid_(line_segments({cover}), step) {}

  std::vector<LineRun> find() {
    const std::vector<double> crossings = crossing_parameters();
    if (crossings.empty()) {
      move_aside({0, static_cast<double>(line_.segment_count()), false, 0}, encloses(cover_, line_.points.front()));
      return {};
    }
    const std::vector<SidedRun> drawn = runs_between(crossings);
    const std::vector<SidedRun> meant = without_tremble(drawn);
    for (const SidedRun& run : drawn) {
      const bool inside = side_at(meant, 0.5 * (run.begin + run.end));
      if (inside != run.inside) move_aside(run, inside);
    }
    std::vector<LineRun> covered;
    if (meant.size() < 2) return covered;
    for (const SidedRun& run : meant) {
      if (run.inside) covered.push_back({run.begin, run.end});
    }
    return covered;
  }

 private:
  std::vector<double> crossing_parameters() const {
    std::vector<double> parameters;
    for (Index i = 0; i < line_.segment_count(); ++i) {
      const Vec2& a = line_.points[i];
      const Vec2& b = line_.points[(i + 1) % line_.points.size()];
      grid_.near_box(a.cwiseMin(b), a.cwiseMax(b), [&](Index j) {
        const GridSegment& other = grid_.segments()[j];
        if (cross_properly(a, b, other.a, other.b)) parameters.push_back(i + crossing_fraction(a, b, other.a, other.b));
      });
    }
    std::sort(parameters.begin(), parameters.end());
    return parameters;
  }

  /// Sides alternate; the longest run tells which it is.
  std::vector<SidedRun> runs_between(const std::vector<double>& crossings) const {
    std::vector<SidedRun> runs;
    const double last = line_.segment_count();
    // A closed line can't enter another one more often than it leaves it, unless one of them crosses itself.
    if (line_.closed && crossings.size() % 2 != 0) return runs;
    if (!line_.closed) runs.push_back({0, crossings.front()});
    for (std::size_t k = 0; k + 1 < crossings.size(); ++k) runs.push_back({crossings[k], crossings[k + 1]});
    runs.push_back({crossings.back(), line_.closed ? crossings.front() + last : last});
    const auto longest = std::max_element(runs.begin(), runs.end(), [](const SidedRun& a, const SidedRun& b) {
      return a.end - a.begin < b.end - b.begin;
    });
    const bool inside = encloses(cover_, place(0.5 * (longest->begin + longest->end)));
    for (auto run = runs.begin(); run != runs.end(); ++run) {
      run->inside = inside == ((run - longest) % 2 == 0);
      run->reach = reach_of(*run);
    }
    return runs;
  }

  Vec2 place(double parameter) const {
    const double count = line_.segment_count();
    return point_at(line_.points, parameter >= count && line_.closed ? parameter - count : parameter);
  }

  NearestPlace nearest(const Vec2& point, double reach) const {
    NearestPlace best;
    const Vec2 box = Vec2::Constant(reach);
    grid_.near_box(point - box, point + box, [&](Index i) {
      const GridSegment& s = grid_.segments()[i];
      const Vec2 at = s.a + nearest_parameter(point, s.a, s.b) * (s.b - s.a);
      const double distance = (at - point).norm();
      if (distance < best.distance) best = {distance, at, (s.b - s.a).normalized()};
    });
    return best;
  }

  double reach_of(const SidedRun& run) const {
    double reach = 0;
    const auto count = static_cast<Index>(line_.points.size());
    for (auto i = static_cast<Index>(std::ceil(run.begin)); i <= run.end && reach < 2 * tremble_; ++i) {
      reach = std::max(reach, std::min(2 * tremble_, nearest(line_.points[i % count], 2 * tremble_).distance));
    }
    return reach;
  }

  /// Joins the least of the runs that are too shallow with its neighbours, until none is left.
  std::vector<SidedRun> without_tremble(std::vector<SidedRun> runs) const {
    while (runs.size() > 1) {
      const auto least = std::min_element(runs.begin(), runs.end(),
                                          [](const SidedRun& a, const SidedRun& b) { return a.reach < b.reach; });
      if (least->reach >= tremble_) break;
      join_neighbours(runs, static_cast<std::size_t>(least - runs.begin()));
    }
    return runs;
  }

  void join_neighbours(std::vector<SidedRun>& runs, std::size_t k) const {
    if (runs.size() == 2) {
      runs[1 - k].begin = std::min(runs[0].begin, runs[1].begin);
      runs[1 - k].end = std::max(runs[0].end, runs[1].end);
      runs.erase(runs.begin() + static_cast<std::ptrdiff_t>(k));
      return;
    }
    // A closed line's runs go round: the one to be joined is brought into the middle.
    if (line_.closed && k == 0) {
      runs.back().begin -= line_.segment_count();
      runs.back().end -= line_.segment_count();
      std::rotate(runs.begin(), runs.end() - 1, runs.end());
      k = 1;
    } else if (line_.closed && k + 1 == runs.size()) {
      runs.front().begin += line_.segment_count();
      runs.front().end += line_.segment_count();
      std::rotate(runs.begin(), runs.begin() + 1, runs.end());
      --k;
    }
    const std::size_t first = k == 0 ? 0 : k - 1;
    const std::size_t last = std::min(k + 1, runs.size() - 1);
    SidedRun joined{runs[first].begin, runs[last].end, !runs[k].inside, 0};
    for (std::size_t i = first; i <= last; ++i) {
      if (i != k) joined.reach = std::max(joined.reach, runs[i].reach);
    }
    runs.erase(runs.begin() + static_cast<std::ptrdiff_t>(first), runs.begin() + static_cast<std::ptrdiff_t>(last + 1));
    runs.insert(runs.begin() + static_cast<std::ptrdiff_t>(first), joined);
  }

  bool side_at(const std::vector<SidedRun>& runs, double parameter) const {
    const double count = line_.closed ? line_.segment_count() : 0;
    for (const SidedRun& run : runs) {
      for (const double shift : {-count, 0.0, count}) {
        if (parameter + shift >= run.begin && parameter + shift <= run.end) return run.inside;
      }
    }
    return runs.front().inside;
  }

  /// Moves the samples of a run, and those next to it, to one side of the cover. Ends of open lines stay on their bars.
  void move_aside(const SidedRun& run, bool inside) {
    const auto count = static_cast<std::ptrdiff_t>(line_.points.size());
    const double turn = signed_area(cover_.points) > 0 ? 1 : -1;
    const double distance = moved_share * tremble_;
    const auto last = static_cast<std::ptrdiff_t>(std::ceil(run.end));
    for (auto i = static_cast<std::ptrdiff_t>(std::floor(run.begin)); i <= last; ++i) {
      if (!line_.closed && (i <= 0 || i + 1 >= count)) continue;
      Vec2& point = line_.points[static_cast<std::size_t>((i % count + count) % count)];
      const NearestPlace close = nearest(point, 2 * tremble_);
      const bool right_side = encloses(cover_, point) == inside;
      if (!std::isfinite(close.distance) || (right_side && close.distance >= distance)) continue;
      point = close.at + (inside ? turn : -turn) * distance * left_of(close.direction);
    }
  }

  CleanLine& line_;
  const CleanLine& cover_;
  double tremble_;
  SegmentGrid grid_;
};

}  // namespace

std::vector<LineRun> covered_runs(CleanLine& line, const CleanLine& cover, double tremble, double step) {
  return RunSearch(line, cover, tremble, step).find();
}

bool encloses(const CleanLine& closed, const Vec2& place) {
  bool inside = false;
  const Points& loop = closed.points;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Vec2& a = loop[i];
    const Vec2& b = loop[(i + 1) % loop.size()];
    if ((a.y() > place.y()) == (b.y() > place.y())) continue;
    const bool upwards = b.y() > a.y();
    if ((orientation(a, b, place) > 0) == upwards) inside = !inside;
  }
  return inside;
}

}  // namespace croquis::silhouette
