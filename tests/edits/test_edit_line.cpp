// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include <catch2/catch.hpp>

#include "croquis/base/error.h"
#include "croquis/edits/edit_line.h"
#include "support/random.h"

namespace croquis {
namespace {

std::vector<EditLine> parse(const std::string& text) { return parse_edit_lines(text); }

/// The sentences with which a text is refused.
std::vector<std::string> refusals(const std::string& text) {
  std::vector<std::string> sentences;
  try {
    parse(text);
  } catch (const Error& error) {
    for (const Finding& finding : error.findings()) {
      CHECK(finding.code == "E_EDIT");
      sentences.push_back(finding.message);
    }
  }
  return sentences;
}

/// Any edit with any elements and values of its parameters.
EditLine random_line(test::Random& random) {
  const auto& edits = all_edits();
  const EditDescription description = edits[random.below(static_cast<std::uint32_t>(edits.size()))].description;
  EditLine line;
  line.edit = description.id;
  line.target.kind = description.kinds[random.below(static_cast<std::uint32_t>(description.kinds.size()))];
  line.target.all = random.below(4) == 0;
  for (std::uint32_t k = 1 + random.below(6); k > 0 && !line.target.all; --k) {
    line.target.elements.push_back(random.below(40));
  }
  for (const ParameterDescription& parameter : description.parameters) {
    if (random.below(2) == 0) continue;
    ParameterValue value = parameter.default_value;
    if (parameter.type == ParameterType::Number) value = random.between(0, 1);
    if (parameter.type == ParameterType::Text) value = "0.5,-2,1e-3";
    if (parameter.type == ParameterType::Flag) value = random.below(2) == 0;
    line.parameters[parameter.name] = value;
  }
  return line;
}

TEST_CASE("an edit comes back from its line, whatever it is") {
  test::Random random(3);
  std::string text;
  std::vector<EditLine> lines;
  for (int round = 0; round < 400; ++round) {
    lines.push_back(random_line(random));
    INFO(to_text(lines.back()));
    CHECK(parse(to_text(lines.back())) == std::vector<EditLine>{lines.back()});
    text += to_text(lines.back()) + (round % 2 == 0 ? ";" : "\n");
  }
  CHECK(parse(text) == lines);
}

TEST_CASE("lines are read with blanks, comments and words in any order") {
  const std::vector<EditLine> lines =
      parse("# a box with a hole\r\n  inset   width=0.25 faces=5 ;;\n\nextrude faces=0,2-4 by=0,0,-1");
  REQUIRE(lines.size() == 2);
  CHECK(lines[0].edit == "inset");
  CHECK(lines[0].target == EditTarget{ComponentKind::Face, false, {5}});
  CHECK(lines[0].parameters == ParameterValues{{"width", 0.25}});
  CHECK(lines[1].target.elements == Elements{0, 2, 3, 4});
  CHECK(lines[1].parameters == ParameterValues{{"by", std::string("0,0,-1")}});
  CHECK(parse("").empty());
  CHECK(parse("pin vertices=all pinned=false").front().target.all);
}

TEST_CASE("every line that can't be understood is named with what would do") {
  struct Case {
    const char* line;
    const char* word;
  };
  for (const Case& wrong :
       {Case{"melt faces=1", "extrude"}, Case{"extrude by=0,0,1", "faces="}, Case{"extrude edges=1 by=0,0,1", "faces="},
        Case{"extrude faces=x", "'x'"}, Case{"extrude faces=3-1", "'3-1'"}, Case{"extrude faces=", "names no element"},
        Case{"extrude faces=1 faces=2", "twice"}, Case{"extrude faces=1 height=2", "distance="},
        Case{"extrude faces=1 distance=far", "a number"}, Case{"inset faces=1 width=-1", "at least 0"},
        Case{"loop-cut edges=1 at", "name=value"}, Case{"pin vertices=1 pinned=maybe", "true or false"},
        Case{"inset faces=1 width=1 width=2", "twice"}}) {
    INFO(wrong.line);
    const std::vector<std::string> sentences = refusals(wrong.line);
    REQUIRE(sentences.size() == 1);
    CHECK(sentences.front().starts_with("'" + std::string(wrong.line) + "'"));
    CHECK(sentences.front().find(wrong.word) != std::string::npos);
    CHECK(std::count(sentences.front().begin(), sentences.front().end(), '\n') == 0);
  }
  CHECK(refusals("melt faces=1; move faces=0 by=1,0,0; dissolve faces=1").size() == 2);
}

TEST_CASE("edits have names and sentences of their own, and defaults that fit") {
  std::vector<std::string> ids;
  for (const Edit& edit : all_edits()) {
    const EditDescription& description = edit.description;
    INFO(description.id);
    CHECK(find_edit(description.id) == &edit);
    CHECK(std::find(ids.begin(), ids.end(), description.id) == ids.end());
    CHECK(!description.kinds.empty());
    CHECK(description.sentence.ends_with('.'));
    CHECK_NOTHROW(complete(description.parameters, {}));
    for (const ParameterDescription& parameter : description.parameters) {
      CHECK(parse_parameter(parameter, to_text(parameter.default_value)) == parameter.default_value);
    }
    ids.push_back(description.id);
  }
  CHECK(find_edit("melt") == nullptr);
}

}  // namespace
}  // namespace croquis
