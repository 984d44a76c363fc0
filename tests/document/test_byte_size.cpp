// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>

#include "croquis/document/byte_size.h"
#include "support/meshes/mesh_shapes.h"
#include "support/trial_operation.h"

namespace croquis {
namespace {

std::size_t size_of(auto content) { return byte_size(Value(std::make_shared<const decltype(content)>(content))); }

TEST_CASE("the size of a value follows its contents") {
  PolyMesh mesh = test::grid(100, 100);
  const std::size_t plain = size_of(mesh);
  CHECK(plain >= 101 * 101 * sizeof(Vec3) + 100 * 100 * 5 * sizeof(Index));
  CHECK(plain < 2 * (101 * 101 * sizeof(Vec3) + 100 * 100 * 5 * sizeof(Index)));
  mesh.channels.push_back({"heat", Domain::Vertex, 1, std::vector<double>(101 * 101), {}});
  CHECK(size_of(mesh) >= plain + 101 * 101 * sizeof(double));

  const std::size_t untagged = size_of(mesh);
  mesh.tags.creases.resize(300);
  mesh.tags.pins.resize(70);
  mesh.tags.sets.push_back({std::string(500, 'x'), 1, std::vector<std::array<Index, 2>>(40), {1}});
  CHECK(size_of(mesh) == untagged + 300 * sizeof(Crease) + 71 * sizeof(Index) + sizeof(CreaseSet) + 500 +
                             40 * sizeof(std::array<Index, 2>));

  Drawing drawing;
  drawing.strokes.resize(3);
  const std::size_t empty = size_of(drawing);
  for (Stroke& stroke : drawing.strokes) stroke.samples.resize(1000);
  CHECK(size_of(drawing) == empty + 3000 * sizeof(StrokeSample));

  Report report = Report::array();
  for (int i = 0; i < 100; ++i) report.push(Report(std::string(1000, 'x')));
  CHECK(size_of(report) >= 100 * 1000);
  CHECK(byte_size(Value(std::shared_ptr<const PolyMesh>())) == 0);
}

TEST_CASE("the size of a node leaves out its value") {
  const std::size_t small = byte_size(test::source_node(test::point(1)));
  PolyMesh mesh = test::grid(100, 100);
  CHECK(byte_size(test::source_node(std::make_shared<const PolyMesh>(mesh))) == small);
  Node node = test::source_node(test::point(1));
  node.parameters["text"] = std::string(5000, 'x');
  CHECK(byte_size(node) >= small + 5000);
}

}  // namespace
}  // namespace croquis
