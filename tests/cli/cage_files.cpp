// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/cage_files.h"

#include <cmath>
#include <set>
#include <tuple>

#include <catch2/catch.hpp>

#include "croquis/io/mesh_file.h"

namespace croquis::test {

std::string obj_of(const PolyMesh& mesh) {
  Progress progress;
  return write_mesh(mesh, MeshFormat::Obj, {}, progress).bytes;
}

PolyMesh mesh_in(const std::string& path) {
  Progress progress;
  return read_mesh(slurp(path), *mesh_format_of(path), path, progress).mesh;
}

std::string tags_json(const MeshTags& tags) {
  Json json = {{"format", "croquis-tags-1"}, {"index_base", 0}, {"edges", Json::array()}, {"pins", tags.pins}};
  for (const Crease& crease : tags.creases) {
    const Json sharpness = std::isinf(crease.sharpness) ? Json("inf") : Json(crease.sharpness);
    json["edges"].push_back({{"v", crease.vertices}, {"sharpness", sharpness}});
  }
  return json.dump();
}

Json report_of(const ProcessResult& result) {
  INFO(result.err);
  return Json::parse(result.out);
}

Words codes_of(const Json& findings) {
  Words codes;
  for (const Json& finding : findings) codes.push_back(finding.at("code"));
  return codes;
}

Json subdivided(const ScratchFolder& folder, const PolyMesh& cage, const Words& options, const std::string& output) {
  Words words = {"subdivide", folder.write("cage.obj", obj_of(cage)), "-o", folder / output, "--json"};
  words.insert(words.end(), options.begin(), options.end());
  const ProcessResult result = run_cli(words);
  INFO(result.err);
  REQUIRE(result.code == 0);
  return Json::parse(result.out);
}

std::string differences(const PolyMesh& a, const PolyMesh& b) {
  if (a.face_offsets != b.face_offsets || a.corners != b.corners) return "faces";
  if (a.vertex_count() != b.vertex_count()) return "vertices";
  for (std::size_t v = 0; v < a.vertex_count(); ++v) {
    if (!a.positions[v].isApprox(b.positions[v], 1e-12) && (a.positions[v] - b.positions[v]).norm() > 1e-12) {
      return "position " + std::to_string(v);
    }
  }
  using Tag = std::tuple<Index, Index, double>;
  const auto tags_of = [](const PolyMesh& mesh) {
    std::set<Tag> tags;
    for (const Crease& crease : mesh.tags.creases) {
      const auto [low, high] = std::minmax(crease.vertices[0], crease.vertices[1]);
      tags.emplace(low, high, crease.sharpness);
    }
    return tags;
  };
  if (tags_of(a) != tags_of(b)) return "sharp edges";
  return std::set(a.tags.pins.begin(), a.tags.pins.end()) == std::set(b.tags.pins.begin(), b.tags.pins.end()) ? ""
                                                                                                              : "pins";
}

}  // namespace croquis::test
