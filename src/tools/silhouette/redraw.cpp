// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/silhouette/redraw.h"

#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "croquis/geometry/polyline.h"
#include "croquis/tools/silhouette/stroke_edit.h"
#include "tools/pointer/segment_distance.h"
#include "tools/silhouette/stroke_places.h"

namespace croquis {
namespace {

/// How far along itself, in reaches, an end of the new stroke must follow the old one. More than 1: a line that comes
/// from the side has left the reach by then.
constexpr double run_in_reaches = 2;

/// Along the old stroke an end's run may be this much shorter or longer than itself.
constexpr double stretch = 2;

/// A replaced part may be this much longer than the stroke that replaces it.
constexpr double longest_shortcut = 4;

struct Foot {
  std::size_t segment = 0;
  Vec2 place = Vec2::Zero();
  double along = 0;  ///< arc length on the old stroke
  double time = 0;
  double distance = std::numeric_limits<double>::max();
};

class OldStroke {
 public:
  explicit OldStroke(const Stroke& stroke) : stroke_(stroke) {
    lengths_ = arc_lengths(places_of(stroke.samples), stroke.closed);
  }

  double total() const { return lengths_.back(); }

  Foot foot(const Vec2& point) const {
    Foot best;
    for (std::size_t i = 0; i < segment_count(stroke_); ++i) {
      const Vec2& begin = segment_begin(stroke_, i);
      const Vec2& end = segment_end(stroke_, i);
      const double t = nearest_parameter(point, begin, end);
      const Vec2 place = begin + t * (end - begin);
      const double distance = (place - point).norm();
      if (distance < best.distance) best = {i, place, lengths_[i] + t * (end - begin).norm(), time_at(i, t), distance};
    }
    return best;
  }

  /// Signed distance along the stroke from one foot to another, the shorter one round a closed stroke.
  double way(const Foot& from, const Foot& to) const {
    const double length = to.along - from.along;
    return stroke_.closed ? length - std::round(length / total()) * total() : length;
  }

  /// The distance forward: of open strokes negative when `to` lies behind.
  double way_forward(const Foot& from, const Foot& to) const {
    const double length = to.along - from.along;
    return stroke_.closed && length < 0 ? length + total() : length;
  }

 private:
  double time_at(std::size_t segment, double t) const {
    const double begin = stroke_.samples[segment].time;
    if (segment + 1 == stroke_.samples.size()) return begin;
    return begin + t * (stroke_.samples[segment + 1].time - begin);
  }

  const Stroke& stroke_;
  std::vector<double> lengths_;
};

Vec2 at_length(const std::vector<Vec2>& places, double length) {
  for (std::size_t i = 1; i < places.size(); ++i) {
    const double step = (places[i] - places[i - 1]).norm();
    if (length <= step && step > 0) return places[i - 1] + length / step * (places[i] - places[i - 1]);
    length -= step;
  }
  return places.back();
}

/// In which direction the beginning of a line runs along the old stroke: +1, -1, or 0 when it doesn't.
int sense_at_begin(const OldStroke& old, const std::vector<Vec2>& line, double run, const RedrawLimits& limits) {
  const double smallest_cosine = std::cos(limits.degrees * std::numbers::pi / 180);
  std::array<Foot, 3> feet;
  std::array<Vec2, 3> places;
  for (std::size_t k = 0; k < 3; ++k) {
    places[k] = at_length(line, run * static_cast<double>(k) / 2);
    feet[k] = old.foot(places[k]);
    if (feet[k].distance > limits.distance) return 0;
  }
  int sense = 0;
  for (std::size_t k = 0; k < 2; ++k) {
    const Vec2 step = places[k + 1] - places[k];
    const Vec2 on_old = feet[k + 1].place - feet[k].place;
    const double way = old.way(feet[k], feet[k + 1]);
    if (std::abs(way) * stretch < run / 2 || std::abs(way) > stretch * run / 2) return 0;
    if (step.dot(on_old) < smallest_cosine * step.norm() * on_old.norm()) return 0;
    const int sign = way > 0 ? 1 : -1;
    if (sense != 0 && sign != sense) return 0;
    sense = sign;
  }
  return sense;
}

/// The new samples in the old stroke's sense, their times counted from 0.
std::vector<StrokeSample> in_sense(const Stroke& drawn, bool forward) {
  std::vector<StrokeSample> samples = drawn.samples;
  if (!forward) std::reverse(samples.begin(), samples.end());
  const double start = samples.front().time;
  for (StrokeSample& sample : samples) sample.time = std::abs(sample.time - start);
  return samples;
}

void fit_times(std::vector<StrokeSample>& samples, double begin, double seconds) {
  const double drawn = samples.back().time;
  for (StrokeSample& sample : samples) sample.time = begin + (drawn > 0 ? sample.time / drawn : 0) * seconds;
}

std::vector<StrokeSample> spliced(const Stroke& old, std::vector<StrokeSample> samples, const Foot& from,
                                  const Foot& to) {
  const auto at = [&](std::size_t i) { return old.samples.begin() + static_cast<std::ptrdiff_t>(i); };
  std::vector<StrokeSample> result;
  if (from.along <= to.along) {
    fit_times(samples, from.time, std::max(0.0, to.time - from.time));
    result.assign(at(0), at(from.segment + 1));
    result.insert(result.end(), samples.begin(), samples.end());
    result.insert(result.end(), at(std::min(to.segment + 1, old.samples.size())), old.samples.end());
  } else {  // past the first sample of a closed stroke: it now begins where the new part ends
    fit_times(samples, from.time, samples.back().time);
    result.assign(at(to.segment + 1), at(from.segment + 1));
    result.insert(result.end(), samples.begin(), samples.end());
  }
  return result;
}

/// How far an end may be from the line that it rests on, pixels of the view it was drawn in.
constexpr double resting_pixels = 12;

/// The piece that bends is this much longer than the end moves …
constexpr double run_in_shifts = 4;

/// … and at least this part of the stroke, but never more than half of it.
constexpr double least_run = 0.25;

/// The stroke that an end rests on: the nearest of the others.
std::optional<PickedStroke> rests_on(const Drawing& drawing, const Stroke& stroke, const Vec2& end) {
  const PickReach reach{resting_pixels, drawn_scale(drawing, stroke)};
  std::optional<PickedStroke> nearest;
  for (const Stroke& other : drawing.strokes) {
    if (other.id == stroke.id) continue;
    const auto picked = nearest_place(other, end, reach);
    if (picked && (!nearest || picked->distance < nearest->distance)) nearest = picked;
  }
  return nearest;
}

Vec2 place_on(const Stroke& stroke, const PickedStroke& place) {
  const Vec2& begin = segment_begin(stroke, place.segment);
  return begin + place.parameter * (segment_end(stroke, place.segment) - begin);
}

/// How far both ends go the same way: all of it where they move alike, nothing where one stays.
Vec2 common_shift(const Vec2& a, const Vec2& b) {
  const Vec2& longer = a.squaredNorm() >= b.squaredNorm() ? a : b;
  const double longest = longer.squaredNorm();
  return longest > 0 ? Vec2(std::clamp(a.dot(b) / longest, 0.0, 1.0) * longer) : Vec2::Zero();
}

void move_ends(Stroke& stroke, const std::optional<Vec2>& first, const std::optional<Vec2>& last) {
  const std::vector<Vec2> places = places_of(stroke.samples);
  const double whole = length(places, false);
  if (first && last) {
    const Vec2 both = common_shift(*first, *last);
    for (StrokeSample& sample : stroke.samples) sample.position += both;
  }
  const auto run = [&](const Vec2& shift) {
    return std::min(whole / 2, std::max(run_in_shifts * shift.norm(), least_run * whole));
  };
  if (first) bend_end(stroke.samples.begin(), stroke.samples.end(), places.front() + *first, run(*first));
  if (last) bend_end(stroke.samples.rbegin(), stroke.samples.rend(), places.back() + *last, run(*last));
}

class Following {
 public:
  Following(const Drawing& before, DrawingEdit& edit) : before_(before), edit_(edit) {}

  /// The strokes that follow those in `moved`.
  std::vector<std::string> follow(const std::vector<std::string>& moved) {
    std::vector<std::string> followers;
    for (std::size_t i = 0; i < before_.strokes.size(); ++i) {
      const Stroke& stroke = before_.strokes[i];
      if (stroke.closed || stroke.samples.size() < 2 || contains(edit_.changed, stroke.id)) continue;
      const auto first = shift_of(stroke, stroke.samples.front().position, moved);
      const auto last = shift_of(stroke, stroke.samples.back().position, moved);
      if (!first && !last) continue;
      move_ends(edit_.drawing.strokes[i], first, last);
      followers.push_back(stroke.id);
    }
    return followers;
  }

 private:
  /// By how much what an end rests on has moved; nothing when it hasn't.
  std::optional<Vec2> shift_of(const Stroke& stroke, const Vec2& end, const std::vector<std::string>& moved) const {
    const auto place = rests_on(before_, stroke, end);
    if (!place || !contains(moved, place->id)) return std::nullopt;
    const Vec2 shift = place_on(*find_stroke(edit_.drawing, place->id), *place) - place->place;
    return shift.isZero(0) ? std::nullopt : std::optional(shift);
  }

  const Drawing& before_;
  DrawingEdit& edit_;
};

}  // namespace

std::optional<Redrawn> redraw(const Stroke& old, const Stroke& drawn, const RedrawLimits& limits) {
  if (old.samples.size() < 2 || drawn.samples.size() < 2) return std::nullopt;
  const std::vector<Vec2> line = places_of(drawn.samples);
  const std::vector<Vec2> reversed(line.rbegin(), line.rend());
  const double drawn_length = length(line, false);
  const double run = run_in_reaches * limits.distance;
  const OldStroke before(old);
  if (drawn_length < 2 * run || before.total() < run) return std::nullopt;

  const int sense = sense_at_begin(before, line, run, limits);
  if (sense == 0 || sense_at_begin(before, reversed, run, limits) != -sense) return std::nullopt;
  std::vector<StrokeSample> samples = in_sense(drawn, sense > 0);
  const Foot from = before.foot(samples.front().position);
  const Foot to = before.foot(samples.back().position);
  const double replaced = before.way_forward(from, to);
  if (replaced <= 0 || replaced > longest_shortcut * drawn_length) return std::nullopt;

  bend_end(samples.begin(), samples.end(), from.place, run);
  bend_end(samples.rbegin(), samples.rend(), to.place, run);
  return Redrawn{spliced(old, std::move(samples), from, to), from.distance + to.distance};
}

void let_ends_follow(const Drawing& before, DrawingEdit& edit) {
  Following following(before, edit);
  std::vector<std::string> moved = edit.changed;
  while (!moved.empty()) {
    moved = following.follow(moved);
    edit.changed.insert(edit.changed.end(), moved.begin(), moved.end());
  }
}

}  // namespace croquis
