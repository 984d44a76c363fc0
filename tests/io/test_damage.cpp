// SPDX-License-Identifier: GPL-3.0-or-later
#include <filesystem>

#include <sys/resource.h>

#include <catch2/catch.hpp>

#include "croquis/io/file.h"
#include "fuzz/readers.h"
#include "io/mesh_compare.h"
#include "support/meshes/mesh_shapes.h"
#include "support/random.h"
#include "support/sample_count.h"

using namespace croquis;
using namespace croquis::test;
namespace fs = std::filesystem;

namespace {

const fs::path fuzz_folder = CROQUIS_FUZZ_FOLDER;

/// One to four edits: bytes and letters of the format's own changed, cut out, doubled, the end cut off, or numbers
/// replaced by ones that hurt.
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
  const std::string letters = bytes.starts_with('{')   ? "{}[]\",:-+.e0123456789 abNaN\xff\n"
                              : bytes.starts_with('<') ? "MmLlHhVvCcSsQqTtAaZz0123456789.,-+eE <>/='\"\n\xff(&"
                                                       : "0123456789.-+eE \n";
  const std::uint32_t edits = 1 + random.below(4);
  for (std::uint32_t i = 0; i < edits && !bytes.empty(); ++i) {
    const std::size_t at = random.below(static_cast<std::uint32_t>(bytes.size()));
    const std::size_t length = std::min<std::size_t>(1 + random.below(12), bytes.size() - at);
    switch (random.below(13)) {
      case 0: bytes.resize(at + 1); break;
      case 1:
      case 2:
      case 3: bytes[at] = static_cast<char>(random.below(256)); break;
      case 4:
      case 5:
      case 6: bytes[at] = letters[random.below(static_cast<std::uint32_t>(letters.size()))]; break;
      case 7:
      case 8: bytes.erase(at, length); break;
      case 9:
      case 10: bytes.insert(at, bytes.substr(at, length)); break;
      default: bytes.replace(at, length, nasty[random.below(static_cast<std::uint32_t>(nasty.size()))]);
    }
  }
  return bytes;
}

/// What the fuzzers begin with, and what once broke the reader.
std::vector<fs::path> kept_inputs(const std::string& reader) {
  std::vector<fs::path> inputs;
  for (const char* folder : {"corpus", "regressions"}) {
    if (!fs::is_directory(fuzz_folder / folder / reader)) continue;
    for (const auto& entry : fs::recursive_directory_iterator(fuzz_folder / folder / reader)) {
      if (entry.is_regular_file()) inputs.push_back(entry.path());
    }
  }
  return inputs;
}

/// Meshes with all that a format may hold, as text and as bytes; nothing for what is no format of meshes.
std::vector<std::string> written_meshes(const std::string& reader) {
  const auto format = mesh_format_of(reader);
  if (!format) return {};
  PolyMesh lined = with_attributes(cube());
  lined.add_line(std::array<Index, 2>{0, 1});
  PolyMesh tagged = tetrahedron();
  tagged.tags = {{{{0, 1}, 2.5}, {{1, 2}, infinite_sharpness}, {{2, 3}, 0.1}, {{3, 0}, 10}}, {1, 2, 0}, {}};
  tagged.channels.push_back({"settled_corner", Domain::Vertex, 1, std::vector<std::uint8_t>{1, 0, 0, 1}, {}});
  std::vector<std::string> files;
  for (const PolyMesh& mesh : {lined, uv_sphere(5, 4), tagged}) {
    for (const bool ascii : {true, false}) files.push_back(write(mesh, *format, {0, ascii}).bytes);
  }
  return files;
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

TEST_CASE("a damaged file is refused or gives content that keeps its rules and survives its own format") {
  Random random(20);
  for (const FuzzedReader& reader : fuzzed_readers()) {
    if (reader.name == "croq") continue;  // test_project_damage.cpp
    std::vector<std::string> files = written_meshes(reader.name);
    for (const fs::path& input : kept_inputs(reader.name)) files.push_back(read_file(input.string()));
    const int rounds = sample_count(300, 6000) * static_cast<int>(files.size());
    int refused = 0;
    for (int i = 0; i < rounds; ++i) {
      const std::string bytes = damaged(files[static_cast<std::size_t>(i) % files.size()], random);
      const ReaderVerdict verdict = reader.verdict_on(bytes);
      if (!verdict.broken.empty()) FAIL(reader.name << ": " << verdict.broken << "\n" << bytes);
      refused += verdict.refused ? 1 : 0;
    }
    INFO(reader.name << ": " << refused << " of " << rounds);
    if (reader.name != "value") CHECK(refused > rounds / 10);
    CHECK(refused < rounds);
  }
}

TEST_CASE("inputs that fuzzers begin with and those that once broke a reader stay harmless") {
  std::size_t replayed = 0;
  for (const FuzzedReader& reader : fuzzed_readers()) {
    const std::vector<fs::path> inputs = kept_inputs(reader.name);
    for (const fs::path& input : inputs) {
      INFO(input);
      CHECK(reader.verdict_on(read_file(input.string())).broken == "");
    }
    CHECK(inputs.size() >= 2);
    replayed += inputs.size();
  }
  CHECK(replayed >= 50);
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
      {MeshFormat::Stl, std::string(80, ' ').append("\xff\xff\xff\xff").append(100, ' ')},
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
