// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <iterator>

#include "croquis/perspective/solid.h"

namespace croquis {
namespace {

void turn_shell(FaceSet& faces, Index shell) {
  for (const Index f : faces.shells[shell].faces) {
    NetworkFace& face = faces.faces[f];
    face.normal = -face.normal;
    for (CurveLoop& loop : face.loops) {
      std::ranges::reverse(loop);
      for (CurveUse& use : loop) use.reversed = !use.reversed;
    }
  }
}

Solid span_solid(const CurveNetwork& network, const std::vector<FittedCurve>& fitted, const FaceSet& faces,
                 Progress& progress, const SolidOptions& options) {
  Solid solid;
  solid.brep = make_brep(network, fitted, faces);
  solid.warnings = find_smooth_edges(solid.brep, options.continuity).warnings;
  std::ranges::move(span_patches(solid.brep, options.patches), std::back_inserter(solid.warnings));
  Progress mesh = progress.step("make triangles", 0.5);
  solid.tessellation = tessellate(solid.brep, mesh, options.tessellation);
  std::ranges::copy(solid.tessellation.warnings, std::back_inserter(solid.warnings));
  return solid;
}

}  // namespace

Solid make_solid(const CurveNetwork& network, const std::vector<FittedCurve>& fitted, const FaceSet& faces,
                 Progress& progress, const SolidOptions& options) {
  Solid solid = span_solid(network, fitted, faces, progress, options);
  FaceSet turned = faces;
  bool wrong = false;
  for (Index s = 0; s < faces.shells.size(); ++s) {
    if (!faces.shells[s].closed || (solid.tessellation.volume[s] < 0) == faces.shells[s].is_void) continue;
    turn_shell(turned, s);  // patches that bulge more than the fans that orientation was found from
    wrong = true;
  }
  if (wrong) solid = span_solid(network, fitted, turned, progress, options);
  progress.report(1);
  return solid;
}

}  // namespace croquis
