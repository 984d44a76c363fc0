// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>

#include "croquis/document/content_hash.h"
#include "croquis/document/document.h"
#include "support/trial_operation.h"

namespace croquis {
namespace {

using test::operation_node;
using test::point;
using test::source_node;

/// A source 1, scaled by 2, scaled again by 3.
Document chain() {
  return Document()
      .with(source_node(point(1)))
      .with(operation_node("scale", {1, "value"}, 2))
      .with(operation_node("scale", {2, "mesh"}, 3));
}

TEST_CASE("new nodes get ids that count up, and keep their order") {
  const Document document = chain();
  REQUIRE(document.nodes().size() == 3);
  for (NodeId id = 1; id <= 3; ++id) {
    CHECK(document.nodes()[id - 1]->id == id);
    CHECK(document.find(id) == document.nodes()[id - 1].get());
  }
  CHECK(document.next_id() == 4);
  CHECK(document.find(0) == nullptr);
  CHECK(document.find(4) == nullptr);
}

TEST_CASE("an edit leaves the old document as it was and shares the other nodes") {
  const Document before = chain();
  const ContentHash hash = content_hash(before);
  Node changed = *before.find(2);
  changed.parameters["factor"] = 5.0;
  const Document after = before.with(changed);
  CHECK(content_hash(before) == hash);
  CHECK(content_hash(after) != hash);
  CHECK(after.nodes()[0] == before.nodes()[0]);
  CHECK(after.nodes()[1] != before.nodes()[1]);
  CHECK(after.nodes()[2] == before.nodes()[2]);
  CHECK(std::get<double>(after.find(2)->parameters.at("factor")) == 5.0);
}

TEST_CASE("an id is never given twice, not even after its node was removed") {
  Document document = chain().without(3);
  CHECK(document.next_id() == 4);
  document = document.with(source_node(point(7)));
  CHECK(document.nodes().back()->id == 4);
  Node far = source_node(point(8));
  far.id = 40;
  document = document.with(far).without(40).with(source_node(point(9)));
  CHECK(document.nodes().back()->id == 41);
}

TEST_CASE("removing a node drops the links to it and no others") {
  const Document before = chain();
  const Document after = before.without(2);
  REQUIRE(after.nodes().size() == 2);
  CHECK(after.nodes()[0] == before.nodes()[0]);
  CHECK(after.find(3)->inputs.empty());
  CHECK(before.find(3)->inputs.size() == 1);
  CHECK(before.without(3).find(2)->inputs.size() == 1);
}

TEST_CASE("removing what isn't there is the same document") {
  const Document document = chain();
  CHECK(same_nodes(document, document.without(9)));
  CHECK_FALSE(same_nodes(document, document.without(3)));
  CHECK_FALSE(same_nodes(document, document.with(*document.find(1))));
}

TEST_CASE("a document of given nodes goes on counting above them") {
  const Document chained = chain();
  CHECK(same_nodes(Document::of(chained.nodes(), 4), chained));
  CHECK(Document::of(chained.nodes(), 0).next_id() == 4);
  CHECK(Document::of(chained.nodes(), 12).next_id() == 12);
  CHECK(Document::of({}, 0).next_id() == 1);
}

}  // namespace
}  // namespace croquis
