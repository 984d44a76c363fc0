// SPDX-License-Identifier: GPL-3.0-or-later
// Which holes are filled at once, and what the check of the result says.
#include <QLocale>
#include <algorithm>
#include <fstream>
#include <map>

#include <catch2/catch.hpp>

#include "app/hole_scans.h"
#include "app/studio_fixture.h"
#include "app/tools/holes/hole_table.h"
#include "app/tools/holes/surface_check.h"
#include "croquis/geometry/mesh_report.h"
#include "croquis/io/file.h"
#include "croquis/io/mesh_file.h"
#include "croquis/operators/all_operations.h"
#include "support/meshes/mesh_shapes.h"
#include "support/scans/scans.h"
#include "support/scans/virtual_scans.h"

using namespace croquis;
using app::Viewport;
using croquis::test::StudioFixture;
using namespace croquis::test;

namespace {

/// The surface of the shipped mug (two sides, a handle), three times refined, with three holes.
PolyMesh refined_mug_with_holes(const std::string& scheme, std::uint64_t seed) {
  Progress progress;
  const std::string file = read_file(CROQUIS_SOURCE_DIR "/examples/data/mug.obj");
  const auto mug = std::make_shared<const PolyMesh>(read_mesh(file, MeshFormat::Obj, "mug.obj", progress).mesh);
  Context context{progress};
  const Registry operations = all_operations();
  const OperationResult refined =
      run(*operations.find("subdivide"), {{"cage", mug}}, {{"scheme", scheme}, {"levels", std::int64_t{3}}}, context);
  const auto surface = refined.outputs.at("mesh").as<PolyMesh>();
  return without_loose_vertices(random_cuts(*surface, seed, 3, 0.15, 0.35).mesh);
}

std::size_t intersections_of(const PolyMesh& mesh) {
  Progress progress;
  return inspect(mesh, true, progress).self_intersections.value();
}

/// A box with two holes: a disc, and a comb that is narrower but has the longer rim of more edges.
PolyMesh box_with_disc_and_comb(bool comb_first) {
  constexpr int squares = 30;
  const PolyMesh box = divided_box(squares);
  std::vector<Index> removed;
  for (Index face = 0; face < box.face_count(); ++face) {
    Vec3 middle = Vec3::Zero();
    for (const Index vertex : box.face(face)) middle += squares * box.positions[vertex] / 3;
    const bool top = middle.z() == squares;
    if (!top && middle.z() != 0) continue;
    const Vec2 at = middle.head<2>() - Vec2::Constant(squares / 2);
    const int column = static_cast<int>(std::floor(at.x())) + 4;  // of the comb: 9 wide, 9 high
    const int row = static_cast<int>(std::floor(at.y())) + 4;
    const bool in_comb = column >= 0 && column < 9 && row >= 0 && row < 9 && (row == 0 || column % 2 == 0);
    if (top == comb_first ? in_comb : at.norm() < 9) removed.push_back(face);
  }
  return without_loose_vertices(without_faces(box, removed));
}

}  // namespace

TEST_CASE("all but the largest keeps the hole of the greatest diameter, however long another one's rim is", "[holes]") {
  const bool comb_first = GENERATE(false, true);
  CAPTURE(comb_first);
  StudioFixture hand;
  open_scan(hand, box_with_disc_and_comb(comb_first));
  const auto& rows = holes(hand).rows;
  REQUIRE(rows.size() == 2);
  const Index disc = rows[0].diameter > rows[1].diameter ? 0 : 1;
  CHECK(rows[disc].edges < rows[1 - disc].edges);
  CHECK(rows[disc].perimeter < rows[1 - disc].perimeter);
  hand.act("fill-all-but-largest");
  hand.settle();
  auto* table = hand.window().findChild<app::HoleTable*>("holes");
  std::map<QString, double> diameters;  // by the words for the state
  std::map<QString, int> columns;
  for (int column = 0; column < table->columnCount(); ++column)
    columns[table->horizontalHeaderItem(column)->text()] = column;
  for (int row = 0; row < table->rowCount(); ++row) {
    diameters[table->item(row, columns.at("State"))->text()] =
        QLocale().toDouble(table->item(row, columns.at("Diameter (units)"))->text());
  }
  REQUIRE(diameters.size() == 2);
  CHECK(diameters.at("open") > diameters.at("filled"));
  CHECK(!hand.window().action("fill-all-but-largest")->isEnabled());
}

TEST_CASE("patches of a refined surface meet nothing, and the check says so", "[hole-sessions]") {
  const std::string scheme = GENERATE("loop", "doo-sabin");
  const std::string kind = GENERATE("one piece", "STL", "a vertex for every corner");
  CAPTURE(scheme, kind);
  const PolyMesh scan = refined_mug_with_holes(scheme, 1);
  StudioFixture hand;
  if (kind == "STL") {
    Progress progress;
    const QString file = hand.folder() + "/mug.stl";
    std::ofstream(file.toStdString(), std::ios::binary) << write_mesh(scan, MeshFormat::Stl, {}, progress).bytes;
    REQUIRE(hand.window().open(file));
    hand.act("holes");
    hand.settle();
  } else {
    open_scan(hand, kind == "one piece" ? scan : as_soup(scan));
  }
  REQUIRE(holes(hand).rows.size() == 3);
  hand.act("fill-inner");
  hand.settle();
  REQUIRE(hand.wait_for([&] { return label(hand, "hole-check").contains("manifold"); }));
  const std::string checked = label(hand, "hole-check").toStdString();
  CAPTURE(checked);
  CHECK(checked.ends_with(", manifold, 0 new intersections, outside unchanged"));
  if (kind == "a vertex for every corner") return;
  CHECK(checked.starts_with("closed, "));
  CHECK(hand.studio().active()->cage_mesh->vertex_count() == scan.vertex_count());
  CHECK(intersections_of(filled_mesh(hand)) == intersections_of(*hand.studio().active()->cage_mesh));
}

TEST_CASE("a scan with a vertex for every corner is checked as the surface that it is", "[holes]") {
  // Every triangle by itself, as some programs write them.
  const PolyMesh cut = ball_with_holes(2);
  PolyMesh apart;
  for (std::size_t f = 0; f < cut.face_count(); ++f) {
    std::vector<Index> corners;
    for (const Index vertex : cut.face(f)) {
      corners.push_back(static_cast<Index>(apart.vertex_count()));
      apart.positions.push_back(cut.positions[vertex]);
    }
    apart.add_face(corners);
  }
  StudioFixture hand;
  open_scan(hand, apart);
  REQUIRE(holes(hand).rows.size() == 2);
  hand.act("fill-all");
  hand.settle();
  REQUIRE(hand.wait_for([&] { return label(hand, "hole-check").contains("manifold"); }));
  const QString text = label(hand, "hole-check");
  INFO(text.toStdString());
  CHECK(text.startsWith("closed but for seams ("));
  CHECK(text.contains("merge the vertices of the scan, manifold, 0 new intersections, outside unchanged"));
  // A patch that does meet something is still reported.
  PolyMesh filled = filled_mesh(hand);
  const auto& ids = std::get<std::vector<std::int32_t>>(filled.channel("patch_id", Domain::Face)->data);
  const auto patch =
      static_cast<std::size_t>(std::find_if(ids.begin(), ids.end(), [](auto id) { return id >= 0; }) - ids.begin());
  Vec3 through = Vec3::Zero();
  for (const Index vertex : filled.face(patch)) through += filled.positions[vertex] / 3;
  const Vec3 out = 0.1 * through.normalized();
  filled.positions[filled.face(0)[0]] = through + out;
  filled.positions[filled.face(0)[1]] = through - out;
  filled.positions[filled.face(0)[2]] = through - out + 0.1 * out.unitOrthogonal();
  Progress progress;
  CHECK(app::check_surface(filled, &apart, progress).intersections > 0);
}

TEST_CASE("an edge that nobody left open is no part of a border", "[holes]") {
  app::CheckedSurface checked;
  checked.open_edges = 10;
  CHECK(!app::is_as_wanted(checked, {}));
  CHECK(app::sentence_of(checked, {}).startsWith("10 open edges, manifold"));
  const app::LeftOpen border{.borders = 1, .border_edges = 7};
  CHECK(!app::is_as_wanted(checked, border));
  CHECK(app::sentence_of(checked, border).startsWith("open at its outer border (7 edges) and along 3 edges more, man"));
  checked.has_patches = false;  // remeshed: with other edges
  CHECK(app::is_as_wanted(checked, border));
  CHECK(app::sentence_of(checked, border) ==
        "open at its outer border (10 edges), otherwise sound: manifold, 0 intersections, remeshed");
  CHECK(!app::is_as_wanted(checked, {.borders = 1, .holes = 1, .failed = 1}));
}

TEST_CASE("the holes of a cage that is refined first are those of its surface", "[holes]") {
  StudioFixture hand;
  const PolyMesh cage = without_loose_vertices(without_faces(divided_box(3), std::vector<Index>{0, 1}));
  Progress progress;
  const QString file = hand.folder() + "/cage.ply";
  std::ofstream(file.toStdString(), std::ios::binary) << write_mesh(cage, MeshFormat::Ply, {}, progress).bytes;
  REQUIRE(hand.window().open(file));
  hand.act("show-smooth");
  hand.settle();
  const auto surface = hand.studio().active()->mesh;
  REQUIRE(surface->face_count() > cage.face_count());
  hand.act("holes");
  hand.settle();
  REQUIRE(holes(hand).rows.size() == 1);
  CHECK(holes(hand).scan() == surface);
  hand.act("fill-all");
  hand.settle();
  CHECK(rims_of(filled_mesh(hand)) == 0);
  CHECK(holes(hand).scan() == surface);
}
