// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tools/perspective/alternative_faces.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include "app/views/render_color.h"
#include "app/window/theme.h"

namespace croquis::app {
namespace {

constexpr int curve_parts = 16;
constexpr double hatch_share = 0.012;  // between lines, of the picture's diagonal
constexpr double outline_width = 3, hatch_width = 1.4, removed_width = 2;

using Loop = std::vector<Vec3>;

std::set<std::string> strokes_of_face(const PerspectiveFace& face) {
  std::set<std::string> strokes;
  for (const std::vector<std::string>& loop : face.strokes) strokes.insert(loop.begin(), loop.end());
  return strokes;
}

std::vector<PerspectiveFace> without(const std::vector<PerspectiveFace>& faces,
                                     const std::vector<PerspectiveFace>& others) {
  std::set<std::set<std::string>> known;
  for (const PerspectiveFace& face : others) known.insert(strokes_of_face(face));
  std::vector<PerspectiveFace> left;
  for (const PerspectiveFace& face : faces) {
    if (!known.contains(strokes_of_face(face))) left.push_back(face);
  }
  return left;
}

/// The curves of a loop, one after the other.
std::optional<Loop> traced_loop(const CurveNetwork& network, const std::vector<std::string>& strokes) {
  std::vector<const NetworkCurve*> curves;
  for (const std::string& id : strokes) {
    const auto found = std::ranges::find(network.curves, id, &NetworkCurve::id);
    if (found == network.curves.end()) return std::nullopt;
    curves.push_back(&*found);
  }
  Loop loop;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    const NetworkCurve &curve = *curves[i], &next = *curves[(i + 1) % curves.size()];
    const bool ahead = curve.end == next.start || curve.end == next.end;
    Loop places;
    for (const RationalCubic& piece : curve.pieces) {
      for (int k = 0; k < curve_parts; ++k) places.push_back(piece.at(static_cast<double>(k) / curve_parts));
    }
    places.push_back(curve.pieces.back().at(1));
    if (!ahead) std::ranges::reverse(places);
    loop.insert(loop.end(), places.begin(), places.end() - 1);
  }
  return loop;
}

struct Plane {
  Vec3 middle = Vec3::Zero(), normal = Vec3::Zero();
};

/// Newell's normal through the mean of the places.
Plane plane_of(const Loop& loop) {
  Plane plane;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    plane.middle += loop[i] / static_cast<double>(loop.size());
    plane.normal += loop[i].cross(loop[(i + 1) % loop.size()]);
  }
  return plane;
}

/// Where the loops cross the line on which `across` has that value, by their places along it.
std::vector<double> crossings(const std::vector<std::vector<Vec2>>& loops, const Vec2& along, const Vec2& across,
                              double value) {
  std::vector<double> places;
  for (const std::vector<Vec2>& loop : loops) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Vec2 &a = loop[i], &b = loop[(i + 1) % loop.size()];
      const double from = across.dot(a) - value, to = across.dot(b) - value;
      if ((from < 0) == (to < 0)) continue;
      places.push_back(along.dot(a + from / (from - to) * (b - a)));
    }
  }
  std::ranges::sort(places);
  return places;
}

/// Lines across a face, equally far from each other in the picture.
std::vector<render::LinePath> hatch_of(const Camera& camera, const std::vector<Loop>& loops, const FromSpace& place) {
  std::vector<render::LinePath> lines;
  const Plane plane = plane_of(loops.front());
  std::vector<std::vector<Vec2>> seen;
  for (const Loop& loop : loops) {
    seen.emplace_back();
    for (const Vec3& point : loop) seen.back().push_back(camera.project(point));
  }
  const Vec2 along = Vec2(1, -1).normalized(), across = Vec2(1, 1).normalized();
  const auto [low, high] = std::ranges::minmax(seen.front(), {}, [&](const Vec2& point) { return across.dot(point); });
  const double step = hatch_share * camera.image_size.norm();
  if (!(step > 0)) return lines;
  const auto lifted = [&](const Vec2& point) {
    const Vec3 ray = camera.ray(point);
    return Vec3(camera.eye + plane.normal.dot(plane.middle - camera.eye) / plane.normal.dot(ray) * ray);
  };
  for (double value = across.dot(low) + step / 2; value < across.dot(high); value += step) {
    const std::vector<double> ends = crossings(seen, along, across, value);
    for (std::size_t i = 0; i + 1 < ends.size(); i += 2) {
      const Vec3 from = lifted(ends[i] * along + value * across), to = lifted(ends[i + 1] * along + value * across);
      if (!from.allFinite() || !to.allFinite()) continue;
      lines.emplace_back();
      lines.back().points = {{place(from), 1, {}}, {place(to), 1, {}}};
    }
  }
  return lines;
}

render::LinePath outline_of(const Loop& loop, const FromSpace& place) {
  render::LinePath path;
  path.closed = true;
  for (const Vec3& point : loop) path.points.push_back({place(point), 1, {}});
  return path;
}

void add_item(const std::vector<render::LinePath>& paths, const render::LineStyle& style,
              std::vector<render::LineItemPtr>& items) {
  if (!paths.empty()) items.push_back(render::make_line_item(paths, style));
}

}  // namespace

FaceDifference difference_of(const PerspectiveResult& result, const FaceAlternative& alternative) {
  return {without(alternative.faces, result.faces), without(result.faces, alternative.faces)};
}

std::vector<std::string> names_of(const std::vector<PerspectiveFace>& faces) {
  std::vector<std::string> names;
  for (const PerspectiveFace& face : faces) {
    std::string name;
    for (const std::string& stroke : strokes_of_face(face)) name += (name.empty() ? "" : "+") + stroke;
    names.push_back(std::move(name));
  }
  return names;
}

std::vector<render::LineItemPtr> difference_items(const PerspectiveResult& result, const FaceDifference& difference,
                                                  const FromSpace& place) {
  std::vector<render::LinePath> added, hatched, removed;
  const auto loops_of = [&](const PerspectiveFace& face) {
    std::vector<Loop> loops;
    for (const std::vector<std::string>& strokes : face.strokes) {
      if (auto loop = traced_loop(result.network, strokes)) loops.push_back(std::move(*loop));
    }
    return loops;
  };
  for (const PerspectiveFace& face : difference.added) {
    const std::vector<Loop> loops = loops_of(face);
    for (const Loop& loop : loops) added.push_back(outline_of(loop, place));
    if (loops.empty()) continue;
    for (render::LinePath& line : hatch_of(result.camera, loops, place)) hatched.push_back(std::move(line));
  }
  for (const PerspectiveFace& face : difference.removed) {
    for (const Loop& loop : loops_of(face)) removed.push_back(outline_of(loop, place));
  }
  std::vector<render::LineItemPtr> items;
  add_item(removed, {removed_width, to_color(colors::error), {6, 5, 0, 0}, render::LineDepth::OnTop}, items);
  add_item(hatched, {hatch_width, to_color(colors::hover, 200), {}, render::LineDepth::OnTop}, items);
  add_item(added, {outline_width, to_color(colors::hover), {}, render::LineDepth::OnTop}, items);
  return items;
}

}  // namespace croquis::app
