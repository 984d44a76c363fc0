// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cstdint>
#include <iomanip>
#include <string>

#include "bench/bench.h"
#include "croquis/base/error.h"
#include "croquis/silhouette/solid.h"
#include "silhouette/part_depths.h"
#include "support/sketches/characters/character.h"
#include "support/sketches/sketch_generator.h"
#include "support/sketches/sketch_scrawls.h"

namespace croquis::bench {
namespace {

using silhouette::LabelledDrawing;
using silhouette::Options;
using silhouette::Quality;
using silhouette::Solid;

Solid solid_of(const Drawing& drawing, Options options) {
  options.quality = Quality::Draft;  // parts aren't united then, so that each can be measured
  Progress progress;
  return inflate(label(drawing, options, progress), drawing, options, progress);
}

/// Of one drawing: apart, and held as suggested.
void print_drawing(std::ostream& out, const std::string& name, const Drawing& drawing) {
  out << "| " << name;
  for (const bool held : {false, true}) {
    Options options;
    options.attach_suggested = held;
    const Solid solid = solid_of(drawing, options);
    const std::vector<test::PartDepth> parts = test::part_depths(solid);
    if (!held) out << " | " << parts.size();
    out << " | " << test::middle_spread(parts) << " | " << test::steepest(parts) << " | "
        << solid.diagnostics.depth_ratio;
  }
  out << " |\n";
}

void print_gallery(std::ostream& out) {
  out << "Spread of the parts' middles over the sum of their depths, the steepest part's slope, and the whole depth "
         "over "
         "what the drawing explains.\n\n"
      << "| drawing | parts | apart: spread | slope | ratio | held as suggested: spread | slope | ratio |\n"
      << "|---|---|---|---|---|---|---|---|\n"
      << std::fixed << std::setprecision(2);
  for (const test::Character& character : test::all_characters()) {
    try {
      print_drawing(out, character.name, test::character_sketch(character).drawing);
    } catch (const Error& error) {
      out << "| " << character.name << " | " << error.findings().front().code << " | | | | | | |\n";
    }
  }
}

struct Refusals {
  int drawings = 0;
  int solids = 0;
  int parts = 0;    ///< refused for their depths
  int figures = 0;  ///< with such a part
  double deepest = 0;

  void add(const Drawing& drawing, const Options& options) {
    ++drawings;
    Findings findings;
    try {
      const Solid solid = solid_of(drawing, options);
      ++solids;
      deepest = std::max(deepest, solid.diagnostics.depth_ratio);
      findings = solid.findings;
    } catch (const Error& error) {
      findings = error.findings();
    }
    const auto unsolved = std::count_if(findings.begin(), findings.end(),
                                        [](const Finding& finding) { return finding.code == "E_NOT_SOLVED"; });
    parts += static_cast<int>(unsolved);
    if (unsolved > 0) ++figures;
  }
};

void print_families(std::ostream& out) {
  constexpr std::uint64_t count = 100;
  out << "\nFamilies of random drawings, seeds from 0: parts refused for their depths (E_NOT_SOLVED).\n\n"
      << "| family | drawings | solids | with a refused part | refused parts | deepest ratio |\n"
      << "|---|---|---|---|---|---|\n";
  const auto print = [&](const std::string& name, const Refusals& refusals) {
    out << "| " << name << " | " << refusals.drawings << " | " << refusals.solids << " | " << refusals.figures << " | "
        << refusals.parts << " | " << refusals.deepest << " |\n";
  };
  for (const bool held : {false, true}) {
    const std::string how = held ? ", held as suggested" : "";
    for (const test::Scrawl family : test::scrawl_families()) {
      Refusals refusals;
      for (std::uint64_t seed = 0; seed < count; ++seed) {
        const test::ScrawledDrawing scrawl = test::random_scrawl(family, seed);
        Options options = Options::of(scrawl.shaky ? silhouette::Preset::Tablet : silhouette::Preset::Clean);
        options.attach_suggested = held;
        refusals.add(scrawl.drawing, options);
      }
      print(test::to_string(family) + how, refusals);
    }
    Refusals layers;
    for (std::uint64_t seed = 0; seed < count; ++seed) {
      Options options;
      options.attach_suggested = held;
      layers.add(test::random_layered_sketch(seed, 2 + static_cast<int>(seed % 8)).drawing, options);
    }
    print("layers" + how, layers);
  }
}

}  // namespace

void bench_silhouette_depth(std::ostream& out) {
  print_gallery(out);
  print_families(out);
}

}  // namespace croquis::bench
