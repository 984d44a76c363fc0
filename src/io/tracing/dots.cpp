// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numbers>

#include "croquis/geometry/polyline.h"
#include "io/tracing/tracing.h"

namespace croquis::tracing {
namespace {

constexpr double wide_shape = 2.5;     // × the usual half width: no line
constexpr double dot_alone = 1.6;      // the same for a shape that no line is joined to
constexpr double most_slender = 2;     // longest way to the middle, × the half width, of a shape that stands alone
constexpr double least_compact = 0.4;  // area / that of a circle of the same length

/// Connected pixels of a mask.
std::vector<std::vector<Pixel>> components(const Mask& mask) {
  std::vector<std::vector<Pixel>> result;
  Mask open = mask;
  for (int y = 0; y < mask.height; ++y) {
    for (int x = 0; x < mask.width; ++x) {
      if (open.at(x, y) == 0) continue;
      std::vector<Pixel> pixels{{x, y}};
      open.at(x, y) = 0;
      for (std::size_t i = 0; i < pixels.size(); ++i) {
        for (int d = 0; d < 8; ++d) {
          const Pixel p = neighbour(pixels[i], d);
          if (open.at_or_empty(p.x, p.y) == 0) continue;
          open.at(p.x, p.y) = 0;
          pixels.push_back(p);
        }
      }
      result.push_back(std::move(pixels));
    }
  }
  return result;
}

/// The outermost pixels of a shape in order around it (Moore's neighbourhood tracing). @param first its topmost one
TracedLine border_of(const Mask& shape, const Pixel& first) {
  TracedLine line{{}, true};
  Pixel pixel = first;
  int from = 4;  // to the left of the topmost, leftmost pixel nothing is set
  do {
    line.points.emplace_back(pixel.x, pixel.y);
    int direction = from;
    for (int turns = 1; turns <= 8; ++turns) {
      const Pixel p = neighbour(pixel, from + turns);
      direction = from + turns;
      if (shape.at_or_empty(p.x, p.y) != 0) break;
      if (turns == 8) return line;
    }
    pixel = neighbour(pixel, direction);
    // On from the last empty neighbour, as the next pixel sees it.
    from = (direction + (direction % 2 != 0 ? 5 : 6)) & 7;
  } while (pixel != first && line.points.size() < shape.values.size());
  return line;
}

bool touches_border(const Mask& mask, const std::vector<Pixel>& pixels) {
  return std::ranges::any_of(
      pixels, [&](const Pixel& p) { return p.x == 0 || p.y == 0 || p.x == mask.width - 1 || p.y == mask.height - 1; });
}

/// Whether a connected piece of ink is one dot as a pen makes it in one place.
bool is_dot_alone(const std::vector<Pixel>& pixels, const PixelGrid<int>& distances, double half_width) {
  double radius = 0;
  Vec2 middle = Vec2::Zero();
  for (const Pixel& p : pixels) {
    radius = std::max(radius, static_cast<double>(distances.at(p.x, p.y)) / pixel_step);
    middle += Vec2(p.x, p.y);
  }
  if (radius < dot_alone * half_width) return false;
  middle /= static_cast<double>(pixels.size());
  return std::ranges::all_of(pixels,
                             [&](const Pixel& p) { return (Vec2(p.x, p.y) - middle).norm() < most_slender * radius; });
}

/// The pixels that belong to wide shapes: those within reach of the places that are far from the outside.
Mask wide_part(const Mask& mask, const PixelGrid<int>& distances, double half_width) {
  const int reach = static_cast<int>(std::ceil(wide_shape * half_width * pixel_step));
  Mask shapes(mask.width, mask.height);
  Mask beside(mask.width, mask.height, 1);
  for (std::size_t i = 0; i < mask.values.size(); ++i) beside.values[i] = distances.values[i] > reach ? 0 : 1;
  const PixelGrid<int> to_core = distances_to_outside(beside);
  for (std::size_t i = 0; i < mask.values.size(); ++i)
    shapes.values[i] = mask.values[i] != 0 && to_core.values[i] <= reach ? 1 : 0;
  return shapes;
}

}  // namespace

std::vector<TracedLine> take_dots(Mask& mask, PixelGrid<int>& distances, double half_width) {
  Mask shapes = wide_part(mask, distances, half_width);
  for (const std::vector<Pixel>& pixels : components(mask)) {
    if (!is_dot_alone(pixels, distances, half_width)) continue;
    for (const Pixel& p : pixels) shapes.at(p.x, p.y) = 1;
  }
  std::vector<TracedLine> dots;
  for (const std::vector<Pixel>& pixels : components(shapes)) {
    for (const Pixel& p : pixels) mask.at(p.x, p.y) = 0;
    if (touches_border(mask, pixels)) continue;
    TracedLine border = border_of(shapes, pixels.front());
    const double outline = length(border.points, true);
    const double area = static_cast<double>(pixels.size());
    if (4 * std::numbers::pi * area > least_compact * outline * outline) dots.push_back(std::move(border));
  }
  if (!dots.empty()) distances = distances_to_outside(mask);
  return dots;
}

}  // namespace croquis::tracing
