// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/remeshing/remesh_plan.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "croquis/base/error.h"

namespace croquis::remeshing {
namespace {

using namespace hole_filling;

constexpr double gibibyte = 1073741824;

std::string gibibytes(double bytes) {
  char text[32];
  std::snprintf(text, sizeof text, bytes < 0.1 * gibibyte ? "%.3f GiB" : "%.1f GiB", bytes / gibibyte);
  return text;
}

std::string advice(const RemeshMemory& memory) {
  const double cell = memory.fitting_cell();
  if (!(cell <= most_cell)) return "fill its holes by patches";
  char text[64];
  std::snprintf(text, sizeof text, "choose cells of %.2g times the mean edge", std::ceil(20 * cell) / 20 + 0.05);
  return std::string(text) + ", or fill its holes by patches";
}

Finding out_of_range(const std::string& name, const std::string& range) {
  return make_error(Category::Usage, "E_PARAMETER", "The option " + name + " is out of range: choose " + range + ".",
                    {{SubjectKind::Parameter, name, {}, {}, {}}});
}

}  // namespace

RemeshOptions remesh_preset(Preset preset) {
  RemeshOptions options;
  options.fill.preset = preset;
  if (preset == Preset::Paper) {
    options.fill.implicit.kernel = implicit::Kernel::ThinPlate;
    options.overlap = 0.1;
  }
  if (preset == Preset::Noisy) {
    options.fill.implicit.value_smoothing = 10;
    options.fill.implicit.gradient_smoothing = 30;
  }
  if (preset == Preset::Sharp) {
    options.cell = 0.5;
    options.snap = 0.3;
  }
  return options;
}

void require_options(const RemeshOptions& options) {
  Findings findings;
  const auto require = [&](bool holds, const std::string& name, const std::string& range) {
    if (!holds) findings.push_back(out_of_range(name, range));
  };
  require(options.cell >= 0.05 && options.cell <= most_cell, "cell", "0.05 to 64 mean edges");
  require(options.overlap >= 0 && options.overlap <= 1, "overlap", "0 to 1");
  require(options.min_points >= 1 && options.max_points >= options.min_points && options.max_points <= 2000 &&
              options.leaf_points >= 1,
          "points-per-domain", "at least 1, at most 2000, and no less at most than at least");
  require(options.smoothing >= 0 && options.smoothing <= 100, "smoothing", "0 to 100 rounds");
  require(options.refine >= 0 && options.refine <= 4, "refine", "0 to 4 rounds");
  require(options.chord >= 0, "chord", "0 or a length");
  require(options.snap >= 0 && options.snap <= 0.5, "snap", "0 to 0.5 cells");
  require(options.adaptive >= 0 && options.adaptive <= 1, "adaptive", "0 to 1 cells");
  require(options.min_component >= 0 && options.min_component < 1, "min-component", "0 to 1");
  if (!findings.empty()) throw Error(std::move(findings));
}

std::size_t whole_bytes(double bytes) { return static_cast<std::size_t>(std::min(std::ceil(bytes), 1e18)); }

std::size_t predicted_remesh_bytes(const PolyMesh& mesh, const RemeshOptions& options) {
  return whole_bytes(RemeshMemory(mesh, options).most());
}

std::size_t least_remesh_bytes(const PolyMesh& mesh, const RemeshOptions& options) {
  return whole_bytes(RemeshMemory(mesh, options).least());
}

void require_memory(const RemeshMemory& memory, std::size_t limit) {
  const double bytes = memory.least();
  if (limit == 0 || bytes <= static_cast<double>(limit)) return;
  throw Error(make_error(Category::Limit, "E_MEMORY",
                         "Remeshing this model needs about " + gibibytes(bytes) + ", and " +
                             gibibytes(static_cast<double>(limit)) + " are allowed: " + advice(memory) + ".",
                         {{SubjectKind::Parameter, "memory-limit", {}, {}, {}}}));
}

}  // namespace croquis::remeshing
