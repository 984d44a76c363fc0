// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/surface/surface_hand.h"

#include <algorithm>

#include "croquis/io/attribute_network_file.h"
#include "croquis/tools/recording/recording.h"
#include "tools/surface/patch_sight.h"

namespace croquis::test {

std::vector<Vec2> by_hand(const std::vector<Vec2>& way, Random& random) {
  constexpr int events = 30;  // half a second of a mouse
  std::vector<double> lengths = {0};
  for (std::size_t i = 1; i < way.size(); ++i) lengths.push_back(lengths.back() + (way[i] - way[i - 1]).norm());
  const auto miss = [&]() -> Vec2 {
    return Vec2(random.between(-1, 1), random.between(-1, 1)) * 0.014 * lengths.back();
  };
  const Vec2 at_start = miss(), at_end = miss();
  std::vector<Vec2> pixels;
  for (int k = 0; k <= events; ++k) {
    const double time = static_cast<double>(k) / events;
    const double share = time * time * (3 - 2 * time);
    const double along = share * lengths.back();
    const auto next = std::clamp<std::size_t>(
        static_cast<std::size_t>(std::ranges::lower_bound(lengths, along) - lengths.begin()), 1, way.size() - 1);
    const double part = lengths[next] - lengths[next - 1];
    const Vec2 place =
        way[next - 1] + (way[next] - way[next - 1]) * (part > 0 ? (along - lengths[next - 1]) / part : 0);
    const Vec2 jitter(random.between(-0.7, 0.7), random.between(-0.7, 0.7));
    pixels.push_back(place + (1 - share) * at_start + share * at_end + jitter);
  }
  return pixels;
}

TestCamera studio_camera() {
  TestCamera camera;
  camera.eye = {1, 5, 9};
  camera.target = {1, 0, 0};
  return camera;
}

SurfaceHand::SurfaceHand() : camera(studio_camera()) {}

Verdict SurfaceHand::noted(Verdict verdict) {
  if (verdict == Verdict::Commit) recording.push_back(recorded::to_line(*tool.done()));
  return verdict;
}

Verdict SurfaceHand::step(PenStep::Kind kind, const Vec2& pixel) {
  return noted(tool.handle({kind, pixel, held, camera.frame(), now += 0.016}));
}

Verdict SurfaceHand::stroke(const std::vector<Vec2>& way) {
  const std::vector<Vec2> pixels = by_hand(way, random);
  step(PenStep::Kind::Begin, pixels.front());
  for (const Vec2& pixel : pixels) step(PenStep::Kind::Sample, pixel);
  return step(PenStep::Kind::End, pixels.back());
}

Verdict SurfaceHand::stroke_through(const std::vector<Vec3>& places) {
  std::vector<Vec2> way;
  for (const Vec3& place : places) way.push_back(pixel(place));
  return stroke(way);
}

Verdict SurfaceHand::drag(const Vec2& from, const Vec2& to) {
  std::vector<Vec2> pixels = by_hand({from, to}, random);
  pixels.front() = from;
  pixels.back() = to;
  step(PenStep::Kind::Begin, from);
  for (const Vec2& one : pixels) step(PenStep::Kind::Sample, one);
  return step(PenStep::Kind::End, to);
}

Verdict SurfaceHand::click(const Vec2& pixel) {
  step(PenStep::Kind::Begin, pixel);
  step(PenStep::Kind::Sample, pixel + Vec2(0.8, -0.6));
  return step(PenStep::Kind::End, pixel + Vec2(0.8, -0.6));
}

std::string SurfaceHand::text() const {
  const auto now_there = tool.network();
  return now_there ? write_attribute_network(*now_there) : std::string();
}

Vec3 SurfaceHand::node_place(const std::string& id) const {
  return network().nodes[require_element(network(), NetworkElement::Node, id)].point;
}

void SurfaceHand::look() {
  Progress progress;
  const auto now_there = tool.network();
  auto surface = std::make_shared<const AttributeSurface>(make_attribute_surface(*now_there, progress));
  auto shown = std::make_shared<const SurfaceTessellation>(tessellate(*now_there, *surface, progress));
  tool.settings().sight = std::make_shared<const PatchSight>(now_there, std::move(surface), std::move(shown));
}

}  // namespace croquis::test
