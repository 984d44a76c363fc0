// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/svg/svg_flattening.h"

#include "croquis/base/limits.h"

namespace croquis {
namespace {

constexpr int places_per_curve = 8;  // enough to know a curve's size
constexpr double same_place = 1e-9;  // × diagonal: what relative commands lose by rounding

}  // namespace

bool is_usable(const SvgSubpath& subpath) {
  return are_usable_numbers(subpath.start) && std::ranges::all_of(subpath.segments, [](const SvgSegment& s) {
           const std::array points = {s.end, s.a, s.b, s.centre, Vec2(s.angle, s.sweep)};
           return std::ranges::all_of(points, are_usable_numbers<Vec2>);
         });
}

void extend(Eigen::AlignedBox2d& box, const SvgSubpath& subpath) {
  Vec2 from = subpath.start;
  box.extend(from);
  for (const SvgSegment& segment : subpath.segments) {
    if (segment.kind != SvgSegment::Kind::Line) {
      for (int i = 1; i < places_per_curve; ++i) {
        box.extend(point_on(segment, from, static_cast<double>(i) / places_per_curve));
      }
    }
    box.extend(segment.end);
    from = segment.end;
  }
}

bool flatten_into(Stroke& stroke, const SvgSubpath& subpath, FlatteningLimits& limits) {
  const auto append = [&](const Vec2& place) {
    StrokeSample sample;
    sample.position = place;
    stroke.samples.push_back(sample);
  };
  Vec2 from = subpath.start;
  append(from);
  for (const SvgSegment& segment : subpath.segments) {
    const int pieces = pieces_within(segment, from, limits.tolerance);
    if (static_cast<std::size_t>(pieces) >= limits.samples_left) return false;
    limits.samples_left -= static_cast<std::size_t>(pieces);
    for (int i = 1; i <= pieces; ++i) append(point_on(segment, from, static_cast<double>(i) / pieces));
    from = segment.end;
  }
  stroke.closed = subpath.closed;
  const bool returns = (from - subpath.start).norm() <= same_place * limits.bounds.diagonal().norm();
  if (stroke.closed && returns && stroke.samples.size() > 1) stroke.samples.pop_back();
  return true;
}

}  // namespace croquis
