// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/sketches/sketch_hand.h"

#include <algorithm>
#include <limits>
#include <numbers>

#include <Eigen/Geometry>

#include "support/sketches/sketch_modifiers.h"
#include "support/sketches/sketch_paths.h"

namespace croquis::test {
namespace {

using Points = std::vector<Vec2>;

double object_size(const SketchTruth& truth, int component) {
  Eigen::AlignedBox2d box;
  for (const TrueContour& contour : truth.outlines) {
    if (contour.component != component) continue;
    for (const Vec2& point : contour.points) box.extend(point);
  }
  return box.diagonal().norm();
}

/// The object whose outline runs through the middle of a stroke.
int component_of(const Stroke& stroke, const SketchTruth& truth) {
  const Vec2& middle = stroke.samples[stroke.samples.size() / 2].position;
  double nearest = std::numeric_limits<double>::infinity();
  int component = 0;
  for (const TrueContour& contour : truth.outlines) {
    for (const Vec2& point : contour.points) {
      if ((point - middle).norm() >= nearest) continue;
      nearest = (point - middle).norm();
      component = contour.component;
    }
  }
  return component;
}

/// One line on its way from the sketch to the hand's strokes.
struct DrawnPath {
  Points points;
  bool closed = false;
};

Points wobbled_path(const DrawnPath& path, Random& random, double amplitude, double wavelength) {
  Points round = path.points;
  if (path.closed) round.push_back(path.points.front());
  // However short an open stroke is, the hand doesn't wobble faster.
  const double period = path.closed ? path_length(round) : std::max(path_length(round), 2 * wavelength);
  const Wobble wobble(random, period, amplitude, wavelength);
  Points moved;
  double distance = 0;
  for (std::size_t i = 0; i < path.points.size(); ++i) {
    if (i > 0) distance += (path.points[i] - path.points[i - 1]).norm();
    moved.push_back(path.points[i] + wobble.at(distance));
  }
  return moved;
}

/// A closed path drawn from a random place on, all round to about that place again.
Points almost_closed(const Points& loop, Random& random, const HandOptions& options) {
  const auto start = static_cast<std::ptrdiff_t>(random.below(static_cast<std::uint32_t>(loop.size())));
  Points round = loop;
  std::rotate(round.begin(), round.begin() + start, round.end());
  const Points turn = round;
  round.insert(round.end(), turn.begin(), turn.end());
  round.push_back(turn.front());
  const double length = path_length(round) / 2;
  const double over = random.between(-options.closing, options.closing) * length;
  const double aside = random.between(-options.aside, options.aside) * length;
  Points drawn = path_part(round, 0, length + over);
  // The last third drifts away to the side.
  const double drawn_length = path_length(drawn);
  Points drifting;
  double distance = 0;
  for (std::size_t i = 0; i < drawn.size(); ++i) {
    if (i > 0) distance += (drawn[i] - drawn[i - 1]).norm();
    const double share = std::clamp((distance / drawn_length - 2.0 / 3) * 3, 0.0, 1.0);
    const Vec2 along = (drawn[std::min(i + 1, drawn.size() - 1)] - drawn[i > 0 ? i - 1 : 0]).normalized();
    drifting.push_back(drawn[i] + aside * share * share * (3 - 2 * share) * left_of(along));
  }
  return drifting;
}

/// Pieces of which each goes back over the one before first; the last one of a closed path runs on over the first.
std::vector<DrawnPath> retraced(const DrawnPath& path, Random& random, int pieces, double size, double most) {
  constexpr double unsteadiness = 0.002;
  constexpr double least_share = 0.4;  // of the most that it goes back
  Points open = path.points;
  if (path.closed) {
    open.insert(open.end(), path.points.begin(), path.points.end());
    open.push_back(path.points.front());
  }
  const double length = path_length(open) / (path.closed ? 2 : 1);
  std::vector<DrawnPath> result;
  double end = 0;
  for (int i = 0; i < pieces; ++i) {
    const double back = random.between(least_share, 1) * most * length;
    const double begin = std::max(0.0, end - back);
    end = (i + 1 < pieces ? i + 1 + random.between(-0.2, 0.2) : pieces) * length / pieces;
    const double over = i + 1 == pieces && path.closed ? back : 0;
    DrawnPath piece{path_part(open, begin, end + over), false};
    piece.points = wobbled_path(piece, random, unsteadiness * size, 0.2 * size);
    result.push_back(std::move(piece));
  }
  return result;
}

/// A path in pieces, none shorter than a tenth of it.
std::vector<DrawnPath> cut(const DrawnPath& path, Random& random, int pieces, double gap) {
  Points open = path.points;
  if (path.closed) open.push_back(path.points.front());
  const double length = path_length(open);
  std::vector<double> cuts{0};
  for (int i = 1; i < pieces; ++i) cuts.push_back((i + random.between(-0.35, 0.35)) / pieces * length);
  cuts.push_back(length);
  std::vector<DrawnPath> result;
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
    const bool first = i == 0 && !path.closed;
    const bool last = i + 2 == cuts.size() && !path.closed;
    const double from = cuts[i] + (first ? 0 : random.between(-gap, gap) / 2);
    const double to = cuts[i + 1] + (last ? 0 : random.between(-gap, gap) / 2);
    result.push_back({path_part(open, from, to), false});
  }
  return result;
}

std::vector<DrawnPath> draw(const Stroke& stroke, double size, Random& random, const HandOptions& options) {
  DrawnPath path{points_of(stroke), stroke.closed};
  if (!path.closed && options.end_miss > 0) {
    const auto miss = [&] { return random.between(-options.end_miss, options.end_miss) * size; };
    const double before = miss();
    path.points = path_part(path.points, before, path_length(path.points) + miss());
  }
  if (options.jitter > 0) path.points = wobbled_path(path, random, options.jitter * size, options.wavelength * size);
  if (path.closed && (options.closing > 0 || options.aside > 0)) {
    path = {almost_closed(path.points, random, options), false};
  }
  if (options.pieces < 2) return {path};
  const int pieces = 2 + static_cast<int>(random.below(static_cast<std::uint32_t>(options.pieces - 1)));
  if (options.retrace > 0) return retraced(path, random, pieces, size, options.retrace);
  return cut(path, random, pieces, options.piece_gap * size);
}

}  // namespace

Drawing drawn_by_hand(const Sketch& sketch, std::uint64_t seed, const HandOptions& options) {
  Random random(seed);
  const double angle = options.turned ? random.between(0, 2 * std::numbers::pi) : 0.0;
  Drawing drawing;
  for (const Stroke& stroke : sketch.drawing.strokes) {
    const double size = object_size(sketch.truth, component_of(stroke, sketch.truth));
    int piece = 0;
    for (const DrawnPath& path : draw(stroke, size, random, options)) {
      Stroke drawn = stroke;
      drawn.closed = path.closed;
      if (piece++ > 0) drawn.id += "/" + std::to_string(piece);
      set_points(drawn, path.points);
      drawing.strokes.push_back(std::move(drawn));
    }
  }
  return rotated({drawing, {}}, angle).drawing;
}

std::vector<HandVariation> hand_variations() {
  const auto variation = [](const char* name, const auto& set) {
    HandVariation one{name, {}};
    set(one.options);
    return one;
  };
  return {
      variation("turned", [](HandOptions& hand) { hand.turned = true; }),
      variation("jitter 1 %", [](HandOptions& hand) { hand.jitter = 0.01, hand.closing = 0.02, hand.aside = 0.01; }),
      variation("jitter 2 %", [](HandOptions& hand) { hand.jitter = 0.02, hand.closing = 0.02, hand.aside = 0.01; }),
      variation("ends missed by 1.5 %", [](HandOptions& hand) { hand.end_miss = 0.015; }),
      variation("ends missed by 2 %", [](HandOptions& hand) { hand.end_miss = 0.02; }),
      variation("ends missed by 3 %", [](HandOptions& hand) { hand.end_miss = 0.03; }),
      variation("ends missed by 4 %", [](HandOptions& hand) { hand.end_miss = 0.04; }),
      variation("loops not closed", [](HandOptions& hand) { hand.closing = 0.05, hand.aside = 0.03; }),
      variation("pieces", [](HandOptions& hand) { hand.pieces = 4, hand.piece_gap = 0.015; }),
      variation("retraced", [](HandOptions& hand) { hand.pieces = 2, hand.retrace = 0.15; }),
      variation("all at once", [](HandOptions& hand) { hand = {0.007, 0.2, 0.015, 0.02, 0.01, 2, 0.01, true, 0}; })};
}

std::vector<NamedSketch> hand_sketches() {
  return {{"dog", dog_sketch()},
          {"duck", duck_sketch()},
          {"octopus", octopus_sketch()},
          {"bear", bear_sketch()},
          {"fish", fish_sketch()},
          {"mushroom", mushroom_sketch()},
          {"three blobs", three_blobs_sketch()},
          {"ring and bar", ring_and_bar_sketch()},
          {"linked rings", linked_rings_sketch()},
          {"snake", snake_sketch()},
          {"chain", chain_sketch()},
          {"trefoil", trefoil_sketch()}};
}

}  // namespace croquis::test
