// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/pictures/drawn_picture.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "croquis/geometry/polyline.h"
#include "support/random.h"

namespace croquis::test {
namespace {

/// How far each pixel is covered by ink, 0..1.
class Coverage {
 public:
  Coverage(int width, int height)
      : width_(width), height_(height), values_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {}

  double& at(int x, int y) {
    return values_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x)];
  }

  void add_segment(const Vec2& a, const Vec2& b, double half_width) {
    const double reach = half_width + 1;
    const int left = std::max(0, static_cast<int>(std::min(a.x(), b.x()) - reach));
    const int right = std::min(width_ - 1, static_cast<int>(std::max(a.x(), b.x()) + reach));
    const int top = std::max(0, static_cast<int>(std::min(a.y(), b.y()) - reach));
    const int bottom = std::min(height_ - 1, static_cast<int>(std::max(a.y(), b.y()) + reach));
    for (int y = top; y <= bottom; ++y) {
      for (int x = left; x <= right; ++x) {
        const Vec2 centre(x + 0.5, y + 0.5);
        const double t = nearest_parameter(centre, a, b);
        const double distance = (a + t * (b - a) - centre).norm();
        at(x, y) = std::max(at(x, y), std::clamp(half_width + 0.5 - distance, 0.0, 1.0));
      }
    }
  }

  void fill(const std::vector<Vec2>& polygon) {
    for (int y = 0; y < height_; ++y) {
      for (int x = 0; x < width_; ++x) {
        bool inside = false;
        for (std::size_t i = 0; i < polygon.size(); ++i) {
          const Vec2 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
          if ((a.y() > y + 0.5) == (b.y() > y + 0.5)) continue;
          const double crossing = a.x() + (y + 0.5 - a.y()) / (b.y() - a.y()) * (b.x() - a.x());
          inside = inside != (crossing > x + 0.5);
        }
        if (inside) at(x, y) = 1;
      }
    }
  }

 private:
  int width_, height_;
  std::vector<double> values_;
};

Coverage covered(const std::vector<InkLine>& lines, const PictureLook& look, double scale) {
  Coverage coverage(look.width, look.height);
  for (const InkLine& line : lines) {
    std::vector<Vec2> points = line.points;
    for (Vec2& point : points) point *= scale;
    if (line.filled) coverage.fill(points);
    for (std::size_t i = 0; i + (line.closed ? 0 : 1) < points.size(); ++i)
      coverage.add_segment(points[i], points[(i + 1) % points.size()], scale * look.line_width / 2);
  }
  return coverage;
}

/// The brightness of the ground at a place, units of the sheet.
double ground_at(const Vec2& place, const Vec2& size, const PictureLook& look) {
  // The edges of the sheet rise to the right.
  const double slant = 0.05;
  const Vec2 to_edge(std::min(place.x() + slant * place.y(), size.x() - place.x() - slant * place.y()),
                     std::min(place.y() + slant * place.x(), size.y() - place.y() - slant * place.x()));
  const bool on_desk = look.desk > 0 && to_edge.minCoeff() < look.desk;
  const double below = (place.y() / size.y() + place.x() / size.x() - 1.1) * size.x();
  const double shade = look.shadow * std::clamp(below / std::max(look.shadow_edge, 1e-9) + 0.5, 0.0, 1.0);
  const double to_square = std::min(std::fmod(place.x(), 40), std::fmod(place.y(), 40));
  const double line = to_square < 1.5 && !on_desk ? look.squares : 0;
  return (on_desk ? 0.2 : look.paper) * (1 - line) * (1 - shade) * (1 - look.fading * place.x() / size.x());
}

/// Nearly normally distributed, of mean 0 and deviation 1.
double bell(Random& random) {
  double sum = 0;
  for (int i = 0; i < 4; ++i) sum += random.between(-1, 1);
  return sum * std::sqrt(0.75);
}

}  // namespace

std::vector<std::uint8_t> drawn_pixels(const std::vector<InkLine>& lines, const PictureLook& look) {
  const double scale = std::max(look.width, look.height) / 1000.0;
  const Vec2 size = Vec2(look.width, look.height) / scale;
  Coverage coverage = covered(lines, look, scale);
  Random random(7);
  std::vector<std::uint8_t> rgba;
  for (int y = 0; y < look.height; ++y) {
    for (int x = 0; x < look.width; ++x) {
      const double ink = coverage.at(x, y);
      const double ground = ground_at(Vec2(x + 0.5, y + 0.5) / scale, size, look);
      double light = look.transparent ? look.ink : ground * (1 - ink * (1 - look.ink / look.paper));
      light += look.noise * bell(random);
      const auto level = static_cast<std::uint8_t>(std::lround(255 * std::clamp(light, 0.0, 1.0)));
      rgba.insert(rgba.end(), {level, level, level});
      rgba.push_back(look.transparent ? static_cast<std::uint8_t>(std::lround(255 * ink)) : std::uint8_t{255});
    }
  }
  return rgba;
}

InkLine ink_line(std::vector<Vec2> points, bool closed) { return {std::move(points), closed, false}; }

InkLine ink_circle(const Vec2& centre, double radius, bool filled) {
  InkLine circle{{}, true, filled};
  for (int i = 0; i < 90; ++i) {
    const double angle = 2 * std::numbers::pi * i / 90;
    circle.points.push_back(centre + radius * Vec2(std::cos(angle), std::sin(angle)));
  }
  return circle;
}

}  // namespace croquis::test
