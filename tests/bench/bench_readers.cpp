// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <cstdint>
#include <iomanip>
#include <numeric>
#include <string>
#include <vector>

#include "bench/bench.h"
#include "bench/cpu_time.h"
#include "croquis/io/mesh_file.h"

namespace croquis::bench {
namespace {

constexpr double megabyte = 1e6;
constexpr std::size_t target_bytes = 20'000'000;
constexpr int runs = 3;

struct Kind {
  const char* name;
  MeshFormat format;
  bool ascii;
};

constexpr Kind kinds[] = {{"OBJ", MeshFormat::Obj, true},         {"PLY text", MeshFormat::Ply, true},
                          {"PLY binary", MeshFormat::Ply, false}, {"STL text", MeshFormat::Stl, true},
                          {"STL binary", MeshFormat::Stl, false}, {"OFF", MeshFormat::Off, true}};

// A wavy sheet of triangles whose coordinates use all their digits.
PolyMesh sheet(Index columns, Index rows) {
  PolyMesh mesh;
  for (Index j = 0; j <= rows; ++j) {
    for (Index i = 0; i <= columns; ++i) {
      const double x = i / 7.0, y = j / 9.0;
      mesh.positions.emplace_back(x, y, std::sin(x) * std::cos(y));
    }
  }
  for (Index j = 0; j < rows; ++j) {
    for (Index i = 0; i < columns; ++i) {
      const Index a = j * (columns + 1) + i, b = a + columns + 1;
      mesh.add_triangle(a, a + 1, b + 1);
      mesh.add_triangle(a, b + 1, b);
    }
  }
  return mesh;
}

std::string file_of(const Kind& kind, std::size_t bytes) {
  Progress progress;
  const auto written = [&](Index side) {
    return write_mesh(sheet(side, side), kind.format, {0, kind.ascii}, progress).bytes;
  };
  constexpr Index trial = 100;
  const double per_cell = static_cast<double>(written(trial).size()) / (trial * trial);
  return written(static_cast<Index>(std::sqrt(static_cast<double>(bytes) / per_cell)));
}

double read_ms(const Kind& kind, const std::string& bytes) {
  return median_cpu_ms(runs, [&] {
    Progress progress;
    read_mesh(bytes, kind.format, "bench", progress);
  });
}

// What the machine needs to touch every byte once: copying and adding them up.
double touch_ms(const std::string& bytes) {
  volatile std::uint64_t sink = 0;
  return median_cpu_ms(runs, [&] {
    const std::string copy = bytes;
    sink = std::accumulate(copy.begin(), copy.end(), sink,
                           [](std::uint64_t sum, char c) { return sum + static_cast<unsigned char>(c); });
  });
}

}  // namespace

void bench_readers(std::ostream& out) {
  out << "readers: time against copying and adding up the same bytes; growth of the time per byte over 4x and 16x\n";
  out << std::left << std::setw(12) << "format" << std::right << std::setw(8) << "MB" << std::setw(10) << "MB/s"
      << std::setw(10) << "ratio" << std::setw(10) << "at 4x" << std::setw(10) << "at 16x" << '\n';
  for (const Kind& kind : kinds) {
    std::vector<double> ms_per_byte;
    double size = 0, ratio = 0;
    for (const std::size_t part : {std::size_t{16}, std::size_t{4}, std::size_t{1}}) {
      const std::string bytes = file_of(kind, target_bytes / part);
      size = static_cast<double>(bytes.size());
      const double ms = read_ms(kind, bytes);
      ms_per_byte.push_back(ms / size);
      ratio = ms / touch_ms(bytes);
    }
    out << std::left << std::setw(12) << kind.name << std::right << std::fixed << std::setprecision(1) << std::setw(8)
        << size / megabyte << std::setw(10) << 1e3 / (ms_per_byte[2] * megabyte) << std::setw(10) << ratio
        << std::setprecision(2) << std::setw(10) << ms_per_byte[1] / ms_per_byte[0] << std::setw(10)
        << ms_per_byte[2] / ms_per_byte[0] << '\n';
  }
}

}  // namespace croquis::bench
