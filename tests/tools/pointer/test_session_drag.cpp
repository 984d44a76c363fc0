// SPDX-License-Identifier: GPL-3.0-or-later
#include <functional>
#include <vector>

#include <catch2/catch.hpp>

#include "croquis/document/content_hash.h"
#include "croquis/tools/pointer/session_drag.h"
#include "support/trial_operation.h"

namespace croquis::test {
namespace {

/// A session with one mesh of one point, whose place is what is dragged.
struct Dragged {
  Session session{Document().with(source_node(point(0)))};
  NodeId node = session.document().nodes().front()->id;
  SessionDrag drag{session};

  Document at(double x) const {
    Node edited = *session.document().find(node);
    edited.source = point(x);
    return session.document().with(std::move(edited));
  }

  double place() const { return x_of(*session.document().find(node)->source); }
};

}  // namespace

TEST_CASE("a drag of a session is one step of its history, or none when it is cancelled") {
  Dragged hand;
  CHECK_FALSE(hand.drag.begun());
  hand.drag.begin("Move");
  CHECK(hand.drag.begun());
  for (const double x : {1, 2, 3}) hand.drag.to(hand.at(x));
  CHECK_FALSE(hand.drag.interrupted());
  hand.drag.end();
  CHECK_FALSE(hand.drag.begun());
  CHECK(hand.session.undo_labels() == std::vector<std::string>{"Move"});
  CHECK(hand.place() == 3);
  hand.drag.begin("Move again");
  hand.drag.to(hand.at(5));
  hand.drag.cancel();
  CHECK_FALSE(hand.drag.begun());
  CHECK(hand.place() == 3);
  CHECK(hand.session.undo_labels() == std::vector<std::string>{"Move"});
}

TEST_CASE("whatever else changes the session interrupts a drag, and cancelling it then takes nothing back") {
  const std::vector<std::function<void(Dragged&)>> others{
      [](Dragged& hand) { hand.session.edit("Other", hand.at(7)); }, [](Dragged& hand) { hand.session.undo(); },
      [](Dragged& hand) {
        hand.session.select({{hand.node, ""}});
      },
      [](Dragged& hand) {
        hand.session.select_components({hand.node, ComponentKind::Vertex, {0}});
      },
      [](Dragged& hand) { hand.session.load(hand.at(9)); }};
  for (const auto& other : others) {
    Dragged hand;
    hand.session.edit("Before", hand.at(1));
    hand.drag.begin("Move");
    hand.drag.to(hand.at(2));
    CHECK_FALSE(hand.drag.interrupted());
    other(hand);
    CHECK(hand.drag.interrupted());
    const ContentHash after = content_hash(hand.session.document());
    const std::uint64_t revision = hand.session.revision();
    hand.drag.cancel();
    CHECK_FALSE(hand.drag.begun());
    CHECK_FALSE(hand.drag.interrupted());
    CHECK(content_hash(hand.session.document()) == after);
    CHECK(hand.session.revision() == revision);
  }
}

TEST_CASE("those who are notified of a drag's own changes don't find it interrupted") {
  Dragged hand;
  int notified = 0;
  bool interrupted = false;
  hand.session.on_change([&] {
    ++notified;
    interrupted = interrupted || hand.drag.interrupted();
  });
  hand.drag.begin("Move");
  hand.drag.to(hand.at(1));
  hand.drag.select({hand.node, ComponentKind::Vertex, {0}});
  hand.drag.to(hand.at(2));
  hand.drag.to(hand.session.document());
  CHECK(notified == 3);
  CHECK_FALSE(interrupted);
  CHECK_FALSE(hand.drag.interrupted());
  CHECK(hand.session.components().elements == std::vector<Index>{0});
  hand.drag.end();
  CHECK_FALSE(interrupted);
}

TEST_CASE("ending or cancelling a drag that was never begun leaves that of another one alone") {
  Dragged hand;
  SessionDrag other(hand.session);
  hand.drag.begin("Move");
  hand.drag.to(hand.at(4));
  other.end();
  other.cancel();
  CHECK_FALSE(hand.drag.interrupted());
  hand.drag.cancel();
  CHECK(hand.place() == 0);
}

}  // namespace croquis::test
