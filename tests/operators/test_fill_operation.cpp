// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <map>
#include <numbers>

#include <catch2/catch.hpp>

#include "croquis/base/error.h"
#include "croquis/document/content_hash.h"
#include "croquis/document/memo.h"
#include "croquis/geometry/mesh_report.h"
#include "croquis/hole_filling/hole_choice.h"
#include "croquis/operators/fill_result.h"
#include "croquis/operators/hole_requests.h"
#include "operators/operations.h"
#include "support/check_operation.h"
#include "support/meshes/mesh_shapes.h"
#include "support/scans/scans.h"

namespace croquis {
namespace {

Values inputs_of(const PolyMesh& scan) { return {{"scan", std::make_shared<const PolyMesh>(scan)}}; }

OperationResult fill(const PolyMesh& scan, const ParameterValues& parameters = {}, int threads = 1) {
  Progress progress;
  Context context{progress};
  context.threads = threads;
  return run(*fill_operation(), inputs_of(scan), parameters, context);
}

const PolyMesh& mesh_of(const OperationResult& result) { return result.outputs.at("mesh").get<PolyMesh>(); }

const Report& details_of(const OperationResult& result) { return result.outputs.at("details").get<Report>(); }

PolyMesh scan() { return test::random_cuts(test::round_sphere(4), 7, 6, 0.12, 0.3).mesh; }

/// Actions of the holes in their order: f, l, x for filled, left, failed.
std::string actions_of(const OperationResult& result) {
  std::string actions;
  for (const Report& hole : details_of(result).at("holes").as_array()) {
    const std::string& action = hole.at("action").as_string();
    actions += action == "fill" ? 'f' : action == "leave" ? 'l' : 'x';
  }
  return actions;
}

std::vector<Index> refused_words(const std::string& text) {
  try {
    parse_hole_ids(text);
  } catch (const Error& error) {
    for (const Finding& finding : error.findings()) CHECK(finding.code == "E_PARAMETER");
    return {static_cast<Index>(error.findings().size())};
  }
  return {};
}

TEST_CASE("filling is a function of its arguments, for every choice") {
  for (const char* fairness : {"rbf", "smooth", "flat"}) {
    for (const bool list : {false, true}) {
      test::check_operation(*fill_operation(), inputs_of(scan()),
                            {{"fairness", std::string(fairness)}, {"list", list}});
    }
  }
  test::check_operation(*fill_operation(), inputs_of(test::open_tube(1, 4, 24, 12)),
                        {{"select", std::string("all-but-largest")}, {"precision", std::string("single")}});
  test::check_operation(*fill_operation(), inputs_of(scan()),
                        {{"holes", std::string("0: leave; 1: flat, trim 1; 2: bulge 0.3")}});
  test::check_operation(*fill_operation(), inputs_of(scan()), {{"mode", std::string("remesh")}});
}

TEST_CASE("filling refuses unusable scans with the same findings every time") {
  PolyMesh points;
  points.positions = {Vec3(0, 0, 0), Vec3(1, 0, 0)};
  test::check_operation(*fill_operation(), inputs_of(points), {});
  CHECK_THROWS_AS(fill(points), Error);
  test::check_operation(*fill_operation(), inputs_of(scan()), {{"only", std::string("99")}});
  CHECK_THROWS_AS(fill(scan(), {{"only", std::string("99")}}), Error);
}

TEST_CASE("a request that changes is the same with what an earlier run left in the memo") {
  Memo memo;
  const auto fill_with_memo = [&](const std::string& holes) {
    Progress progress;
    Context context{progress};
    context.memo = &memo;
    return run(*fill_operation(), inputs_of(scan()), {{"holes", holes}}, context);
  };
  for (const std::string holes :
       {"", "1: flat", "1: flat; 2: leave", "1: smooth", "", "3: trim 1", "3: trim 1; 4: flat"}) {
    INFO(holes);
    const OperationResult warm = fill_with_memo(holes);
    const OperationResult cold = fill(scan(), {{"holes", holes}});
    CHECK(content_hash(warm.outputs.at("mesh")) == content_hash(cold.outputs.at("mesh")));
    CHECK(content_hash(warm.outputs.at("details")) == content_hash(cold.outputs.at("details")));
  }
}

TEST_CASE("rims come out as lines in the order of the holes, whether filled or listed") {
  const PolyMesh given = scan();
  for (const bool list : {false, true}) {
    const OperationResult result = fill(given, {{"list", list}});
    const PolyMesh& rims = result.outputs.at("rims").get<PolyMesh>();
    const auto& holes = details_of(result).at("holes").as_array();
    REQUIRE(rims.line_count() == holes.size());
    for (std::size_t i = 0; i < holes.size(); ++i)
      CHECK(rims.line(i).size() == static_cast<std::size_t>(holes[i].at("boundary_edges").as_integer()) + 1);
  }
}

TEST_CASE("the number of a hole's patch is the one that its faces have, after an earlier filling too") {
  const OperationResult once = fill(scan(), {{"only", std::string("2,4")}});
  const OperationResult twice = fill(mesh_of(once));
  const auto& ids = std::get<std::vector<std::int32_t>>(mesh_of(twice).channel("patch_id", Domain::Face)->data);
  for (const Report& hole : details_of(twice).at("holes").as_array()) {
    const std::int64_t patch = hole.at("patch").as_integer();
    CHECK(patch >= 2);
    CHECK(std::count(ids.begin(), ids.end(), static_cast<std::int32_t>(patch)) > 0);
  }
}

TEST_CASE("a filled scan begins with the scan, and its report counts the rest") {
  const PolyMesh given = scan();
  const OperationResult result = fill(given);
  const PolyMesh& mesh = mesh_of(result);
  const Report& details = details_of(result);
  CHECK(std::equal(given.positions.begin(), given.positions.end(), mesh.positions.begin()));
  CHECK(std::equal(given.corners.begin(), given.corners.end(), mesh.corners.begin()));
  CHECK(actions_of(result) == "ffffff");
  CHECK(details.at("untouched_vertices").as_integer() == static_cast<std::int64_t>(given.vertex_count()));
  CHECK(details.at("new_vertices").as_integer() ==
        static_cast<std::int64_t>(mesh.vertex_count() - given.vertex_count()));
  CHECK(details.at("new_faces").as_integer() == static_cast<std::int64_t>(mesh.face_count() - given.face_count()));
  CHECK(details.at("domains").as_integer() == 6);  // one function for each patch
  const Report& points = details.at("points_per_domain");
  CHECK(points.at("min").as_integer() > 10);
  CHECK(points.at("min").as_integer() <= points.at("median").as_integer());
  CHECK(points.at("median").as_integer() <= points.at("max").as_integer());
  for (const Report& hole : details.at("holes").as_array()) {
    CHECK(hole.at("reason").is_null());
    CHECK(hole.at("confidence").as_number() > 0);
    CHECK(hole.at("confidence").as_number() <= 1);
    // A sphere of radius 1 in 5120 triangles bends by 4 degrees from one to the next.
    CHECK(hole.at("max_normal_jump").as_number() > 0.1);
    CHECK(hole.at("max_normal_jump").as_number() < 20);
  }
}

TEST_CASE("a fairness that is asked for counts for the borders of open surfaces as well") {
  const PolyMesh tube = test::open_tube(1, 4, 48, 30);
  const auto method = [&](const ParameterValues& parameters) {
    return details_of(fill(tube, parameters)).at("holes").as_array().front().at("method").as_string();
  };
  const std::string all = "all";
  CHECK(method({{"select", all}}) == "minimal");
  CHECK(method({{"select", all}, {"fairness", std::string("auto")}}) == "minimal");
  CHECK(method({{"select", all}, {"fairness", std::string("flat")}}) == "minimal");
  CHECK(method({{"select", all}, {"fairness", std::string("rbf")}}) != "minimal");
  CHECK(method({{"select", all}, {"fairness", std::string("smooth")}}).starts_with("cgal-c1"));
  CHECK(method({{"only", std::string("0")}, {"fairness", std::string("smooth")}}).starts_with("cgal-c1"));
  CHECK(method({{"holes", std::string("0: rbf")}}) != "minimal");
}

TEST_CASE("a flat cap over the wide end of an open surface isn't trusted") {
  for (const PolyMesh& open : {test::bust(64, 48), test::bowl(48, 24)}) {
    const OperationResult result = fill(open, {{"select", std::string("all")}});
    const Report& hole = details_of(result).at("holes").as_array().front();
    CHECK(hole.at("method").as_string() == "minimal");
    CHECK(hole.at("confidence").as_number() < 0.3);
    const auto doubt = std::ranges::find(result.warnings, "W_LOW_CONFIDENCE", &Finding::code);
    CHECK(doubt != result.warnings.end());
  }
}

TEST_CASE("lists of ids are numbers and ranges; every other word is refused by name") {
  CHECK(parse_hole_ids("").empty());
  CHECK(parse_hole_ids("7") == std::vector<Index>{7});
  CHECK(parse_hole_ids("4,1;3 1") == std::vector<Index>{1, 3, 4});
  CHECK(parse_hole_ids("2-4, 3-5,") == std::vector<Index>{2, 3, 4, 5});
  for (const char* wrong : {"a", "-1", "1-", "5-3", "1.5", "99999999999", "0-4000000000", ",", "0x1"}) {
    INFO(wrong);
    CHECK(refused_words(wrong) == std::vector<Index>{1});
  }
  CHECK(refused_words("1,a,2,b") == std::vector<Index>{2});
}

TEST_CASE("single precision rounds what is new and nothing else") {
  const PolyMesh given = scan();
  const OperationResult result = fill(given, {{"precision", std::string("single")}});
  const PolyMesh& mesh = mesh_of(result);
  REQUIRE(mesh.vertex_count() > given.vertex_count());
  CHECK(std::equal(given.positions.begin(), given.positions.end(), mesh.positions.begin()));
  for (std::size_t v = given.vertex_count(); v < mesh.vertex_count(); ++v) {
    for (const double coordinate : mesh.positions[v]) {
      const volatile float rounded = static_cast<float>(coordinate);  // else GCC 12 may not round at all
      CHECK(static_cast<double>(rounded) == coordinate);
    }
  }
}

TEST_CASE("the selection that hosts ask for names the holes that are filled") {
  const PolyMesh open = test::random_cuts(test::open_tube(1, 4, 48, 24), 7, 4, 0.12, 0.3).mesh;
  const auto all = fill(open, {{"list", true}}).details.get<FillResult>()->holes;
  REQUIRE(all.size() > 3);
  REQUIRE(std::ranges::any_of(all, &HoleRow::is_border));
  std::vector<hole_filling::HoleSize> sizes;
  for (const HoleRow& row : all) sizes.push_back({row.kind, row.diameter});
  for (const char* select : {"inner", "all", "all-but-largest", "none"}) {
    for (const double limit : {0.0, all[0].diameter, all[1].diameter}) {
      const OperationResult result =
          fill(open, {{"list", true}, {"select", std::string(select)}, {"max-diameter", limit}});
      const double greatest = limit > 0 ? limit : 1e9;
      const auto named = named_holes(sizes, parse_selection(select), greatest);
      for (const HoleRow& row : result.details.get<FillResult>()->holes) {
        CHECK((row.state == FillAction::Fill) == (named[row.id] == hole_filling::Naming::Named));
      }
    }
  }
}

TEST_CASE("programs read of a filling what its mesh shows") {
  const PolyMesh given = scan();
  const OperationResult result = fill(given, {{"holes", std::string("1: leave")}});
  const FillResult& found = *result.details.get<FillResult>();
  CHECK(content_hash(Value(found.scan)) == content_hash(Value(std::make_shared<const PolyMesh>(given))));
  const PolyMesh& rims = result.outputs.at("rims").get<PolyMesh>();
  REQUIRE(found.holes.size() == rims.line_count());
  CHECK(found.new_faces == mesh_of(result).face_count() - given.face_count());
  CHECK(found.untouched_vertices == given.vertex_count());
  CHECK_FALSE((found.listed || found.remeshed));
  for (const HoleRow& hole : found.holes) {
    const bool filled = hole.id != 1;
    CHECK((hole.state == FillAction::Fill) == filled);
    CHECK((hole.patch && hole.angle && hole.confidence) == filled);
    CHECK(hole.angle.value_or(1) < std::numbers::pi);
    CHECK(hole.normal.dot(hole.at.normalized()) > 0.9);  // cut out of a sphere around the origin
  }
  CHECK(fill(given, {{"mode", std::string("remesh")}}).details.get<FillResult>()->remeshed.has_value());
}

/// Faces on the side of greater x get vertices of their own, as texture charts have.
PolyMesh in_two_charts(PolyMesh mesh) {
  std::map<Index, Index> copies;
  for (std::size_t face = 0; face < mesh.face_count(); ++face) {
    Vec3 sum = Vec3::Zero();
    for (const Index vertex : mesh.face(face)) sum += mesh.positions[vertex];
    if (sum.x() < 0) continue;
    for (Index corner = mesh.face_offsets[face]; corner < mesh.face_offsets[face + 1]; ++corner) {
      const auto fresh = static_cast<Index>(mesh.positions.size());
      const auto [copy, is_new] = copies.try_emplace(mesh.corners[corner], fresh);
      if (is_new) mesh.positions.push_back(Vec3(mesh.positions[mesh.corners[corner]]));
      mesh.corners[corner] = copy->second;
    }
  }
  return mesh;
}

/// A sheet with a hole, and another one that stands on an inner row of its edges: these have three faces, and the rim
/// of the standing one ends there.
PolyMesh sheet_with_fin() {
  PolyMesh mesh = test::cut(test::sheet(12, 12), Vec3(9, 9, 0), 1.5).mesh;
  std::vector<Index> row;
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    if (mesh.positions[v].y() == 3 && mesh.positions[v].x() > 2 && mesh.positions[v].x() < 8) row.push_back(v);
  }
  const auto top = static_cast<Index>(mesh.vertex_count());
  for (const Index v : row) mesh.positions.push_back(mesh.positions[v] + Vec3(0, 0, 1));
  for (Index i = 0; i + 1 < row.size(); ++i) {
    mesh.add_triangle(row[i], row[i + 1], top + i);
    mesh.add_triangle(row[i + 1], top + i + 1, top + i);
  }
  return mesh;
}

/// A sheet with two holes, and a bar that sticks through the rim of one: nothing closes that one.
PolyMesh barred_sheet() {
  PolyMesh mesh = test::cut(test::cut(test::sheet(24, 12), Vec3(6, 6, 0), 3).mesh, Vec3(18, 6, 0), 3).mesh;
  return test::merged(mesh, test::translated(test::scaled(test::divided_box(2), 2), Vec3(5, 5, -1)));
}

/// Edges of one face, by their ends' places: an oracle that knows nothing of views.
std::size_t open_edges_by_place(const PolyMesh& mesh) {
  using Place = std::array<double, 3>;
  std::map<std::array<Place, 2>, int> faces;
  const auto place = [&](Index v) {
    return Place{mesh.positions[v].x(), mesh.positions[v].y(), mesh.positions[v].z()};
  };
  for (std::size_t face = 0; face < mesh.face_count(); ++face) {
    const auto corners = mesh.face(face);
    for (std::size_t i = 0; i < corners.size(); ++i) {
      std::array<Place, 2> ends = {place(corners[i]), place(corners[(i + 1) % corners.size()])};
      std::ranges::sort(ends);
      ++faces[ends];
    }
  }
  return static_cast<std::size_t>(std::ranges::count_if(faces, [](const auto& edge) { return edge.second == 1; }));
}

/// Edges of one face as the mesh has them, apart where vertices are.
std::size_t open_edges_as_written(const PolyMesh& mesh) {
  Progress progress;
  return inspect(mesh, false, progress).boundary_edges;
}

TEST_CASE("what is open is counted with seams joined, before and after, and the first line tells all of it") {
  struct Case {
    PolyMesh scan;
    std::string begin;
    std::size_t loose;
  };
  const Case cases[] = {{in_two_charts(scan()), "6 holes: 6 filled, 0 left open.", 0},
                        {sheet_with_fin(), "2 holes: 1 filled, 1 left open.", 6},
                        {barred_sheet(), "3 holes: 1 filled, 2 left open, 1 of them since no patch is sound.", 0}};
  for (const Case& given : cases) {
    const OperationResult result = fill(given.scan);
    const Report& details = details_of(result);
    const std::string& summary = details.at("summary").as_string();
    CAPTURE(summary);
    CHECK(summary.starts_with(given.begin));
    const Report& edges = details.at("open_edges");
    const auto count = [&](const char* key) { return static_cast<std::size_t>(edges.at(key).as_integer()); };
    CHECK(count("before") == open_edges_by_place(given.scan));
    CHECK(count("after") == open_edges_by_place(mesh_of(result)));
    CHECK(count("loose") == given.loose);
    CHECK(2 * count("seams") == open_edges_as_written(given.scan) - count("before"));
    std::size_t of_holes = 0;
    for (const Report& hole : details.at("holes").as_array()) {
      if (hole.at("action").as_string() != "fill")
        of_holes += static_cast<std::size_t>(hole.at("boundary_edges").as_integer());
    }
    CHECK(count("after") == of_holes + count("loose"));
    const auto tells = [&](std::size_t number, const std::string& what) {
      const std::string words = " " + std::to_string(number) + what;
      CHECK((summary.find(words) != std::string::npos) == (number > 0));
    };
    tells(count("after"), " edges stay open.");
    tells(count("loose"), " open edges belong to no hole");
    tells(count("seams"), " edges of seams count as closed");
  }
}

}  // namespace
}  // namespace croquis
