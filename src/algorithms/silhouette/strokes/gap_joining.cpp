// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/strokes/gap_joining.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <tuple>

#include "algorithms/silhouette/strokes/segment_grid.h"

namespace croquis::silhouette {
namespace {

// Directions of strokes that continue one another agree within 60 degrees; people don't draw more exactly.
constexpr double agreeing_cosine = 0.5;
// Those that overshoot one another run side by side: the end of one that crosses the other passes behind it.
constexpr double beside_cosine = 0.8;
// Outward directions are taken over this length (u), for the last samples alone are mostly noise; and over a shorter
// one, for around a tight bend, such as the tip of a limb, the long chord points elsewhere.
constexpr double chord_reach = 40;
constexpr double bend_reach = 20;
// Below this distance (u) the direction from end to end is noise.
constexpr double negligible_gap = 3;
// A stroke must be this many times longer than the hole it leaves to count as closed.
constexpr double closing_ratio = 4;

// Chords are no longer than this share of their stroke: that of a small circle would cut across it.
constexpr double chord_share = 0.1;

// The gap and the distance aside are measured along a direction that is uncertain, and both may be as large as they
// may.
constexpr double closing_slack = 1.5;

struct End {
  Index stroke = 0;
  bool at_start = false;
  Vec2 place = Vec2::Zero();
  std::array<Vec2, 2> outward;  ///< over the last bit, then over a longer one
  double reach = 0;             ///< how far it may miss a line
};

/// How much speaks for a pair of ends: what is told, then a stroke that all but closes, then what continues.
enum class Claim { Told, Closing, Continuing, None };

struct Pair {
  Claim claim = Claim::None;
  bool wanted = true;
  double distance = 0;
  Index a = 0;  ///< ends, a < b
  Index b = 0;
};

class Joiner {
 public:
  Joiner(const std::vector<SampledStroke>& strokes, const StrokeReading& reading, const DrawingScale& scale,
         double spacing)
      : strokes_(strokes), reading_(reading), scale_(scale), spacing_(spacing), grid_(segments(strokes), 2 * spacing) {
    for (Index s = 0; s < strokes_.size(); ++s) {
      if (strokes_[s].closed) continue;
      for (const bool at_start : {true, false}) {
        ends_.push_back(end_of(s, at_start));
        widest_ = std::max(widest_, widest_miss(s));
      }
    }
    partner_.assign(ends_.size(), no_index);
  }

  GapJoining join() {
    GapJoining result;
    for (const Pair& pair : candidates()) {
      if (!pair.wanted || partner_[pair.a] != no_index || partner_[pair.b] != no_index) {
        result.possible.push_back(ends_of(pair));
        continue;
      }
      result.joined.push_back(ends_of(pair));
      partner_[pair.a] = pair.b;
      partner_[pair.b] = pair.a;
      const End& a = ends_[pair.a];
      const End& b = ends_[pair.b];
      if (a.stroke == b.stroke && pair.distance < scale_.close) continue;
      result.joins.push_back({a.stroke, b.stroke, pair.distance, 0.5 * (a.place + b.place)});
    }
    result.chains = chains();
    return result;
  }

 private:
  End end_of(Index stroke, bool at_start) const {
    const Points& points = strokes_[stroke].points;
    double bend = bend_reach * scale_.unit;
    double chord = chord_reach * scale_.unit;
    if (by_size()) {
      bend = std::min(bend, chord_share / 2 * strokes_[stroke].length);
      chord = std::min(chord, chord_share * strokes_[stroke].length);
    }
    return {stroke,
            at_start,
            at_start ? points.front() : points.back(),
            {end_tangent(points, at_start, bend), end_chord(points, at_start, chord)},
            scale_.reach(strokes_[stroke].size)};
  }

  bool by_size() const { return scale_.close_share > 0; }

  /// The farthest that an end of a stroke may be from one that it is joined with.
  double widest_miss(Index stroke) const {
    return std::max({scale_.gap, scale_.reach_share * strokes_[stroke].size,
                     closing_slack * scale_.close_share * strokes_[stroke].length});
  }

  static std::vector<GridSegment> segments(const std::vector<SampledStroke>& strokes) {
    std::vector<GridSegment> all;
    for (Index s = 0; s < strokes.size(); ++s) {
      const Points& points = strokes[s].points;
      const std::size_t count = strokes[s].closed ? points.size() : points.size() - 1;
      for (Index i = 0; i < count; ++i) all.push_back({points[i], points[(i + 1) % points.size()], s, i});
    }
    return all;
  }

  std::vector<Pair> candidates() const {
    std::vector<Index> by_x(ends_.size());
    for (Index i = 0; i < by_x.size(); ++i) by_x[i] = i;
    std::sort(by_x.begin(), by_x.end(), [this](Index a, Index b) {
      return std::tuple(ends_[a].place.x(), a) < std::tuple(ends_[b].place.x(), b);
    });
    std::vector<Pair> pairs;
    for (std::size_t i = 0; i < by_x.size(); ++i) {
      for (std::size_t k = i + 1; k < by_x.size(); ++k) {
        if (ends_[by_x[k]].place.x() - ends_[by_x[i]].place.x() > widest_) break;
        consider(std::min(by_x[i], by_x[k]), std::max(by_x[i], by_x[k]), pairs);
      }
    }
    std::sort(pairs.begin(), pairs.end(), [](const Pair& p, const Pair& q) {
      return std::tuple(p.claim, p.distance, p.a, p.b) < std::tuple(q.claim, q.distance, q.a, q.b);
    });
    return pairs;
  }

  void consider(Index a, Index b, std::vector<Pair>& pairs) const {
    const double distance = (ends_[a].place - ends_[b].place).norm();
    if (distance >= widest_ || !compatible(ends_[a], ends_[b])) return;
    Pair pair{claim(ends_[a], ends_[b], distance), true, distance, a, b};
    const EndPair ends = ends_of(pair);
    const auto named = [&ends](const EndPair& other) { return other.same_ends(ends); };
    if (std::any_of(reading_.together.begin(), reading_.together.end(), named)) {
      pair.claim = Claim::Told;
    } else if (std::any_of(reading_.apart.begin(), reading_.apart.end(), named)) {
      return;
    }
    pair.wanted = pair.claim != Claim::None;
    if (pair.wanted || (by_size() && near_enough(ends_[a], ends_[b], distance))) pairs.push_back(pair);
  }

  Claim claim(const End& a, const End& b, double distance) const {
    Claim found = Claim::None;
    if (misses_itself(a, b)) {
      found = Claim::Closing;
    } else if (continues(a, b, distance) || closes(a, b, distance)) {
      found = Claim::Continuing;
    }
    return found != Claim::None && blocked(a, b) ? Claim::None : found;
  }

  /// Whether hands miss by so much.
  bool near_enough(const End& a, const End& b, double distance) const {
    const double length = strokes_[a.stroke].length;
    if (a.stroke == b.stroke) return distance <= closing_slack * scale_.close_share * (length + distance);
    // Ends that run side by side are those of two outlines, or of one drawn twice.
    return distance <= farthest_join(a, b) && a.outward.back().dot(b.outward.back()) < agreeing_cosine;
  }

  double farthest_join(const End& a, const End& b) const {
    return std::max(scale_.gap, scale_.reach_share * (strokes_[a.stroke].size + strokes_[b.stroke].size) / 2);
  }

  EndPair ends_of(const Pair& pair) const {
    const StrokeEnd a{strokes_[ends_[pair.a].stroke].stroke, ends_[pair.a].at_start};
    const StrokeEnd b{strokes_[ends_[pair.b].stroke].stroke, ends_[pair.b].at_start};
    return {std::min(a, b), std::max(a, b), pair.distance};
  }

  bool compatible(const End& a, const End& b) const {
    const std::string& first = strokes_[a.stroke].object;
    const std::string& second = strokes_[b.stroke].object;
    return first.empty() || second.empty() || first == second;
  }

  bool continues(const End& a, const End& b, double distance) const {
    if (a.stroke == b.stroke && stroke_length(a.stroke) < closing_ratio * distance) return false;
    if (distance >= farthest_join(a, b)) return false;
    return continues(a, b, distance, 0) || continues(a, b, distance, 1);
  }

  bool continues(const End& a, const End& b, double distance, std::size_t reach) const {
    if (a.outward[reach].dot(-b.outward[reach]) <= agreeing_cosine) return false;
    if (distance <= negligible_gap * scale_.unit) return true;
    const Vec2 across = (b.place - a.place) / distance;
    const double from_a = across.dot(a.outward[reach]);
    const double from_b = -across.dot(b.outward[reach]);
    if (from_a > agreeing_cosine && from_b > agreeing_cosine) return true;  // both point across the hole
    // Both overshoot the other's end and run side by side.
    return from_a < -agreeing_cosine && from_b < -agreeing_cosine &&
           a.outward[reach].dot(-b.outward[reach]) > beside_cosine;
  }

  bool closes(const End& a, const End& b, double distance) const {
    return a.stroke == b.stroke && distance < scale_.close && stroke_length(a.stroke) > closing_ratio * distance &&
           !(reaches_line(a) && reaches_line(b));
  }

  /// The ends of a stroke that was meant to be closed: the hand stopped early, or went on beside the start.
  bool misses_itself(const End& a, const End& b) const {
    if (!by_size() || a.stroke != b.stroke) return false;
    const Vec2 miss = b.place - a.place;
    const double length = strokes_[a.stroke].length + miss.norm();
    for (std::size_t reach = 0; reach < a.outward.size(); ++reach) {
      if (a.outward[reach].dot(-b.outward[reach]) <= agreeing_cosine) continue;
      const Vec2 along = (a.outward[reach] - b.outward[reach]).normalized();
      const double share = std::hypot(miss.dot(along) / scale_.close_share, cross(along, miss) / scale_.aside_share);
      if (share <= closing_slack * length) return true;
    }
    const bool side_by_side = a.outward.back().dot(b.outward.back()) >= agreeing_cosine;
    return miss.norm() <= scale_.aside_share * length && !side_by_side && !(reaches_line(a) && reaches_line(b));
  }

  double stroke_length(Index stroke) const {
    return spacing_ * static_cast<double>(strokes_[stroke].points.size() - 1);
  }

  /// True when another line, or the rest of the own one, is near enough that the end may be passing behind it.
  bool reaches_line(const End& end) const {
    bool reached = false;
    const Vec2 reach = Vec2::Constant(end.reach);
    grid_.near_box(end.place - reach, end.place + reach, [&](Index i) {
      const GridSegment& segment = grid_.segments()[i];
      if (reached || is_near_own_ends(segment, end.stroke)) return;
      const Vec2 nearest = segment.a + nearest_parameter(end.place, segment.a, segment.b) * (segment.b - segment.a);
      reached = (nearest - end.place).norm() <= end.reach;
    });
    return reached;
  }

  bool is_near_own_ends(const GridSegment& segment, Index stroke) const {
    if (segment.line != stroke) return false;
    const double near = by_size() ? widest_miss(stroke) : std::numeric_limits<double>::infinity();
    return std::min(distance_to_end(segment, true), distance_to_end(segment, false)) < near;
  }

  /// True when a line crosses the bridge or the last bit of either stroke.
  bool blocked(const End& a, const End& b) const {
    Points path = last_bit(a);
    const Points other = last_bit(b);
    path.insert(path.end(), other.rbegin(), other.rend());
    Vec2 low = path.front();
    Vec2 high = path.front();
    for (const Vec2& point : path) {
      low = low.cwiseMin(point);
      high = high.cwiseMax(point);
    }
    bool found = false;
    grid_.near_box(low, high, [&](Index i) {
      const GridSegment& segment = grid_.segments()[i];
      if (found || belongs_to_end(segment, a) || belongs_to_end(segment, b) || is_loose_end(segment, a, b)) return;
      for (std::size_t k = 0; k + 1 < path.size() && !found; ++k) {
        found = cross_properly(path[k], path[k + 1], segment.a, segment.b);
      }
    });
    return found;
  }

  /// The samples within reach of an end, the end itself last.
  Points last_bit(const End& end) const {
    const Points& points = strokes_[end.stroke].points;
    const auto wanted = static_cast<std::size_t>(std::ceil(end.reach / spacing_)) + 1;
    const auto count = static_cast<std::ptrdiff_t>(std::min(wanted, points.size()));
    Points bit;
    if (end.at_start) {
      bit.assign(points.begin(), points.begin() + count);
      std::reverse(bit.begin(), bit.end());
    } else {
      bit.assign(points.end() - count, points.end());
    }
    return bit;
  }

  double distance_to_end(const GridSegment& segment, bool at_start) const {
    const auto last = static_cast<double>(strokes_[segment.line].points.size() - 2);
    return spacing_ * (at_start ? segment.position : last - segment.position);
  }

  bool belongs_to_end(const GridSegment& segment, const End& end) const {
    return segment.line == end.stroke && distance_to_end(segment, end.at_start) < widest_miss(end.stroke) + end.reach;
  }

  /// The overshoot of a stem that ends at the line with the hole must not keep the hole open.
  bool is_loose_end(const GridSegment& segment, const End& a, const End& b) const {
    const double reach = std::max({scale_.reach(strokes_[segment.line].size), a.reach, b.reach});
    return !strokes_[segment.line].closed &&
           std::min(distance_to_end(segment, true), distance_to_end(segment, false)) < reach;
  }

  std::vector<StrokeChain> chains() const {
    std::vector<Index> first_end(strokes_.size(), no_index);
    for (Index e = 0; e < ends_.size(); e += 2) first_end[ends_[e].stroke] = e;
    std::vector<char> done(strokes_.size(), 0);
    std::vector<StrokeChain> chains;
    for (Index s = 0; s < strokes_.size(); ++s) {
      if (done[s]) continue;
      chains.push_back(chain_of(s, first_end[s], done));
    }
    return chains;
  }

  /// Ends come in pairs (start, end) per stroke, so e ^ 1 is the other end of the same stroke.
  StrokeChain chain_of(Index stroke, Index start_end, std::vector<char>& done) const {
    StrokeChain chain;
    done[stroke] = 1;
    chain.links.push_back({stroke, false});
    if (start_end == no_index) {
      chain.closed = true;
      return chain;
    }
    for (Index end = partner_[start_end + 1]; end != no_index; end = partner_[end ^ 1U]) {
      if (ends_[end].stroke == stroke) {
        chain.closed = true;
        return chain;
      }
      done[ends_[end].stroke] = 1;
      chain.links.push_back({ends_[end].stroke, !ends_[end].at_start});
    }
    for (Index end = partner_[start_end]; end != no_index; end = partner_[end ^ 1U]) {
      done[ends_[end].stroke] = 1;
      chain.links.insert(chain.links.begin(), {ends_[end].stroke, ends_[end].at_start});
    }
    return chain;
  }

  const std::vector<SampledStroke>& strokes_;
  const StrokeReading& reading_;
  const DrawingScale& scale_;
  double spacing_;
  SegmentGrid grid_;
  std::vector<End> ends_;
  std::vector<Index> partner_;  ///< per end
  double widest_ = 0;           ///< of all ends
};

}  // namespace

GapJoining join_gaps(const std::vector<SampledStroke>& strokes, const StrokeReading& reading, const DrawingScale& scale,
                     double spacing) {
  return Joiner(strokes, reading, scale, spacing).join();
}

}  // namespace croquis::silhouette
