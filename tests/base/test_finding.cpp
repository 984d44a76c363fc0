// SPDX-License-Identifier: GPL-3.0-or-later
#include <set>
#include <string>

#include <catch2/catch.hpp>

#include "croquis/base/finding.h"

using namespace croquis;

TEST_CASE("only errors stop an operation") {
  CHECK_FALSE(has_errors({}));
  const Finding warning = make_warning(Category::Geometry, "W_THIN", "The sheet is thin.");
  const Finding error = make_error(Category::Geometry, "E_OPEN", "The contour is open.");
  Finding info = warning;
  info.severity = Severity::Info;
  CHECK_FALSE(has_errors({info, warning}));
  CHECK(has_errors({info, warning, error}));
}

TEST_CASE("the short forms keep what they are given") {
  const Finding finding =
      make_error(Category::Limit, "E_MEMORY", "Too much.", {{SubjectKind::Stroke, "s1", {}, 12, {1, 2}}});
  CHECK(finding.severity == Severity::Error);
  CHECK(finding.category == Category::Limit);
  CHECK(finding.code == "E_MEMORY");
  CHECK(finding.message == "Too much.");
  REQUIRE(finding.subjects.size() == 1);
  CHECK(finding.subjects[0].id == "s1");
  CHECK(finding.subjects[0].line == 12);
  CHECK_FALSE(finding.subjects[0].file);
  CHECK(make_warning(Category::Io, "W_X", "X.").severity == Severity::Warning);
}

TEST_CASE("kinds are spelled as reports spell them, each its own way") {
  const std::vector<std::pair<SubjectKind, std::string>> names = {
      {SubjectKind::Stroke, "stroke"}, {SubjectKind::Contour, "contour"}, {SubjectKind::Crossing, "crossing"},
      {SubjectKind::Line, "line"},     {SubjectKind::Curve, "curve"},     {SubjectKind::Node, "node"},
      {SubjectKind::Point, "point"},   {SubjectKind::Face, "face"},       {SubjectKind::Edge, "edge"},
      {SubjectKind::Vertex, "vertex"}, {SubjectKind::Hole, "hole"},       {SubjectKind::Parameter, "parameter"},
      {SubjectKind::File, "file"}};
  for (const auto& [kind, name] : names) CHECK(to_string(kind) == name);
}

TEST_CASE("elements with numbers are spelled by them, all others by their names") {
  const Subject face = numbered_subject(SubjectKind::Face, 7, {1, 2, 3});
  CHECK(face.index == 7);
  CHECK(face.at == std::vector<double>{1, 2, 3});
  CHECK(name_of(face) == "7");
  CHECK(name_of(numbered_subject(SubjectKind::Hole, 0)) == "0");
  CHECK(name_of(edge_subject(3, 12)) == "3-12");
  CHECK(name_of({SubjectKind::Stroke, "5", {}, {}, {}}) == "5");
  CHECK_FALSE(Subject{SubjectKind::Stroke, "5", {}, {}, {}}.index);
}
