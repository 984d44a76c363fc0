// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/perspective/coordinates/contradiction_search.h"

#include <algorithm>
#include <limits>
#include <tuple>
#include <utility>

#include <Eigen/Geometry>

#include "algorithms/perspective/camera/sheet_frame.h"

namespace croquis {
namespace {

/// What is as good as normal, in sigma per degree of freedom.
constexpr double normal_rms = 2.5;

/// A vertex must be so much better off than all its strokes before it is taken for two.
constexpr double split_advantage = 0.25;

/// A lone contradiction is believed when leaving out its stroke takes away so much of the squares.
constexpr double lone_share = 0.5;

/// A stroke that misses its vanishing point by so many sigma is of the wrong colour, or drawn badly.
constexpr double misdirection = 5;

/// Leaving out a wrong stroke leaves at most this part of the residuals.
constexpr double least_help = 0.97;

/// In drawings of more strokes only those are left out in earnest that a quick look finds best: so many of all, and so
/// many of those that don't point where their group says.
constexpr std::size_t many_strokes = 120;
constexpr std::size_t looked_at = 24;
constexpr int quick_rounds = 2;

bool ties_something(const CoordinateTies& ties, std::size_t stroke) {
  return ties.groups[stroke] != StrokeGroup::Unknown && ties.of_stroke[stroke][0] != no_index &&
         ties.of_stroke[stroke][1] != no_index;
}

SolvedVertices solved_with_group(TiedVertices& tied, Index stroke, StrokeGroup group) {
  const StrokeGroup before = tied.ties.groups[stroke];
  tied.ties.groups[stroke] = group;
  SolvedVertices result = solved(tied);
  tied.ties.groups[stroke] = before;
  return result;
}

/// Infinite where vertices would lie behind the eye or at one place.
double rms_with_group(TiedVertices& tied, Index stroke, StrokeGroup group) {
  const SolvedVertices result = solved_with_group(tied, stroke, group);
  const bool possible = result.solution.in_front && !has_coincident_vertices(result.table);
  return possible ? result.solution.rms_of_freedom() : std::numeric_limits<double>::infinity();
}

/// Equal ones by place: the order of the drawing means nothing.
void sort_by_rms(const CoordinateTies& ties, std::vector<StrokeSuspicion>& ranking) {
  const auto order = [&](const StrokeSuspicion& suspicion) {
    const std::array<Index, 2>& ends = ties.of_stroke[suspicion.stroke];
    return std::tuple(suspicion.rms, std::min(ends[0], ends[1]), std::max(ends[0], ends[1]));
  };
  std::stable_sort(ranking.begin(), ranking.end(),
                   [&](const StrokeSuspicion& a, const StrokeSuspicion& b) { return order(a) < order(b); });
}

class ContradictionSearch {
 public:
  ContradictionSearch(TiedVertices& tied, std::span<const StrokeGroup> drawn, double sigma,
                      const PerspectiveDrawing& drawing, const DrawingVertices& vertices,
                      const CoordinateOptions& options)
      : tied_(tied),
        drawn_(drawn),
        drawing_(drawing),
        vertices_(vertices),
        options_(options),
        sigma_(std::max(sigma, options.contradiction_noise)) {}

  std::vector<Contradiction> run(Progress& progress) {
    std::vector<Contradiction> found;
    for (int round = 0; round < 2 * options_.most_contradictions; ++round) {
      progress.report(0.5 * round / (2 * options_.most_contradictions));
      const SolvedVertices now = solved(tied_);
      if (!is_suspicious(now)) break;
      const std::vector<StrokeSuspicion> ranking = ranked_strokes(tied_, suspects(now, progress), progress);
      if (ranking.empty()) break;
      const StrokeSuspicion worst = most_suspicious(now, ranking);
      if (!is_wrong(now, worst)) break;
      if (tied_.ties.groups[worst.stroke] != drawn_[worst.stroke]) {
        tied_.ties.groups[worst.stroke] = drawn_[worst.stroke];  // it was promoted by mistake
        continue;
      }
      if (static_cast<int>(found.size()) == options_.most_contradictions) break;
      found.push_back(contradiction(worst));
      tied_.ties.groups[worst.stroke] = StrokeGroup::Unknown;
    }
    return found;
  }

 private:
  bool is_suspicious(const SolvedVertices& now) const {
    return now.solution.rms() > options_.contradiction * sigma_ ||
           now.solution.worst() > options_.lone_contradiction * sigma_ || has_coincident_vertices(now.table);
  }

  /// The strokes to be left out one by one.
  std::vector<Index> suspects(const SolvedVertices& now, Progress& progress) {
    const std::vector<Index> all = tying_strokes(tied_.ties);
    if (all.size() <= many_strokes || !now.solution.in_front) return all;
    const std::vector<Vec3> near = now.positions();
    std::vector<StrokeSuspicion> quick;
    for (const Index stroke : all) {
      progress.check();
      const StrokeGroup group = std::exchange(tied_.ties.groups[stroke], StrokeGroup::Unknown);
      quick.push_back({stroke, solved(tied_, &near, quick_rounds).solution.rms_of_freedom()});
      tied_.ties.groups[stroke] = group;
    }
    sort_by_rms(tied_.ties, quick);
    std::vector<Index> best;
    std::size_t plain = 0, misdirected = 0;
    for (const StrokeSuspicion& suspicion : quick) {
      std::size_t& count = is_misdirected(suspicion.stroke) ? misdirected : plain;
      if (++count <= looked_at) best.push_back(suspicion.stroke);
    }
    return best;
  }

  /// Several wrong strokes hide each other. One that doesn't point where its group says comes first, as long as
  /// leaving it out helps at all.
  StrokeSuspicion most_suspicious(const SolvedVertices& now, const std::vector<StrokeSuspicion>& ranking) const {
    const double most = least_help * now.solution.rms_of_freedom();
    for (const StrokeSuspicion& suspicion : ranking) {
      if (suspicion.rms < most && is_misdirected(suspicion.stroke)) return suspicion;
    }
    return ranking.front();
  }

  bool is_misdirected(Index stroke) const {
    const StrokeGroup group = tied_.ties.groups[stroke];
    if (!is_parallel(group)) return false;
    const auto [a, b] = tied_.ties.of_stroke[stroke];
    const Vec3 direction = tied_.seen.rotation.col(axis_of(group));
    const Vec3 point(tied_.seen.focal * direction.x(), tied_.seen.focal * direction.y(), direction.z());
    return vanishing_residual(point, tied_.seen.places[a], tied_.seen.places[b]) > misdirection * sigma_;
  }

  bool is_wrong(const SolvedVertices& now, const StrokeSuspicion& worst) {
    if (now.solution.rms() > options_.contradiction * sigma_ || has_coincident_vertices(now.table)) return true;
    const SolvedVertices without = solved_with_group(tied_, worst.stroke, StrokeGroup::Unknown);
    return without.solution.squares < lone_share * now.solution.squares &&
           without.solution.worst() < options_.lone_contradiction * sigma_;
  }

  Contradiction contradiction(const StrokeSuspicion& worst) {
    Contradiction result;
    result.stroke = worst.stroke;
    result.fix = better_group(worst);
    if (result.fix == StrokeGroup::Unknown && worst.rms > normal_rms * sigma_)
      result.split = vertex_to_split(worst.rms);
    return result;
  }

  /// Groups along axes tie more, so one that fits says more than a plane that fits. Curves can't run along axes.
  StrokeGroup better_group(const StrokeSuspicion& worst) {
    const double limit = std::max(normal_rms * sigma_, 1.25 * worst.rms);
    const bool straight = drawing_.strokes[worst.stroke].straight;
    for (const int first : {0, 3}) {
      if (first == 0 && !straight) continue;
      StrokeGroup best = StrokeGroup::Unknown;
      double least = limit;
      for (int k = first; k < first + 3; ++k) {
        const auto group = static_cast<StrokeGroup>(k);
        if (group == drawn_[worst.stroke]) continue;
        const double rms = rms_with_group(tied_, worst.stroke, group);
        if (rms < least) {
          least = rms;
          best = group;
        }
      }
      if (best != StrokeGroup::Unknown) return best;
    }
    return StrokeGroup::Unknown;
  }

  /// The vertex without which, each of its strokes ending on its own, the rest fits much better.
  Index vertex_to_split(double best_rms) const {
    Index best = no_index;
    double least = std::max(split_advantage * best_rms, 0.0);
    for (Index v = 0; v < vertices_.vertices.size(); ++v) {
      if (vertices_.vertices[v].ends.size() < 2) continue;
      const double rms = solved(without_vertex(v)).solution.rms_of_freedom();
      if (rms >= least) continue;
      least = rms;
      best = v;
    }
    return best;
  }

  TiedVertices without_vertex(Index vertex) const {
    TiedVertices split = tied_;
    bool first = true;
    for (const StrokeEnd& end : vertices_.vertices[vertex].ends) {
      Index& at = split.ties.of_stroke[end.stroke][end.at_end ? 1 : 0];
      if (at != vertex || std::exchange(first, false)) continue;
      at = static_cast<Index>(split.seen.places.size());
      split.seen.places.push_back(split.seen.places[vertex]);
      split.seen.weights.push_back(split.seen.weights[vertex]);
    }
    return split;
  }

  TiedVertices& tied_;
  std::span<const StrokeGroup> drawn_;
  const PerspectiveDrawing& drawing_;
  const DrawingVertices& vertices_;
  const CoordinateOptions& options_;
  double sigma_;
};

}  // namespace

std::vector<Vec3> SolvedVertices::positions() const {
  std::vector<Vec3> list;
  for (Index v = 0; v < table.vertex_count(); ++v) list.push_back(solution.position(table, v));
  return list;
}

SolvedVertices solved(const TiedVertices& tied, const std::vector<Vec3>* near, int rounds) {
  SolvedVertices result;
  result.table = make_classes(tied.seen.places.size(), tied.ties);
  result.solution = solve_classes(tied.seen, result.table, near, rounds);
  return result;
}

std::vector<Index> tying_strokes(const CoordinateTies& ties) {
  std::vector<Index> strokes;
  for (Index s = 0; s < ties.groups.size(); ++s) {
    if (ties_something(ties, s)) strokes.push_back(s);
  }
  return strokes;
}

std::vector<StrokeSuspicion> ranked_strokes(const TiedVertices& tied, const std::vector<Index>& strokes,
                                            Progress& progress) {
  TiedVertices trial = tied;
  std::vector<StrokeSuspicion> ranking;
  for (const Index stroke : strokes) {
    progress.check();
    // Other wrong strokes may go on pulling vertices together.
    ranking.push_back({stroke, solved_with_group(trial, stroke, StrokeGroup::Unknown).solution.rms_of_freedom()});
  }
  sort_by_rms(tied.ties, ranking);
  return ranking;
}

std::vector<Contradiction> resolve_contradictions(TiedVertices& tied, std::span<const StrokeGroup> drawn, double sigma,
                                                  const PerspectiveDrawing& drawing, const DrawingVertices& vertices,
                                                  const CoordinateOptions& options, Progress& progress) {
  return ContradictionSearch(tied, drawn, sigma, drawing, vertices, options).run(progress);
}

TiedVertices tied_vertices(const PerspectiveDrawing& drawing, const DrawingVertices& vertices,
                           const CameraEstimate& camera, std::span<const StrokeGroup> groups) {
  const double unit = SheetFrame(drawing).unit;
  TiedVertices tied;
  tied.seen.rotation = camera.camera.rotation;
  tied.seen.focal = camera.camera.focal_length / unit;
  for (const DrawingVertex& vertex : vertices.vertices) {
    tied.seen.places.push_back((vertex.position - camera.camera.principal_point) / unit);
    double weight = 0;
    for (const StrokeEnd& end : vertex.ends) weight += drawing.strokes[end.stroke].weight;
    tied.seen.weights.push_back(weight / static_cast<double>(vertex.ends.size()));
  }
  tied.ties.of_stroke = vertices.of_stroke;
  tied.ties.groups.assign(groups.begin(), groups.end());
  return tied;
}

}  // namespace croquis
