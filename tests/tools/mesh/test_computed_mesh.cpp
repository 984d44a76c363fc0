// SPDX-License-Identifier: GPL-3.0-or-later
// Work on meshes that are computed: edits go into a step of edits after them.
#include <cmath>

#include <catch2/catch.hpp>

#include "croquis/base/error.h"
#include "croquis/document/content_hash.h"
#include "croquis/edits/apply_edits.h"
#include "croquis/operators/all_operations.h"
#include "croquis/tools/mesh/mesh_tool.h"
#include "croquis/workspace/chain.h"
#include "croquis/workspace/object_commands.h"
#include "croquis/workspace/step_commands.h"
#include "support/main_loop.h"
#include "support/meshes/mesh_shapes.h"
#include "support/random.h"
#include "support/trial_operation.h"
#include "tools/pointer/mesh_views.h"

namespace croquis {
namespace {

using Kind = PenStep::Kind;

Registry with_copying() {
  Registry registry = all_operations();
  test::add_operation(registry, test::mesh_to_mesh("copy"),
                      [](const Values& inputs, const ParameterValues&, Context&) -> OperationResult {
                        return {{{"mesh", inputs.at("mesh")}}, {}};
                      });
  return registry;
}

/// A mesh called "box" under the tool: held by a source, or what a step gives that copies it.
struct Bench {
  test::MainLoop loop;
  Workspace workspace{with_copying(), loop.post(), {}};
  MeshTool tool{workspace.session(), &workspace};
  test::TestCamera camera;
  NodeId source = 0;

  Bench(const PolyMesh& mesh, bool computed) {
    camera.eye = {2.6, 2.2, 4};
    source = add_source(workspace, "box", std::make_shared<const PolyMesh>(mesh));
    tool.set_node(computed ? add_step(workspace, source, "copy") : source);
    settle();
  }

  void settle() {
    loop.run_until([&] { return !workspace.busy(); });
  }
  Session& session() { return workspace.session(); }
  const PolyMesh& mesh() const { return *tool.editable().mesh(); }
  Verdict apply(const std::string& text) { return tool.edits().apply(parse_edit_lines(text).front()); }
  ContentHash hash() { return content_hash(session().document()); }
  std::string lines() { return text_of(session().document().find(tool.editable().node())->parameters, "do"); }

  /// As the window does after every change: undo takes a step away.
  void follow() {
    if (session().document().find(tool.editable().node()) == nullptr) tool.set_node(workspace.active()->editable);
  }

  Verdict drag(const Vec2& from, const Vec2& to) {
    tool.handle({Kind::Begin, from, {}, camera.frame(), 1});
    for (int i = 1; i <= 8; ++i) tool.handle({Kind::Sample, from + (to - from) * i / 8, {}, camera.frame(), 1.1});
    return tool.handle({Kind::End, to, {}, camera.frame(), 1.2});
  }
};

ContentHash hash_of(const PolyMesh& mesh) { return content_hash(Value(std::make_shared<const PolyMesh>(mesh))); }

TEST_CASE("random edits of a computed mesh are those of the same mesh as a source, and undo gives every state back") {
  test::Random random(11);
  const std::vector<const char*> texts = {"extrude faces=# distance=0.1",
                                          "inset faces=# width=0.001",
                                          "loop-cut edges=#",
                                          "move vertices=# by=0.01,0,0",
                                          "pin vertices=#",
                                          "sharpness edges=# value=3",
                                          "delete faces=#",
                                          "dissolve edges=#"};
  for (int round = 0; round < 6; ++round) {
    const PolyMesh mesh = round % 2 == 0 ? test::torus(7, 5) : test::grid(4, 3);
    Bench held(mesh, false);
    Bench computed(mesh, true);
    const auto mode = static_cast<MeshMode>(random.below(4));
    for (Bench* bench : {&held, &computed}) bench->tool.selection().set_mode(mode);
    std::vector<ContentHash> states{computed.hash()};
    for (int step = 0; step < 8; ++step) {
      std::string text = texts[random.below(static_cast<std::uint32_t>(texts.size()))];
      text.replace(text.find('#'), 1, std::to_string(random.below(5)));
      INFO(text);
      Verdict expected = Verdict::Continue;
      try {
        expected = held.apply(text);
      } catch (const Error&) {
        CHECK_THROWS_AS(computed.apply(text), Error);
        continue;
      }
      CHECK(computed.apply(text) == expected);
      if (expected == Verdict::Commit) states.push_back(computed.hash());
      CHECK(hash_of(computed.mesh()) == hash_of(held.mesh()));
      CHECK(computed.session().components().elements == held.session().components().elements);
      CHECK(computed.tool.selection().mode() == held.tool.selection().mode());
    }
    CHECK(computed.session().document().nodes().size() <= 3);  // one step of edits, with all lines
    computed.settle();
    CHECK(hash_of(*computed.workspace.active()->mesh) == hash_of(held.mesh()));
    CHECK(hash_of(*source_mesh(computed.session().document(), computed.source)) == hash_of(mesh));
    for (std::size_t left = states.size() - 1; left-- > 0;) {
      computed.session().undo();
      computed.follow();
      CHECK(computed.hash() == states[left]);
    }
    CHECK(hash_of(computed.mesh()) == hash_of(mesh));
  }
}

TEST_CASE("commands on what is selected in a computed mesh are lines, and the selection goes on") {
  Bench held(test::torus(9, 6), false);
  Bench computed(test::torus(9, 6), true);
  for (Bench* bench : {&held, &computed}) {
    MeshTool& tool = bench->tool;
    tool.selection().set_mode(MeshMode::Edge);
    tool.selection().pick(ComponentKind::Edge, {2, 6, 9});
    CHECK(tool.take(recorded::Move{.by = {0.1, 0, 0}}) == Verdict::Commit);
    CHECK(tool.selection().selected() == Elements{2, 6, 9});
    CHECK(tool.take(recorded::Rotate{.axis = {0, 1, 0}, .degrees = 20}) == Verdict::Commit);
    CHECK(tool.take(recorded::Scale{.factors = {1, 2, 1}}) == Verdict::Commit);
    tool.selection().pick(ComponentKind::Edge, {2});
    CHECK(tool.take(recorded::Tag{.sharpness = 2}) == Verdict::Commit);
    tool.selection().pick(ComponentKind::Edge, {2, 6});
    CHECK(tool.take(recorded::Tag{.change = 1.5}) == Verdict::Commit);
    CHECK(tool.take(recorded::Pin{}) == Verdict::Commit);
    CHECK(tool.selection().selected() == Elements{2, 6});
  }
  CHECK(hash_of(computed.mesh()) == hash_of(held.mesh()));
  auto labels = computed.session().undo_labels();
  labels.erase(labels.begin());  // the step that copies
  CHECK(labels == held.session().undo_labels());
  CHECK_THROWS_AS(computed.tool.take(recorded::TagSet{.name = "corners"}), Error);
}

TEST_CASE("a drag of the manipulator is one line of a computed mesh and one undo step") {
  for (const MeshHandles handles : {MeshHandles::Move, MeshHandles::Rotate, MeshHandles::Scale}) {
    Bench held(test::cube(), false);
    Bench computed(test::cube(), true);
    computed.apply("sharpness edges=0 value=2");
    held.apply("sharpness edges=0 value=2");
    for (Bench* bench : {&held, &computed}) {
      bench->tool.set_handles(handles);
      bench->tool.selection().set_mode(MeshMode::Face);
      bench->tool.selection().pick(ComponentKind::Face, {1});
      const std::size_t steps = bench->session().undo_labels().size();
      const auto frame = bench->camera.frame();
      const ManipulatorPicture picture = manipulator_picture(bench->tool, frame);
      REQUIRE(!picture.lines.empty());
      const auto& line = picture.lines.front().points;
      const auto from = frame.project(line[line.size() / 2]);
      REQUIRE(from);
      const Verdict verdict = bench->drag(from->pixel, from->pixel + Vec2(37, -21));
      CHECK(verdict == Verdict::Commit);
      CHECK(bench->session().undo_labels().size() == steps + 1);
      CHECK(bench->tool.selection().selected() == Elements{1});
    }
    const std::string lines = computed.lines();
    CHECK(std::count(lines.begin(), lines.end(), ';') == 1);
    for (Index v = 0; v < 8; ++v) CHECK((computed.mesh().positions[v] - held.mesh().positions[v]).norm() < 1e-9);
  }
}

TEST_CASE("a drag that is given up leaves no step of edits") {
  Bench bench(test::cube(), true);
  const ContentHash before = bench.hash();
  const NodeId node = bench.tool.editable().node();
  bench.tool.set_handles(MeshHandles::Move);
  bench.tool.selection().set_mode(MeshMode::Face);
  bench.tool.selection().pick(ComponentKind::Face, {1});
  const auto frame = bench.camera.frame();
  const auto points = manipulator_picture(bench.tool, frame).lines.front().points;
  const Vec2 from = frame.project(points[points.size() / 2])->pixel;
  bench.tool.handle({Kind::Begin, from, {}, frame, 1});
  bench.tool.handle({Kind::Sample, from + Vec2(30, 0), {}, frame, 1});
  CHECK(bench.hash() != before);
  CHECK(bench.tool.editable().node() != node);
  bench.tool.handle({Kind::Cancel, from, {}, frame, 1});
  CHECK(bench.hash() == before);
  CHECK(bench.tool.editable().node() == node);
  CHECK(bench.tool.selection().selected() == Elements{1});
}

TEST_CASE("the last edit of a computed mesh is made again with other numbers") {
  Bench bench(test::cube(), true);
  bench.tool.selection().set_mode(MeshMode::Face);
  bench.apply("inset faces=1 width=0.1");
  REQUIRE(bench.tool.edits().last() != nullptr);
  CHECK_THROWS_AS(bench.tool.edits().adjust({{"width", 5.0}}), Error);
  CHECK(bench.tool.edits().adjust({{"width", 0.2}}) == Verdict::Commit);
  CHECK(bench.lines() == "inset faces=1 width=0.2");
  CHECK(bench.session().undo_labels().size() == 2);
  CHECK(bench.session().document().nodes().size() == 3);
}

TEST_CASE("elements of a computed mesh stay selected while it moves, and fall out when it is joined otherwise") {
  Bench bench(test::torus(7, 5), true);
  const auto replace_source = [&](const PolyMesh& mesh) {
    Node node = *bench.session().document().find(bench.source);
    node.source = std::make_shared<const PolyMesh>(mesh);
    bench.session().edit("Replace", bench.session().document().with(std::move(node)));
    bench.settle();
  };
  bench.tool.selection().set_mode(MeshMode::Vertex);
  bench.tool.selection().pick(ComponentKind::Vertex, {3, 4});
  replace_source(test::scaled(test::torus(7, 5), 2));
  CHECK(bench.tool.selection().selected() == Elements{3, 4});
  replace_source(test::torus(9, 8));
  CHECK(bench.session().components().empty());
  bench.session().undo();
  bench.settle();
  CHECK(bench.mesh().vertex_count() == 35);
}

TEST_CASE("a step of edits that is off is left alone: new edits go after it") {
  Bench bench(test::cube(), true);
  bench.apply("inset faces=1 width=0.1");
  const NodeId first = bench.tool.editable().node();
  enable_step(bench.workspace, first, false);
  bench.settle();
  CHECK(bench.mesh().face_count() == 6);
  bench.apply("extrude faces=0 distance=1");
  CHECK(bench.tool.editable().node() != first);
  CHECK(bench.mesh().face_count() == 10);
}

}  // namespace
}  // namespace croquis
