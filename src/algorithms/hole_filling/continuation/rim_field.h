// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "algorithms/hole_filling/continuation/other_sheets.h"
#include "croquis/hole_filling/hole_site.h"
#include "croquis/hole_filling/implicit_options.h"
#include "croquis/implicit/local_fit.h"

namespace croquis::hole_filling {

/// The surface around a site continued over its hole.
struct RimField {
  std::shared_ptr<const implicit::LocalFit> fit;
  double edge = 0;  ///< mean length of the rims' edges, model units
  double size = 0;  ///< diameter of the largest rim

  implicit::Field other = {};                   ///< instead of `fit`, where one fit isn't enough
  std::vector<std::size_t> domain_points = {};  ///< of each fit

  implicit::Field field() const { return other ? other : fit->field(); }
};

struct RimFitOptions {
  double stiffness = 1;       ///< factor of the smoothing
  bool other_sheets = false;  ///< sheets that pass nearby count too, so that the continuation keeps clear of them
  std::vector<PassingPoint> guides = {};  ///< further places and normals of the surface
  bool every_normal = false;  ///< r^5 too takes the normals of all places, not of a few: slower, steadier far away
};

/// Whether the surface around is continued with its curvature, by r^5: right beside one plain hole, and too much where
/// the surface has to turn.
bool continues_curvature(const HoleSite& site, const ImplicitOptions& options);

/// Fits one radial basis function to the surface around the rims: vertices within max(4 edges, reach × size) along the
/// surface, the sparser the farther away, rims included. A bulge that the site wishes for turns them about the rims
/// first; places that the patch is to go through are met exactly. Where r^5 is safe, normals count at a few of the
/// places alone: the other places give the rest, and a fit takes a tenth of the time.
///
/// Fitted again with ten times the smoothing when a rim vertex that isn't a centre lies half an edge off (half of what
/// the centres resolve, for rims with more edges than centres; on rough surfaces five times the roughness, if that is
/// more); nothing when that doesn't help either, or there is nothing to fit.
std::optional<RimField> fit_rims(const HoleSite& site, const ImplicitOptions& options, const RimFitOptions& how);

}  // namespace croquis::hole_filling
