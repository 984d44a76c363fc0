// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>

#include "croquis/base/error.h"
#include "croquis/tools/all_steps.h"
#include "croquis/tools/recording/recording.h"
#include "croquis/tools/silhouette/sketch_steps.h"
#include "croquis/tools/silhouette/stroke_setting.h"
#include "tools/strokes/drawn_strokes.h"

namespace croquis {
namespace {

using silhouette::is_set_behind;
using silhouette::StrokeKind;

/// Three circles that were drawn one after the other.
Drawing circles() {
  Drawing drawing;
  for (int i = 0; i < 3; ++i) drawing.strokes.push_back(test::circle("c" + std::to_string(i), {60.0 * i, 0}, 50));
  return drawing;
}

const Stroke& stroke(const Drawing& drawing, const std::string& id) { return *find_stroke(drawing, id); }

TEST_CASE("an inner outline is set to be a hole or a part") {
  const Drawing before = circles();
  const DrawingEdit hole = set_kind(before, "c1", StrokeKind::Hole);
  CHECK(hole.changed == std::vector<std::string>{"c1"});
  CHECK(silhouette::stroke_kind(stroke(hole.drawing, "c1")) == StrokeKind::Hole);
  CHECK(silhouette::stroke_kind(stroke(set_kind(hole.drawing, "c1", StrokeKind::Part).drawing, "c1")) ==
        StrokeKind::Part);
  CHECK_THROWS_AS(set_kind(before, "c7", StrokeKind::Part), Error);
}

TEST_CASE("which of two strokes lies in front is said of the one drawn later, and taken back") {
  const Drawing before = circles();
  const Drawing swapped = set_in_front(before, "c0", "c2").drawing;
  CHECK(is_set_behind(stroke(swapped, "c2"), stroke(swapped, "c0")));
  CHECK(!is_set_behind(stroke(swapped, "c2"), stroke(swapped, "c1")));
  const Drawing back = set_in_front(swapped, "c2", "c0").drawing;
  for (const Stroke& one : back.strokes) CHECK(one.data == stroke(before, one.id).data);
  const Drawing both = set_in_front(swapped, "c1", "c2").drawing;
  CHECK(stroke(both, "c2").data.at("behind") == "c0,c1");
  CHECK(stroke(set_in_front(both, "c2", "c0").drawing, "c2").data.at("behind") == "c1");
}

TEST_CASE("a stroke drawn behind all comes in front of one alone") {
  Drawing drawing = circles();
  drawing.strokes[2].data["behind"] = "all";
  const Drawing front = set_in_front(drawing, "c2", "c0").drawing;
  CHECK(stroke(front, "c2").data.at("behind") == "c1");
  CHECK(stroke(set_in_front(drawing, "c1", "c2").drawing, "c2").data.at("behind") == "all");
}

TEST_CASE("an open stroke, which may be a limb in front, is set to lie behind even where it was drawn first") {
  Drawing drawing = circles();
  drawing.strokes[0].closed = false;
  const Drawing behind = set_in_front(drawing, "c1", "c0").drawing;
  CHECK(is_set_behind(stroke(behind, "c0"), stroke(behind, "c1")));
  CHECK(!is_set_behind(stroke(set_in_front(behind, "c0", "c1").drawing, "c0"), stroke(behind, "c1")));
}

TEST_CASE("thickness is kept by the stroke, or by the group of a part with a name") {
  Drawing drawing = circles();
  drawing.strokes[1].object = "tail fin";
  CHECK(thickness_of(drawing, "c0") == 1);
  const Drawing thin = set_thickness(drawing, "c0", 0.4).drawing;
  CHECK(stroke(thin, "c0").data.at("thickness") == "0.4");
  CHECK(thickness_of(thin, "c0") == 0.4);
  CHECK(thickness_of(thin, "c1") == 1);
  const Drawing fin = set_thickness(drawing, "c1", 0.2).drawing;
  CHECK(fin.object_data.at("tail fin").at("thickness") == "0.2");
  CHECK(thickness_of(fin, "c1") == 0.2);
  CHECK(thickness_of(set_thickness(drawing, "c0", 100).drawing, "c0") == most_thickness);
  CHECK(thickness_of(set_thickness(drawing, "c0", 0).drawing, "c0") == least_thickness);
  CHECK(!stroke(set_thickness(thin, "c0", 1).drawing, "c0").data.contains("thickness"));
  drawing.strokes[0].data["thickness"] = "flat";
  CHECK(thickness_of(drawing, "c0") == 1);
}

TEST_CASE("recorded settings are read as they were written, and one of each line") {
  const std::vector<std::string> lines{R"({"do":"stroke-set","stroke":"stroke 2","kind":"part"})",
                                       R"({"do":"stroke-set","stroke":"stroke 2","in-front-of":"stroke 1"})",
                                       R"({"do":"stroke-set","stroke":"stroke 2","thickness":0.5})"};
  for (const std::string& line : lines)
    CHECK(recorded::to_line(recorded::parse(line, "r", recorded::all_steps()).front().step) == line);
  for (const char* wrong :
       {R"({"do":"stroke-set","stroke":"a"})", R"({"do":"stroke-set","stroke":"a","kind":"part","thickness":1})",
        R"({"do":"stroke-set","stroke":"a","thickness":0})", R"({"do":"stroke-set","stroke":"a","kind":"lid"})"})
    CHECK_THROWS_AS(recorded::parse(wrong, "r", recorded::all_steps()), Error);
}

}  // namespace
}  // namespace croquis
