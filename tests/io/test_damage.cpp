// SPDX-License-Identifier: GPL-3.0-or-later
#include <filesystem>

#include <sys/resource.h>

#include <catch2/catch.hpp>

#include "croquis/io/file.h"
#include "io/mesh_compare.h"
#include "support/meshes/mesh_shapes.h"
#include "support/random.h"
#include "support/sample_count.h"

using namespace croquis;
using namespace croquis::test;
namespace fs = std::filesystem;

namespace {

struct Kind {
  MeshFormat format;
  bool ascii;
};

const std::vector<Kind> kinds = {{MeshFormat::Obj, true}, {MeshFormat::Ply, true},  {MeshFormat::Ply, false},
                                 {MeshFormat::Stl, true}, {MeshFormat::Stl, false}, {MeshFormat::Off, true},
                                 {MeshFormat::Glb, false}};

// One to four edits: bytes changed, cut out, doubled, or numbers replaced by ones that hurt.
std::string damaged(std::string bytes, Random& random) {
  static const std::vector<std::string> nasty = {"-1",
                                                 "4294967295",
                                                 "99999999999999999999",
                                                 "nan",
                                                 "1e999",
                                                 "",
                                                 "\xff\xff\xff\xff",
                                                 std::string(4, '\0'),
                                                 "\n",
                                                 "#",
                                                 "\\\n",
                                                 "0"};
  const std::uint32_t edits = 1 + random.below(4);
  for (std::uint32_t i = 0; i < edits && !bytes.empty(); ++i) {
    const std::size_t at = random.below(static_cast<std::uint32_t>(bytes.size()));
    const std::size_t length = std::min<std::size_t>(1 + random.below(12), bytes.size() - at);
    switch (random.below(4)) {
      case 0: bytes[at] = static_cast<char>(random.below(256)); break;
      case 1: bytes.erase(at, length); break;
      case 2: bytes.insert(at, bytes.substr(at, length)); break;
      default: bytes.replace(at, length, nasty[random.below(static_cast<std::uint32_t>(nasty.size()))]);
    }
  }
  return bytes;
}

std::size_t peak_bytes() {
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::size_t>(usage.ru_maxrss) * 1024;
}

std::string repeated(const std::string& text, std::size_t count) {
  std::string result;
  for (std::size_t i = 0; i < count; ++i) result += text;
  return result;
}

}  // namespace

TEST_CASE("a damaged file is refused or gives a usable mesh that survives its own format") {
  Random random(20);
  PolyMesh lined = with_attributes(cube());
  lined.add_line(std::array<Index, 2>{0, 1});
  PolyMesh tagged = tetrahedron();
  tagged.tags = {{{{0, 1}, 2.5}, {{1, 2}, infinite_sharpness}, {{2, 3}, 0.1}, {{3, 0}, 10}}, {1, 2, 0}, {}};
  tagged.channels.push_back({"settled_corner", Domain::Vertex, 1, std::vector<std::uint8_t>{1, 0, 0, 1}, {}});
  for (const Kind& kind : kinds) {
    const std::vector<std::string> files = {write(lined, kind.format, {0, kind.ascii}).bytes,
                                            write(uv_sphere(5, 4), kind.format, {0, kind.ascii}).bytes,
                                            write(tagged, kind.format, {0, kind.ascii}).bytes};
    std::size_t refused = 0;
    for (int i = 0; i < sample_count(3000, 30000); ++i) {
      const std::string bytes = damaged(files[static_cast<std::size_t>(i) % files.size()], random);
      const std::string broken = broken_property(bytes, kind.format);
      if (!broken.empty()) FAIL(to_string(kind.format) << ": " << broken << "\n" << bytes);
      try {
        read(bytes, kind.format);
      } catch (const Error&) {
        ++refused;
      }
    }
    CHECK(refused > 300);
  }
}

TEST_CASE("inputs that once broke a reader stay harmless") {
  std::size_t replayed = 0;
  for (const char* folder : {"regressions", "corpus"}) {
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(CROQUIS_FUZZ_FOLDER) / folder)) {
      const auto format = mesh_format_of(entry.path().parent_path().filename().string());
      if (!entry.is_regular_file() || !format) continue;
      INFO(entry.path());
      CHECK(broken_property(read_file(entry.path().string()), *format) == "");
      ++replayed;
    }
  }
  CHECK(replayed >= 20);
}

TEST_CASE("files that claim or nest more than they hold cost little memory") {
  const std::size_t before = peak_bytes();
  const std::string xyz = "property float x\nproperty float y\nproperty float z\n";
  const std::string binary = "ply\nformat binary_little_endian 1.0\n";
  const std::string list = "property list uint int vertex_indices\n";
  const std::vector<std::pair<MeshFormat, std::string>> files = {
      {MeshFormat::Ply, binary + "element vertex 18446744073709551615\n" + xyz + "end_header\n"},
      {MeshFormat::Ply, binary + "element face 1\n" + list + "end_header\n\xff\xff\xff\xff"},
      {MeshFormat::Ply,
       binary + repeated("element a 4000000000\n", 1) + "element b 4000000000\n" + xyz + "end_header\n"},
      {MeshFormat::Ply, binary + "element vertex 1000000000\n" + repeated(xyz, 1) + "property list uint double w\n" +
                            "end_header\n" + std::string(1000, '\xff')},
      {MeshFormat::Ply, "ply\n" + std::string(1000000, 'x')},
      {MeshFormat::Ply, "ply\nformat ascii 1.0\nelement vertex 1\n" + repeated("property float x\n", 20000)},
      {MeshFormat::Off, "OFF 4294967295 4294967295 0\n0 0 0\n"},
      {MeshFormat::Off, "OFF 1 1 0\n0 0 0\n4294967295 0 0 0\n"},
      {MeshFormat::Stl, std::string(80, ' ') + "\xff\xff\xff\xff" + std::string(100, ' ')},
      {MeshFormat::Stl, "solid " + std::string(1000000, 'x')},
      {MeshFormat::Stl, "solid\n" + repeated("facet ", 200000)},
      {MeshFormat::Obj, "v 0 0 0\nf" + repeated(" 1", 500000)},
      {MeshFormat::Obj, repeated("v 0 0 0\\\n", 100000)},
      {MeshFormat::Obj, repeated("f 1 2 3\n", 100000)},
      {MeshFormat::Obj, repeated("x\n", 500000)},
      {MeshFormat::Obj, "v " + std::string(1000000, '9') + " 0 0\n"},
  };
  for (const auto& [format, bytes] : files) {
    INFO(bytes.substr(0, 120));
    const Findings findings = refusal(bytes, format);
    CHECK(findings.size() <= 300);
  }
  CHECK(peak_bytes() - before < 200U * 1024 * 1024);
}
