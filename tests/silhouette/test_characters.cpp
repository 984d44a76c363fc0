// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <set>

#include <catch2/catch.hpp>

#include "croquis/base/error.h"
#include "croquis/silhouette/labelled_figure.h"
#include "silhouette/labelled_counts.h"
#include "support/sketches/characters/character.h"
#include "support/sketches/sketch_modifiers.h"

namespace croquis::silhouette {
namespace {

/// Whether the solids found are those that were meant: as many, each with its Euler number, nothing refused.
bool read_as_meant(const Drawing& drawing, const test::SketchTruth& truth, const Options& options) {
  try {
    const LabelledDrawing labelled = test::label_quietly(drawing, options);
    std::vector<int> meant = truth.euler_region;
    std::sort(meant.begin(), meant.end());
    return !has_errors(labelled.findings) && test::euler_numbers(labelled) == meant;
  } catch (const Error&) {
    return false;
  }
}

using Names = std::set<std::string>;

/// The characters whose drawing, made by `draw`, isn't read as meant.
template <typename Draw>
Names misread(const Options& options, Draw draw) {
  Names names;
  for (const test::Character& character : test::all_characters()) {
    const test::Sketch sketch = character_sketch(character);
    if (!read_as_meant(draw(character, sketch), sketch.truth, options)) names.insert(character.name);
  }
  return names;
}

/// What isn't among the known ones.
Names unexpected(Names misread, const Names& known) {
  for (const std::string& name : known) misread.erase(name);
  return misread;
}

TEST_CASE("characters drawn with exact lines are read as they were made") {
  const auto exact = [](const test::Character&, const test::Sketch& sketch) { return sketch.drawing; };
  CHECK(misread({}, exact) == Names{});
  CHECK(misread(Options::of(Preset::Tablet), exact) == Names{});
}

TEST_CASE("characters drawn by hand are read as they were made") {
  std::uint64_t seed = 100;
  const auto by_hand = [&](const test::Character&, const test::Sketch& sketch) {
    return test::noisy(sketch.drawing, seed++);
  };
  // Ends that the hand's errors bring to the wrong line.
  const Names known{"beads on a string", "flower", "spider"};
  CHECK(unexpected(misread(Options::of(Preset::Tablet), by_hand), known) == Names{});
}

TEST_CASE("characters of whole outlines that cross are read by the order of drawing") {
  const auto whole = [](const test::Character& character, const test::Sketch&) { return whole_outlines(character); };
  CHECK(misread(Options::of(Preset::Tablet), whole) == Names{});
}

}  // namespace
}  // namespace croquis::silhouette
