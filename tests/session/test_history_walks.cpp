// SPDX-License-Identifier: GPL-3.0-or-later
#include <vector>

#include <catch2/catch.hpp>

#include "croquis/document/content_hash.h"
#include "croquis/session/session.h"
#include "support/random.h"
#include "support/sample_count.h"
#include "support/trial_operation.h"

namespace croquis {
namespace {

/// What a history should be: the hash of each document of it, and which one is current.
struct Model {
  std::vector<ContentHash> hashes;
  std::size_t current = 0;
  std::size_t saved = 0;  ///< hashes.size() or more when it can't be reached

  void add(const ContentHash& hash) {
    if (hash == hashes[current]) return;
    if (saved > current) saved = ~std::size_t{0};
    hashes.resize(++current);
    hashes.push_back(hash);
  }
};

Document random_edit(const Document& document, test::Random& random) {
  const std::uint32_t choice = document.nodes().empty() ? 0 : random.below(5);
  if (choice == 0) return document.with(test::source_node(test::point(random.below(4))));
  const Node& chosen = *document.nodes()[random.below(static_cast<std::uint32_t>(document.nodes().size()))];
  if (choice == 1) return document.with(test::operation_node("scale", {chosen.id, "mesh"}, random.below(4)));
  if (choice == 2) return document.without(chosen.id);
  Node changed = chosen;
  if (choice == 3) changed.name = std::string(1, static_cast<char>('a' + random.below(3)));
  if (choice == 4) changed.visible = random.below(2) == 0;
  return document.with(changed);
}

void random_drag(Session& session, Model& model, test::Random& random) {
  session.begin_drag("Drag");
  for (std::uint32_t i = random.below(4); i > 0; --i) session.drag(random_edit(session.document(), random));
  if (random.below(3) == 0) {
    session.cancel_drag();
    return;
  }
  session.end_drag();
  model.add(content_hash(session.document()));
}

void random_action(Session& session, Model& model, test::Random& random) {
  const std::uint32_t choice = random.below(10);
  if (choice < 4) {
    session.edit("Edit", random_edit(session.document(), random));
    model.add(content_hash(session.document()));
  } else if (choice < 6) {
    session.undo();
    if (model.current > 0) --model.current;
  } else if (choice < 8) {
    session.redo();
    if (model.current + 1 < model.hashes.size()) ++model.current;
  } else if (choice < 9) {
    random_drag(session, model, random);
  } else {
    session.mark_saved();
    model.saved = model.current;
  }
}

bool agrees(const Session& session, const Model& model) {
  return content_hash(session.document()) == model.hashes[model.current] &&
         session.undo_labels().size() == model.current &&
         session.redo_labels().size() == model.hashes.size() - 1 - model.current &&
         session.modified() == (model.saved != model.current);
}

TEST_CASE("random walks of edits, drags, undo and redo arrive where they should") {
  const int walks = test::sample_count(1000, 20000);
  for (int walk = 0; walk < walks; ++walk) {
    test::Random random(static_cast<std::uint64_t>(walk));
    Session session;
    Model model{{content_hash(session.document())}, 0, 0};
    bool right = true;
    for (int i = 0; i < 40; ++i) {
      random_action(session, model, random);
      right = right && agrees(session, model);
    }
    while (session.can_redo()) session.redo();
    right = right && content_hash(session.document()) == model.hashes.back();
    while (session.can_undo()) session.undo();
    right = right && content_hash(session.document()) == model.hashes.front();
    INFO("walk " << walk);
    REQUIRE(right);
  }
}

}  // namespace
}  // namespace croquis
