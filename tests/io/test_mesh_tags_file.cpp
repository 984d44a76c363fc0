// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>

#include "croquis/base/error.h"
#include "croquis/io/json.h"
#include "croquis/io/mesh_tags_file.h"

using namespace croquis;

namespace {

MeshTagsReadResult parsed(const std::string& text) { return read_mesh_tags(read_json(text, "file")); }

/// A file with these members besides its format.
std::string with(const std::string& members) { return "{\"format\": \"croquis-tags-1\", " + members + "}"; }

std::string edge(const std::string& members) {
  return with("\"edges\": [{\"v\": [0, 1], \"sharpness\": 1}, " + members + "]");
}

Findings refused(const std::string& text) {
  try {
    parsed(text);
  } catch (const Error& error) {
    return error.findings();
  }
  FAIL("it was read: " << text);
  return {};
}

}  // namespace

TEST_CASE("tags are read with finite and infinite sharpness, pins and sets") {
  const MeshTagsReadResult result = parsed(with(
      "\"index_base\": 0, \"edges\": [{\"v\": [8, 9], \"sharpness\": \"inf\"}, {\"v\": [11, 8], \"sharpness\": 2.5}, "
      "{\"v\": [1, 1], \"sharpness\": -3}], \"pins\": [4, 4, 99], "
      "\"sets\": [{\"name\": \"rim\", \"sharpness\": 3, \"edges\": [[8, 9]], \"pins\": [4]}]"));
  CHECK(result.tags == MeshTags{{{{8, 9}, infinite_sharpness}, {{11, 8}, 2.5}, {{1, 1}, -3}},
                                {4, 4, 99},
                                {{"rim", 3, {{8, 9}}, {4}}}});
  CHECK(result.warnings.empty());
  CHECK(parsed("{\"format\": \"croquis-tags-1\"}").tags.empty());
}

TEST_CASE("tags come back from their own JSON the same") {
  const MeshTags tags{{{{3, 2}, 0.1}, {{0, no_index}, infinite_sharpness}, {{5, 5}, 0}},
                      {7, 0},
                      {{"", infinite_sharpness, {}, {}}, {"a \"b\"", 0.3, {{3, 2}, {2, 3}}, {7}}}};
  CHECK(parsed(write_json(report_of(tags))).tags == tags);
  CHECK(parsed(write_json(report_of({}))).tags.empty());
  CHECK(report_of({}).find("sets") == nullptr);
  CHECK(report_of(tags).at("edges").as_array()[1].at("sharpness").as_string() == "inf");
}

TEST_CASE("tags that count vertices from 1 are understood everywhere") {
  const MeshTags tags =
      parsed(with("\"edges\": [{\"v\": [1, 2], \"sharpness\": 1}], \"index_base\": 1, \"pins\": [3], "
                  "\"sets\": [{\"name\": \"a\", \"sharpness\": 1, \"edges\": [[1, 2]], \"pins\": [3]}]"))
          .tags;
  CHECK(tags == MeshTags{{{{0, 1}, 1}}, {2}, {{"a", 1, {{0, 1}}, {2}}}});
  const Findings findings = refused(with("\"index_base\": 1, \"pins\": [1, 0]"));
  REQUIRE(findings.size() == 1);
  CHECK(findings[0].code == "E_INDEX");
  CHECK_THAT(findings[0].message, Catch::Contains("pins[1]"));
}

TEST_CASE("members that tags don't have are passed over with one warning for each name") {
  const MeshTagsReadResult result =
      parsed(with("\"author\": \"me\", \"edges\": [{\"v\": [0, 1], \"sharpness\": 1, \"colour\": 3}, "
                  "{\"v\": [1, 2], \"sharpness\": 1, \"colour\": 4}]"));
  CHECK(result.tags.creases.size() == 2);
  REQUIRE(result.warnings.size() == 2);
  for (const Finding& warning : result.warnings) CHECK(warning.code == "W_IGNORED");
  CHECK_THAT(result.warnings[1].message, Catch::Contains("2 'colour' of edges"));
}

TEST_CASE("tags of another form are refused with the place") {
  struct Case {
    std::string text, place;
  };
  const std::vector<Case> cases = {
      {"[]", "object"},
      {"{}", "format"},
      {"{\"format\": \"croquis-tags-2\"}", "format"},
      {"{\"format\": 1}", "format"},
      {with("\"index_base\": 2"), "index_base"},
      {with("\"index_base\": 0.5"), "index_base"},
      {with("\"edges\": {}"), "edges"},
      {with("\"edges\": null"), "edges"},
      {with("\"pins\": 3"), "pins"},
      {with("\"pins\": [\"a\"]"), "pins[0]"},
      {with("\"pins\": [1, -1]"), "pins[1]"},
      {with("\"pins\": [1.5]"), "pins[0]"},
      {with("\"pins\": [4294967296]"), "pins[0]"},
      {edge("3"), "edges[1]"},
      {edge("{\"sharpness\": 1}"), "edges[1].v"},
      {edge("{\"v\": [1], \"sharpness\": 1}"), "edges[1].v"},
      {edge("{\"v\": [1, 2, 3], \"sharpness\": 1}"), "edges[1].v"},
      {edge("{\"v\": [1, null], \"sharpness\": 1}"), "edges[1].v[1]"},
      {edge("{\"v\": [1, 2]}"), "edges[1].sharpness"},
      {edge("{\"v\": [1, 2], \"sharpness\": \"sharp\"}"), "edges[1].sharpness"},
      {edge("{\"v\": [1, 2], \"sharpness\": null}"), "edges[1].sharpness"},
      {with("\"sets\": [1]"), "sets[0]"},
      {with("\"sets\": [{\"sharpness\": 1}]"), "sets[0].name"},
      {with("\"sets\": [{\"name\": \"a\"}]"), "sets[0].sharpness"},
      {with("\"sets\": [{\"name\": \"a\", \"sharpness\": 1, \"edges\": [[1]]}]"), "sets[0].edges[0]"}};
  for (const Case& c : cases) {
    INFO(c.text);
    const Findings findings = refused(c.text);
    REQUIRE(findings.size() == 1);
    CHECK(findings[0].category == Category::Malformed);
    CHECK_THAT(findings[0].message, Catch::Contains(c.place));
  }
  CHECK(refused(with("\"pins\": [-1, -2], \"edges\": [1, 2, 3]")).size() == 5);
}
