// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/silhouette/resting_ends.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "croquis/geometry/polyline.h"
#include "croquis/tools/silhouette/stroke_pick.h"
#include "tools/pointer/segment_distance.h"
#include "tools/silhouette/end_bending.h"
#include "tools/silhouette/stroke_ids.h"
#include "tools/silhouette/stroke_places.h"

namespace croquis {
namespace {

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

void let_ends_follow(const Drawing& before, DrawingEdit& edit) {
  Following following(before, edit);
  std::vector<std::string> moved = edit.changed;
  while (!moved.empty()) {
    moved = following.follow(moved);
    edit.changed.insert(edit.changed.end(), moved.begin(), moved.end());
  }
}

}  // namespace croquis
