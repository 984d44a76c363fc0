// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/strokes/doubled_strokes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <span>
#include <utility>

#include "algorithms/silhouette/strokes/drawing_findings.h"
#include "algorithms/silhouette/strokes/segment_grid.h"

namespace croquis::silhouette {
namespace {

// Lines nearer than this (u) over the share of the shorter one look like one line.
constexpr double doubling_distance = 6;
constexpr double doubling_share = 0.6;

// An end runs along a line no farther from it than that (u), nor than hands miss by. Where it does so for less than
// some of these distances, or for more than a share of the line, it is by chance; what is left of it is longer, too.
constexpr double retracing_distance = 10;
constexpr double least_retraced = 4;
constexpr double most_retraced = 0.5;
// Lines run along one another up to 45 degrees.
constexpr double parallel_cosine = 0.7;

// Lines that keep to one side of one another, this far apart (u) or more, are two outlines: the sides of a thin tube.
constexpr double strand_distance = 2;
// They keep to one side when their mean distance is so many times its standard deviation.
constexpr double steadiness = 2;

/// How far another line runs from the samples of one.
struct Company {
  double count = 0;
  double sum = 0;  ///< of signed distances, left of the other line positive
  double squares = 0;

  void add(double distance) {
    ++count;
    sum += distance;
    squares += distance * distance;
  }

  bool is_strand(double unit) const {
    const double mean = std::abs(sum) / count;
    const double deviation = std::sqrt(std::max(0.0, squares / count - mean * mean));
    return mean >= strand_distance * unit && mean >= steadiness * deviation;
  }
};

/// Signed distances to the lines other than `own` that are within `reach` of a place.
std::map<Index, double> lines_beside(const SegmentGrid& grid, const Vec2& place, Index own, double reach) {
  std::map<Index, double> beside;
  const Vec2 box = Vec2::Constant(reach);
  grid.near_box(place - box, place + box, [&](Index i) {
    const GridSegment& segment = grid.segments()[i];
    if (segment.line == own) return;
    const Vec2 along = segment.b - segment.a;
    const Vec2 away = place - (segment.a + nearest_parameter(place, segment.a, segment.b) * along);
    const double distance = away.norm();
    if (distance > reach) return;
    const auto [entry, fresh] = beside.try_emplace(segment.line, reach);
    if (fresh || distance < std::abs(entry->second)) entry->second = cross(along, away) < 0 ? -distance : distance;
  });
  return beside;
}

/// The samples of strokes that are left while ends are cut off.
class RetracedEnds {
 public:
  RetracedEnds(const std::vector<SampledStroke>& strokes, const DrawingScale& scale)
      : strokes_(strokes), scale_(scale), grid_(stroke_segments(strokes), scale.step, retracing_distance * scale.unit) {
    for (const SampledStroke& stroke : strokes) kept_.push_back({0, static_cast<Index>(stroke.points.size())});
  }

  /// Begin and end of what is left of each stroke.
  std::vector<std::array<Index, 2>> run() {
    for (Index s = static_cast<Index>(strokes_.size()); s-- > 0;) {
      if (strokes_[s].closed || !may_be_outline(strokes_[s].told)) continue;
      for (const bool at_start : {false, true}) cut(s, at_start);
    }
    return std::move(kept_);
  }

 private:
  static bool may_be_outline(StrokeKind told) {
    return told == StrokeKind::Visible || told == StrokeKind::Contour || told == StrokeKind::Part ||
           told == StrokeKind::Blob || told == StrokeKind::Hole;
  }

  void cut(Index s, bool at_start) {
    const Points& points = strokes_[s].points;
    const auto [begin, end] = kept_[s];
    Index along = begin;  // counted from the end that is looked at
    Index i = at_start ? begin : end - 1;
    for (; along + 1 < end; ++along) {
      const Index next = at_start ? i + 1 : i - 1;
      if (!runs_along_another(s, i, (points[next] - points[i]).normalized())) break;
      i = next;
    }
    const double cut = spacing(s) * (along - begin), rest = spacing(s) * (end - along);
    if (std::min(cut, rest) < least_retraced * reach(s) || !goes_on_from_end(s, at_start, i, cut)) return;
    kept_[s] = at_start ? std::array{i, end} : std::array{begin, i + 1};
  }

  double reach(Index s) const {
    return std::min(retracing_distance * scale_.unit, scale_.reach_share * strokes_[s].size);
  }
  double spacing(Index s) const { return strokes_[s].length / static_cast<double>(strokes_[s].points.size() - 1); }

  bool runs_along_another(Index s, Index i, const Vec2& direction) const {
    const Vec2& place = strokes_[s].points[i];
    const Vec2 box = Vec2::Constant(reach(s));
    bool found = false;
    grid_.near_box(place - box, place + box, [&](Index k) {
      const GridSegment& segment = grid_.segments()[k];
      if (found || !may_be_retraced(segment, s, i)) return;
      const Vec2 along = segment.b - segment.a;
      const Vec2 away = place - (segment.a + nearest_parameter(place, segment.a, segment.b) * along);
      found = std::abs(along.dot(direction)) > parallel_cosine * along.norm() && away.norm() < reach(s);
    });
    return found;
  }

  /// Whether another line, or the other end of the same one, ends where a stroke goes on alone, and in its direction:
  /// lines that only come together don't.
  bool goes_on_from_end(Index s, bool at_start, Index i, double cut) const {
    const Points& points = strokes_[s].points;
    const auto back = static_cast<Index>(std::min(cut, 2 * reach(s)) / spacing(s));
    const Vec2 onward = (points[i] - points[at_start ? i - back : i + back]).normalized();
    const auto bit = [&](Index other) {
      const auto [begin, end] = kept_[other];
      return std::span(strokes_[other].points).subspan(begin, end - begin);
    };
    for (Index other = 0; other < strokes_.size(); ++other) {
      if (strokes_[other].closed || cut > most_retraced * strokes_[other].length) continue;
      for (const bool start : {true, false}) {
        if (other == s && start == at_start) continue;
        const Vec2& end = start ? bit(other).front() : bit(other).back();
        if ((end - points[i]).norm() > 2 * reach(s)) continue;
        if (end_chord(bit(other), start, 2 * reach(s)).dot(onward) > parallel_cosine) return true;
      }
    }
    return false;
  }

  bool may_be_retraced(const GridSegment& segment, Index s, Index i) const {
    const auto [begin, end] = kept_[segment.line];
    if (segment.position < begin || segment.position + 1 >= end + (strokes_[segment.line].closed ? 1 : 0)) return false;
    if (segment.line != s) return true;
    const Index apart = std::max(segment.position, i) - std::min(segment.position, i);
    return apart > strokes_[s].points.size() / 2;
  }

  const std::vector<SampledStroke>& strokes_;
  const DrawingScale& scale_;
  SegmentGrid grid_;
  std::vector<std::array<Index, 2>> kept_;  ///< per stroke
};

}  // namespace

std::vector<Index> doubled_strokes(const std::vector<SampledStroke>& strokes, const DrawingScale& scale) {
  const double reach = doubling_distance * scale.unit;
  const SegmentGrid grid(stroke_segments(strokes), scale.step, reach);
  std::map<std::pair<Index, Index>, Company> company;
  for (Index s = 0; s < strokes.size(); ++s) {
    for (const Vec2& point : strokes[s].points) {
      for (const auto& [other, distance] : lines_beside(grid, point, s, reach)) company[{s, other}].add(distance);
    }
  }
  std::vector<Index> doubled(strokes.size(), no_index);
  for (const auto& [pair, distances] : company) {
    const auto& [s, other] = pair;
    const auto size = strokes[s].points.size(), other_size = strokes[other].points.size();
    if (size > other_size || (size == other_size && s < other)) continue;  // asked of the shorter one
    if (distances.count < doubling_share * static_cast<double>(size) || distances.is_strand(scale.unit)) continue;
    if (strokes[s].told == StrokeKind::Visible) doubled[s] = other;
  }
  return doubled;
}

void cut_retraced_ends(std::vector<SampledStroke>& strokes, const DrawingScale& scale) {
  const std::vector<std::array<Index, 2>> kept = RetracedEnds(strokes, scale).run();
  for (Index s = 0; s < strokes.size(); ++s) {
    SampledStroke& stroke = strokes[s];
    const auto [begin, end] = kept[s];
    if (end - begin == stroke.points.size()) continue;
    stroke.points = Points(stroke.points.begin() + begin, stroke.points.begin() + end);
    stroke.length = length(stroke.points, false);
    stroke.size = size_of(stroke.points, false);
  }
}

}  // namespace croquis::silhouette
