// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cstdint>
#include <iomanip>
#include <string>
#include <vector>

#include "bench/bench.h"
#include "bench/cpu_time.h"
#include "croquis/base/error.h"
#include "croquis/silhouette/attachment.h"
#include "croquis/silhouette/solid.h"
#include "silhouette/surface_quality.h"
#include "support/sketches/sketch_generator.h"

namespace croquis::bench {
namespace {

using silhouette::LabelledDrawing;
using silhouette::LabelledFigure;
using silhouette::Options;
using silhouette::Solid;

std::vector<silhouette::AttachedPair> suggested_pairs(const LabelledDrawing& labelled) {
  std::vector<silhouette::AttachedPair> pairs;
  for (const LabelledFigure& figure : labelled.figures) {
    for (const silhouette::AttachSuggestion& suggestion : attach_suggestions(figure)) {
      if (suggestion.hold != silhouette::Hold::Joined) continue;
      pairs.push_back({figure.objects[suggestion.a].name, figure.objects[suggestion.b].name});
    }
  }
  return pairs;
}

/// Of a family of drawings.
struct JoinedShare {
  std::size_t pairs = 0;
  std::size_t joined = 0;
  std::size_t drawings = 0;
  std::size_t whole = 0;  ///< drawings all of whose pairs were joined
  double ms = 0;

  void add(const Drawing& drawing) {
    Progress progress;
    Options options;
    const LabelledDrawing labelled = label(drawing, options, progress);
    options.attach = suggested_pairs(labelled);
    Solid solid;
    ms += cpu_ms([&] { solid = inflate(labelled, drawing, options, progress); });
    pairs += options.attach.size();
    joined += solid.attached.size();
    ++drawings;
    whole += solid.attached.size() == options.attach.size() ? 1U : 0U;
  }

  void print(std::ostream& out, const std::string& name) const {
    out << "| " << name << " | " << drawings << " | " << whole << " | " << pairs << " | " << joined << " | "
        << std::fixed << std::setprecision(1) << 100.0 * static_cast<double>(joined) / static_cast<double>(pairs)
        << " | " << ms / static_cast<double>(drawings) << " |\n";
  }
};

void print_joined(std::ostream& out) {
  constexpr std::uint64_t count = 40;
  out << "\nPairs that look like limb and body, all attached.\n\n"
      << "| family | drawings | all joined | pairs | joined | % | ms each |\n|---|---|---|---|---|---|---|\n";
  JoinedShare animals;
  for (const test::Sketch& sketch : {test::dog_sketch(), test::duck_sketch(), test::octopus_sketch()}) {
    animals.add(sketch.drawing);
  }
  animals.print(out, "dog, duck, octopus");
  JoinedShare figures;
  JoinedShare layers;
  for (std::uint64_t seed = 0; seed < count; ++seed) {
    figures.add(test::random_figure_sketch(seed).drawing);
    layers.add(test::random_layered_sketch(seed, 2 + static_cast<int>(seed % 8)).drawing);
  }
  figures.print(out, "body with limbs, random");
  layers.print(out, "layers, random");
}

/// The triangles of every sketch of the gallery.
void print_triangles(std::ostream& out) {
  constexpr double slender = 15;
  out << "Triangles of the gallery.\n\n"
      << "| sketch | triangles | below 15 degrees % | smallest angle | rim serration, p95 |\n|---|---|---|---|---|\n"
      << std::fixed << std::setprecision(1);
  for (const test::NamedSketch& sketch : test::all_sketches()) {
    Progress progress;
    const Options options;
    const Drawing& drawing = sketch.sketch.drawing;
    const PolyMesh mesh = inflate(label(drawing, options, progress), drawing, options, progress).mesh;
    const std::vector<double> angles = test::smallest_angles(mesh);
    const auto below = std::lower_bound(angles.begin(), angles.end(), slender) - angles.begin();
    out << "| " << sketch.name << " | " << angles.size() << " | "
        << 100.0 * static_cast<double>(below) / static_cast<double>(angles.size()) << " | " << angles.front() << " | "
        << test::rim_serration(mesh).p95 << " |" << std::endl;
  }
}

}  // namespace

void bench_silhouette_finish(std::ostream& out) {
  print_triangles(out);
  print_joined(out);
}

}  // namespace croquis::bench
