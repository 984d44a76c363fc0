// SPDX-License-Identifier: GPL-3.0-or-later
#include <filesystem>

#include <catch2/catch.hpp>

#include "croquis/base/error.h"
#include "croquis/io/file.h"
#include "croquis/io/json.h"
#include "croquis/io/surface_places_file.h"

using namespace croquis;

namespace {

const std::filesystem::path place_seeds = std::filesystem::path(CROQUIS_FUZZ_FOLDER) / "corpus/places";

SurfacePlacesReadResult read_places(const std::string& text) { return read_surface_places(read_json(text, "file")); }

Findings refused_places(const std::string& text) {
  try {
    read_places(text);
  } catch (const Error& error) {
    return error.findings();
  }
  FAIL("it was read: " << text);
  return {};
}

}  // namespace

TEST_CASE("places of a surface are read with their faces, and names that the format doesn't have are told") {
  const SurfacePlacesReadResult read = read_places(read_file((place_seeds / "all.json").string()));
  CHECK(read.places == std::vector<SurfacePlaceQuestion>{
                           {"hood", {0, 0.25, 0.5}}, {"t \"x\"", {3, 0, 1}}, {"roof", {11, 1e-9, -0.5}}});
  REQUIRE(read.warnings.size() == 2);
  for (const Finding& warning : read.warnings) CHECK(warning.code == "W_IGNORED");
  CHECK(read_places(write_json(report_of(read.places))).places == read.places);
}

TEST_CASE("each wrong place of a surface is named") {
  const Findings findings = refused_places(read_file((place_seeds / "wrong.json").string()));
  REQUIRE(findings.size() == 6);
  for (std::size_t i = 0; i < findings.size(); ++i) {
    CHECK(findings[i].code == (i == 3 ? "E_NOT_FINITE" : "E_SYNTAX"));
    CHECK(findings[i].message.find("places[" + std::to_string(i) + "]") != std::string::npos);
  }
  CHECK(refused_places("{}").size() == 1);
  CHECK(refused_places("[]").size() == 1);
  CHECK(refused_places("{\"format\":\"croquis-abs/1\",\"places\":[]}").size() == 1);
  CHECK(refused_places("{\"format\":\"croquis-abs-places/1\",\"places\":{}}").size() == 1);
}
