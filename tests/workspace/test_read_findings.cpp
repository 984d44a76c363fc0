// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "croquis/io/perspective_drawing_file.h"
#include "croquis/io/svg_drawing.h"
#include "croquis/workspace/read_findings.h"
#include "support/trial_operation.h"

namespace croquis::test {
namespace {

/// One finding about each stroke, one about the sheet, and one that two strokes share a name.
const std::string sheet_svg =
    R"(<svg xmlns="http://www.w3.org/2000/svg" xmlns:cq="urn:croquis:perspective:1">
<path id="a" stroke="#F28C00" cq:group="1" d="M 10 10 L 200 30"/>
<path id="b" stroke="#F28C00" cq:weight="-1" d="M 10 90 L 200 80"/>
<path id="c" stroke="#F28C00" cq:group="2" d="M 10 150 L 200 130"/>
<path id="c" stroke="#F28C00" d="M 10 190 L 200 180"/></svg>)";

/// The single point is reported, and no stroke of the drawing.
const std::string sketch_svg =
    R"(<svg xmlns="http://www.w3.org/2000/svg"><path id="a" d="M 10 10 L 200 30"/><path id="dot" d="M 5 5 Z"/>
<path id="a" d="M 10 90 L 200 80"/></svg>)";

using Names = std::vector<std::string>;

Names reported(const ReadFindings& findings, const Document& document) {
  Names names;
  for (const Finding& finding : findings.in(document)) {
    const bool about_stroke = finding.subjects.front().kind == SubjectKind::Stroke;
    names.push_back(finding.code + (about_stroke ? " " + finding.subjects.front().id : ""));
  }
  return names;
}

template <class AnyDrawing>
Document with_drawing(const Document& document, NodeId node, AnyDrawing drawing) {
  Node edited = *document.find(node);
  edited.source = std::make_shared<const AnyDrawing>(std::move(drawing));
  return document.with(std::move(edited));
}

Names without(Names names, const std::string& name) {
  REQUIRE(std::erase(names, name) == 1);
  return names;
}

using Change = std::function<void(PerspectiveStroke&)>;

std::vector<Change> all_changes() {
  return {[](auto& s) { s.id = "other"; },
          [](auto& s) { s.role = StrokeRole::Construction; },
          [](auto& s) { s.group = StrokeGroup::NormalZ; },
          [](auto& s) { s.colour = "#010203"; },
          [](auto& s) { s.pieces[0][1].x() += 1e-9; },
          [](auto& s) { s.pieces.push_back(s.pieces[0]); },
          [](auto& s) { s.straight = !s.straight; },
          [](auto& s) { s.from = "P"; },
          [](auto& s) { s.to = "P"; },
          [](auto& s) { s.link = true; },
          [](auto& s) { s.start_lock = EndLock::Smooth; },
          [](auto& s) { s.end_lock = EndLock::Corner; },
          [](auto& s) { s.hidden = true; },
          [](auto& s) { s.weight = 3; }};
}

}  // namespace

TEST_CASE("a finding about a stroke of a perspective drawing is reported until that stroke is changed or deleted") {
  Progress progress;
  const PerspectiveReadResult file = read_perspective_svg(sheet_svg, "sheet.svg", progress);
  const Document read = Document().with(source_node(std::make_shared<const PerspectiveDrawing>(file.drawing)));
  const NodeId node = read.nodes().front()->id;
  ReadFindings findings;
  findings.add(file.warnings, read);
  const Names all{"GROUP_COLOUR a", "W_VALUE b", "GROUP_COLOUR c", "W_DUPLICATE_ID c-2", "W_NO_SHEET"};
  REQUIRE(reported(findings, read) == all);
  for (std::size_t i = 0; i < file.drawing.strokes.size(); ++i) {
    const Names others = without(all, all[i]);
    for (const Change& change : all_changes()) {
      PerspectiveDrawing edited = file.drawing;
      change(edited.strokes[i]);
      CHECK(reported(findings, with_drawing(read, node, edited)) == others);
    }
    PerspectiveDrawing less = file.drawing;
    less.strokes.erase(less.strokes.begin() + static_cast<std::ptrdiff_t>(i));
    CHECK(reported(findings, with_drawing(read, node, less)) == others);
  }
  CHECK(reported(findings, read.without(node)) == Names{"W_NO_SHEET"});
  CHECK(reported(findings, read) == all);
}

TEST_CASE("what else is changed in a document leaves the findings about strokes as they are") {
  Progress progress;
  PerspectiveReadResult file = read_perspective_svg(sheet_svg, "sheet.svg", progress);
  file.drawing.strokes[0].pieces[0][1].x() = std::numeric_limits<double>::quiet_NaN();
  const Document read = Document().with(source_node(std::make_shared<const PerspectiveDrawing>(file.drawing)));
  const NodeId node = read.nodes().front()->id;
  ReadFindings findings;
  findings.add(file.warnings, read);
  const Names all = reported(findings, read);
  PerspectiveDrawing edited = file.drawing;
  edited.image_size *= 2;
  edited.unit = "mm";
  edited.known_lengths.push_back({"a", 3});
  std::ranges::reverse(edited.strokes);
  edited.strokes.push_back(edited.strokes.front());
  edited.strokes.back().id = "new";
  CHECK(reported(findings, with_drawing(read, node, edited)) == all);
  // Another drawing with strokes of the same names.
  edited.strokes.clear();
  const Document both = read.with(source_node(std::make_shared<const PerspectiveDrawing>(edited), "second"));
  CHECK(reported(findings, both) == all);
  CHECK(reported(findings, with_drawing(both, both.nodes().back()->id, file.drawing)) == all);
}

TEST_CASE("a finding about a stroke of a sketch is reported until that stroke is changed, one left out always") {
  Progress progress;
  const DrawingReadResult file = read_svg_drawing(sketch_svg, "sketch.svg", progress);
  const Document read = Document().with(source_node(std::make_shared<const Drawing>(file.drawing)));
  const NodeId node = read.nodes().front()->id;
  ReadFindings findings;
  findings.add(file.warnings, read);
  REQUIRE(reported(findings, read) == Names{"W_TINY dot", "W_DUPLICATE_ID a-2"});
  Drawing edited = file.drawing;
  edited.strokes[0].samples.pop_back();
  CHECK(reported(findings, with_drawing(read, node, edited)) == Names{"W_TINY dot", "W_DUPLICATE_ID a-2"});
  edited.strokes[1].samples.pop_back();
  CHECK(reported(findings, with_drawing(read, node, edited)) == Names{"W_TINY dot"});
  edited.strokes.clear();
  CHECK(reported(findings, with_drawing(read, node, edited)) == Names{"W_TINY dot"});
  findings.clear();
  CHECK(findings.in(read).empty());
}

TEST_CASE("findings of files that were added later stay beside those of a drawing") {
  Progress progress;
  const DrawingReadResult file = read_svg_drawing(sketch_svg, "sketch.svg", progress);
  const Document read = Document().with(source_node(std::make_shared<const Drawing>(file.drawing)));
  ReadFindings findings;
  findings.add(file.warnings, read);
  Drawing edited = file.drawing;
  edited.strokes[1].closed = true;
  const Document later = with_drawing(read, read.nodes().front()->id, edited).with(source_node(point(1), "mesh"));
  findings.add(
      {make_warning(Category::Malformed, "W_TRIAL", "A face is missing.", {numbered_subject(SubjectKind::Face, 3)})},
      later);
  CHECK(reported(findings, later) == Names{"W_TINY dot", "W_TRIAL"});
  CHECK(reported(findings, read) == Names{"W_TINY dot", "W_DUPLICATE_ID a-2", "W_TRIAL"});
}

}  // namespace croquis::test
