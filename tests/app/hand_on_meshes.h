// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <fstream>
#include <string>

#include <catch2/catch.hpp>

#include "app/studio_fixture.h"
#include "croquis/io/mesh_file.h"
#include "support/meshes/mesh_shapes.h"

/// Words of tests about work on meshes in the window.
namespace croquis::test {

constexpr std::array<int, 4> all_views = {app::SketchView, app::PerspectiveView, app::TopView, app::SideView};

/// Writes a mesh to a file of that name and opens it.
inline void open_mesh(StudioFixture& hand, const PolyMesh& mesh, const std::string& name) {
  Progress progress;
  const std::string path = hand.folder().toStdString() + "/" + name + ".obj";
  std::ofstream(path, std::ios::binary) << write_mesh(mesh, MeshFormat::Obj, {}, progress).bytes;
  REQUIRE(hand.window().open(QString::fromStdString(path)));
  hand.settle();
}

/// The cube [-1, 1]^3.
inline PolyMesh centred_cube() { return translated(scaled(cube(), 2), {-1, -1, -1}); }

/// Of the active object.
inline const PolyMesh& cage(StudioFixture& hand) { return *hand.studio().active()->cage_mesh; }

}  // namespace croquis::test
