// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>

#include "croquis/base/error.h"
#include "croquis/document/content_hash.h"
#include "croquis/edits/apply_edits.h"
#include "croquis/geometry/mesh_report.h"
#include "croquis/tools/all_steps.h"
#include "croquis/tools/mesh/mesh_tool.h"
#include "croquis/tools/recording/general_steps.h"
#include "croquis/tools/recording/recording.h"
#include "support/meshes/mesh_shapes.h"
#include "support/random.h"

namespace croquis {
namespace {

EditLine line_of(const std::string& text) { return parse_edit_lines(text).front(); }

/// A mesh called "box" under the tool.
struct Bench {
  Session session;
  MeshTool tool{session};

  explicit Bench(PolyMesh mesh) : session(document_with(std::move(mesh))) { tool.set_node(1); }

  static Document document_with(PolyMesh mesh) {
    Node node;
    node.name = "box";
    node.source = std::make_shared<const PolyMesh>(std::move(mesh));
    return Document().with(std::move(node));
  }

  const PolyMesh& mesh() const { return *tool.editable().mesh(); }
  Verdict apply(const std::string& text) { return tool.edits().apply(line_of(text)); }
  ContentHash hash() const { return content_hash(session.document()); }
};

ContentHash hash_of(const PolyMesh& mesh) { return content_hash(Value(std::make_shared<const PolyMesh>(mesh))); }

TEST_CASE("an edit by its line is one undo step, called by its title, recorded as its line") {
  Bench bench(test::cube());
  bench.tool.selection().set_mode(MeshMode::Face);
  CHECK(bench.apply("inset faces=3,1 width=0.1") == Verdict::Commit);
  CHECK(bench.session.undo_labels() == std::vector<std::string>{"Inset 2 faces"});
  REQUIRE(bench.tool.done());
  const auto* step = bench.tool.done()->as<recorded::EditStep>();
  REQUIRE(step != nullptr);
  CHECK(step->node == "box");
  CHECK(recorded::to_line(*bench.tool.done()) == R"({"do":"edit","node":"box","line":"inset faces=3,1 width=0.1"})");
  bench.apply("pin vertices=all");
  bench.apply("delete faces=0");
  CHECK(bench.session.undo_labels() == std::vector<std::string>{"Inset 2 faces", "Pin box", "Delete 1 face"});
}

TEST_CASE("what an edit made is selected, in the mode that shows it") {
  Bench bench(test::cube());
  bench.tool.selection().set_mode(MeshMode::Vertex);
  const auto& selected = [&]() -> const ComponentSelection& { return bench.session.components(); };
  bench.apply("extrude faces=2 by=0,0,5");
  CHECK(bench.tool.selection().mode() == MeshMode::Face);
  CHECK(selected().kind == ComponentKind::Face);
  REQUIRE(selected().elements.size() == 1);
  for (const Index vertex : bench.mesh().face(selected().elements.front()))
    CHECK(bench.mesh().positions[vertex].z() >= 5);
  bench.apply("loop-cut edges=0 at=0.25");
  CHECK(bench.tool.selection().mode() == MeshMode::Edge);
  CHECK(selected().elements.size() >= 4);
  for (const Index edge : selected().elements) {
    for (const Index vertex : bench.tool.editable().topology()->edge_vertices(edge)) CHECK(vertex >= 8);
  }
  bench.apply("move vertices=1,2 by=0,0,1");
  CHECK(selected().kind == ComponentKind::Vertex);
  CHECK(selected().elements == Elements{1, 2});
  bench.tool.selection().pick(ComponentKind::Face, {0, 1});
  bench.apply("delete faces=0");
  CHECK(selected().elements.empty());
}

TEST_CASE("in object mode an edit selects no elements") {
  Bench bench(test::cube());
  CHECK(bench.apply("inset faces=3 width=0.1") == Verdict::Commit);
  CHECK(bench.tool.selection().mode() == MeshMode::Object);
  CHECK(bench.session.components().empty());
}

TEST_CASE("an edit that is refused or changes nothing leaves everything as it was") {
  Bench bench(test::cube());
  bench.tool.selection().set_mode(MeshMode::Face);
  bench.tool.selection().pick(ComponentKind::Face, {4});
  const ContentHash before = bench.hash();
  CHECK_THROWS_AS(bench.apply("inset faces=99 width=0.1"), Error);
  CHECK_THROWS_AS(bench.apply("inset faces=0 width=9"), Error);
  CHECK_THROWS_AS(bench.apply("extrude faces=0"), Error);
  CHECK(bench.apply("move faces=0 by=0,0,0") == Verdict::Continue);
  CHECK(bench.apply("pin vertices=0 pinned=false") == Verdict::Continue);
  CHECK(bench.hash() == before);
  CHECK_FALSE(bench.session.can_undo());
  CHECK(bench.session.components().elements == Elements{4});
}

TEST_CASE("a recorded edit replays to the same mesh, whatever is selected") {
  Bench first(test::torus(9, 6));
  first.tool.selection().set_mode(MeshMode::Face);
  Bench second(test::torus(9, 6));
  for (const char* line : {"inset faces=3-5,9 width=0.02", "extrude faces=4 distance=0.1",
                           "rotate edges=7,8 degrees=30", "sharpness edges=1-9 value=2.5", "dissolve edges=2"}) {
    CHECK(first.apply(line) == Verdict::Commit);
    const std::string text = recorded::to_line(*first.tool.done());
    second.tool.take(recorded::parse(text, "recording", recorded::all_steps()).front().step);
    CHECK(hash_of(first.mesh()) == hash_of(second.mesh()));
  }
  CHECK(first.session.undo_labels() == second.session.undo_labels());
  second.tool.set_node(7);
  CHECK_THROWS_AS(second.tool.take(*first.tool.done()), Error);
}

TEST_CASE("commands on the selection do what the edits of their names do") {
  Bench hand(test::torus(9, 6));
  Bench line(test::torus(9, 6));
  hand.tool.selection().set_mode(MeshMode::Face);
  hand.tool.selection().pick(ComponentKind::Face, {3, 4, 10});
  const auto same = [&](Verdict verdict, const std::string& text) {
    INFO(text);
    CHECK(verdict == Verdict::Commit);
    CHECK(line.apply(text) == Verdict::Commit);
    CHECK(hash_of(hand.mesh()) == hash_of(line.mesh()));
  };
  same(hand.tool.take(recorded::Move{.by = {0.1, 1.0 / 3, 0}}), "move faces=3,4,10 by=0.1,0.3333333333333333,0");
  same(hand.tool.take(recorded::Rotate{.axis = {0, 1, 1}, .degrees = 33, .pivot = Vec3(1, 0, 0)}),
       "rotate faces=3,4,10 axis=0,1,1 degrees=33 about=1,0,0");
  same(hand.tool.take(recorded::Scale{.factors = {1, 2, 1}, .pivot = Vec3::Zero()}),
       "scale faces=3,4,10 factors=1,2,1 about=0,0,0");
  same(hand.tool.take(recorded::Extrude{.by = {0, 0, 0.5}}), "extrude faces=3,4,10 by=0,0,0.5");
  same(hand.tool.take(recorded::LoopCut{.edge = 5, .at = 0.3}), "loop-cut edges=5 at=0.3");
  hand.tool.selection().pick(ComponentKind::Edge, {2, 6});
  same(hand.tool.take(recorded::Tag{.sharpness = 2.5}), "sharpness edges=2,6 value=2.5");
  hand.tool.selection().pick(ComponentKind::Vertex, {0, 5});
  same(hand.tool.take(recorded::Pin{}), "pin vertices=0,5");
  same(hand.tool.take(recorded::Action{"delete"}), "dissolve vertices=0,5");
}

TEST_CASE("an edit begins with numbers that can be seen, whatever the size of what is selected") {
  for (const double size : {1e-3, 1.0, 1e4}) {
    Bench bench(test::scaled(test::cube(), size));
    bench.tool.selection().set_mode(MeshMode::Face);
    CHECK(bench.tool.edits().begin("inset") == Verdict::Continue);  // nothing is selected
    bench.tool.selection().pick(ComponentKind::Face, {3, 1});
    CHECK(bench.tool.edits().begin("inset") == Verdict::Commit);
    CHECK(bench.mesh().face_count() > 6);
    const double width = std::get<double>(bench.tool.edits().last()->parameters.at("width"));
    CHECK(width > 0.01 * size);
    CHECK(width < 0.5 * size);
  }
  // A long face has less room than its size promises.
  PolyMesh strip = test::grid(1, 1);
  for (Vec3& place : strip.positions) place.x() *= 300;
  Bench bench(strip);
  bench.tool.selection().set_mode(MeshMode::Face);
  bench.tool.selection().pick(ComponentKind::Face, {0});
  CHECK(bench.tool.edits().begin("inset") == Verdict::Commit);
}

TEST_CASE("the last edit with other numbers is the same as having made it so, and one step of the history") {
  Bench first(test::torus(9, 6));
  Bench second(test::torus(9, 6));
  for (Bench* bench : {&first, &second}) bench->tool.selection().set_mode(MeshMode::Face);
  const ContentHash before = first.hash();
  MeshEditor& edits = first.tool.edits();
  CHECK(edits.last() == nullptr);
  first.apply("inset faces=3,4 width=0.02");
  const ComponentSelection selected = first.session.components();
  for (const double width : {0.01, 0.05, 0.03}) {
    CHECK(edits.adjust({{"width", width}}) == Verdict::Commit);
    CHECK(first.session.undo_labels() == std::vector<std::string>{"Inset 2 faces"});
    CHECK(first.session.components() == selected);
  }
  second.apply("inset faces=3,4 width=0.03");
  CHECK(hash_of(first.mesh()) == hash_of(second.mesh()));
  // What is refused changes nothing, and what does nothing is no step.
  CHECK_THROWS_AS(edits.adjust({{"width", 9.0}}), Error);
  CHECK(hash_of(first.mesh()) == hash_of(second.mesh()));
  REQUIRE(edits.last() != nullptr);
  CHECK(std::get<double>(edits.last()->parameters.at("width")) == 0.03);
  first.session.undo();
  CHECK(first.hash() == before);
  CHECK(edits.last() == nullptr);
  CHECK(edits.adjust({{"width", 0.01}}) == Verdict::Continue);
  first.session.redo();
  CHECK(edits.last() != nullptr);
  first.apply("pin vertices=0");
  CHECK(edits.adjust({{"pinned", false}}) == Verdict::Commit);
  CHECK(first.session.undo_labels() == std::vector<std::string>{"Inset 2 faces"});
  CHECK(edits.adjust({{"pinned", true}}) == Verdict::Commit);
  CHECK(first.session.undo_labels() == std::vector<std::string>{"Inset 2 faces", "Pin 1 vertex"});
}

TEST_CASE("an edit with other numbers replays") {
  Bench first(test::torus(9, 6));
  Bench second(test::torus(9, 6));
  std::vector<std::string> lines;
  first.apply("inset faces=3,7 width=0.02");
  lines.push_back(recorded::to_line(*first.tool.done()));
  first.tool.edits().adjust({{"width", 0.04}});
  lines.push_back(recorded::to_line(*first.tool.done()));
  CHECK(lines.back() == R"({"do":"edit","node":"box","line":"inset faces=3,7 width=0.04","again":true})");
  for (const std::string& line : lines) {
    second.tool.take(recorded::parse(line, "recording", recorded::all_steps()).front().step);
  }
  CHECK(first.hash() == second.hash());
  CHECK(second.session.undo_labels().size() == 1);
  Bench third(test::torus(9, 6));
  CHECK_THROWS_AS(third.tool.take(*first.tool.done()), Error);
}

TEST_CASE("turning by more than ten turns is turning by the rest") {
  Bench far(test::cube());
  Bench near(test::cube());
  for (Bench* bench : {&far, &near}) {
    bench->tool.selection().set_mode(MeshMode::Face);
    bench->tool.selection().pick(ComponentKind::Face, {1});
  }
  far.tool.take(recorded::Rotate{.axis = Vec3::UnitZ(), .degrees = 36000 + 25, .pivot = Vec3::Zero()});
  near.tool.take(recorded::Rotate{.axis = Vec3::UnitZ(), .degrees = 25, .pivot = Vec3::Zero()});
  for (Index v = 0; v < 8; ++v) CHECK((far.mesh().positions[v] - near.mesh().positions[v]).norm() < 1e-9);
  CHECK(far.tool.done()->as<recorded::Rotate>()->degrees == 36025);
}

TEST_CASE("random edits keep a sound mesh sound, and undo gives every mesh back") {
  test::Random random(5);
  const std::vector<const char*> lines = {"extrude faces=# distance=0.1",
                                          "inset faces=# width=0.001",
                                          "loop-cut edges=#",
                                          "dissolve edges=#",
                                          "move vertices=# by=0.01,0,0",
                                          "pin vertices=#",
                                          "sharpness edges=# value=3"};
  for (int round = 0; round < 12; ++round) {
    const bool ring = round % 2 == 0;
    Bench bench(ring ? test::torus(7, 5) : test::cube());
    bench.tool.selection().set_mode(static_cast<MeshMode>(random.below(4)));
    std::vector<ContentHash> hashes{bench.hash()};
    for (int step = 0; step < 8; ++step) {
      std::string line = lines[random.below(static_cast<std::uint32_t>(lines.size()))];
      line.replace(line.find('#'), 1, std::to_string(random.below(5)));
      INFO(line);
      try {
        if (bench.apply(line) == Verdict::Commit) hashes.push_back(bench.hash());
      } catch (const Error& error) {
        CHECK((error.findings().front().code == "E_INPUT" || error.findings().front().code == "E_EDIT"));
      }
      CHECK(bench.hash() == hashes.back());
      const std::size_t count = element_count(*bench.tool.editable().topology(), bench.session.components().kind);
      for (const Index element : bench.session.components().elements) CHECK(element < count);
    }
    CHECK(validate(bench.mesh()).empty());
    Progress progress;
    const MeshReport report = inspect(bench.mesh(), true, progress);
    CHECK(report.closed);
    CHECK(report.euler_characteristic == (ring ? 0 : 2));
    REQUIRE(bench.session.undo_labels().size() == hashes.size() - 1);
    for (std::size_t left = hashes.size() - 1; left-- > 0;) {
      bench.session.undo();
      CHECK(bench.hash() == hashes[left]);
    }
  }
}

}  // namespace
}  // namespace croquis
