// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/sketches/characters/character.h"
#include "support/sketches/sketch_layers.h"

namespace croquis::test {
namespace {

Character teapot() {
  return {
      "teapot",
      {{"spout", limb_outline({{600, 260}, {690, 330}, {750, 440}}, {46, 34, 26}), {}},
       {"handle", limb_outline({{330, 400}, {200, 410}, {150, 300}, {210, 200}, {330, 200}}, {22, 22, 22, 22, 22}), {}},
       {"knob", circle_outline({450, 560}, 30), {}},
       {"lid", ellipse({450, 490}, 130, 46), {}},
       {"body", ellipse({450, 300}, 200, 185), {}}}};
}

Character glasses() {
  return {"glasses",
          {{"left temple", limb_outline({{200, 380}, {120, 420}, {90, 330}}, {14, 13, 12}), {}},
           {"right temple", limb_outline({{700, 380}, {780, 420}, {810, 330}}, {14, 13, 12}), {}},
           {"bridge", limb_outline({{390, 360}, {450, 390}, {510, 360}}, {15, 14, 15}), {}},
           {"left rim", circle_outline({290, 340}, 130), {circle_outline({290, 340}, 98)}},
           {"right rim", circle_outline({610, 340}, 130), {circle_outline({610, 340}, 98)}}}};
}

Character key() {
  return {"key",
          {{"first tooth", limb_outline({{640, 340}, {640, 250}}, {18, 18}), {}},
           {"second tooth", limb_outline({{720, 340}, {720, 230}}, {18, 18}), {}},
           {"shaft", limb_outline({{280, 350}, {500, 350}, {770, 350}}, {24, 24, 24}), {}},
           {"bow", circle_outline({210, 350}, 120), {circle_outline({210, 350}, 72)}}}};
}

Character heart_with_arrow() {
  return {"heart with arrow",
          {{"arrow", limb_outline({{90, 200}, {450, 350}, {785, 489.5}}, {15, 15, 15}), {}},
           {"heart",
            smooth({{450, 520},
                    {540, 610},
                    {680, 570},
                    {690, 430},
                    {580, 260},
                    {450, 110},
                    {320, 260},
                    {210, 430},
                    {220, 570},
                    {360, 610}}),
            {}},
           {"head", smooth({{770, 440}, {850, 520}, {740, 530}}), {}}}};
}

Character car() {
  return {"car",
          {{"aerial", limb_outline({{640, 400}, {700, 560}}, {7, 5}), {}},
           {"body",
            smooth({{90, 200},
                    {100, 290},
                    {220, 320},
                    {320, 430},
                    {540, 440},
                    {660, 330},
                    {800, 290},
                    {820, 200},
                    {700, 170},
                    {450, 165},
                    {200, 170}}),
            {}},
           {"window", smooth({{300, 330}, {360, 400}, {500, 400}, {570, 340}, {440, 315}}), {}},
           {"left wheel", circle_outline({230, 180}, 85), {}},
           {"left hub", circle_outline({230, 180}, 32), {}},
           {"right wheel", circle_outline({660, 180}, 85), {}},
           {"right hub", circle_outline({660, 180}, 32), {}},
           {"lamp", ellipse({775, 255}, 20, 26), {}}}};
}

Character pancakes() {
  Character stack{"pancakes", {{"plate", ellipse({450, 100}, 340, 55), {}}}};
  const double shift[] = {0, 25, -20, 10, -30, 15, 5};
  for (int i = 0; i < 7; ++i) {
    stack.parts.push_back({"pancake " + std::to_string(i + 1), ellipse({450 + shift[i], 140 + 62.0 * i}, 240, 48), {}});
  }
  stack.parts.push_back({"butter", rounded_polygon({{410, 490}, {490, 490}, {490, 545}, {410, 545}}, 12), {}});
  return stack;
}

Character mug() {
  return {
      "mug",
      {{"handle", limb_outline({{560, 420}, {700, 420}, {730, 300}, {680, 200}, {550, 200}}, {26, 26, 26, 26, 26}), {}},
       {"body", rounded_polygon({{230, 90}, {600, 90}, {610, 530}, {220, 530}}, 40), {}}}};
}

Character mug_in_one_line() {
  return {"mug in one line",
          {{"mug",
            smooth({{240, 500},
                    {400, 530},
                    {580, 500},
                    {620, 440},
                    {720, 430},
                    {790, 330},
                    {760, 220},
                    {640, 170},
                    {560, 90},
                    {400, 70},
                    {250, 90},
                    {225, 290}}),
            {smooth({{640, 370}, {700, 360}, {722, 310}, {700, 255}, {640, 245}, {625, 310}})}}}};
}

Character umbrella() {
  return {
      "umbrella",
      {{"stick", limb_outline({{450, 480}, {450, 200}, {470, 90}, {530, 80}, {550, 140}}, {13, 13, 13, 13, 12}), {}},
       {"tip", limb_outline({{450, 560}, {450, 660}}, {11, 7}), {}},
       {"canopy",
        smooth({{120, 340},
                {220, 520},
                {450, 620},
                {680, 520},
                {780, 340},
                {670, 380},
                {560, 350},
                {450, 390},
                {340, 350},
                {230, 380}}),
        {}}}};
}

Character ring_round_finger() {
  // The ring passes behind the finger and in front of it: two layers of one ring, drawn as its front half.
  return {"bone through a ring",
          {{"ring", circle_outline({450, 350}, 190), {circle_outline({450, 350}, 130)}},
           {"bone", limb_outline({{450, 60}, {450, 640}}, {52, 46}), {}}}};
}

Character crossed_sticks() {
  return {"crossed sticks behind a disc",
          {{"first stick", limb_outline({{150, 130}, {750, 570}}, {26, 26}), {}},
           {"second stick", limb_outline({{750, 130}, {150, 570}}, {26, 26}), {}},
           {"disc", circle_outline({450, 350}, 150), {}}}};
}

Character sword() {
  return {"sword",
          {{"blade", limb_outline({{450, 620}, {450, 500}, {450, 250}, {450, 40}}, {20, 24, 26, 9}), {}},
           {"guard", limb_outline({{310, 490}, {590, 490}}, {20, 20}), {}},
           {"pommel", circle_outline({450, 640}, 32), {}}}};
}

Character ice_cream() {
  return {"ice cream",
          {{"cone", smooth({{340, 360}, {450, 380}, {560, 360}, {520, 220}, {450, 50}, {380, 220}}), {}},
           {"left scoop", circle_outline({385, 430}, 95), {}},
           {"right scoop", circle_outline({525, 430}, 95), {}},
           {"top scoop", circle_outline({455, 545}, 90), {}},
           {"cherry", circle_outline({470, 640}, 32), {}}}};
}

Character rocket() {
  return {"rocket",
          {{"flame", smooth({{400, 160}, {500, 160}, {490, 90}, {450, 30}, {410, 90}}), {}},
           {"left fin", smooth({{370, 300}, {280, 220}, {270, 110}, {340, 140}, {400, 190}}), {}},
           {"right fin", smooth({{530, 300}, {620, 220}, {630, 110}, {560, 140}, {500, 190}}), {}},
           {"body",
            smooth({{450, 680}, {540, 540}, {560, 380}, {520, 160}, {450, 140}, {380, 160}, {340, 380}, {360, 540}}),
            {}},
           {"window", circle_outline({450, 470}, 48), {}},
           {"pane", circle_outline({450, 470}, 26), {}}}};
}

Character boat() {
  return {"boat",
          {{"mast", limb_outline({{450, 220}, {450, 640}}, {12, 9}), {}},
           {"sail", smooth({{470, 600}, {600, 440}, {660, 290}, {560, 280}, {470, 290}, {465, 440}}), {}},
           {"hull", smooth({{130, 260}, {300, 240}, {600, 240}, {790, 280}, {690, 130}, {450, 90}, {240, 120}}), {}},
           {"porthole 1", circle_outline({350, 180}, 22), {}},
           {"porthole 2", circle_outline({450, 175}, 22), {}},
           {"porthole 3", circle_outline({550, 180}, 22), {}}}};
}

Character star() { return {"star of 12 points", {{"star", star_outline({450, 350}, 12, 280, 170), {}}}}; }

Character doughnut() {
  return {"doughnut", {{"doughnut", ellipse({450, 350}, 280, 250), {ellipse({450, 350}, 105, 90)}}}};
}

Character two_circles() {
  return {"two circles",
          {{"first", circle_outline({370, 350}, 170), {}}, {"second", circle_outline({560, 380}, 150), {}}}};
}

Character scissors() {
  return {"scissors",
          {{"first blade", limb_outline({{520, 300}, {380, 430}, {200, 610}}, {24, 30, 8}), {}},
           {"first bow", ellipse({640, 180}, 95, 75, -45), {ellipse({640, 180}, 62, 43, -45)}},
           {"second blade", limb_outline({{380, 300}, {520, 430}, {700, 610}}, {24, 30, 8}), {}},
           {"second bow", ellipse({260, 180}, 95, 75, 45), {ellipse({260, 180}, 62, 43, 45)}},
           {"rivet", circle_outline({450, 365}, 13), {}}}};
}

Character chair() {
  return {"chair",
          {{"left post", limb_outline({{310, 620}, {310, 330}, {310, 80}}, {18, 18, 18}), {}},
           {"right post", limb_outline({{590, 620}, {590, 330}, {590, 80}}, {18, 18, 18}), {}},
           {"back rest", limb_outline({{300, 560}, {450, 580}, {600, 560}}, {34, 36, 34}), {}},
           {"seat", ellipse({450, 330}, 190, 48), {}}}};
}

Character bead_string() {
  Character beads{"beads on a string", {{"string", limb_outline({{80, 330}, {450, 300}, {820, 330}}, {9, 9, 9}), {}}}};
  for (int i = 0; i < 5; ++i) {
    beads.parts.push_back(
        {"bead " + std::to_string(i + 1), circle_outline({190 + 130.0 * i, 315 + (i % 2) * 4.0}, 48), {}});
  }
  return beads;
}

}  // namespace

std::vector<Character> thing_characters() {
  return {teapot(),
          glasses(),
          key(),
          heart_with_arrow(),
          car(),
          pancakes(),
          mug(),
          mug_in_one_line(),
          umbrella(),
          ring_round_finger(),
          crossed_sticks(),
          sword(),
          ice_cream(),
          rocket(),
          boat(),
          star(),
          doughnut(),
          two_circles(),
          scissors(),
          chair(),
          bead_string()};
}

}  // namespace croquis::test
