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
#include "support/sketches/characters/character.h"
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

/// How slender the triangles of a family of solids are.
struct Slenderness {
  double sum = 0;  ///< of the shares, %
  double worst = 0;
  std::string worst_name;
  std::size_t solids = 0;

  /// @return the share of triangles with an angle below 15 degrees, %
  double add(const std::string& name, const std::vector<double>& angles) {
    constexpr double slender = 15;
    const auto below = std::lower_bound(angles.begin(), angles.end(), slender) - angles.begin();
    const double share = 100.0 * static_cast<double>(below) / static_cast<double>(angles.size());
    sum += share;
    ++solids;
    if (share > worst) {
      worst = share;
      worst_name = name;
    }
    return share;
  }

  void print(std::ostream& out, const std::string& family) const {
    out << "| " << family << " | " << solids << " | " << sum / static_cast<double>(solids) << " | " << worst << " | "
        << worst_name << " |\n";
  }
};

PolyMesh solid_of(const Drawing& drawing, const Options& options) {
  Progress progress;
  return inflate(label(drawing, options, progress), drawing, options, progress).mesh;
}

/// The triangles of every sketch of the gallery.
Slenderness print_triangles(std::ostream& out) {
  out << "Triangles of the gallery.\n\n"
      << "| sketch | triangles | below 15 degrees % | smallest angle | rim serration, p95 |\n|---|---|---|---|---|\n"
      << std::fixed << std::setprecision(1);
  Slenderness gallery;
  for (const test::NamedSketch& sketch : test::all_sketches()) {
    const PolyMesh mesh = solid_of(sketch.sketch.drawing, {});
    const std::vector<double> angles = test::smallest_angles(mesh);
    out << "| " << sketch.name << " | " << angles.size() << " | " << gallery.add(sketch.name, angles) << " | "
        << angles.front() << " | " << test::rim_serration(mesh).p95 << " |" << std::endl;
  }
  return gallery;
}

/// Characters apart, and held as they suggest.
void print_families(std::ostream& out, const Slenderness& gallery) {
  Slenderness apart;
  Slenderness held;
  Options options = Options::of(silhouette::Preset::Clean);
  options.strokes.crossings = silhouette::Crossings::Front;
  for (const test::Character& character : test::all_characters()) {
    const Drawing drawing = test::character_sketch(character).drawing;
    for (const bool attached : {false, true}) {
      options.attach_suggested = attached;
      const PolyMesh mesh = solid_of(drawing, options);
      if (mesh.face_count() > 0) (attached ? held : apart).add(character.name, test::smallest_angles(mesh));
    }
  }
  out << "\nTriangles below 15 degrees, %.\n\n| family | solids | mean | worst | of |\n|---|---|---|---|---|\n";
  gallery.print(out, "gallery");
  apart.print(out, "characters, apart");
  held.print(out, "characters, held as suggested");
}

}  // namespace

void bench_silhouette_finish(std::ostream& out) {
  print_families(out, print_triangles(out));
  print_joined(out);
}

}  // namespace croquis::bench
