// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tools/holes/remesh_estimate.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>

#include "app/tools/holes/filling.h"
#include "croquis/remeshing/remesh.h"

namespace croquis::app {
namespace {

/// For a triangle of the scan, with cubes as large as its edges: a rough figure on the safe side. The shipped scan of
/// 20,000 triangles took half of it.
constexpr double seconds_per_face = 40e-6;

double number(const Studio& studio, const Node& node, const char* name, double otherwise) {
  const ParameterValue value = filling_value(studio, node, name);
  if (const auto* found = std::get_if<double>(&value)) return *found;
  if (const auto* found = std::get_if<std::int64_t>(&value)) return static_cast<double>(*found);
  return otherwise;
}

QString seconds(double count) {
  if (count < 1) return QCoreApplication::translate("Holes", "a second");
  if (count < 90) return QCoreApplication::translate("Holes", "%1 s").arg(std::lround(count));
  return QCoreApplication::translate("Holes", "%1 min").arg(std::lround(count / 60));
}

QString bytes(std::size_t count) {
  const double megabytes = static_cast<double>(count) * 1e-6;
  if (megabytes < 1000) return QCoreApplication::translate("Holes", "%1 MB").arg(std::lround(megabytes));
  return QCoreApplication::translate("Holes", "%1 GB").arg(megabytes * 1e-3, 0, 'f', 1);
}

}  // namespace

QString estimate_sentence(const Studio& studio, const Node& node, const PolyMesh& scan) {
  remeshing::RemeshOptions options;
  options.cell = std::max(number(studio, node, "cell", options.cell), 1e-3);
  options.refine = static_cast<int>(number(studio, node, "refine", options.refine));
  options.adaptive = number(studio, node, "adaptive", options.adaptive);
  options.overlap = number(studio, node, "overlap", options.overlap);
  const double finer = 1 / (options.cell * options.cell);
  const double time = seconds_per_face * static_cast<double>(scan.face_count()) * std::max(finer, 0.3);
  return QCoreApplication::translate(
             "Holes", "About %1, and %2 of memory at most; every vertex of the model will be another one.")
      .arg(seconds(time), bytes(remeshing::predicted_remesh_bytes(scan, options)));
}

}  // namespace croquis::app
