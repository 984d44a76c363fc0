// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <filesystem>
#include <iomanip>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include "bench/bench.h"
#include "bench/cpu_time.h"
#include "croquis/base/error.h"
#include "croquis/io/file.h"
#include "croquis/io/svg_drawing.h"
#include "croquis/silhouette/labelled_figure.h"
#include "croquis/silhouette/solid.h"

namespace croquis::bench {
namespace {

using silhouette::LabelledDrawing;
using silhouette::Options;

constexpr double covered_share = 0.6;  // of the drawing's box, both ways

template <typename Each>
Vec2 extent(const Each& for_each_place) {
  Vec2 low = Vec2::Constant(std::numeric_limits<double>::infinity());
  Vec2 high = -low;
  for_each_place([&](const Vec2& place) {
    low = low.cwiseMin(place);
    high = high.cwiseMax(place);
  });
  return (high - low).cwiseMax(0);
}

struct Outcome {
  bool solid = false;
  bool covers = false;
  std::string problem;  ///< code of the first error
  double reading_ms = 0;
  double all_ms = 0;
  std::vector<silhouette::StrokeKind> kinds;
};

bool covers(const PolyMesh& solid, const Drawing& drawing) {
  const Vec2 drawn = extent([&](const auto& take) {
    for (const Stroke& stroke : drawing.strokes) {
      for (const StrokeSample& sample : stroke.samples) take(sample.position);
    }
  });
  const Vec2 made = extent([&](const auto& take) {
    for (const Vec3& position : solid.positions) take(Vec2(position.head<2>()));
  });
  return (made.array() >= covered_share * drawn.array()).all();
}

std::string first_error(const Findings& findings) {
  const auto error = std::ranges::find(findings, Severity::Error, &Finding::severity);
  return error == findings.end() ? "" : error->code;
}

Outcome outcome(const Drawing& drawing) {
  Outcome result;
  Options options;
  options.attach_suggested = true;
  Progress progress;
  try {
    LabelledDrawing labelled;
    result.reading_ms = cpu_ms([&] { labelled = label(drawing, options, progress); });
    result.kinds = labelled.kinds;
    silhouette::Solid solid;
    result.all_ms = result.reading_ms + cpu_ms([&] { solid = inflate(labelled, drawing, options, progress); });
    result.solid = solid.mesh.face_count() > 0;
    result.covers = result.solid && covers(solid.mesh, drawing);
  } catch (const Error& error) {
    result.problem = first_error(error.findings());
  }
  return result;
}

}  // namespace

void bench_strangers(std::ostream& out, const std::vector<std::string>& words) {
  if (words.empty()) {
    out << "Give a folder of sketches (.svg): strangers FOLDER\n";
    return;
  }
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(words.front())) {
    if (entry.path().extension() == ".svg") files.push_back(entry.path());
  }
  std::ranges::sort(files);
  int solids = 0, covering = 0;
  double reading = 0, all = 0, slowest = 0;
  std::map<std::string, int> kinds;
  out << std::fixed << std::setprecision(0);
  for (const std::filesystem::path& file : files) {
    Progress progress;
    Outcome one;
    try {
      one = outcome(read_svg_drawing(read_file(file.string()), file.string(), progress).drawing);
    } catch (const Error& error) {
      one.problem = first_error(error.findings());
    }
    solids += one.solid ? 1 : 0;
    covering += one.covers ? 1 : 0;
    reading += one.reading_ms;
    all += one.all_ms;
    slowest = std::max(slowest, one.reading_ms);
    for (const silhouette::StrokeKind kind : one.kinds) ++kinds[to_string(kind)];
    if (!one.covers) out << file.filename().string() << ": " << (one.solid ? "covers less" : one.problem) << "\n";
  }
  const auto count = static_cast<double>(std::max<std::size_t>(1, files.size()));
  out << "\n| drawings | solids | cover 60 % of the box | read in, ms each | slowest | solid in, ms each |\n"
      << "|---|---|---|---|---|---|\n| " << files.size() << " | " << solids << " | " << covering << " | "
      << reading / count << " | " << slowest << " | " << all / count << " |\n\n| kind | strokes |\n|---|---|\n";
  for (const auto& [kind, strokes] : kinds) out << "| " << kind << " | " << strokes << " |\n";
}

}  // namespace croquis::bench
