// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/geometry/predicates.h"

#include "geometry/exact_kernel.h"

namespace croquis {
namespace {

ExactKernel::Point_2 to_cgal(const Vec2& point) { return {point.x(), point.y()}; }

}  // namespace

int orientation(const Vec2& a, const Vec2& b, const Vec2& c) {
  return static_cast<int>(CGAL::orientation(to_cgal(a), to_cgal(b), to_cgal(c)));
}

int in_circle(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  return static_cast<int>(CGAL::side_of_oriented_circle(to_cgal(a), to_cgal(b), to_cgal(c), to_cgal(d)));
}

}  // namespace croquis
