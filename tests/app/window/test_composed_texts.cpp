// SPDX-License-Identifier: GPL-3.0-or-later
// What libraries compose while the program runs, in Korean: steps of the history, findings, names.
#include <QFile>
#include <QLabel>
#include <QListWidget>
#include <QRegularExpression>
#include <QXmlStreamReader>
#include <fstream>
#include <map>
#include <set>

#include <catch2/catch.hpp>

#include "app/files/file_reader.h"
#include "app/hole_scans.h"
#include "app/panels/lists.h"
#include "app/replay/replay_player.h"
#include "app/window/language.h"
#include "croquis/tools/all_steps.h"
#include "support/sketches/sketch_errors.h"

namespace croquis::test {
namespace {

/// English again, whatever a test does.
class InKorean {
 public:
  InKorean() { app::use_language("ko"); }
  ~InKorean() { app::use_language("en"); }
};

/// Hangul, and no English beside names of files, of formats and of what people named.
bool is_all_korean(QString text) {
  static const QRegularExpression names(QStringLiteral(
      "'[^']*'|\"[^\"]*\"|\\w+\\.(croq|svg|obj|ply|stl|off|glb|json|png)|Head|Hex bolt|nodes|moveto|mug|hexbolt|scan|"
      "hoodfront|hood|corners|"
      "JSON|JPEG|PNG|SVG|XML|UTF|\\.croq|Error "
      "parsing.*|STL|PLY|OBJ|OFF|glTF|GLB|OpenCASCADE|Croquis|rbf|auto|contour, .* visible"));
  static const QRegularExpression hangul(QStringLiteral("[\\x{ac00}-\\x{d7a3}]"));
  static const QRegularExpression english(QStringLiteral("[A-Za-z]{2}"));
  text.remove(names);
  return text.contains(hangul) && !text.contains(english);
}

std::map<QString, QString> korean_texts() {
  QFile file(CROQUIS_SOURCE_DIR "/languages/croquis_ko.ts");
  REQUIRE(file.open(QIODevice::ReadOnly));
  QXmlStreamReader reader(&file);
  std::map<QString, QString> texts;
  QString source;
  while (!reader.atEnd()) {
    if (reader.readNext() != QXmlStreamReader::StartElement) continue;
    if (reader.name() == QLatin1String("source")) source = reader.readElementText();
    if (reader.name() == QLatin1String("translation")) texts[source] = reader.readElementText();
  }
  return texts;
}

QString with_values(QString text) {
  for (int i = 1; i <= 9; ++i) text.replace("%" + QString::number(i), "q" + QString::number(10 + i));
  return text;
}

/// Plays steps, or actions by their names, and collects all that the list of the history shows meanwhile.
void collect_steps(StudioFixture& hand, const QString& steps, std::set<QString>& shown) {
  const auto* list = hand.window().findChild<app::HistoryList*>("history");
  for (const QString& step : steps.split(" | ")) {
    if (step.startsWith('{')) app::play(hand.window(), recorded::parse(step.toStdString(), "", recorded::all_steps()));
    if (!step.startsWith('{')) hand.act(step);
    hand.settle();
    for (int row = 0; row < list->count(); ++row) shown.insert(list->item(row)->text());
  }
}

/// Names and contents; ';' ends a line.
constexpr const char* bad_files =
    R"(empty.obj> ## index.obj>v 0 0 0;v 1 0 0;v 0 1 0;f 1 2 9 ## number.obj>v 0 0 x;v 1 0 0;v 0 1 0;f 1 2 3)"
    R"( ## corners.obj>v 0 0 0;v 1 0 0;f 1 2 ## faceless.obj>v 0 0 0;v 1 0 0 ## word.obj>v 0 0 0;foo 3)"
    R"( ## infinite.obj>v 0 0 inf;v 1 0 0;v 0 1 0;f 1 2 3 ## point.obj>v 0 0 0;v 0 0 0;v 0 0 0;f 1 2 3 ## short.stl>abc)"
    R"( ## facets.stl>solid a;facet normal 0 0 1;outer loop;vertex 0 0 0;endloop;endfacet;endsolid a ## head.ply>plyy)"
    R"( ## format.ply>ply;end_header; ## property.ply>ply;format ascii 1.0;property float x;end_header; ## begin.off>OOF;)"
    R"( ## cut.ply>ply;format ascii 1.0;element vertex 9;property float x;end_header;0; ## counts.off>OFF;1 x 0;)"
    R"( ## short.off>OFF;900 900 0; ## magic.glb>glTX ## short.glb>glTF ## empty.svg> ## broken.svg><svg><path)"
    R"( ## other.svg><html></html> ## blank.svg><svg xmlns='http://www.w3.org/2000/svg'></svg>)"
    R"( ## path.svg><svg xmlns='http://www.w3.org/2000/svg'><path d='L 3 4'/></svg> ## picture.png>no picture)"
    R"( ## list.json>{"format":"croquis-abs/1","nodes":3} ## project.croq>no project ## empty.croq>)"
    R"( ## node.json>{"format":"croquis-abs/1","nodes":[{"id":"a","at":[0,0]}]})";

void draw_circle(StudioFixture& hand, double x, double radius) {
  std::vector<Vec2> places;
  for (int k = 0; k <= 40; ++k)
    places.emplace_back(x + radius * std::cos(M_PI * k / 20), radius * std::sin(M_PI * k / 20));
  hand.draw(places);
}

}  // namespace

TEST_CASE("every composed text is Korean with its values, and none is taken for another", "[composed-texts]") {
  const std::map<QString, QString> korean = korean_texts();
  QFile file(CROQUIS_SOURCE_DIR "/languages/composed.txt");
  REQUIRE(file.open(QIODevice::ReadOnly));
  CHECK(app::localized("Erase stroke 3") == "Erase stroke 3");
  const InKorean speaking;
  int lines = 0;
  for (const QString& line : QString::fromUtf8(file.readAll()).split('\n', Qt::SkipEmptyParts)) {
    if (line.startsWith('#')) continue;
    INFO(line.toStdString());
    REQUIRE(korean.contains(line));
    const QString translated = with_values(korean.at(line));
    CHECK(app::localized(with_values(line).toStdString()).toStdString() == translated.toStdString());
    ++lines;
  }
  CHECK(lines > 600);
  CHECK(app::localized("Erase stroke 3") == QStringLiteral("획 3 지우기"));
  CHECK(app::localized("'a.obj', line 3: there is no vertex 9.") ==
        QStringLiteral("'a.obj' 3행: 정점 9이(가) 없습니다."));
  CHECK(app::localized("STL can't hold normals, colours and groups.")
            .startsWith(QStringLiteral("STL 형식에는 노멀, 색상")));
  CHECK(app::localized("Gnome 2") == "Gnome 2");
  CHECK(app::localized("Bulge 0.2") == QStringLiteral("볼록함 0.2"));
  CHECK(app::localized("Smoothing Triangles (Loop)") == QStringLiteral("스무딩 삼각형 (Loop)"));
}

TEST_CASE("whatever is done in a Korean window has a Korean step in the history, with the names that people gave",
          "[composed-texts]") {
  const InKorean speaking;
  std::set<QString> shown;
  StudioFixture hand;
  hand.window().set_unattended();
  hand.window().start_with();
  hand.look_at({-200, -200}, {200, 200});
  for (const double radius : {60, 20}) draw_circle(hand, 0, radius);
  draw_circle(hand, 80, 50);
  hand.settle();
  collect_steps(
      hand,
      R"({"do":"drag","stroke":"stroke 1","by":[4,9]} | {"do":"stroke-set","stroke":"stroke 2","kind":"hole"} | )"
      R"({"do":"stroke-set","stroke":"stroke 2","kind":"visible"} | )"
      R"({"do":"stroke-set","stroke":"stroke 1","in-front-of":"stroke 3"} | )"
      R"({"do":"stroke-set","stroke":"stroke 3","thickness":0.5} | add-step-subdivide | )"
      R"({"do":"set","node":"subdivide","parameter":"levels","value":1} | step-on | step-on | freeze-step | undo | )"
      R"(add-sketch-top)",
      shown);
  rename_object(hand.studio(), hand.studio().objects().front().node, "Head");
  const auto* objects = hand.window().findChild<app::ObjectList*>("objects");
  CHECK(objects->topLevelItem(0)->text(0) == "Head");
  CHECK(objects->topLevelItem(1)->text(0).startsWith(QStringLiteral("스케치")));
  for (const char* name : {"mug.obj", "hex_bolt.obj"})
    REQUIRE(hand.window().open(QString(CROQUIS_SOURCE_DIR "/examples/data/") + name));
  collect_steps(
      hand,
      R"(group | duplicate-object | hide | delete-object | {"do":"select","nodes":["mug"]} | edge-mode | )"
      R"({"do":"loop-cut","node":"mug","edge":3,"at":0.4} | {"do":"edit","node":"mug","line":"inset faces=10 width=0.01"} | )"
      R"({"do":"tag","node":"mug","edges":"sharper-than","degrees":80,"sharpness":2.5} | )"
      R"({"do":"edit","node":"mug","line":"extrude faces=0,1 by=0,0.2,0.1"} | {"do":"move","node":"mug","by":[0.05,0,0]} | )"
      R"({"do":"rotate","node":"mug","axis":[0,1,0],"degrees":5} | {"do":"scale","node":"mug","factors":[0.9,0.9,0.9]} | )"
      R"({"do":"edit","node":"mug","line":"pin vertices=0-3"} | delete | show-smooth | freeze)",
      shown);
  REQUIRE(hand.window().open(CROQUIS_SOURCE_DIR "/examples/data/surface/car_crashed.json"));
  collect_steps(
      hand,
      R"({"do":"surface-join","curves":["hoodfront"],"join":"crease"} | {"do":"surface-split","curve":"hoodfront","at":0.5} | )"
      R"({"do":"surface-set-faces","faces":["hood"],"fullness":0.3})",
      shown);
  open_scan(hand, ball_with_holes(4));
  collect_steps(
      hand,
      R"({"do":"hole","holes":[2]} | {"do":"hole","holes":[1,3]} | fill-inner | )"
      R"({"do":"hole","holes":[3],"action":"remove"} | {"do":"set","node":"fill","parameter":"bulge","value":0.2})",
      shown);
  for (const QString& step : shown) {
    INFO(step.toStdString());
    CHECK(is_all_korean(step));
  }
  CHECK(shown.size() >= 30);
}

TEST_CASE("findings about bad drawings and files are Korean", "[composed-texts]") {
  const InKorean speaking;
  StudioFixture hand;
  hand.window().set_unattended();
  std::set<QString> shown;
  const auto* findings = hand.window().findChild<app::FindingsList*>("findings");
  for (const ErrorSketch& sketch : error_sketches()) {
    app::start_with(hand.studio(), sketch.drawing);
    hand.settle();
    for (int row = 0; row < findings->count(); ++row) shown.insert(findings->item(row)->text());
  }
  for (const QString& each : QString(bad_files).split(" ## ")) {
    const QString path = hand.folder() + "/" + each.section('>', 0, 0);
    std::ofstream(path.toStdString(), std::ios::binary) << each.section('>', 1).replace(';', '\n').toStdString();
    hand.window().open(path);
    hand.settle();
    const QStringList sentences = app::sentences_of(hand.window().parts().last_findings, path);
    INFO(path.toStdString());
    CHECK(!sentences.isEmpty());
    CHECK(hand.window().findChild<QLabel*>("message")->text().startsWith(sentences.value(0)));
    for (const QString& sentence : sentences) shown.insert(sentence);
  }
  for (const QString& sentence : shown) {
    INFO(sentence.toStdString());
    CHECK(is_all_korean(sentence));
  }
  CHECK(shown.size() >= 25);
}

TEST_CASE("lists of known texts are translated one by one", "[composed-texts]") {
  const InKorean speaking;
  CHECK(app::localized("STL can't hold normals.").contains(app::localized("normals")));
  const QString lost = app::localized("STL can't hold the order of vertices, normals and names of objects.");
  INFO(lost.toStdString());
  CHECK(is_all_korean(lost));
  for (const char* part : {"the order of vertices", "normals", "names of objects"})
    CHECK(lost.contains(app::localized(part)));
}

}  // namespace croquis::test
