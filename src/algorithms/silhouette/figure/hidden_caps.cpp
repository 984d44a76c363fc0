// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/figure/hidden_caps.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>

#include "algorithms/silhouette/figure/contour_completion.h"
#include "algorithms/silhouette/strokes/visible_crossings.h"
#include "croquis/geometry/polyline.h"

namespace croquis::silhouette {
namespace {

constexpr double no_limit = std::numeric_limits<double>::infinity();
constexpr double pi = std::numbers::pi;
// The two ends of a line that goes round a limb are joined behind what it ends at for no more than this, the surer the
// less, however wide the limb is beside the gaps between limbs.
constexpr double cap_cost = 1.5;
// However far apart they are, as long as the whole outline turns round once and the cap bends no other way.
constexpr double wide_cap_cost = 2.7;
// A cap turns round by at most so much: half a turn for a limb's end, more where the line is mostly hidden.
constexpr double most_cap_turn = 1.6 * pi;
// Directions at the ends are known so well, all in all.
constexpr double turn_tolerance = 1;

bool same_bars(const std::array<const HiddenEnd*, 2>& a, const std::array<const HiddenEnd*, 2>& b) {
  return std::minmax(a[0]->bar, a[1]->bar) == std::minmax(b[0]->bar, b[1]->bar);
}

double turn(const Vec2& before, const Vec2& after) { return std::atan2(cross(before, after), before.dot(after)); }

double turning_of(std::span<const Vec2> points) {
  double sum = 0;
  for (std::size_t i = 1; i + 1 < points.size(); ++i) sum += turn(points[i] - points[i - 1], points[i + 1] - points[i]);
  return sum;
}

/// A curve without inflection of its handles turns like its control polygon.
double turning_of(const std::array<Vec2, 4>& curve) { return turning_of(std::span<const Vec2>(curve)); }

/// Whether an outline goes round once, with the surface inside as far as its side is known.
bool turns_once(double whole, int side) {
  return std::abs(std::abs(whole) - 2 * pi) < turn_tolerance && whole * side >= 0;
}

/// Whether a piece of an outline only turns the way that the whole does.
bool is_cap(double turning, double whole) {
  const double same = whole > 0 ? turning : -turning;
  return same >= 0 && same <= most_cap_turn;
}

}  // namespace

HiddenCaps::HiddenCaps(const std::vector<CleanLine>& lines, const Junctions& junctions)
    : lines_(lines), junctions_(junctions), ends_(lines.size(), {nullptr, nullptr}), roles_(lines.size(), Role::Any) {
  for (const HiddenEnd& end : junctions.ends) ends_[end.line][end.at_start ? 0 : 1] = &end;
  for (const CleanLine& line : lines) {
    const double chord = (line.points.back() - line.points.front()).norm();
    roundness_.push_back(std::max(0.0, 1 - 2 * chord / croquis::length(line.points, false)));
    turning_.push_back(line.closed ? 0 : turning_of(line.points));
  }
  find_handles();
}

void HiddenCaps::find_handles() {
  std::vector<Index> free;
  for (Index line = 0; line < lines_.size(); ++line) {
    if (ends_[line][0] != nullptr && ends_[line][1] != nullptr && junctions_.sides[line] == 0) free.push_back(line);
  }
  for (const Index inner : free) {
    const Vec2& middle = lines_[inner].points[lines_[inner].points.size() / 2];
    for (const Index outer : free) {
      if (inner == outer || !same_bars(ends_[inner], ends_[outer]) || !encloses(lines_[outer], middle)) continue;
      roles_[inner] = Role::InnerSide;
      roles_[outer] = Role::OuterSide;
    }
  }
}

int HiddenCaps::outward_side(const HiddenEnd& end) const {
  const int known = silhouette::outward_side(junctions_, end);
  if (known != 0) return known;
  const int round = (signed_area(lines_[end.line].points) >= 0) == (roles_[end.line] != Role::InnerSide) ? 1 : -1;
  return end.at_start ? -round : round;
}

const HiddenEnd* HiddenCaps::other_end(const HiddenEnd& end) const { return ends_[end.line][end.at_start ? 1 : 0]; }

double HiddenCaps::highest_cost(const HiddenEnd& a, const HiddenEnd& b, const std::array<Vec2, 4>& curve) const {
  if (a.line == b.line) return highest_cost_of_one(a, b, curve);
  // How far curves turn says little of an unsteady hand's lines: strands of knots would be closed as necks.
  const double certain = 1 - junctions_.tremble;
  return certain > 0 && close_a_limb(a, b, curve) ? wide_cap_cost / certain : no_limit;
}

double HiddenCaps::highest_cost_of_one(const HiddenEnd& a, const HiddenEnd& b, const std::array<Vec2, 4>& curve) const {
  // A line that passes behind itself goes on there.
  if (a.bar == a.line || b.bar == b.line || roles_[a.line] != Role::Any) return no_limit;
  const double round = roundness_[a.line];
  double highest = round > 0 ? cap_cost / round : no_limit;
  const double along = a.at_start ? -1 : 1;  // the cap leads from the line's end to its start
  const double cap = along * turning_of(curve);
  if (turns_once(turning_[a.line] + cap, junctions_.sides[a.line]) && is_cap(cap, turning_[a.line] + cap)) {
    highest = std::min(highest, wide_cap_cost);
  }
  return highest;
}

/// Whether two lines between the same two things and the caps at both ends go round once.
bool HiddenCaps::close_a_limb(const HiddenEnd& a, const HiddenEnd& b, const std::array<Vec2, 4>& curve) const {
  // What other lines end at is more likely a strand that goes on than a limb.
  if (junctions_.sides[a.line] != 0 || junctions_.sides[b.line] != 0) return false;
  const HiddenEnd* far_a = other_end(a);
  const HiddenEnd* far_b = other_end(b);
  if (far_a == nullptr || far_b == nullptr || a.bar != b.bar || far_a->bar != far_b->bar || a.bar == far_a->bar) {
    return false;
  }
  const double first = turning_of(curve);
  const double second = turning_of(completion_curve(lines_[b.line].end(far_b->at_start), far_b->tangent,
                                                    lines_[a.line].end(far_a->at_start), far_a->tangent));
  const double along_a = a.at_start ? -turning_[a.line] : turning_[a.line];
  const double along_b = b.at_start ? turning_[b.line] : -turning_[b.line];
  const double whole = along_a + first + along_b + second;
  return turns_once(whole, silhouette::outward_side(junctions_, a)) && is_cap(first, whole) && is_cap(second, whole);
}

}  // namespace croquis::silhouette
