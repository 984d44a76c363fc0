// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>

#include "croquis/base/error.h"
#include "croquis/document/content_hash.h"
#include "croquis/document/memo.h"
#include "croquis/geometry/mesh_report.h"
#include "operators/operations.h"
#include "support/check_operation.h"
#include "support/meshes/mesh_shapes.h"

namespace croquis {
namespace {

OperationResult edit(const PolyMesh& mesh, const ParameterValues& parameters) {
  Progress progress;
  Context context{progress};
  return run(*edit_operation(), {{"mesh", std::make_shared<const PolyMesh>(mesh)}}, parameters, context);
}

const PolyMesh& mesh_of(const OperationResult& result) { return result.outputs.at("mesh").get<PolyMesh>(); }

const Report& details_of(const OperationResult& result) { return result.outputs.at("details").get<Report>(); }

TEST_CASE("editing is a list of edits, and the details count what is new") {
  const OperationResult result =
      edit(test::cube(), {{"do", std::string("inset faces=0 width=0.25; extrude faces=0 distance=1")}});
  CHECK(mesh_of(result).face_count() == 14);
  CHECK(details_of(result).at("new_faces").as_integer() == 8);
  CHECK(details_of(result).at("new_vertices").as_integer() == 0);
  CHECK(details_of(result).at("edits").as_array()[0].as_string() == "inset faces=0 width=0.25");
  Progress progress;
  CHECK(inspect(mesh_of(result), false, progress).volume == Approx(1.25));
  CHECK(mesh_of(edit(test::cube(), {})).corners == test::cube().corners);
}

TEST_CASE("edits with a memo of earlier lines are those without one") {
  const std::vector<std::string> lines = {"inset faces=0 width=0.25", "extrude faces=0 distance=1", "loop-cut edges=3",
                                          "delete faces=2", "move vertices=1 by=0,0,1"};
  Memo memo;
  std::string text;
  for (const std::string& line : lines) {
    text += line + ";";
    const OperationResult expected = edit(test::cube(), {{"do", text}});
    for (int again = 0; again < 2; ++again) {
      Progress progress;
      Context context{progress, Quality::Final, &memo};
      const OperationResult kept =
          run(*edit_operation(), {{"mesh", std::make_shared<const PolyMesh>(test::cube())}}, {{"do", text}}, context);
      CHECK(content_hash(kept.outputs.at("mesh")) == content_hash(expected.outputs.at("mesh")));
      CHECK(details_of(kept).at("new_faces").as_integer() == details_of(expected).at("new_faces").as_integer());
    }
  }
}

TEST_CASE("edits of one mesh are refused for another one, and taken when it only moved") {
  const std::string lines = "extrude faces=0 distance=1";
  const std::string name = details_of(edit(test::cube(), {{"do", lines}})).at("connectivity").as_string();
  CHECK(!name.empty());
  const ParameterValues same{{"do", lines}, {"connectivity", name}};
  CHECK_NOTHROW(edit(test::scaled(test::cube(), 3), same));
  for (const PolyMesh& other : {test::torus(5, 4), test::grid(2, 2), test::triangulated(test::cube())}) {
    try {
      edit(other, same);
      FAIL("accepted");
    } catch (const Error& error) {
      CHECK(error.findings().front().code == "E_CONNECTIVITY");
    }
  }
}

}  // namespace
}  // namespace croquis
