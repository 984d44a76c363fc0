// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/reading/connections.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <utility>

#include "algorithms/silhouette/figure/contour_completion.h"
#include "algorithms/silhouette/reading/reading_costs.h"
#include "algorithms/silhouette/strokes/doubled_strokes.h"
#include "algorithms/silhouette/strokes/segment_grid.h"

namespace croquis::silhouette {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// Outward directions are taken over this length (u), for the last samples alone are mostly noise; and over a shorter
// one, for around a tight bend, such as the tip of a limb, the long chord points elsewhere. Neither is more than a
// share of the stroke.
constexpr double chord_reach = 40;
constexpr double bend_reach = 20;
constexpr double chord_share = 0.1;
// Below this distance (u) the direction from end to end is noise.
constexpr double negligible_gap = 3;
// A stroke that closes itself may lack so much of its length.
constexpr double farthest_closing = 0.3;
// Two strokes that make an outline together may lack so much of the length of the shorter one.
constexpr double farthest_opening = 1.0 / 3;
// Ends of two strokes may be apart by so much of what hands miss by, and always by so much of the drawing (1000 u).
constexpr double farthest_gap = 2.5;
constexpr double least_farthest_gap = 50;
// An end may miss what it passes behind by so much of what hands miss by.
constexpr double farthest_miss = 2.25;
constexpr double dearest_meeting = 5;
// Ends that go on as one another at less than this, and have nothing else within so much more, are one line.
constexpr double plain_cost = 0.15;
constexpr double plain_margin = 0.6;
// Hidden pieces are candidates up to this length, in typical distances of ends, and so many of them for an end.
constexpr double longest_hidden = 40;
constexpr double shortest_hidden = 0.1;  // u
constexpr std::size_t most_hidden = 7;

class ConnectionSearch {
 public:
  ConnectionSearch(const std::vector<SampledStroke>& strokes, const DrawingScale& scale)
      : strokes_(strokes),
        scale_(scale),
        spacing_(scale.step / 2),
        doubled_(doubled_strokes(strokes, scale)),
        grid_(segments(strokes, doubled_), 2 * spacing_),
        largest_(largest_size(strokes)) {}

  Connections run(const Progress& progress) {
    find_ends();
    find_crossings();
    progress.check();
    find_joins();
    progress.check();
    for (Index end = 0; end < found_.ends.size(); ++end) find_meetings(end);
    doubt_joins_at_lines();
    drop_beside_plain_joins();
    progress.check();
    find_hidden();
    found_.doubled = std::move(doubled_);
    return std::move(found_);
  }

 private:
  /// Of strokes that weren't drawn over others.
  static std::vector<GridSegment> segments(const std::vector<SampledStroke>& strokes,
                                           const std::vector<Index>& doubled) {
    std::vector<GridSegment> all = stroke_segments(strokes);
    std::erase_if(all, [&](const GridSegment& segment) { return doubled[segment.line] != no_index; });
    return all;
  }

  static double largest_size(const std::vector<SampledStroke>& strokes) {
    double largest = 0;
    for (const SampledStroke& stroke : strokes) largest = std::max(largest, stroke.size);
    return largest;
  }

  void find_ends() {
    for (Index s = 0; s < strokes_.size(); ++s) {
      const SampledStroke& stroke = strokes_[s];
      if (stroke.closed || doubled_[s] != no_index) continue;
      const double bend = std::min(bend_reach * scale_.unit, chord_share / 2 * stroke.length);
      const double chord = std::min(chord_reach * scale_.unit, chord_share * stroke.length);
      for (const bool at_start : {true, false}) {
        found_.ends.push_back(
            {s,
             at_start,
             at_start ? stroke.points.front() : stroke.points.back(),
             {end_tangent(stroke.points, at_start, bend), end_chord(stroke.points, at_start, chord)}});
      }
    }
  }

  void find_crossings() {
    std::map<std::pair<Index, Index>, int> counts;
    grid_.pairs([&](Index i, Index j) {
      const GridSegment& a = grid_.segments()[i];
      const GridSegment& b = grid_.segments()[j];
      if (cross_properly(a.a, a.b, b.a, b.b)) ++counts[std::minmax(a.line, b.line)];
    });
    for (const auto& [pair, count] : counts) found_.crossings.push_back({pair.first, pair.second, count});
  }

  // Ends that meet.

  void find_joins() {
    for (Index a = 0; a < found_.ends.size(); ++a) {
      for (Index b = a + 1; b < found_.ends.size(); ++b) {
        if (std::optional<EndJoin> join = join_between(found_.ends[a], found_.ends[b])) {
          join->a = a;
          join->b = b;
          found_.joins.push_back(*join);
        }
      }
    }
  }

  bool same_object(Index a, Index b) const {
    const std::string& first = strokes_[a].object;
    const std::string& second = strokes_[b].object;
    return first.empty() || second.empty() || first == second;
  }

  std::optional<EndJoin> join_between(const LineEnd& a, const LineEnd& b) const {
    const double distance = (b.place - a.place).norm();
    const bool closing = a.stroke == b.stroke;
    const SampledStroke& first = strokes_[a.stroke];
    const SampledStroke& second = strokes_[b.stroke];
    const double usual = closing ? std::max(scale_.gap, scale_.close_share * first.length)
                                 : std::max(scale_.gap, scale_.reach_share * (first.size + second.size) / 2);
    const double widest = closing ? std::max(scale_.close, farthest_closing * first.length)
                                  : std::max({farthest_gap * usual, least_farthest_gap * scale_.unit,
                                              farthest_opening * std::min(first.length, second.length)});
    if (distance > widest || !same_object(a.stroke, b.stroke)) return std::nullopt;
    const double share = distance / usual;
    double cost = costs::gap * (closing || share > farthest_gap ? costs::opening(share) : costs::miss(share));
    cost += (closing ? costs::turn_of_closing : costs::turn) * turn_between(a, b, distance, share);
    if (is_blocked(a.place, b.place, a.stroke, b.stroke)) cost += costs::line_between;
    return EndJoin{0, 0, std::min(1.0, share), cost};
  }

  /// Sum of 1 - cosine over the turns at a gap, for the better of both directions of the ends. Of ends that are near to
  /// each other the direction from one to the other says little.
  double turn_between(const LineEnd& a, const LineEnd& b, double distance, double share) const {
    double least = infinity;
    for (std::size_t reach = 0; reach < a.outward.size(); ++reach) {
      const double straight = 1 + a.outward[reach].dot(b.outward[reach]);
      double turn = straight;
      if (distance > negligible_gap * scale_.unit) {
        const Vec2 across = (b.place - a.place) / distance;
        const double from_a = across.dot(a.outward[reach]);
        const double from_b = -across.dot(b.outward[reach]);
        const double bridged = std::min(2 - from_a - from_b, 2 + from_a + from_b + costs::overshoot);
        const double weight = std::min(1.0, share);
        turn = weight * bridged + (1 - weight) * straight;
      }
      least = std::min(least, turn);
    }
    return least;
  }

  /// Whether a line of other strokes lies between two places.
  bool is_blocked(const Vec2& from, const Vec2& to, Index one, Index other) const {
    bool blocked = false;
    grid_.near_box(from.cwiseMin(to), from.cwiseMax(to), [&](Index i) {
      const GridSegment& segment = grid_.segments()[i];
      if (segment.line == one || segment.line == other) return;
      blocked = blocked || cross_properly(from, to, segment.a, segment.b);
    });
    return blocked;
  }

  // Ends that pass behind something.

  double reach(Index one, Index other) const {
    return scale_.reach(std::max(strokes_[one].size, strokes_[other].size));
  }

  /// The samples of a stroke within reach of its end, the end itself first.
  Points last_bit(const LineEnd& end, double reach) const {
    const Points& points = strokes_[end.stroke].points;
    const std::size_t count = std::min(points.size(), static_cast<std::size_t>(reach / spacing_) + 2);
    Points bit(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(count));
    if (!end.at_start) std::copy_n(points.rbegin(), count, bit.begin());
    return bit;
  }

  void find_meetings(Index index) {
    const LineEnd& end = found_.ends[index];
    const double farthest = farthest_miss * scale_.reach(std::max(strokes_[end.stroke].size, largest_));
    const Points bit = last_bit(end, farthest);
    const Vec2 around = Vec2::Constant(farthest);
    std::vector<EndMeeting> all;
    std::set<Index> crossed;
    grid_.near_box(end.place - around, end.place + around, [&](Index i) {
      const GridSegment& segment = grid_.segments()[i];
      if (!same_object_or_other(segment, end)) return;
      for (const EndMeeting& meeting : meetings_with(end, bit, segment)) {
        all.push_back(meeting);
        if (meeting.along < 0) crossed.insert(meeting.bar);
      }
    });
    std::map<std::pair<Index, int>, EndMeeting> best;  // by bar and side
    for (EndMeeting& meeting : all) {
      meeting.end = index;
      if (meeting.along > 0 && crossed.contains(meeting.bar)) meeting.cost += costs::bar_crossed;
      EndMeeting& known = best.try_emplace({meeting.bar, meeting.side}, meeting).first->second;
      if (meeting.cost < known.cost) known = meeting;
    }
    for (auto& [bar, meeting] : best) {
      if (meeting.cost >= dearest_meeting) continue;
      meeting.cost += place_cost(end, meeting);
      found_.meetings.push_back(meeting);
    }
  }

  /// A line passes behind its own other parts, not behind its end.
  bool same_object_or_other(const GridSegment& segment, const LineEnd& end) const {
    if (segment.line != end.stroke) return true;
    const auto last = static_cast<double>(strokes_[segment.line].points.size() - 2);
    const double from_end = spacing_ * (end.at_start ? segment.position : last - segment.position);
    return from_end > 3 * reach(segment.line, segment.line);
  }

  /// The ways in which an end may meet a segment: what its last bit crosses, what lies ahead, what lies beside it.
  std::vector<EndMeeting> meetings_with(const LineEnd& end, const Points& bit, const GridSegment& segment) const {
    std::vector<EndMeeting> meetings;
    const double usual = reach(end.stroke, segment.line);
    const double most = farthest_miss * usual;
    const Vec2 direction = (segment.b - segment.a).normalized();
    // The stem comes from where the bar's surface isn't; an unsteady hand's last samples say little about where that
    // is.
    const double heading_left = (cross(direction, end.outward[0]) + cross(direction, end.outward[1])) / 2;
    const auto add = [&](double along, const Vec2& at, double more) {
      const double cost = costs::junction_miss * costs::miss(std::abs(along) / usual) + more;
      for (const int side : {1, -1}) {
        meetings.push_back(
            {0, segment.line, at, side, along, cost + costs::against_heading * std::max(0.0, -side * heading_left)});
      }
    };
    double walked = 0;
    for (std::size_t k = 0; k + 1 < bit.size() && walked < most; ++k) {
      if (cross_properly(bit[k], bit[k + 1], segment.a, segment.b)) {
        const double fraction = crossing_fraction(bit[k], bit[k + 1], segment.a, segment.b);
        const double length = (bit[k + 1] - bit[k]).norm();
        add(-(walked + fraction * length), bit[k] + fraction * (bit[k + 1] - bit[k]), 0);
        break;
      }
      walked += (bit[k + 1] - bit[k]).norm();
    }
    for (const Vec2& outward : end.outward) {
      const Vec2 ahead = end.place + most * outward;
      if (!cross_properly(end.place, ahead, segment.a, segment.b)) continue;
      const double distance = most * crossing_fraction(end.place, ahead, segment.a, segment.b);
      add(distance, end.place + distance * outward, 0);
    }
    const Vec2 nearest = segment.a + nearest_parameter(end.place, segment.a, segment.b) * (segment.b - segment.a);
    const double distance = (nearest - end.place).norm();
    if (distance < usual) {
      add(distance, nearest, costs::beside);
    }
    return meetings;
  }

  double place_cost(const LineEnd& end, const EndMeeting& meeting) const {
    const SampledStroke& bar = strokes_[meeting.bar];
    double cost = costs::junction + (meeting.bar == end.stroke ? costs::own_line : 0);
    if (!bar.closed) {
      const double to_end = std::min((meeting.at - bar.points.front()).norm(), (meeting.at - bar.points.back()).norm());
      cost += costs::end_of_bar * std::max(0.0, 1 - to_end / reach(end.stroke, meeting.bar));
    }
    const bool blocked = meeting.along > 0 && is_blocked(end.place, meeting.at, end.stroke, meeting.bar);
    return blocked ? cost + costs::line_before_bar : cost;
  }

  /// An end that lies on a line does so by chance if it goes on as another one across a gap.
  void doubt_joins_at_lines() {
    std::vector<double> least(found_.ends.size(), infinity);
    for (const EndMeeting& meeting : found_.meetings) {
      least[meeting.end] = std::min(least[meeting.end], meeting.cost);
    }
    for (EndJoin& join : found_.joins) {
      for (const Index end : {join.a, join.b}) {
        join.cost += costs::line_at_gap * join.gap * std::max(0.0, 1 - least[end] / costs::chance_meeting);
      }
    }
  }

  /// Ends that plainly are one place of a line have no other meaning.
  void drop_beside_plain_joins() {
    constexpr std::array<double, 2> none{infinity, infinity};
    std::vector<std::array<double, 2>> least(found_.ends.size(), none);  // and the next one
    for (const EndJoin& join : found_.joins) {
      for (const Index end : {join.a, join.b}) {
        auto& [first, second] = least[end];
        second = std::min(second, std::max(first, join.cost));
        first = std::min(first, join.cost);
      }
    }
    const auto is_plain = [&](const EndJoin& join) {
      return join.cost < plain_cost && std::ranges::all_of(std::array{join.a, join.b}, [&](Index end) {
               return least[end][0] == join.cost && least[end][1] > join.cost + plain_margin;
             });
    };
    std::vector<char> plain(found_.ends.size(), 0);
    for (const EndJoin& join : found_.joins) {
      if (is_plain(join)) plain[join.a] = plain[join.b] = 1;
    }
    std::erase_if(found_.joins,
                  [&](const EndJoin& join) { return (plain[join.a] || plain[join.b]) && !is_plain(join); });
    std::erase_if(found_.meetings, [&](const EndMeeting& meeting) { return plain[meeting.end] != 0; });
  }

  // Hidden pieces.

  void find_hidden() {
    std::map<Index, const EndMeeting*> likeliest;
    for (const EndMeeting& meeting : found_.meetings) {
      const EndMeeting*& known = likeliest.try_emplace(meeting.end, &meeting).first->second;
      if (meeting.cost < known->cost) known = &meeting;
    }
    const double reference = typical_distance(likeliest);
    std::map<std::pair<Index, Index>, double> all;
    std::map<Index, std::vector<std::pair<double, Index>>> of_end;
    for (const auto& [a, from] : likeliest) {
      for (const auto& [b, to] : likeliest) {
        const double distance = (to->at - from->at).norm();
        if (b <= a || distance > longest_hidden * reference || distance < shortest_hidden * scale_.unit) continue;
        const double cost = hidden_cost(found_.ends[a], *from, found_.ends[b], *to, reference);
        all[{a, b}] = cost;
        of_end[a].emplace_back(cost, b);
        of_end[b].emplace_back(cost, a);
      }
    }
    std::map<std::pair<Index, Index>, double> kept;
    for (auto& [end, others] : of_end) {
      std::sort(others.begin(), others.end());
      if (others.size() > most_hidden) others.resize(most_hidden);
      for (const auto& [cost, other] : others) kept[std::minmax(end, other)] = cost;
    }
    for (const auto& [pair, cost] : kept) found_.hidden.push_back({pair.first, pair.second, cost});
  }

  /// The median distance to the nearest other end, of those that likely pass behind something.
  double typical_distance(const std::map<Index, const EndMeeting*>& likeliest) const {
    std::vector<double> nearest;
    for (const auto& [a, from] : likeliest) {
      double least = infinity;
      for (const auto& [b, to] : likeliest) {
        if (a != b) least = std::min(least, (to->at - from->at).norm());
      }
      if (from->cost < 1 && least < infinity) nearest.push_back(least);
    }
    constexpr double least_reference = 4;
    if (nearest.empty()) return 100 * scale_.unit;
    const auto middle = nearest.begin() + static_cast<std::ptrdiff_t>(nearest.size() / 2);
    std::nth_element(nearest.begin(), middle, nearest.end());
    return std::max(*middle, least_reference * scale_.unit);
  }

  double hidden_cost(const LineEnd& a, const EndMeeting& from, const LineEnd& b, const EndMeeting& to,
                     double reference) const {
    const auto curve = completion_curve(from.at, a.outward[0], to.at, b.outward[0]);
    double cost = completion_cost(curve, 0, reference, {});
    if (a.stroke == b.stroke) cost = std::min(cost, costs::hidden_of_one_stroke);
    return costs::flattened(costs::hidden * cost);
  }

  const std::vector<SampledStroke>& strokes_;
  const DrawingScale& scale_;
  double spacing_;
  std::vector<Index> doubled_;
  SegmentGrid grid_;
  double largest_;
  Connections found_;
};

}  // namespace

Connections find_connections(const std::vector<SampledStroke>& strokes, const DrawingScale& scale,
                             const Progress& progress) {
  return ConnectionSearch(strokes, scale).run(progress);
}

}  // namespace croquis::silhouette
