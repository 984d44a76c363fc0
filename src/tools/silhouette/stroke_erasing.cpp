// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/tools/silhouette/stroke_erasing.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <Eigen/Geometry>

#include "croquis/base/text.h"
#include "croquis/geometry/polyline.h"
#include "croquis/silhouette/stroke_data.h"
#include "tools/pointer/segment_distance.h"
#include "tools/silhouette/stroke_places.h"

namespace croquis {
namespace {

/// A stroke of which less is left goes altogether.
constexpr double least_rest = 0.1;

/// A stretch of a stroke. Places are counted in segments: 2.5 is the middle of the third one.
struct Stretch {
  double from = 0;
  double to = 0;
};

/// The parameters, not limited to 0..1, at which a line runs within a disc; from > to for none.
Stretch inside_disc(const Vec2& start, const Vec2& step, const Vec2& centre, double radius) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const Vec2 offset = start - centre;
  const double a = step.squaredNorm();
  const double c = offset.squaredNorm() - radius * radius;
  if (a == 0) return c <= 0 ? Stretch{-infinity, infinity} : Stretch{infinity, -infinity};
  const double b = offset.dot(step);
  const double root = b * b - a * c;
  if (root < 0) return {infinity, -infinity};
  return {(-b - std::sqrt(root)) / a, (-b + std::sqrt(root)) / a};
}

/// The same of a band: the places that lie beside the segment from `begin` to `end`, not beyond its ends.
Stretch inside_band(const Vec2& start, const Vec2& step, const Vec2& begin, const Vec2& end, double radius) {
  const Vec2 way = end - begin;
  const double length = way.norm();
  Stretch inside{-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  if (length == 0) return {1, 0};
  const Vec2 direction = way / length;
  const auto limit = [&](const Vec2& axis, double low, double high) {
    const double at = axis.dot(start - begin);
    const double speed = axis.dot(step);
    if (speed == 0) {
      if (at < low || at > high) inside = {1, 0};
      return;
    }
    const double to_low = (low - at) / speed;
    const double to_high = (high - at) / speed;
    inside.from = std::max(inside.from, std::min(to_low, to_high));
    inside.to = std::min(inside.to, std::max(to_low, to_high));
  };
  limit(direction, 0, length);
  if (inside.from <= inside.to) limit({-direction.y(), direction.x()}, -radius, radius);
  return inside;
}

/// What a step of the eraser covers of a segment: it is convex, and so one stretch.
Stretch covered(const Vec2& a, const Vec2& b, const Vec2& from, const Vec2& to, double radius) {
  Stretch all{1, 0};
  const Vec2 step = b - a;
  for (const Stretch& part :
       {inside_disc(a, step, from, radius), inside_disc(a, step, to, radius), inside_band(a, step, from, to, radius)}) {
    if (part.from > part.to) continue;
    all = all.from > all.to ? part : Stretch{std::min(all.from, part.from), std::max(all.to, part.to)};
  }
  return {std::max(all.from, 0.0), std::min(all.to, 1.0)};
}

/// The covered stretches of a stroke, apart from each other and in order.
std::vector<Stretch> covered(const Stroke& stroke, const std::vector<Vec2>& path, double radius) {
  Eigen::AlignedBox2d around;
  for (const StrokeSample& sample : stroke.samples) around.extend(sample.position);
  std::vector<Stretch> found;
  for (std::size_t k = 0; k < path.size(); ++k) {
    const Vec2& from = path[k == 0 ? 0 : k - 1];
    Eigen::AlignedBox2d step(from);
    step.extend(path[k]);
    if (around.isEmpty() || step.exteriorDistance(around) > radius) continue;
    for (std::size_t i = 0; i < segment_count(stroke); ++i) {
      const Stretch part = covered(segment_begin(stroke, i), segment_end(stroke, i), from, path[k], radius);
      const auto segment = static_cast<double>(i);
      if (part.from <= part.to) found.push_back({segment + part.from, segment + part.to});
    }
  }
  std::sort(found.begin(), found.end(), [](const Stretch& a, const Stretch& b) { return a.from < b.from; });
  std::vector<Stretch> merged;
  for (const Stretch& part : found) {
    if (!merged.empty() && part.from <= merged.back().to)
      merged.back().to = std::max(merged.back().to, part.to);
    else
      merged.push_back(part);
  }
  return merged;
}

/// What lies between covered stretches. Of a closed stroke the last one may go on past its first sample.
std::vector<Stretch> uncovered(const Stroke& stroke, const std::vector<Stretch>& parts) {
  const auto whole = static_cast<double>(segment_count(stroke));
  std::vector<Stretch> rests;
  for (std::size_t i = 0; i + 1 < parts.size(); ++i) rests.push_back({parts[i].to, parts[i + 1].from});
  if (stroke.closed) {
    rests.push_back({parts.back().to, parts.front().from + whole});
  } else {
    rests.insert(rests.begin(), {0, parts.front().from});
    rests.push_back({parts.back().to, whole});
  }
  return rests;
}

StrokeSample between(const StrokeSample& a, const StrokeSample& b, double t) {
  StrokeSample sample;
  sample.position = a.position + t * (b.position - a.position);
  sample.pressure = a.pressure + t * (b.pressure - a.pressure);
  sample.tilt = a.tilt + t * (b.tilt - a.tilt);
  sample.time = a.time + t * (b.time - a.time);
  return sample;
}

/// A sample of a stroke by its number; of a closed one also beyond the last, in the next round.
StrokeSample sample_at(const Stroke& stroke, std::size_t number) {
  const std::size_t count = stroke.samples.size();
  StrokeSample sample = stroke.samples[number % count];
  if (number < count) return sample;
  const double seconds = stroke.samples.back().time - stroke.samples.front().time;
  sample.time += seconds + seconds / static_cast<double>(count);  // the closing segment takes as long as others do
  return sample;
}

/// The samples of a stretch, times counted from its first one.
std::vector<StrokeSample> samples_of(const Stroke& stroke, const Stretch& part) {
  const auto at = [&](double place) {
    const auto segment = static_cast<std::size_t>(place);
    const double t = place - std::floor(place);
    return t == 0 ? sample_at(stroke, segment) : between(sample_at(stroke, segment), sample_at(stroke, segment + 1), t);
  };
  std::vector<StrokeSample> samples{at(part.from)};
  for (double place = std::floor(part.from) + 1; place < part.to; ++place) samples.push_back(at(place));
  if (part.to > part.from) samples.push_back(at(part.to));
  const double start = samples.front().time;
  for (StrokeSample& sample : samples) sample.time -= start;
  return samples;
}

double length_of(const std::vector<StrokeSample>& samples) { return length(places_of(samples), false); }

/// The pieces that are left of a stroke; the first one has its name, the others none yet.
std::vector<Stroke> rests_of(const Stroke& stroke, const std::vector<Stretch>& erased, double radius) {
  std::vector<Stroke> rests;
  double left = 0;
  for (const Stretch& part : uncovered(stroke, erased)) {
    if (part.from >= part.to) continue;
    Stroke rest = stroke;
    rest.samples = samples_of(stroke, part);
    rest.closed = false;
    const double piece = length_of(rest.samples);
    if (piece <= 2 * radius) continue;
    const auto kind = silhouette::stroke_kind(stroke);
    const bool was_inner = kind == silhouette::StrokeKind::Part || kind == silhouette::StrokeKind::Hole;
    if (was_inner) rest.data.erase(silhouette::kind_key);  // only of closed outlines
    for (const char* key : {silhouette::joined_key, silhouette::apart_key}) rest.data.erase(key);
    left += piece;
    rests.push_back(std::move(rest));
  }
  const double before = length(places_of(stroke.samples), stroke.closed);
  if (left < least_rest * before) rests.clear();
  return rests;
}

/// Strokes that pass behind `of` pass behind its new piece too.
void name_piece(Drawing& drawing, const std::string& of, const std::string& piece) {
  for (Stroke& stroke : drawing.strokes) {
    const auto behind = stroke.data.find(silhouette::behind_key);
    if (behind == stroke.data.end()) continue;
    const auto names = text_parts(behind->second, ",");
    if (std::find(names.begin(), names.end(), of) != names.end()) behind->second += "," + piece;
  }
}

}  // namespace

std::vector<std::vector<Vec2>> erased_pieces(const Drawing& drawing, const std::vector<Vec2>& path, double radius) {
  std::vector<std::vector<Vec2>> pieces;
  for (const Stroke& stroke : drawing.strokes) {
    for (const Stretch& part : covered(stroke, path, radius)) pieces.push_back(places_of(samples_of(stroke, part)));
  }
  return pieces;
}

DrawingEdit erase_along(const Drawing& drawing, const std::vector<Vec2>& path, double radius) {
  DrawingEdit edit{drawing, {}, {}, {}};
  for (const Stroke& stroke : drawing.strokes) {
    const std::vector<Stretch> erased = covered(stroke, path, radius);
    if (erased.empty()) continue;
    std::vector<Stroke> rests = rests_of(stroke, erased, radius);
    const auto old = std::find_if(edit.drawing.strokes.begin(), edit.drawing.strokes.end(),
                                  [&](const Stroke& other) { return other.id == stroke.id; });
    if (rests.empty()) {
      edit.drawing.strokes.erase(old);
      edit.removed.push_back(stroke.id);
      continue;
    }
    auto place = old - edit.drawing.strokes.begin();
    *old = std::move(rests.front());
    edit.changed.push_back(stroke.id);
    forget_ends(edit.drawing, stroke.id);
    for (std::size_t i = 1; i < rests.size(); ++i) {
      rests[i].id = new_stroke_id(edit.drawing);
      edit.added.push_back(rests[i].id);
      name_piece(edit.drawing, stroke.id, rests[i].id);
      edit.drawing.strokes.insert(edit.drawing.strokes.begin() + ++place, std::move(rests[i]));
    }
  }
  return edit;
}

}  // namespace croquis
