// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/perspective/solids.h"

#include <algorithm>
#include <array>
#include <utility>

#include <Eigen/Geometry>

#include "support/perspective/solid_builder.h"

namespace croquis::test {
namespace {

/// A prism with both ends closed.
Prism add_block(SolidBuilder& builder, const PrismShape& shape) {
  Prism prism = builder.prism(shape);
  builder.face({prism.low_loop});
  builder.face({prism.high_loop});
  return prism;
}

PerspectiveSolid block(const std::string& name, const PrismShape& shape) {
  SolidBuilder builder(name);
  add_block(builder, shape);
  return builder.take();
}

/// Profiles of what is extruded along y hold (z, x): mirrored, so that they can be written as (x, z).
Profile upright(Profile profile) {
  std::reverse(profile.begin(), profile.end());
  for (ProfileSide& side : profile) std::swap(side.start.x(), side.start.y());
  return profile;
}

/// A box with a lens: the lens is open in front.
struct CameraParts {
  Prism body;
  Prism lens;
};

constexpr double camera_height = 2.4;
const Vec2 lens_centre(1.15, 2.4);  // z, x

CameraParts add_camera(SolidBuilder& builder) {
  CameraParts parts;
  parts.body = builder.prism({.profile = rectangle({0, 0}, {camera_height, 4.2}), .axis = 1, .from = 0, .to = 1.35});
  builder.face({parts.body.high_loop});
  parts.lens = builder.prism({.profile = circle(lens_centre, 0.8), .axis = 1, .from = -0.75, .to = 0});
  builder.face({parts.body.low_loop, parts.lens.high_loop});
  builder.link(parts.body.low[0], parts.lens.high[3]);
  return parts;
}

}  // namespace

int PerspectiveSolid::rings() const {
  int count = 0;
  for (const SolidFace& face : faces) count += static_cast<int>(face.loops.size()) - 1;
  return count;
}

PerspectiveSolid box() { return block("box", {.profile = rectangle({0, 0}, {4, 3}), .to = 2}); }

PerspectiveSolid l_block() {
  const Profile profile = polygon({{0, 0}, {2.5, 0}, {2.5, 1.2}, {1.1, 1.2}, {1.1, 3}, {0, 3}});
  return block("L-block", {.profile = upright(profile), .axis = 1, .to = 2});
}

PerspectiveSolid t_block() {
  const Profile profile = polygon({{1.3, 0}, {2.2, 0}, {2.2, 2}, {3.6, 2}, {3.6, 3}, {0, 3}, {0, 2}, {1.3, 2}});
  return block("T-block", {.profile = upright(profile), .axis = 1, .to = 1.7});
}

PerspectiveSolid wedge() {
  const Profile profile = polygon({{0, 0}, {4, 0}, {4, 0.9}, {0, 2.3}});
  return block("wedge", {.profile = upright(profile), .axis = 1, .to = 2.6});
}

PerspectiveSolid cut_corner_box() {
  SolidBuilder b("cut corner");
  const Index v0 = b.vertex(0, 0, 0), v1 = b.vertex(4, 0, 0), v2 = b.vertex(4, 3, 0), v3 = b.vertex(0, 3, 0);
  const Index v4 = b.vertex(0, 0, 2), v6 = b.vertex(4, 3, 2), v7 = b.vertex(0, 3, 2);
  const Index x = b.vertex(2.6, 0, 2), y = b.vertex(4, 1.1, 2), z = b.vertex(4, 0, 0.9);
  for (const auto& [from, to] : {std::pair(v0, v1),
                                 {v1, v2},
                                 {v2, v3},
                                 {v3, v0},
                                 {v0, v4},
                                 {v2, v6},
                                 {v3, v7},
                                 {v1, z},
                                 {v4, x},
                                 {x, y},
                                 {y, v6},
                                 {v6, v7},
                                 {v7, v4},
                                 {x, z},
                                 {z, y}}) {
    b.line(from, to);
  }
  b.face({v3, v2, v1, v0});
  b.face({v0, v1, z, x, v4});
  b.face({v1, v2, v6, y, z});
  b.face({v2, v3, v7, v6});
  b.face({v3, v0, v4, v7});
  b.face({v4, x, y, v6, v7});
  b.face({z, y, x});
  return b.take();
}

PerspectiveSolid stack(int boxes) {
  SolidBuilder b("stack of " + std::to_string(boxes));
  std::vector<std::array<Index, 4>> rings;
  double z = 0;
  for (int level = 0; level <= boxes; ++level) {
    rings.push_back({b.vertex(0, 0, z), b.vertex(3, 0, z), b.vertex(3, 2.4, z), b.vertex(0, 2.4, z)});
    z += 0.8 + 0.15 * (level % 3);
    for (std::size_t i = 0; i < 4; ++i) b.line(rings.back()[i], rings.back()[(i + 1) % 4]);
    if (level == 0) continue;
    const auto& below = rings[static_cast<std::size_t>(level) - 1];
    for (std::size_t i = 0; i < 4; ++i) b.line(below[i], rings.back()[i]);
    for (std::size_t i = 0; i < 4; ++i) {
      b.face({below[i], below[(i + 1) % 4], rings.back()[(i + 1) % 4], rings.back()[i]});
    }
  }
  const auto& bottom = rings.front();
  const auto& top = rings.back();
  b.face({bottom[3], bottom[2], bottom[1], bottom[0]});
  b.face({top[0], top[1], top[2], top[3]});
  return b.take();
}

PerspectiveSolid pocket_box() {
  SolidBuilder b("pocket");
  const Prism body = b.prism({.profile = rectangle({0, 0}, {4, 3}), .to = 2});
  const Prism pocket = b.prism({.profile = rectangle({1, 0.8}, {3.2, 2.1}), .from = 1.1, .to = 2, .inside_out = true});
  b.face({body.low_loop});
  b.face({body.high_loop, pocket.high_loop});
  b.face({pocket.low_loop});
  b.link(body.high[0], pocket.high[0]);
  return b.take();
}

PerspectiveSolid two_boxes() {
  SolidBuilder b("two boxes");
  const Prism left = add_block(b, {.profile = rectangle({0, 0}, {2, 3}), .to = 2});
  const Prism right = add_block(b, {.profile = rectangle({2.9, 0.7}, {4.6, 2.2}), .to = 1.2});
  b.link(left.low[1], right.low[0]);
  return b.take(2);
}

PerspectiveSolid ring_frame() {
  SolidBuilder b("ring frame");
  const Prism outer = b.prism({.profile = rectangle({0, 0}, {3, 4}), .axis = 1, .to = 1});
  const Prism inner = b.prism({.profile = rectangle({0.8, 0.9}, {2.2, 3.1}), .axis = 1, .to = 1, .inside_out = true});
  b.face({outer.low_loop, inner.low_loop});
  b.face({outer.high_loop, inner.high_loop});
  b.link(outer.low[0], inner.low[0]);
  return b.take(1, 1);
}

PerspectiveSolid mitred_frame() {
  SolidBuilder b("mitred frame");
  const Prism outer = b.prism({.profile = rectangle({0, 0}, {3, 4}), .axis = 1, .to = 1});
  const Prism inner = b.prism({.profile = rectangle({0.8, 0.9}, {2.2, 3.1}), .axis = 1, .to = 1, .inside_out = true});
  for (std::size_t i = 0; i < 4; ++i) {
    b.line(outer.low[i], inner.low[i]);
    b.line(outer.high[i], inner.high[i]);
  }
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t next = (i + 1) % 4;
    b.face({outer.low[next], outer.low[i], inner.low[i], inner.low[next]});
    b.face({outer.high[i], outer.high[next], inner.high[next], inner.high[i]});
  }
  return b.take(1, 1);
}

PerspectiveSolid rounded_block() {
  Profile profile = polygon({{0, 0}, {2.8, 0}, {4, 1.2}, {4, 3}, {0, 3}});
  profile[1].pieces = {quarter({2.8, 1.2}, {0, -1.2}, {1.2, 0})};
  return block("rounded block", {.profile = profile, .to = 1.8});
}

PerspectiveSolid d_block() {
  Profile profile = polygon({{0, 0}, {3, 0}});
  const Vec2 centre(1.5, 0), x(1.5, 0), y(0, 1.5);
  profile[1].pieces = {quarter(centre, x, y), quarter(centre, y, -x)};
  return block("D-block", {.profile = profile, .to = 1.6});
}

PerspectiveSolid cylinder() { return block("cylinder", {.profile = circle({0, 0}, 1.3), .to = 2}); }

PerspectiveSolid soap() {
  SolidBuilder b("soap");
  const Index v0 = b.vertex(0, 0, 0), v1 = b.vertex(3, 0, 0), v2 = b.vertex(3, 2, 0), v3 = b.vertex(0, 2, 0);
  const Index v4 = b.vertex(0, 0, 1), v5 = b.vertex(3, 0, 1), v6 = b.vertex(3, 2, 1), v7 = b.vertex(0, 2, 1);
  for (const auto& [from, to] :
       {std::pair(v0, v1), {v1, v2}, {v2, v3}, {v3, v0}, {v0, v4}, {v1, v5}, {v2, v6}, {v3, v7}}) {
    b.line(from, to);
  }
  b.curve(v4, v5, {0.9, 0, 1.55}, {2.1, 0, 1.55});
  b.curve(v5, v6, {3, 0.6, 1.4}, {3, 1.4, 1.4});
  b.curve(v6, v7, {2.1, 2, 1.55}, {0.9, 2, 1.55});
  b.curve(v7, v4, {0, 1.4, 1.4}, {0, 0.6, 1.4});
  b.face({v3, v2, v1, v0});
  b.face({v0, v1, v5, v4});
  b.face({v1, v2, v6, v5});
  b.face({v2, v3, v7, v6});
  b.face({v3, v0, v4, v7});
  b.face({v4, v5, v6, v7}, false);
  return b.take();
}

PerspectiveSolid camera_body() {
  SolidBuilder b("camera");
  const CameraParts parts = add_camera(b);
  b.face({parts.lens.low_loop});
  return b.take();
}

PerspectiveSolid camera_ring() {
  SolidBuilder b("camera with ring");
  const CameraParts parts = add_camera(b);
  const Prism pocket =
      b.prism({.profile = circle(lens_centre, 0.45), .axis = 1, .from = -0.75, .to = -0.35, .inside_out = true});
  b.face({parts.lens.low_loop, pocket.low_loop});
  b.face({pocket.high_loop});
  b.link(parts.lens.low[0], pocket.low[0]);
  return b.take();
}

std::vector<PerspectiveSolid> all_solids() {
  std::vector<PerspectiveSolid> solids{box(),         l_block(),   t_block(),    wedge(),        cut_corner_box(),
                                       pocket_box(),  two_boxes(), ring_frame(), mitred_frame(), rounded_block(),
                                       d_block(),     cylinder(),  soap(),       bottle(),       camera_body(),
                                       camera_ring(), ball()};
  for (int boxes = 2; boxes <= 6; ++boxes) solids.push_back(stack(boxes));
  return solids;
}

}  // namespace croquis::test
