// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/perspective/solid_drawing.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include <Eigen/Geometry>

#include "support/random.h"

namespace croquis::test {
namespace {

class SolidPen {
 public:
  SolidPen(const PerspectiveSolid& solid, const Camera& camera, const SolidDrawingOptions& options)
      : solid_(solid), camera_(camera), options_(options), random_(options.seed * 7919 + 17) {}

  SolidDrawing draw();

 private:
  Vec2 deviation(double scale);
  void set_true_curves();
  void set_places();
  PerspectiveStroke stroke_between(Index from, Index to);
  PerspectiveStroke edge(Index number);
  void add_construction_line(int axis);
  void add_links();
  void set_known();
  void shuffle();
  StrokeGroup colour_of(StrokeGroup group);
  bool faces_away(Index curve) const;

  const PerspectiveSolid& solid_;
  const Camera& camera_;
  const SolidDrawingOptions& options_;
  Random random_;
  SolidDrawing result_;
  std::vector<Vec2> places_;  // of the vertices as they are drawn
};

/// Normally distributed in both coordinates (Box and Muller).
Vec2 SolidPen::deviation(double scale) {
  const double radius = std::sqrt(-2 * std::log(1 - random_.unit()));
  const double angle = 2 * std::numbers::pi * random_.unit();
  return scale * radius * Vec2(std::cos(angle), std::sin(angle));
}

void SolidPen::set_true_curves() {
  result_.network = solid_.network;
  for (NetworkCurve& curve : result_.network.curves) {
    if (curve.straight) continue;
    for (RationalCubic& piece : curve.pieces) {
      const double nearest = camera_.depth(piece.points[0]);
      for (std::size_t i = 0; i < 4; ++i) piece.weights[i] = nearest / camera_.depth(piece.points[i]);
    }
  }
}

void SolidPen::set_places() {
  for (const Vec3& vertex : solid_.network.vertices) {
    if (camera_.depth(vertex) <= 0) throw std::logic_error("a solid to be drawn is behind the eye");
    places_.push_back(camera_.project(vertex) + deviation(options_.noise));
  }
}

PerspectiveStroke SolidPen::stroke_between(Index from, Index to) {
  PerspectiveStroke stroke;
  const Vec2 a = places_[from] + deviation(options_.end_jitter), b = places_[to] + deviation(options_.end_jitter);
  stroke.pieces = {{a, a + (b - a) / 3, b - (b - a) / 3, b}};
  stroke.straight = true;
  if (options_.vertex_ids) {
    stroke.from = "v" + std::to_string(from);
    stroke.to = "v" + std::to_string(to);
  }
  return stroke;
}

PerspectiveStroke SolidPen::edge(Index number) {
  const NetworkCurve& curve = solid_.network.curves[number];
  PerspectiveStroke stroke = stroke_between(curve.start, curve.end);
  stroke.id = curve.id;
  stroke.group = colour_of(solid_.groups[number]);
  stroke.hidden = options_.hidden && faces_away(number);
  if (curve.straight) return stroke;
  const Vec2 start = stroke.start(), end = stroke.end();
  const Vec2 start_shift = start - camera_.project(curve.pieces.front().points[0]);
  const Vec2 end_shift = end - camera_.project(curve.pieces.back().points[3]);
  stroke.straight = false;
  stroke.pieces.clear();
  for (const RationalCubic& piece : curve.pieces) {
    PictureCubic cubic;
    for (std::size_t i = 0; i < 4; ++i) cubic[i] = camera_.project(piece.points[i]) + deviation(options_.noise);
    if (!stroke.pieces.empty()) cubic[0] = stroke.pieces.back()[3];
    stroke.pieces.push_back(cubic);
  }
  stroke.pieces.front()[0] = start;
  stroke.pieces.front()[1] += start_shift;
  stroke.pieces.back()[2] += end_shift;
  stroke.pieces.back()[3] = end;
  return stroke;
}

StrokeGroup SolidPen::colour_of(StrokeGroup group) {
  if (options_.colouring == Colouring::Axes || !is_parallel(group)) return group;
  const auto turn = static_cast<int>(1 + random_.below(2));
  return static_cast<StrokeGroup>(3 + (axis_of(group) + turn) % 3);
}

void SolidPen::add_construction_line(int axis) {
  Eigen::AlignedBox3d box;
  for (const NetworkCurve& curve : solid_.network.curves) {
    for (const RationalCubic& piece : curve.pieces) {
      for (const Vec3& point : piece.points) box.extend(point);
    }
  }
  PerspectiveStroke stroke;
  stroke.id = "c" + std::to_string(result_.drawing.strokes.size());
  stroke.role = StrokeRole::Construction;
  stroke.group = static_cast<StrokeGroup>(axis);
  stroke.straight = true;
  const Vec3 middle = box.center() + 1.1 * box.sizes().cwiseProduct(
                                               Vec3(random_.unit() - 0.5, random_.unit() - 0.5, random_.unit() - 0.5));
  double half = box.sizes()[axis] * random_.between(0.5, 0.8);
  // A line that comes close to the eye would be endless in the picture.
  const double deepest = camera_.depth(box.center());
  while (camera_.depth(middle - half * Vec3::Unit(axis)) < 0.3 * deepest ||
         camera_.depth(middle + half * Vec3::Unit(axis)) < 0.3 * deepest) {
    half /= 2;
    if (half < 1e-6 * box.sizes()[axis]) throw std::logic_error("a construction line is behind the eye");
  }
  const Vec2 a = camera_.project(middle - half * Vec3::Unit(axis)) + deviation(options_.noise);
  const Vec2 b = camera_.project(middle + half * Vec3::Unit(axis)) + deviation(options_.noise);
  stroke.pieces = {{a, a + (b - a) / 3, b - (b - a) / 3, b}};
  result_.drawing.strokes.push_back(std::move(stroke));
}

void SolidPen::add_links() {
  for (std::size_t i = 0; i < solid_.links.size(); ++i) {
    PerspectiveStroke stroke = stroke_between(solid_.links[i].from, solid_.links[i].to);
    stroke.id = "l" + std::to_string(i);
    stroke.role = StrokeRole::Construction;
    stroke.link = true;
    stroke.group = solid_.links[i].group;
    result_.drawing.strokes.push_back(std::move(stroke));
  }
}

/// By Simpson's rule.
double arc_length(const NetworkCurve& curve) {
  constexpr int parts = 200;
  double sum = 0;
  for (const RationalCubic& piece : curve.pieces) {
    for (int i = 0; i <= parts; ++i) {
      const double weight = i == 0 || i == parts ? 1 : i % 2 == 1 ? 4 : 2;
      sum += weight / (3 * parts) * piece.derivative(static_cast<double>(i) / parts).norm();
    }
  }
  return sum;
}

void SolidPen::set_known() {
  result_.drawing.known_point = KnownPoint{camera_.project(solid_.network.vertices[0]), solid_.network.vertices[0]};
  const NetworkCurve& curve = result_.network.curves[0];
  result_.drawing.known_lengths = {{curve.id, arc_length(curve)}};
}

void SolidPen::shuffle() {
  auto& strokes = result_.drawing.strokes;
  for (std::size_t i = strokes.size(); i > 1; --i) {
    std::swap(strokes[i - 1], strokes[random_.below(static_cast<std::uint32_t>(i))]);
  }
  for (PerspectiveStroke& stroke : strokes) {
    if (random_.below(2) == 0) continue;
    std::ranges::reverse(stroke.pieces);
    for (PictureCubic& piece : stroke.pieces) std::ranges::reverse(piece);
    std::swap(stroke.from, stroke.to);
  }
}

/// The mean normal of a face as seen from the middle of one of its curves; faces of the test solids are nearly plane.
bool SolidPen::faces_away(Index curve) const {
  const NetworkCurve& edge = solid_.network.curves[curve];
  const Vec3 middle = (solid_.network.vertices[edge.start] + solid_.network.vertices[edge.end]) / 2;
  return std::ranges::none_of(solid_.faces, [&](const SolidFace& face) {
    bool touched = false;
    Vec3 normal = Vec3::Zero();
    for (const auto& loop : face.loops) {
      for (const SolidSide& side : loop) {
        const NetworkCurve& other = solid_.network.curves[side.curve];
        touched = touched || side.curve == curve;
        for (const RationalCubic& piece : other.pieces) {
          for (std::size_t i = 0; i < 3; ++i) {
            const Vec3 step = piece.points[i].cross(piece.points[i + 1]);
            normal += side.reversed ? Vec3(-step) : step;
          }
        }
      }
    }
    return touched && normal.dot(camera_.eye - middle) > 0;
  });
}

SolidDrawing SolidPen::draw() {
  result_.camera = camera_;
  result_.drawing.image_size = camera_.image_size;
  set_true_curves();
  set_places();
  for (int axis = 0; axis < 3; ++axis) {
    for (int i = 0; i < options_.construction_lines; ++i) add_construction_line(axis);
  }
  for (Index i = 0; i < solid_.network.curves.size(); ++i) {
    result_.drawing.strokes.push_back(edge(i));
    result_.groups.push_back(result_.drawing.strokes.back().group);
  }
  if (options_.links) add_links();
  if (options_.known) set_known();
  if (options_.shuffled) shuffle();
  return std::move(result_);
}

}  // namespace

SolidDrawing drawn(const PerspectiveSolid& solid, const Camera& camera, const SolidDrawingOptions& options) {
  return SolidPen(solid, camera, options).draw();
}

SolidDrawing drawn(const PerspectiveSolid& solid, const View& view, const SolidDrawingOptions& options) {
  SolidDrawing result = drawn(solid, camera_for(solid, view), options);
  result.drawing.origin = view.origin;
  return result;
}

}  // namespace croquis::test
