// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <numbers>

#include "support/sketches/characters/character.h"
#include "support/sketches/sketch_layers.h"

namespace croquis::test {
namespace {

/// Places on a circle.
Vec2 polar(const Vec2& centre, double radius, double degrees) {
  const double angle = degrees * std::numbers::pi / 180;
  return centre + radius * Vec2(std::cos(angle), std::sin(angle));
}

Character hand() {
  return {"hand",
          {{"hand",
            smooth({{360, 90},  {350, 200}, {290, 290}, {200, 350}, {170, 400}, {210, 425}, {300, 380},
                    {350, 370}, {335, 480}, {320, 580}, {345, 600}, {370, 580}, {395, 470}, {410, 420},
                    {420, 500}, {425, 620}, {452, 640}, {478, 620}, {480, 500}, {488, 420}, {510, 480},
                    {535, 590}, {562, 600}, {582, 575}, {560, 460}, {552, 400}, {590, 450}, {630, 520},
                    {658, 520}, {665, 490}, {620, 380}, {570, 280}, {545, 190}, {540, 90},  {450, 70}}),
            {}}}};
}

Character hand_with_thumb() {
  return {
      "hand with thumb across",
      {{"index", limb_outline({{370, 330}, {345, 500}, {330, 590}}, {34, 32, 28}), {}},
       {"middle", limb_outline({{440, 340}, {435, 520}, {432, 640}}, {34, 32, 28}), {}},
       {"ring finger", limb_outline({{505, 340}, {520, 510}, {528, 610}}, {33, 31, 27}), {}},
       {"little", limb_outline({{560, 310}, {595, 440}, {615, 520}}, {29, 27, 24}), {}},
       {"palm",
        smooth(
            {{345, 360}, {450, 390}, {570, 360}, {590, 250}, {550, 130}, {530, 70}, {370, 70}, {350, 140}, {325, 250}}),
        {}},
       {"thumb", limb_outline({{290, 190}, {360, 240}, {470, 290}}, {44, 40, 32}), {}}}};
}

Character flower(int petals, const std::string& name) {
  Character flower{name, {}};
  const Vec2 centre(450, 430);
  flower.parts.push_back({"stem", limb_outline({{450, 350}, {440, 200}, {460, 50}}, {16, 16, 16}), {}});
  const double half = 150 * std::sin(std::numbers::pi / petals) * 0.82;
  for (int i = 0; i < petals; ++i) {
    const double degrees = 360.0 * (i + 0.25) / petals;
    flower.parts.push_back(
        {"petal " + std::to_string(i + 1), ellipse(polar(centre, 150, degrees), 85, half, degrees), {}});
  }
  flower.parts.push_back({"middle", circle_outline(centre, 92), {}});
  return flower;
}

Character tree() {
  return {"tree",
          {{"trunk", smooth({{400, 400}, {500, 400}, {490, 220}, {520, 90}, {450, 70}, {370, 90}, {405, 220}}), {}},
           {"back crown", cloud_outline({450, 520}, 150, 110, 9, 0.12), {}},
           {"left crown", cloud_outline({320, 430}, 130, 95, 9, 0.12), {}},
           {"right crown", cloud_outline({580, 430}, 130, 95, 9, 0.12), {}}}};
}

Character mushroom() {
  return {"mushroom",
          {{"stalk", smooth({{400, 400}, {500, 400}, {490, 200}, {530, 80}, {450, 65}, {370, 80}, {410, 200}}), {}},
           {"cap",
            smooth({{180, 350}, {230, 500}, {450, 610}, {670, 500}, {720, 350}, {600, 320}, {450, 310}, {300, 320}}),
            {}},
           {"spot 1", ellipse({340, 450}, 42, 34, 20), {}},
           {"spot 2", ellipse({480, 520}, 48, 36, -10), {}},
           {"spot 3", ellipse({590, 430}, 36, 30, -30), {}}}};
}

Character apple_with_worm() {
  return {"apple with worm",
          {{"stalk", limb_outline({{450, 540}, {470, 640}}, {13, 15}), {}},
           {"leaf", smooth({{470, 590}, {540, 650}, {640, 640}, {570, 580}}), {}},
           {"apple",
            smooth({{450, 545},
                    {560, 580},
                    {670, 480},
                    {650, 280},
                    {540, 130},
                    {450, 140},
                    {360, 130},
                    {250, 280},
                    {230, 480},
                    {340, 580}}),
            {}},
           {"worm", limb_outline({{560, 350}, {620, 400}, {690, 380}, {740, 430}}, {17, 18, 18, 20}), {}}}};
}

Character cherries() {
  return {"cherries",
          {{"left stalk", limb_outline({{300, 260}, {350, 420}, {450, 580}}, {9, 9, 11}), {}},
           {"left cherry", circle_outline({290, 210}, 100), {}},
           {"right cherry", ellipse({560, 180}, 115, 100), {}},
           {"right stalk", limb_outline({{560, 240}, {530, 420}, {455, 585}}, {9, 9, 11}), {}},
           {"leaf", smooth({{440, 590}, {540, 660}, {680, 640}, {760, 570}, {620, 550}}), {}}}};
}

Character snowman() {
  return {"snowman",
          {{"left arm", limb_outline({{370, 390}, {250, 450}}, {12, 9}), {}},
           {"right arm", limb_outline({{530, 390}, {650, 440}}, {12, 9}), {}},
           {"bottom", circle_outline({450, 170}, 135), {}},
           {"middle", circle_outline({450, 370}, 105), {}},
           {"head", circle_outline({450, 525}, 78), {}},
           {"brim", ellipse({450, 590}, 110, 20), {}},
           {"hat", rounded_polygon({{385, 592}, {515, 592}, {510, 690}, {390, 690}}, 14), {}},
           {"left eye", circle_outline({422, 545}, 9), {}},
           {"right eye", circle_outline({478, 545}, 9), {}},
           {"nose", limb_outline({{450, 522}, {510, 510}}, {11, 5}), {}},
           {"upper button", circle_outline({450, 410}, 11), {}},
           {"lower button", circle_outline({450, 345}, 11), {}}}};
}

Character person() {
  return {"person",
          {{"left leg", limb_outline({{405, 260}, {390, 150}, {385, 60}}, {42, 36, 32}), {}},
           {"right leg", limb_outline({{495, 260}, {510, 150}, {515, 60}}, {42, 36, 32}), {}},
           {"left arm", limb_outline({{365, 450}, {290, 370}, {250, 280}}, {32, 28, 26}), {}},
           {"right arm", limb_outline({{535, 450}, {610, 370}, {650, 280}}, {32, 28, 26}), {}},
           {"body",
            smooth({{380, 500}, {450, 515}, {520, 500}, {550, 400}, {540, 250}, {450, 225}, {360, 250}, {350, 400}}),
            {}},
           {"head", ellipse({450, 590}, 80, 92), {}},
           {"left eye", circle_outline({422, 605}, 10), {}},
           {"right eye", circle_outline({478, 605}, 10), {}},
           {"mouth", ellipse({450, 555}, 26, 9), {}}}};
}

Character crossed_arms() {
  return {"crossed arms",
          {{"body",
            smooth({{330, 520}, {450, 560}, {570, 520}, {610, 380}, {570, 150}, {450, 90}, {330, 150}, {290, 380}}),
            {}},
           {"head", circle_outline({450, 620}, 75), {}},
           {"left arm", limb_outline({{310, 480}, {260, 360}, {360, 300}, {520, 350}}, {38, 36, 32, 30}), {}},
           {"right arm", limb_outline({{590, 480}, {640, 360}, {540, 295}, {380, 350}}, {38, 36, 32, 30}), {}}}};
}

Character robot() {
  return {"robot",
          {{"aerial", limb_outline({{450, 600}, {450, 680}}, {8, 8}), {}},
           {"left arm", limb_outline({{320, 400}, {230, 330}, {220, 220}}, {24, 24, 24}), {}},
           {"right arm", limb_outline({{580, 400}, {670, 330}, {680, 220}}, {24, 24, 24}), {}},
           {"left leg", rounded_polygon({{360, 60}, {420, 60}, {420, 230}, {360, 230}}, 14), {}},
           {"right leg", rounded_polygon({{480, 60}, {540, 60}, {540, 230}, {480, 230}}, 14), {}},
           {"body", rounded_polygon({{310, 190}, {590, 190}, {590, 440}, {310, 440}}, 30), {}},
           {"head", rounded_polygon({{350, 430}, {550, 430}, {550, 610}, {350, 610}}, 30), {}},
           {"left eye", circle_outline({410, 540}, 26), {}},
           {"right eye", circle_outline({490, 540}, 26), {}},
           {"mouth", rounded_polygon({{400, 460}, {500, 460}, {500, 485}, {400, 485}}, 10), {}},
           {"panel", rounded_polygon({{380, 250}, {520, 250}, {520, 360}, {380, 360}}, 12), {}}}};
}

}  // namespace

std::vector<Character> people_and_plants() {
  return {hand(),    hand_with_thumb(), flower(8, "flower"), flower(5, "buttercup"),
          tree(),    mushroom(),        apple_with_worm(),   cherries(),
          snowman(), person(),          crossed_arms(),      robot()};
}

}  // namespace croquis::test
