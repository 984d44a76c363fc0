// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/scans/ply_file.h"

#include <fstream>
#include <sstream>

#include "croquis/io/mesh_file.h"

namespace croquis::bench {

void write_ply(const PolyMesh& mesh, const std::string& path) {
  Progress progress;
  std::ofstream(path, std::ios::binary) << write_mesh(mesh, MeshFormat::Ply, {}, progress).bytes;
}

PolyMesh read_ply(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::stringstream bytes;
  bytes << file.rdbuf();
  Progress progress;
  return read_mesh(bytes.str(), MeshFormat::Ply, path, progress).mesh;
}

}  // namespace croquis::bench
