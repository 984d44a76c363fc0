// SPDX-License-Identifier: GPL-3.0-or-later
#include <atomic>
#include <fstream>
#include <map>
#include <mutex>
#include <random>
#include <set>
#include <sstream>
#include <thread>

#include <catch2/catch.hpp>

#include "croquis/base/error.h"
#include "croquis/document/content_hash.h"
#include "croquis/document/registry.h"
#include "croquis/io/attribute_network_file.h"
#include "croquis/io/mesh_file.h"
#include "croquis/io/perspective_drawing_file.h"
#include "croquis/io/svg_drawing.h"
#include "croquis/operators/all_operations.h"
#include "support/sample_count.h"

namespace croquis {
namespace {

struct Work {
  std::string name;
  const Operation* operation = nullptr;
  Values inputs;
  ParameterValues parameters;
};

std::string bytes_of(const std::string& file) {
  std::ifstream in(CROQUIS_SOURCE_DIR "/examples/data/" + file, std::ios::binary);
  std::ostringstream bytes;
  bytes << in.rdbuf();
  return bytes.str();
}

/// One small input of each system.
std::vector<Work> works(const Registry& registry) {
  Progress progress;
  const auto mesh = [&](const std::string& file, MeshFormat format) {
    return std::make_shared<const PolyMesh>(read_mesh(bytes_of(file), format, file, progress).mesh);
  };
  const auto sketch = [&](const std::string& file) {
    return std::make_shared<const Drawing>(read_svg_drawing(bytes_of(file), file, progress).drawing);
  };
  const auto bottle = std::make_shared<const PerspectiveDrawing>(
      read_perspective_svg(bytes_of("perspective/bottle.svg"), "bottle.svg", progress).drawing);
  const auto bowl = std::make_shared<const AttributeNetwork>(
      read_attribute_network(bytes_of("surface/bowl.json"), "bowl.json").network);
  return {
      {"ring", registry.find("inflate"), {{"drawing", sketch("ring_and_bar.svg")}}, {{"resolution", 20.0}}},
      {"trefoil", registry.find("inflate"), {{"drawing", sketch("trefoil.svg")}}, {{"resolution", 20.0}}},
      {"bottle", registry.find("perspective"), {{"drawing", bottle}}, {}},
      {"bowl", registry.find("surface"), {{"network", bowl}}, {}},
      {"bolt",
       registry.find("subdivide"),
       {{"cage", mesh("bolt.obj", MeshFormat::Obj)}},
       {{"levels", std::int64_t{2}}}},
      {"pumpkin", registry.find("fill"), {{"scan", mesh("pumpkin_scan.ply", MeshFormat::Ply)}}, {}},
  };
}

using Hashes = std::map<std::string, ContentHash>;

/// Of every output.
/// @param reports the work is cancelled at this one; 0: never
/// @throws Cancelled
Hashes computed(const Work& work, int reports) {
  std::atomic<bool> cancel = false;
  int left = reports;
  const auto count = [&](double, const std::string&) {
    if (left > 0 && --left == 0) cancel = true;
  };
  Progress progress(count, &cancel);
  Context context{progress};
  Hashes hashes;
  for (const auto& [port, value] : run(*work.operation, work.inputs, work.parameters, context).outputs)
    hashes[port] = content_hash(value);
  return hashes;
}

TEST_CASE("operations on threads side by side, some of them cancelled, give what each gives alone") {
  const Registry registry = all_operations();
  const std::vector<Work> all = works(registry);
  std::map<std::string, Hashes> alone;
  for (const Work& work : all) alone[work.name] = computed(work, 0);

  std::mutex mutex;
  std::set<std::string> different;
  int whole = 0;
  const auto run_some = [&](unsigned seed) {
    std::mt19937 random(seed);
    for (int round = 0; round < test::sample_count(20, 200); ++round) {
      const Work& work = all[random() % all.size()];
      const int reports = random() % 2 == 0 ? 0 : static_cast<int>(1 + random() % 40);
      try {
        const bool same = computed(work, reports) == alone.at(work.name);
        const std::lock_guard lock(mutex);
        ++whole;
        if (!same) different.insert(work.name);
      } catch (const Cancelled&) {
      }
    }
  };
  std::vector<std::thread> threads;
  for (unsigned seed = 1; seed <= 4; ++seed) threads.emplace_back(run_some, seed);
  for (std::thread& thread : threads) thread.join();
  CHECK(different == std::set<std::string>());
  CHECK(whole >= 20);
}

}  // namespace
}  // namespace croquis
