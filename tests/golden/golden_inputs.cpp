// SPDX-License-Identifier: GPL-3.0-or-later
// croquis-golden-inputs FOLDER COUNT   writes COUNT inputs of each system, the same ones every time
#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

#include "croquis/io/attribute_network_file.h"
#include "croquis/io/mesh_file.h"
#include "croquis/io/perspective_drawing_file.h"
#include "support/attribute_surface/joined_networks.h"
#include "support/attribute_surface/loops.h"
#include "support/meshes/cages.h"
#include "support/perspective/solid_drawing.h"
#include "support/perspective/solids.h"
#include "support/perspective/views.h"
#include "support/random.h"
#include "support/scans/known_scans.h"
#include "support/sketches/sketch_hand.h"
#include "support/sketches/sketch_scrawls.h"
#include "support/sketches/sketch_svg.h"

namespace croquis::test {
namespace {

/// The element of a list that a number stands for, and what is left of the number.
template <typename List>
const auto& taken(const List& list, std::size_t& number) {
  const auto& one = list[number % list.size()];
  number /= list.size();
  return one;
}

/// What hands make of the gallery's sketches, and every third one a scrawl.
std::string sketch(std::size_t number) {
  static const std::vector<NamedSketch> sketches = hand_sketches();
  static const std::vector<HandVariation> variations = hand_variations();
  const std::uint64_t seed = number;
  if (number % 3 == 2) {
    number /= 3;
    return to_svg(random_scrawl(taken(scrawl_families(), number), seed).drawing);
  }
  const Sketch& meant = taken(sketches, number).sketch;
  return to_svg(drawn_by_hand(meant, seed, taken(variations, number).options));
}

std::string sheet(std::size_t number) {
  static const std::vector<PerspectiveSolid> solids = all_solids();
  static const std::vector<View> views = all_views();
  SolidDrawingOptions options;
  options.seed = number;
  options.noise = number % 2 == 0 ? 0 : 0.6;
  options.end_jitter = number % 4 == 3 ? 0.4 : 0;
  options.vertex_ids = number % 4 < 2;
  const PerspectiveSolid& solid = taken(solids, number);
  return write_perspective_svg(drawn(solid, taken(views, number), options).drawing);
}

std::string network(std::size_t number) {
  static const std::vector<AttributeNetwork> joined = joined_networks();
  const std::uint64_t seed = number;
  if (number % 4 == 3) {
    number /= 4;
    const AttributeNetwork& one = taken(joined, number);
    return write_attribute_network(resized(one, 1 + 0.5 * static_cast<double>(number)));
  }
  return write_attribute_network(number % 4 == 2 ? flat_loop(3 + number % 8, seed) : random_loop(2 + number % 9, seed));
}

/// A cage with some edges tagged and every vertex moved a little.
std::string cage(std::size_t number) {
  static const std::vector<NamedCage> cages = all_cages();
  Random random(number);
  PolyMesh mesh = taken(cages, number).mesh;
  for (Vec3& place : mesh.positions) {
    for (double& coordinate : place) coordinate += random.between(-0.05, 0.05);
  }
  std::vector<VertexPair> sharp;
  const double share = random.unit();
  for (const VertexPair& edge : all_edges(mesh)) {
    if (random.unit() < share) sharp.push_back(edge);
  }
  Progress progress;
  return write_mesh(tagged(std::move(mesh), sharp), MeshFormat::Obj, {}, progress).bytes;
}

std::string scan(std::size_t number) {
  constexpr std::uint64_t first_seed = 70001;  // no rules were tuned on these
  constexpr std::size_t triangles = 5000;
  const std::uint64_t seed = first_seed + number;
  Progress progress;
  return write_mesh(known_scan(taken(all_scan_kinds, number), seed, triangles).mesh, MeshFormat::Ply, {}, progress)
      .bytes;
}

bool write_inputs(const std::filesystem::path& folder, std::size_t count) {
  struct System {
    std::string name, extension;
    std::string (*input)(std::size_t);
  };
  const std::vector<System> systems = {{"sketch", ".svg", sketch},
                                       {"perspective", ".svg", sheet},
                                       {"network", ".json", network},
                                       {"cage", ".obj", cage},
                                       {"scan", ".ply", scan}};
  std::filesystem::create_directories(folder);
  for (const System& system : systems) {
    for (std::size_t number = 0; number < count; ++number) {
      const std::string digits = std::to_string(1000 + number).substr(1);
      std::ofstream file(folder / (system.name + "-" + digits + system.extension), std::ios::binary);
      file << system.input(number);
      if (!file.good()) return false;
    }
  }
  return true;
}

}  // namespace
}  // namespace croquis::test

int main(int argc, char** argv) {
  const int count = argc == 3 ? std::atoi(argv[2]) : 0;
  if (count < 1 || count > 1000) {
    std::cerr << "usage: croquis-golden-inputs FOLDER COUNT, at most 1000\n";
    return 2;
  }
  if (croquis::test::write_inputs(argv[1], static_cast<std::size_t>(count))) return 0;
  std::cerr << "an input could not be written into " << argv[1] << '\n';
  return 1;
}
