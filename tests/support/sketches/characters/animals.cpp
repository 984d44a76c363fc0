// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/sketches/characters/character.h"
#include "support/sketches/sketch_layers.h"

namespace croquis::test {
namespace {

Character cat() {
  return {
      "cat",
      {{"tail", limb_outline({{560, 160}, {680, 130}, {770, 190}, {760, 290}, {700, 300}}, {24, 24, 22, 20, 16}), {}},
       {"body",
        smooth({{450, 430}, {540, 380}, {600, 240}, {600, 120}, {450, 85}, {300, 120}, {300, 240}, {360, 380}}),
        {}},
       {"left ear", smooth({{335, 560}, {330, 650}, {350, 665}, {400, 620}, {420, 570}, {380, 540}}), {}},
       {"right ear", smooth({{565, 560}, {570, 650}, {550, 665}, {500, 620}, {480, 570}, {520, 540}}), {}},
       {"head", ellipse({450, 500}, 140, 110), {}},
       {"left paw", limb_outline({{410, 250}, {405, 170}, {400, 90}}, {34, 32, 36}), {}},
       {"right paw", limb_outline({{490, 250}, {495, 170}, {500, 90}}, {34, 32, 36}), {}},
       {"left eye", ellipse({400, 525}, 20, 26), {}},
       {"right eye", ellipse({500, 525}, 20, 26), {}},
       {"nose", ellipse({450, 480}, 18, 12), {}}}};
}

Character teddy() {
  return {"teddy",
          {{"left ear", circle_outline({340, 620}, 50), {}},
           {"right ear", circle_outline({560, 620}, 50), {}},
           {"left arm", limb_outline({{370, 360}, {300, 300}, {240, 230}}, {46, 44, 44}), {}},
           {"right arm", limb_outline({{530, 360}, {600, 300}, {660, 230}}, {46, 44, 44}), {}},
           {"body", ellipse({450, 270}, 150, 160), {}},
           {"head", ellipse({450, 520}, 140, 120), {}},
           {"left leg", limb_outline({{370, 150}, {310, 90}}, {58, 62}), {}},
           {"right leg", limb_outline({{530, 150}, {590, 90}}, {58, 62}), {}},
           {"belly", ellipse({450, 275}, 85, 90), {}},
           {"muzzle", ellipse({450, 485}, 56, 42), {}},
           {"left eye", circle_outline({400, 555}, 15), {}},
           {"right eye", circle_outline({500, 555}, 15), {}},
           {"nose", ellipse({450, 500}, 19, 13), {}}}};
}

Character elephant() {
  return {"elephant",
          {{"far fore leg", limb_outline({{420, 280}, {430, 100}}, {46, 46}), {}},
           {"far hind leg", limb_outline({{640, 280}, {650, 100}}, {48, 46}), {}},
           {"tail", limb_outline({{740, 400}, {800, 330}, {805, 240}}, {13, 11, 9}), {}},
           {"body",
            smooth({{340, 440}, {450, 520}, {620, 520}, {760, 440}, {760, 300}, {640, 240}, {460, 230}, {340, 300}}),
            {}},
           {"near fore leg", limb_outline({{380, 290}, {365, 85}}, {56, 52}), {}},
           {"near hind leg", limb_outline({{700, 300}, {715, 85}}, {60, 52}), {}},
           {"trunk", limb_outline({{230, 420}, {140, 340}, {120, 220}, {70, 180}}, {52, 40, 30, 22}), {}},
           {"head", ellipse({280, 460}, 125, 130), {}},
           {"ear", smooth({{300, 570}, {390, 590}, {430, 500}, {400, 400}, {340, 360}, {300, 420}, {290, 500}}), {}},
           {"eye", circle_outline({220, 490}, 14), {}}}};
}

Character fish() {
  return {"fish",
          {{"tail", smooth({{640, 350}, {700, 400}, {800, 480}, {770, 350}, {800, 220}, {700, 300}}), {}},
           {"back fin", smooth({{350, 430}, {420, 560}, {520, 560}, {540, 430}, {450, 400}}), {}},
           {"body",
            smooth({{120, 350}, {220, 450}, {380, 480}, {560, 430}, {690, 350}, {560, 270}, {380, 220}, {220, 250}}),
            {}},
           {"side fin", smooth({{420, 350}, {500, 370}, {540, 320}, {480, 290}, {430, 310}}), {}},
           {"eye", circle_outline({215, 380}, 24), {}}}};
}

Character duck() {
  return {"duck",
          {{"far foot", limb_outline({{500, 200}, {505, 110}, {470, 95}}, {17, 15, 20}), {}},
           {"near foot", limb_outline({{420, 200}, {420, 110}, {385, 90}}, {17, 15, 20}), {}},
           {"body",
            smooth({{250, 350},
                    {350, 400},
                    {520, 380},
                    {680, 470},
                    {720, 430},
                    {660, 260},
                    {520, 180},
                    {340, 180},
                    {240, 260}}),
            {}},
           {"beak", smooth({{210, 560}, {120, 570}, {70, 540}, {120, 510}, {220, 520}}), {}},
           {"head", ellipse({290, 520}, 110, 115), {}},
           {"wing", smooth({{380, 340}, {480, 350}, {600, 330}, {560, 260}, {440, 240}, {380, 280}}), {}},
           {"eye", circle_outline({265, 555}, 17), {}}}};
}

Character bunny() {
  return {"bunny",
          {{"far ear", limb_outline({{300, 560}, {260, 690}}, {30, 20}), {}},
           {"tail", circle_outline({745, 250}, 52), {}},
           {"body", ellipse({560, 260}, 200, 150), {}},
           {"fore leg", limb_outline({{410, 200}, {380, 110}, {340, 85}}, {36, 30, 26}), {}},
           {"head", ellipse({320, 460}, 115, 105), {}},
           {"near ear", limb_outline({{350, 540}, {380, 630}, {430, 690}}, {34, 36, 22}), {}},
           {"thigh", circle_outline({640, 210}, 105), {}},
           {"hind foot", limb_outline({{600, 100}, {710, 95}}, {30, 32}), {}},
           {"eye", circle_outline({290, 490}, 16), {}}}};
}

Character octopus() {
  Character octopus{"octopus", {}};
  const std::vector<std::vector<Vec2>> arms{
      {{390, 340}, {300, 330}, {180, 360}, {110, 300}}, {{400, 310}, {310, 250}, {200, 240}, {120, 180}},
      {{420, 300}, {360, 200}, {270, 140}, {220, 80}},  {{440, 290}, {420, 190}, {390, 110}, {400, 50}},
      {{470, 290}, {490, 190}, {520, 110}, {510, 50}},  {{490, 300}, {550, 200}, {640, 140}, {690, 80}},
      {{510, 310}, {600, 250}, {700, 240}, {790, 180}}, {{520, 340}, {610, 330}, {730, 360}, {800, 300}}};
  for (std::size_t i = 0; i < arms.size(); ++i) {
    octopus.parts.push_back({"arm " + std::to_string(i + 1), limb_outline(arms[i], {34, 30, 22, 13}), {}});
  }
  octopus.parts.push_back({"head", ellipse({455, 460}, 140, 165), {}});
  octopus.parts.push_back({"left eye", circle_outline({405, 440}, 24), {}});
  octopus.parts.push_back({"right eye", circle_outline({505, 440}, 24), {}});
  return octopus;
}

Character snail() {
  return {"snail",
          {{"left feeler", limb_outline({{690, 420}, {660, 520}}, {14, 11}), {}},
           {"right feeler", limb_outline({{730, 420}, {770, 520}}, {14, 11}), {}},
           {"foot",
            smooth({{90, 150},
                    {300, 190},
                    {560, 170},
                    {640, 260},
                    {650, 400},
                    {720, 450},
                    {790, 390},
                    {780, 240},
                    {700, 130},
                    {400, 105}}),
            {}},
           {"shell", circle_outline({390, 340}, 185), {}},
           {"eye", circle_outline({735, 385}, 13), {}}}};
}

Character butterfly() {
  return {"butterfly",
          {{"left fore wing", smooth({{440, 400}, {330, 580}, {180, 620}, {110, 520}, {180, 400}, {330, 350}}), {}},
           {"right fore wing", smooth({{460, 400}, {570, 580}, {720, 620}, {790, 520}, {720, 400}, {570, 350}}), {}},
           {"left hind wing", smooth({{440, 340}, {330, 330}, {210, 270}, {230, 150}, {340, 140}, {420, 240}}), {}},
           {"right hind wing", smooth({{460, 340}, {570, 330}, {690, 270}, {670, 150}, {560, 140}, {480, 240}}), {}},
           {"body", limb_outline({{450, 500}, {450, 340}, {450, 160}}, {26, 34, 18}), {}},
           {"head", circle_outline({450, 555}, 45), {}}}};
}

Character spider() {
  Character spider{"spider", {}};
  for (int i = 0; i < 4; ++i) {
    const double rise = 130 - 105.0 * i;
    spider.parts.push_back(
        {"left leg " + std::to_string(i + 1),
         limb_outline({{400, 360 + 0.2 * rise}, {240, 370 + rise}, {110, 290 + 1.2 * rise}}, {15, 13, 9}),
         {}});
    spider.parts.push_back(
        {"right leg " + std::to_string(i + 1),
         limb_outline({{500, 360 + 0.2 * rise}, {660, 370 + rise}, {790, 290 + 1.2 * rise}}, {15, 13, 9}),
         {}});
  }
  spider.parts.push_back({"abdomen", ellipse({450, 400}, 120, 140), {}});
  spider.parts.push_back({"head", circle_outline({450, 230}, 70), {}});
  return spider;
}

Character turtle() {
  return {"turtle",
          {{"tail", limb_outline({{700, 230}, {800, 200}}, {22, 9}), {}},
           {"fore leg", limb_outline({{330, 220}, {300, 130}}, {44, 42}), {}},
           {"hind leg", limb_outline({{620, 220}, {650, 130}}, {44, 42}), {}},
           {"head", limb_outline({{300, 300}, {200, 380}, {130, 400}}, {46, 44, 54}), {}},
           {"shell", smooth({{230, 250}, {300, 400}, {470, 470}, {640, 400}, {720, 250}, {600, 195}, {350, 195}}), {}},
           {"eye", circle_outline({110, 420}, 11), {}}}};
}

Character whale() {
  return {"whale",
          {{"tail", smooth({{650, 330}, {730, 400}, {760, 520}, {800, 430}, {870, 420}, {800, 350}, {720, 260}}), {}},
           {"body",
            smooth({{70, 300},
                    {130, 450},
                    {330, 510},
                    {560, 420},
                    {720, 340},
                    {700, 260},
                    {520, 170},
                    {260, 140},
                    {110, 190}}),
            {}},
           {"fin", smooth({{350, 260}, {420, 240}, {480, 130}, {400, 110}, {320, 190}}), {}},
           {"eye", circle_outline({180, 330}, 13), {}}}};
}

Character penguin() {
  return {"penguin",
          {{"left foot", ellipse({390, 80}, 62, 26), {}},
           {"right foot", ellipse({520, 80}, 62, 26), {}},
           {"left wing", limb_outline({{330, 420}, {260, 320}, {230, 230}}, {34, 34, 18}), {}},
           {"right wing", limb_outline({{570, 420}, {640, 320}, {670, 230}}, {34, 34, 18}), {}},
           {"body",
            smooth({{450, 520}, {560, 450}, {600, 290}, {560, 120}, {450, 80}, {340, 120}, {300, 290}, {340, 450}}),
            {}},
           {"head", circle_outline({450, 570}, 95), {}},
           {"belly", ellipse({450, 270}, 85, 140), {}},
           {"beak", smooth({{420, 560}, {450, 575}, {480, 560}, {450, 515}}), {}},
           {"left eye", circle_outline({415, 600}, 12), {}},
           {"right eye", circle_outline({485, 600}, 12), {}}}};
}

Character giraffe() {
  return {"giraffe",
          {{"far fore leg", limb_outline({{420, 260}, {425, 70}}, {24, 20}), {}},
           {"far hind leg", limb_outline({{620, 260}, {625, 70}}, {26, 20}), {}},
           {"tail", limb_outline({{680, 330}, {730, 250}, {730, 180}}, {10, 9, 12}), {}},
           {"ear", smooth({{330, 610}, {360, 650}, {400, 640}, {370, 600}}), {}},
           {"neck", limb_outline({{420, 310}, {360, 450}, {310, 580}}, {52, 38, 30}), {}},
           {"body", ellipse({530, 310}, 165, 90), {}},
           {"near fore leg", limb_outline({{460, 270}, {465, 60}}, {30, 24}), {}},
           {"near hind leg", limb_outline({{660, 270}, {670, 60}}, {32, 24}), {}},
           {"head", smooth({{330, 640}, {350, 590}, {310, 550}, {220, 520}, {180, 550}, {250, 600}, {290, 640}}), {}},
           {"eye", circle_outline({295, 600}, 9), {}}}};
}

Character mouse() {
  return {"mouse",
          {{"tail", limb_outline({{640, 190}, {760, 150}, {820, 230}, {800, 330}}, {13, 11, 9, 7}), {}},
           {"body",
            smooth({{160, 230}, {280, 350}, {450, 400}, {620, 340}, {680, 220}, {600, 140}, {400, 120}, {220, 160}}),
            {}},
           {"ear", circle_outline({340, 390}, 72), {}},
           {"eye", circle_outline({240, 265}, 13), {}},
           {"nose", circle_outline({150, 222}, 20), {}}}};
}

Character owl() {
  return {"owl",
          {{"body",
            smooth({{450, 620}, {590, 600}, {630, 420}, {590, 180}, {450, 90}, {310, 180}, {270, 420}, {310, 600}}),
            {}},
           {"left eye", circle_outline({385, 500}, 58), {}},
           {"left pupil", circle_outline({390, 500}, 24), {}},
           {"right eye", circle_outline({515, 500}, 58), {}},
           {"right pupil", circle_outline({510, 500}, 24), {}},
           {"beak", smooth({{430, 440}, {450, 455}, {470, 440}, {450, 395}}), {}},
           {"left wing", smooth({{300, 400}, {350, 330}, {340, 200}, {285, 220}, {255, 320}}), {}},
           {"right wing", smooth({{600, 400}, {550, 330}, {560, 200}, {615, 220}, {645, 320}}), {}}}};
}

Character pig() {
  return {"pig",
          {{"far fore leg", limb_outline({{390, 230}, {395, 110}}, {36, 32}), {}},
           {"far hind leg", limb_outline({{610, 230}, {615, 110}}, {36, 32}), {}},
           {"body", ellipse({510, 310}, 210, 145), {}},
           {"near fore leg", limb_outline({{450, 220}, {450, 90}}, {42, 36}), {}},
           {"near hind leg", limb_outline({{660, 230}, {670, 90}}, {42, 36}), {}},
           {"ear", smooth({{300, 470}, {330, 560}, {390, 530}, {370, 450}}), {}},
           {"head", circle_outline({290, 380}, 115), {}},
           {"snout", ellipse({220, 360}, 50, 42), {}},
           {"left nostril", ellipse({203, 362}, 8, 12), {}},
           {"right nostril", ellipse({233, 362}, 8, 12), {}},
           {"eye", circle_outline({300, 425}, 12), {}}}};
}

}  // namespace

std::vector<Character> animal_characters() {
  return {cat(),    teddy(),  elephant(), fish(),    duck(),    bunny(), octopus(), snail(), butterfly(),
          spider(), turtle(), whale(),    penguin(), giraffe(), mouse(), owl(),     pig()};
}

}  // namespace croquis::test
