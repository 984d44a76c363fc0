// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>

#include "croquis/session/selection.h"
#include "support/trial_operation.h"

namespace croquis {
namespace {

Value drawing_of(const std::vector<std::string>& ids) {
  Drawing drawing;
  for (const std::string& id : ids) {
    drawing.strokes.emplace_back();
    drawing.strokes.back().id = id;
  }
  return std::make_shared<const Drawing>(std::move(drawing));
}

TEST_CASE("a selection is sorted, and each item is in it once") {
  const Document document =
      Document().with(test::source_node(drawing_of({"a", "b"}))).with(test::source_node(test::point(1)));
  const Selection selection = existing({{2, ""}, {1, "b"}, {1, "a"}, {2, ""}, {1, ""}}, document);
  CHECK(selection == Selection{{1, ""}, {1, "a"}, {1, "b"}, {2, ""}});
}

TEST_CASE("what isn't in the document falls out of a selection") {
  const Document document = Document()
                                .with(test::source_node(drawing_of({"a"})))
                                .with(test::operation_node("scale", {1, "value"}, 2))
                                .with(test::source_node(std::shared_ptr<const Drawing>()));
  const Selection selection = existing({{1, "a"}, {1, "b"}, {2, "face 7"}, {3, "a"}, {4, ""}, {0, ""}}, document);
  CHECK(selection == Selection{{1, "a"}, {2, "face 7"}, {3, "a"}});
  CHECK(existing({{1, "a"}}, Document()).empty());
}

}  // namespace
}  // namespace croquis
