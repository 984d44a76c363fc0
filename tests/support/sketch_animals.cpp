// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/sketch_gallery.h"
#include "support/sketch_layers.h"
#include "support/sketch_spline.h"
#include "support/sketch_tubes.h"

#include <cmath>
#include <numbers>

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
      // The near ear hangs over the cheek.
      limb_part({{282, 560}, {322, 520}, {336, 462}, {330, 410}}, {24, 32, 36, 27}, 9),
      // Near legs, before the body.
      limb_part({{340, 330}, {335, 240}, {338, 150}, {322, 92}}, {48, 38, 31, 34}, 8),
      limb_part({{655, 335}, {668, 245}, {640, 160}, {642, 92}}, {60, 44, 32, 34}, 8),
      // Far legs, behind it.
      limb_part({{425, 330}, {432, 240}, {440, 165}, {424, 112}}, {40, 34, 29, 31}, 2),
      limb_part({{560, 330}, {556, 240}, {535, 170}, {534, 112}}, {44, 36, 29, 31}, 1),
      // Tail, wagging behind the rump.
      limb_part({{660, 370}, {745, 430}, {800, 505}, {805, 590}}, {26, 25, 22, 17}, 3),
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
      // Beak, behind the cheek.
      blob({{235, 590}, {180, 582}, {120, 560}, {72, 540}, {76, 516}, {130, 508}, {190, 506}, {240, 520}}, 2),
      // Wing, over the flank.
      blob({{395, 330},
            {470, 338},
            {560, 330},
            {650, 345},
            {735, 348},
            {690, 285},
            {600, 225},
            {500, 210},
            {420, 235},
            {380, 285}},
           7),
      // Near foot over the belly's edge, far foot behind it.
      limb_part({{440, 215}, {445, 130}, {405, 80}}, {28, 20, 26}, 8),
      limb_part({{545, 225}, {560, 130}, {525, 92}}, {26, 18, 23}, 1),
  });
}

Sketch octopus_sketch() {
  return layered_sketch({
      blob({{450, 650},
            {545, 622},
            {598, 540},
            {590, 450},
            {545, 375},
            {505, 318},
            {450, 302},
            {395, 318},
            {355, 375},
            {310, 450},
            {302, 540},
            {355, 622}},
           20),
      limb_part({{380, 390}, {290, 330}, {190, 330}, {120, 400}, {105, 490}}, {36, 32, 27, 22, 15}, 6),
      limb_part({{390, 370}, {300, 262}, {200, 215}, {110, 235}, {60, 300}}, {36, 32, 27, 22, 15}, 7),
      limb_part({{410, 360}, {345, 235}, {275, 140}, {185, 95}, {95, 105}}, {36, 32, 27, 22, 15}, 8),
      limb_part({{435, 360}, {410, 230}, {430, 140}, {400, 70}, {330, 45}}, {36, 32, 27, 22, 15}, 9),
      limb_part({{465, 360}, {505, 235}, {480, 145}, {505, 75}, {575, 50}}, {36, 32, 27, 22, 15}, 10),
      limb_part({{490, 360}, {555, 235}, {625, 140}, {715, 95}, {805, 105}}, {36, 32, 27, 22, 15}, 5),
      limb_part({{510, 370}, {600, 262}, {700, 215}, {790, 235}, {840, 300}}, {36, 32, 27, 22, 15}, 4),
      limb_part({{520, 390}, {610, 330}, {710, 330}, {780, 400}, {795, 490}}, {36, 32, 27, 22, 15}, 3),
  });
}

}  // namespace croquis::test
