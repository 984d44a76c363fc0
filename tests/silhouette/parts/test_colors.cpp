// SPDX-License-Identifier: GPL-3.0-or-later
// Colours of parts.
#include <cmath>
#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "croquis/silhouette/stroke_data.h"
#include "silhouette/solids.h"

using namespace croquis;
using namespace croquis::silhouette;

namespace {

/// Three circles: the first two overlap, the third lies apart.
Drawing circles(const std::vector<std::string>& fills) {
  Drawing drawing;
  for (std::size_t k = 0; k < 3; ++k) {
    Stroke stroke;
    stroke.id = "circle " + std::to_string(k + 1);
    stroke.closed = true;
    for (int i = 0; i < 64; ++i) {
      const double angle = 2 * 3.14159265358979 * i / 64;
      const double middle = k < 2 ? 90.0 * static_cast<double>(k) : 400;
      stroke.samples.push_back({Vec2(middle + 60 * std::cos(angle), 60 * std::sin(angle))});
    }
    if (!fills[k].empty()) stroke.data[fill_key] = fills[k];
    drawing.strokes.push_back(std::move(stroke));
  }
  return drawing;
}

/// The colours of an object's vertices, each once; nothing where the mesh has no colours.
std::set<std::vector<int>> colors_of(const Solid& solid, const std::string& name) {
  const AttributeChannel* colors = solid.mesh.channel("color", Domain::Vertex);
  if (colors == nullptr) return {};
  const auto& values = std::get<std::vector<std::uint8_t>>(colors->data);
  const AttributeChannel& owner = *solid.mesh.channel("object", Domain::Face);
  std::set<std::vector<int>> found;
  for (Index face = 0; face < solid.mesh.face_count(); ++face) {
    const auto object = static_cast<std::size_t>(std::get<std::vector<std::int32_t>>(owner.data)[face]);
    if (owner.labels[object] != name) continue;
    for (const Index vertex : solid.mesh.face(face))
      found.insert({values[3 * vertex], values[3 * vertex + 1], values[3 * vertex + 2]});
  }
  return found;
}

using Colors = std::set<std::vector<int>>;

}  // namespace

TEST_CASE("a stroke's fill is the colour of its part and changes no shape", "[colors]") {
  const Solid plain = test::solid_of(circles({"", "", ""}));
  CHECK(plain.mesh.channel("color", Domain::Vertex) == nullptr);
  const Solid solid = test::solid_of(circles({"#ff8000", "#0010a0", ""}));
  CHECK(solid.mesh.positions == plain.mesh.positions);
  CHECK(solid.mesh.corners == plain.mesh.corners);
  CHECK(colors_of(solid, solid.objects[0].name) == Colors{{255, 128, 0}});
  CHECK(colors_of(solid, solid.objects[1].name) == Colors{{0, 16, 160}});
  const Colors grey = colors_of(solid, solid.objects[2].name);
  REQUIRE(grey.size() == 1);
  CHECK(grey.begin()->at(0) == grey.begin()->at(2));
}

TEST_CASE("parts that are attached share a colour, and what is no colour counts as none", "[colors]") {
  const Solid plain = test::solid_of(circles({"", "", ""}));
  Options options;
  options.attach.push_back({plain.objects[0].name, plain.objects[1].name});
  const Solid joined = test::solid_of(circles({"", "#0010a0", "purple"}), options);
  REQUIRE(joined.shells.size() == 2);
  for (const SolidShell& shell : joined.shells) {
    for (const Index object : shell.objects) {
      const Colors colors = colors_of(joined, joined.objects[object].name);
      CHECK((colors == Colors{{0, 16, 160}}) == (shell.objects.size() == 2));
    }
  }
}
