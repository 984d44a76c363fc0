// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <numbers>

#include "support/sketches/sketch_gallery.h"
#include "support/sketches/sketch_layers.h"
#include "support/sketches/sketch_spline.h"
#include "support/sketches/sketch_tubes.h"

namespace croquis::test {
namespace {

/// A part drawn along its own middle line.
LayeredPart limb_part(const std::vector<Vec2>& through, const std::vector<double>& radii, int priority) {
  return {tube_outline(limb(through, radii, 0)), priority};
}

LayeredPart blob(const std::vector<Vec2>& through, int priority) { return {smooth_loop(through), priority}; }

}  // namespace

Sketch dog_sketch() {
  return layered_sketch({
      // Body, from chest to rump.
      blob({{300, 420},
            {400, 425},
            {520, 418},
            {640, 428},
            {712, 395},
            {728, 325},
            {690, 262},
            {600, 258},
            {500, 270},
            {400, 258},
            {310, 255},
            {258, 300},
            {255, 370}},
           5),
      // Head with its muzzle to the left.
      blob({{205, 590},
            {275, 596},
            {335, 560},
            {352, 495},
            {330, 430},
            {275, 398},
            {222, 402},
            {178, 422},
            {120, 424},
            {80, 446},
            {78, 486},
            {112, 506},
            {150, 520},
            {168, 562}},
           7),
      // The near ear hangs over the back of the head.
      blob({{262, 560},
            {300, 585},
            {352, 582},
            {392, 552},
            {408, 500},
            {396, 462},
            {368, 458},
            {352, 488},
            {332, 525},
            {292, 536}},
           9),
      // Near legs, before the body.
      limb_part({{340, 330}, {335, 240}, {338, 150}, {322, 92}}, {48, 38, 31, 34}, 8),
      limb_part({{638, 318}, {662, 235}, {646, 160}, {630, 92}}, {52, 42, 31, 34}, 8),
      // Far legs: their tops end a little behind the belly's edge.
      limb_part({{432, 285}, {438, 220}, {442, 165}, {426, 112}}, {34, 32, 29, 31}, 2),
      limb_part({{552, 285}, {552, 220}, {536, 165}, {534, 112}}, {36, 33, 29, 31}, 1),
      // Tail, wagging behind the rump.
      limb_part({{684, 384}, {756, 440}, {806, 512}, {810, 596}}, {20, 22, 20, 15}, 3),
  });
}

Sketch duck_sketch() {
  return layered_sketch({
      // Body with a raised stern.
      blob({{240, 330},
            {330, 372},
            {470, 366},
            {600, 372},
            {700, 425},
            {772, 462},
            {765, 385},
            {700, 270},
            {590, 185},
            {440, 160},
            {300, 185},
            {228, 255}},
           4),
      // Head and neck.
      blob({{265, 640},
            {335, 628},
            {376, 570},
            {368, 505},
            {345, 445},
            {350, 370},
            {318, 305},
            {262, 300},
            {225, 350},
            {222, 430},
            {200, 490},
            {185, 555},
            {208, 615}},
           6),
      // Beak, from behind the cheek.
      blob({{215, 586}, {170, 584}, {112, 562}, {70, 540}, {74, 515}, {125, 508}, {175, 508}, {225, 520}, {245, 555}},
           2),
      // Wing over the flank, its tip beyond the stern.
      blob({{408, 322},
            {470, 338},
            {560, 326},
            {660, 330},
            {760, 330},
            {815, 312},
            {770, 285},
            {690, 258},
            {600, 246},
            {500, 240},
            {425, 262},
            {388, 292}},
           7),
      // Near foot over the belly's edge, far foot behind it.
      limb_part({{425, 192}, {432, 120}, {390, 75}}, {21, 18, 24}, 8),
      limb_part({{545, 200}, {558, 125}, {522, 88}}, {22, 17, 22}, 1),
  });
}

Sketch octopus_sketch() {
  const Vec2 centre(450, 480);
  // In the head's own polar coordinates: 1 is its outline.
  const auto place = [&](double radius, double degrees) -> Vec2 {
    const double angle = degrees * std::numbers::pi / 180;
    return centre + radius * Vec2(150 * std::cos(angle), 172 * std::sin(angle));
  };
  std::vector<Vec2> head;
  for (int i = 0; i < 12; ++i) head.push_back(place(1, 30.0 * i));
  std::vector<LayeredPart> parts{blob(head, 20)};
  for (int k = 0; k < 8; ++k) {
    const double root = 180 + 180.0 / 7 * k;
    // The two in the middle swap places, so that one lies over the other; the rest curl outwards.
    const double way = k < 4 ? 1 : -1;
    const bool middle = k == 3 || k == 4;
    const std::vector<Vec2> line{
        place(0.85, root), place(1.3, root + (middle ? 0 : 4 * way)), place(1.75, root + way * (middle ? 13 : 2)),
        place(2.2, root + way * (middle ? 27 : -9)), place(2.45, root + way * (middle ? 28 : -24))};
    parts.push_back(limb_part(line, {24, 24, 21, 18, 14}, k + 1));
  }
  return layered_sketch(parts);
}

Sketch bear_sketch() {
  return layered_sketch({
      {circle_outline({450, 520}, 130), 6},  // head
      blob({{450, 420}, {560, 400}, {620, 280}, {570, 160}, {450, 130}, {330, 160}, {280, 280}, {340, 400}}, 4),
      {circle_outline({345, 630}, 55), 2},  // ears behind the head
      {circle_outline({555, 630}, 55), 1},
      limb_part({{340, 345}, {250, 300}, {190, 230}}, {44, 42, 40}, 7),  // arms before the body
      limb_part({{560, 345}, {650, 300}, {710, 230}}, {44, 42, 40}, 8),
      limb_part({{375, 190}, {330, 110}, {300, 60}}, {56, 52, 50}, 3),  // legs behind it
      limb_part({{525, 190}, {570, 110}, {600, 60}}, {56, 52, 50}, 0),
  });
}

Sketch fish_sketch() {
  return layered_sketch({
      blob({{160, 350}, {260, 450}, {420, 490}, {560, 440}, {660, 350}, {560, 260}, {420, 210}, {260, 250}}, 5),
      blob({{610, 350}, {720, 430}, {810, 500}, {780, 350}, {810, 200}, {720, 270}}, 2),  // tail
      blob({{340, 460}, {400, 560}, {500, 600}, {520, 540}, {490, 430}, {420, 420}}, 3),  // fin on its back
      blob({{400, 290}, {450, 310}, {530, 270}, {590, 190}, {530, 170}, {440, 200}}, 7),  // fin in front
      limb_part({{300, 270}, {310, 190}, {350, 130}}, {34, 28, 20}, 1),                   // fin below
  });
}

Sketch mushroom_sketch() {
  return layered_sketch({
      blob({{140, 430}, {220, 570}, {400, 650}, {600, 610}, {730, 480}, {750, 400}, {600, 370}, {430, 380}, {260, 375}},
           5),
      limb_part({{430, 420}, {440, 300}, {460, 150}}, {80, 86, 100}, 3),
      limb_part({{600, 230}, {640, 160}, {650, 80}}, {40, 45, 50}, 2),
      {circle_outline({630, 255}, 85), 6},
      limb_part({{250, 90}, {330, 130}, {420, 150}}, {30, 36, 40}, 7),
  });
}

}  // namespace croquis::test
