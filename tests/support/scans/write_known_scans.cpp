// SPDX-License-Identifier: GPL-3.0-or-later
// Known scans as files, to look at: the thing and what was scanned of it.
#include <cstdint>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <string>

#include "croquis/io/mesh_file.h"
#include "support/scans/known_scans.h"

namespace {

using namespace croquis;
using namespace croquis::test;

void write(const PolyMesh& mesh, const std::filesystem::path& path) {
  Progress progress;
  std::ofstream(path, std::ios::binary) << write_mesh(mesh, MeshFormat::Ply, {}, progress).bytes;
}

void write(const KnownScan& scan, const std::filesystem::path& folder, const std::string& name) {
  write(scan.truth, folder / (name + "_truth.ply"));
  write(scan.mesh, folder / (name + "_scan.ply"));
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3 && argc != 4) {
    std::cerr << "usage: write_known_scans FOLDER SEED [TRIANGLES]\n";
    return 2;
  }
  const std::uint64_t seed = std::stoull(argv[2]);
  const std::size_t triangles = argc == 4 ? std::stoull(argv[3]) : 0;
  std::filesystem::create_directories(argv[1]);
  for (const ScanKind kind : all_scan_kinds) {
    const std::clock_t began = std::clock();
    const KnownScan scan = known_scan(kind, seed, triangles);
    std::cout << name_of(kind) << ' ' << seed << ": " << scan.truth.face_count() << " triangles, "
              << scan.mesh.face_count() << " scanned, " << static_cast<double>(std::clock() - began) / CLOCKS_PER_SEC
              << " s;";
    for (const KnownHole& hole : scan.holes) std::cout << ' ' << name_of(hole.kind) << ' ' << hole.rim.size() << ',';
    std::cout << '\n';
    write(scan, argv[1], std::string(name_of(kind)) + "-" + argv[2]);
  }
  return 0;
}
