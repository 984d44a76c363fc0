// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "algorithms/silhouette/skeleton/chordal_axis.h"
#include "algorithms/silhouette/skeleton/depth.h"
#include "algorithms/silhouette/surface/inflation.h"

namespace croquis::test {

/// The sheets of a figure with the usual settings.
inline silhouette::InflatedSheets inflated_sheets(const silhouette::LabelledFigure& figure) {
  Progress progress;
  silhouette::Skeleton skeleton = silhouette::chordal_axis(figure, 0.3, progress);
  solve_depth(skeleton, figure, {}, progress);
  const silhouette::SheetBasis basis = make_sheet_basis(figure, skeleton, silhouette::Quality::Final, {}, progress);
  return raise_sheets(skeleton, basis, {}, progress);
}

}  // namespace croquis::test
