// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/surface/rim_chord.h"

#include <algorithm>
#include <cmath>

#include "algorithms/silhouette/sampling/rim_distance.h"
#include "algorithms/silhouette/sampling/rim_radius.h"

namespace croquis::silhouette {
namespace {

/// Nearer to the rim, in parts of the first row's depth, the chord would be too thin for rounded numbers.
constexpr double least_part_of_row = 0.05;

}  // namespace

void flatten_to_rim_chords(const SheetSampling& sheets, Eigen::VectorXd& thickness) {
  const RimDistances rim = rim_distances(sheets, greatest_first_row());
  for (Index v = 0; v < rim.nearest.size(); ++v) {
    if (rim.nearest[v] == no_index || rim.distance[v] <= 0) continue;
    // Near the rim the section rises like the root of the depth, the chord in proportion to it.
    const double row = rim.edges[rim.nearest[v]].first_row;
    thickness[v] *= std::sqrt(std::clamp(rim.distance[v] / row, least_part_of_row, 1.0));
  }
}

}  // namespace croquis::silhouette
