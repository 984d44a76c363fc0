// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>

#include "croquis/base/error.h"
#include "croquis/document/backdrop.h"
#include "croquis/document/byte_size.h"
#include "croquis/document/content_hash.h"
#include "croquis/session/session.h"
#include "support/meshes/mesh_shapes.h"
#include "support/trial_operation.h"

namespace croquis {
namespace {

using Labels = std::vector<std::string>;

Document two_nodes() {
  return Document().with(test::source_node(test::point(1), "one")).with(test::source_node(test::point(2), "two"));
}

Document renamed(const Document& document, NodeId id, std::string name) {
  Node node = *document.find(id);
  node.name = std::move(name);
  return document.with(node);
}

std::string name_of(const Session& session, NodeId id) { return session.document().find(id)->name; }

Value drawing_of(const std::vector<std::string>& ids) {
  Drawing drawing;
  for (const std::string& id : ids) {
    drawing.strokes.emplace_back();
    drawing.strokes.back().id = id;
  }
  return std::make_shared<const Drawing>(std::move(drawing));
}

TEST_CASE("an edit is a step with its label, undone and redone") {
  Session session(two_nodes());
  CHECK_FALSE(session.can_undo());
  session.edit("Rename one", renamed(session.document(), 1, "first"));
  session.edit("Rename two", renamed(session.document(), 2, "second"));
  CHECK(session.undo_labels() == Labels{"Rename one", "Rename two"});
  session.undo();
  CHECK(name_of(session, 1) == "first");
  CHECK(name_of(session, 2) == "two");
  CHECK(session.undo_labels() == Labels{"Rename one"});
  CHECK(session.redo_labels() == Labels{"Rename two"});
  session.undo();
  CHECK(name_of(session, 1) == "one");
  CHECK(session.redo_labels() == Labels{"Rename one", "Rename two"});
  session.redo();
  CHECK(name_of(session, 1) == "first");
  CHECK(session.redo_labels() == Labels{"Rename two"});
  session.edit("Rename again", renamed(session.document(), 1, "uno"));
  CHECK_FALSE(session.can_redo());
  CHECK(session.undo_labels() == Labels{"Rename one", "Rename again"});
}

TEST_CASE("nothing to undo or redo is no change") {
  Session session(two_nodes());
  session.undo();
  session.redo();
  CHECK(session.revision() == 0);
  CHECK(same_nodes(session.document(), session.document()));
}

TEST_CASE("an edit that changes nothing is no step") {
  Session session(two_nodes());
  session.edit("Same", session.document());
  session.edit("Same content", renamed(session.document(), 1, "one"));
  Node node = *session.document().find(1);
  node.source = test::point(1);
  session.edit("Same value", session.document().with(node));
  CHECK_FALSE(session.can_undo());
  CHECK_FALSE(session.modified());
  CHECK(session.revision() == 0);
  node.source = test::point(3);
  session.edit("Another value", session.document().with(node));
  CHECK(session.undo_labels() == Labels{"Another value"});
}

TEST_CASE("a drag of many changes is one step") {
  Session session(two_nodes());
  session.begin_drag("Drag");
  for (const char* name : {"a", "b", "c"}) session.drag(renamed(session.document(), 1, name));
  CHECK(name_of(session, 1) == "c");
  CHECK_FALSE(session.can_undo());
  session.end_drag();
  CHECK(session.undo_labels() == Labels{"Drag"});
  session.undo();
  CHECK(name_of(session, 1) == "one");
  session.redo();
  CHECK(name_of(session, 1) == "c");
}

TEST_CASE("a drag that is cancelled or comes back leaves no trace") {
  Session session(two_nodes());
  session.edit("Rename", renamed(session.document(), 2, "second"));
  session.undo();
  const ContentHash before = content_hash(session.document());
  session.select({{1, ""}});
  session.begin_drag("Drag");
  session.drag(session.document().without(1));
  CHECK(session.selection().empty());
  CHECK(session.modified());
  session.cancel_drag();
  CHECK(content_hash(session.document()) == before);
  CHECK(session.selection() == Selection{{1, ""}});
  CHECK_FALSE(session.modified());
  CHECK(session.can_redo());

  session.begin_drag("Drag");
  session.drag(renamed(session.document(), 1, "a"));
  session.drag(renamed(session.document(), 1, "one"));
  session.end_drag();
  CHECK_FALSE(session.can_undo());
  CHECK_FALSE(session.modified());
  CHECK(session.can_redo());
  session.begin_drag("Nothing at all");
  session.end_drag();
  CHECK(session.can_redo());
}

TEST_CASE("whatever else is done ends a drag first") {
  Session session(two_nodes());
  session.begin_drag("Drag");
  session.drag(renamed(session.document(), 1, "a"));
  session.edit("Edit", renamed(session.document(), 2, "b"));
  CHECK(session.undo_labels() == Labels{"Drag", "Edit"});
  session.begin_drag("Drag 2");
  session.drag(renamed(session.document(), 1, "c"));
  session.undo();
  CHECK(name_of(session, 1) == "a");
  CHECK(session.redo_labels() == Labels{"Drag 2"});
  session.begin_drag("Drag 3");
  session.drag(renamed(session.document(), 1, "d"));
  session.begin_drag("Drag 4");
  session.drag(renamed(session.document(), 1, "e"));
  session.redo();
  CHECK(session.undo_labels() == Labels{"Drag", "Edit", "Drag 3", "Drag 4"});
  session.cancel_drag();
  session.end_drag();
  CHECK(name_of(session, 1) == "e");
  CHECK_THROWS_AS(session.drag(two_nodes()), Error);
}

TEST_CASE("modified means another document than the saved one, across undo and redo") {
  Session session(two_nodes());
  CHECK_FALSE(session.modified());
  session.edit("A", renamed(session.document(), 1, "a"));
  CHECK(session.modified());
  session.mark_saved();
  CHECK_FALSE(session.modified());
  session.undo();
  CHECK(session.modified());
  session.redo();
  CHECK_FALSE(session.modified());
  session.undo();
  session.edit("B", renamed(session.document(), 1, "b"));
  session.undo();
  CHECK(session.modified());  // what was saved can't be reached any more
  session.mark_saved();
  session.redo();
  CHECK(session.modified());
}

TEST_CASE("loading forgets history and selection") {
  Session session(two_nodes());
  session.edit("A", renamed(session.document(), 1, "a"));
  session.edit("B", renamed(session.document(), 1, "b"));
  session.undo();
  session.select({{1, ""}});
  session.begin_drag("Drag");
  session.load(Document().with(test::source_node(test::point(9), "nine")));
  CHECK(name_of(session, 1) == "nine");
  CHECK_FALSE(session.can_undo());
  CHECK_FALSE(session.can_redo());
  CHECK(session.selection().empty());
  CHECK_FALSE(session.modified());
  CHECK_THROWS_AS(session.drag(two_nodes()), Error);
  session.load(two_nodes(), true);
  CHECK(session.modified());
  session.edit("C", renamed(session.document(), 1, "c"));
  session.undo();
  CHECK(session.modified());
  session.mark_saved();
  CHECK_FALSE(session.modified());
}

TEST_CASE("going to a step is undo and redo as often as needed, and one change") {
  Session session(two_nodes());
  for (int step = 1; step <= 12; ++step) session.edit("Step", renamed(session.document(), 1, std::to_string(step)));
  const auto history = session.history();
  REQUIRE(history.size() == 13);
  CHECK(history.back().state == session.state());
  int changes = 0;
  session.on_change([&] { ++changes; });
  for (const std::size_t steps : {4U, 12U, 0U, 7U, 7U}) {
    session.go_to(steps);
    CHECK(session.undo_labels().size() == steps);
    CHECK(session.redo_labels().size() == 12 - steps);
    CHECK(session.state() == history[steps].state);
    CHECK(same_nodes(session.document(), history[steps].document));
    CHECK(session.history()[12].state == history[12].state);
  }
  CHECK(changes == 4);
  session.go_to(1000);
  CHECK(session.state() == history[12].state);
}

TEST_CASE("versions are no steps, are saved with the document and go when another one is loaded") {
  Session session(two_nodes());
  session.edit("A", renamed(session.document(), 1, "a"));
  session.mark_saved();
  const auto state = session.versions.state();
  session.versions.set({{"first", session.document()}});
  CHECK(session.modified());
  CHECK(session.versions.state() > state);
  session.undo();
  REQUIRE(session.versions.list().size() == 1);
  CHECK(session.redo_labels() == Labels{"A"});
  session.redo();
  session.mark_saved();
  CHECK_FALSE(session.modified());
  session.versions.set({{"first", session.document(), {1, 2}}}, true);
  CHECK_FALSE(session.modified());
  session.edit("first", two_nodes());
  session.undo();
  CHECK_FALSE(session.modified());
  session.versions.set({});
  CHECK(session.modified());
  session.load(two_nodes(), false, {}, {{"other", two_nodes()}});
  CHECK(session.versions.list().front().name == "other");
  CHECK_FALSE(session.modified());
  session.load(two_nodes());
  CHECK(session.versions.list().empty());
}

TEST_CASE("recovered work comes with the documents that undo leads back to") {
  Session before(two_nodes());
  for (const char* name : {"a", "b", "c"}) before.edit(name, renamed(before.document(), 1, name));
  before.undo();
  CHECK(past_of(before, 1).size() == 1);
  CHECK(past_of(before, 1)[0].label == "b");
  Session session;
  session.load(before.document(), true, past_of(before, 10));
  CHECK(session.undo_labels() == Labels{"a", "b"});
  CHECK(session.modified());
  CHECK(session.history_bytes() > 0);
  session.undo();
  CHECK(name_of(session, 1) == "a");
  session.undo();
  CHECK(name_of(session, 1) == "one");
  CHECK_FALSE(session.can_undo());
  CHECK(session.modified());
  session.redo();
  session.redo();
  CHECK(name_of(session, 1) == "b");
  session.mark_saved();
  session.undo();
  CHECK(session.modified());
}

TEST_CASE("undo brings back the selection of then, without what isn't there") {
  Session session(Document().with(test::source_node(drawing_of({"a", "b"}))));
  session.select({{1, "b"}, {1, "a"}});
  Node fewer = *session.document().find(1);
  fewer.source = drawing_of({"b"});
  session.edit("Erase a", session.document().with(fewer));
  CHECK(session.selection() == Selection{{1, "b"}});
  session.undo();
  CHECK(session.selection() == Selection{{1, "a"}, {1, "b"}});
  session.redo();
  CHECK(session.selection() == Selection{{1, "b"}});

  session.edit("Add", session.document().with(test::source_node(test::point(1))));
  session.select({{1, ""}, {2, ""}});
  session.edit("Rename", renamed(session.document(), 2, "x"));
  session.undo();
  session.undo();
  CHECK(session.selection() == Selection{{1, "b"}});
}

TEST_CASE("listeners hear of every change, in order, and may use the session") {
  Session session(two_nodes());
  std::string heard;
  session.on_change([&] { heard += "a" + std::to_string(session.revision()); });
  session.on_change([&] { heard += "b "; });
  session.edit("A", renamed(session.document(), 1, "a"));
  session.select({{1, ""}});
  session.select({{1, ""}, {7, ""}});  // the same
  session.undo();
  session.mark_saved();
  CHECK(heard == "a1b a2b a3b ");
  session.redo();
  session.mark_saved();
  CHECK(heard == "a1b a2b a3b a4b a4b ");
  bool once = true;
  session.on_change([&] {
    if (std::exchange(once, false)) session.select({});
  });
  session.select({{2, ""}});
  CHECK(session.selection().empty());
}

TEST_CASE("an id given away stays used after its step was undone") {
  Session session(two_nodes());
  session.edit("Add", session.document().with(test::source_node(test::point(3))));
  CHECK(session.document().nodes().back()->id == 3);
  session.undo();
  session.edit("Add another", session.document().with(test::source_node(test::point(4))));
  CHECK(session.document().nodes().back()->id == 4);
}

Value large_value(std::size_t points) {
  PolyMesh mesh;
  mesh.positions.resize(points, Vec3::Zero());
  return std::make_shared<const PolyMesh>(std::move(mesh));
}

Document with_value(const Document& document, double x) {
  PolyMesh mesh;
  mesh.positions.resize(1000, Vec3(x, 0, 0));
  Node node = *document.find(1);
  node.source = std::make_shared<const PolyMesh>(std::move(mesh));
  return document.with(node);
}

TEST_CASE("the oldest steps are forgotten above the byte cap") {
  constexpr std::size_t step = 1000 * sizeof(Vec3);
  constexpr std::size_t cap = 10 * step;
  Session session(Document().with(test::source_node(large_value(1000))), cap);
  for (int i = 1; i <= 30; ++i) {
    session.edit("Edit " + std::to_string(i), with_value(session.document(), i));
    CHECK(session.history_bytes() <= cap);
  }
  const Labels labels = session.undo_labels();
  CHECK(labels.size() >= 8);
  CHECK(labels.size() <= 10);
  CHECK(labels.back() == "Edit 30");
  const std::size_t steps = labels.size();
  for (std::size_t i = 0; i < steps; ++i) session.undo();
  CHECK_FALSE(session.can_undo());
  CHECK(session.redo_labels().size() == steps);
  CHECK(session.redo_labels().front() == labels.front());
  for (std::size_t i = 0; i < steps; ++i) session.redo();
  CHECK(test::x_of(*session.document().find(1)->source) == 30);
}

TEST_CASE("the newest step is kept however large it is") {
  Session session(Document().with(test::source_node(large_value(1000))), 10);
  session.edit("A", with_value(session.document(), 1));
  session.edit("B", with_value(session.document(), 2));
  CHECK(session.undo_labels() == Labels{"B"});
  session.undo();
  CHECK(test::x_of(*session.document().find(1)->source) == 1);
  CHECK(session.redo_labels() == Labels{"B"});
}

TEST_CASE("steps share what they didn't change") {
  Session session(Document().with(test::source_node(large_value(100000), "scan")));
  for (int i = 0; i < 50; ++i) session.edit("Rename", renamed(session.document(), 1, std::to_string(i)));
  CHECK(session.history_bytes() < 50 * 1000);
  session.edit("Remove", session.document().without(1));
  CHECK(session.history_bytes() >= 100000 * sizeof(Vec3));
  session.undo();  // now it is part of the current document again
  CHECK(session.history_bytes() < 50 * 1000);
}

TEST_CASE("selected components are part of undo steps, and cost nothing while they stay the same") {
  const auto mesh = [](double size) {
    return Value(std::make_shared<const PolyMesh>(test::scaled(test::cube(), size)));
  };
  Session session(Document().with(test::source_node(mesh(1))));
  int changes = 0;
  session.on_change([&] { ++changes; });
  session.select_components({1, ComponentKind::Face, {4, 1}});
  CHECK(session.components() == ComponentSelection{1, ComponentKind::Face, {1, 4}});
  CHECK(changes == 1);
  session.select_components({1, ComponentKind::Face, {1, 4, 4}});
  CHECK(changes == 1);
  CHECK_FALSE(session.can_undo());
  const auto before = session.shared_components();

  Node larger = *session.document().find(1);
  larger.source = mesh(2);
  session.edit("grow", session.document().with(larger));
  CHECK(session.shared_components() == before);
  larger.source = mesh(3);
  session.edit("grow again", session.document().with(larger), ComponentSelection{1, ComponentKind::Vertex, {7}});
  CHECK(changes == 3);
  CHECK(session.components() == ComponentSelection{1, ComponentKind::Vertex, {7}});
  session.undo();
  CHECK(session.components() == *before);
  session.redo();
  CHECK(session.components() == ComponentSelection{1, ComponentKind::Vertex, {7}});

  session.edit("remove", session.document().without(1));
  CHECK(session.components().empty());
  CHECK(session.components().node == 0);
  session.undo();
  CHECK(session.components().elements == std::vector<Index>{7});
  session.load(Document());
  CHECK(session.components().empty());
}

TEST_CASE("a drag given up brings back the components selected at its beginning") {
  Session session(Document().with(test::source_node(Value(std::make_shared<const PolyMesh>(test::cube())))));
  session.select_components({1, ComponentKind::Edge, {2}});
  session.begin_drag("delete by dragging");
  session.drag(session.document().without(1));
  CHECK(session.components().empty());
  session.cancel_drag();
  CHECK(session.components() == ComponentSelection{1, ComponentKind::Edge, {2}});
}

TEST_CASE("steps that change the picture behind a drawing share its bytes, and none counts twice") {
  Node node = test::source_node(large_value(10));
  const auto picture = std::make_shared<const PictureFile>(PictureFile{std::string(3'000'000, 'p'), 40, 30, "a.png"});
  const auto behind = [&](double opacity) {
    Node edited = node;
    edited.id = 1;
    edited.backdrop = std::make_shared<const Backdrop>(Backdrop{picture, Vec2::Zero(), 1, opacity, true});
    return Document().with(edited);
  };
  Session session(behind(0));
  for (int i = 1; i <= 50; ++i) session.edit("Opacity", behind(i / 50.0));
  CHECK(session.undo_labels().size() == 50);
  CHECK(session.history_bytes() < 50 * 1000);
  session.edit("Opacity", behind(1));
  CHECK(session.undo_labels().size() == 50);  // nothing changed
  node.id = 1;
  session.edit("Remove", Document().with(node));
  CHECK(session.history_bytes() >= 3'000'000);
  session.undo();
  CHECK(session.history_bytes() < 50 * 1000);
  CHECK(session.document().find(1)->backdrop->opacity == 1);
}

}  // namespace
}  // namespace croquis
