// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLabel>
#include <algorithm>
#include <fstream>
#include <string>

#include <catch2/catch.hpp>

#include "app/studio_fixture.h"
#include "croquis/geometry/mesh_topology.h"
#include "croquis/io/mesh_file.h"
#include "support/scans/scans.h"
#include "support/scans/virtual_scans.h"

/// Words of tests about holes in the window.
namespace croquis::test {

/// Opens a mesh as a file, its hole tool with it.
inline void open_scan(StudioFixture& hand, const PolyMesh& scan, const QString& name = "scan") {
  Progress progress;
  const QString file = hand.folder() + "/" + name + ".ply";
  std::ofstream(file.toStdString(), std::ios::binary) << write_mesh(scan, MeshFormat::Ply, {}, progress).bytes;
  REQUIRE(hand.window().open(file));
  hand.act("holes");
  hand.settle();
}

inline PolyMesh ball_with_holes(std::size_t count = 6) {
  return without_loose_vertices(random_cuts(round_sphere(4), 7, count, 0.15, 0.3).mesh);
}

inline app::ScanHoles& holes(StudioFixture& hand) { return hand.holes(); }

inline std::size_t count(StudioFixture& hand, FillAction state) {
  const auto& rows = holes(hand).rows;
  return static_cast<std::size_t>(
      std::count_if(rows.begin(), rows.end(), [&](const HoleRow& row) { return row.state == state; }));
}

inline std::string last_step(StudioFixture& hand) { return hand.studio().session().undo_labels().back(); }

inline QString label(StudioFixture& hand, const char* name) { return hand.window().findChild<QLabel*>(name)->text(); }

inline const PolyMesh& filled_mesh(StudioFixture& hand) { return *hand.studio().active()->mesh; }

inline std::size_t rims_of(const PolyMesh& mesh) { return MeshTopology(mesh).boundary_loops().size(); }

}  // namespace croquis::test
