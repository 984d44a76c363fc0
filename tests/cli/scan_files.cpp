// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/scan_files.h"

#include <algorithm>

#include <catch2/catch.hpp>

#include "support/scans/scans.h"

namespace croquis::test {

std::string bytes_of(const PolyMesh& mesh, MeshFormat format) {
  Progress progress;
  return write_mesh(mesh, format, {}, progress).bytes;
}

std::string ply_of(const PolyMesh& mesh) { return bytes_of(mesh, MeshFormat::Ply); }

bool begins_with(const PolyMesh& grown, const PolyMesh& given) {
  return grown.vertex_count() >= given.vertex_count() && grown.face_count() >= given.face_count() &&
         std::equal(given.positions.begin(), given.positions.end(), grown.positions.begin()) &&
         std::equal(given.face_offsets.begin(), given.face_offsets.end(), grown.face_offsets.begin()) &&
         std::equal(given.corners.begin(), given.corners.end(), grown.corners.begin());
}

PolyMesh holed_scan() {
  const PolyMesh ball = random_cuts(round_sphere(4), 3, 3, 0.12, 0.3).mesh;
  return cut_ring(ball, Vec3(0, 0, 1), 0.15, 0.45).mesh;
}

PolyMesh holed_sphere() { return cut(round_sphere(3), Vec3(0, 0, 1), 0.4).mesh; }

Json filled(const std::string& input, const std::string& output, const Words& options) {
  Words words = {"fill", input, "-o", output, "--json"};
  words.insert(words.end(), options.begin(), options.end());
  const ProcessResult result = run_cli(words);
  INFO(result.err);
  REQUIRE(result.code == 0);
  return Json::parse(result.out);
}

std::set<int> holes_with(const Json& report, const std::string& action) {
  std::set<int> ids;
  for (const Json& hole : report.at("details").at("holes")) {
    if (hole.at("action") == action) ids.insert(hole.at("id").get<int>());
  }
  return ids;
}

}  // namespace croquis::test
