// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "croquis/hole_filling/fill_options.h"
#include "croquis/hole_filling/hole_site.h"
#include "croquis/implicit/local_fit.h"
#include "croquis/implicit/point_tree.h"

namespace croquis::hole_filling {

/// A place on a part of the surface that passes by a hole, with its unit normal.
struct PassingPoint {
  Vec3 position;
  Vec3 normal;
};

/// Of points in their order those that are nearer to none taken than `spacing`, which grows until they are `most` at
/// most.
std::vector<PassingPoint> spread_out(const std::vector<PassingPoint>& all, double spacing, std::size_t most);

/// Sparse points of the sheets that come nearer to a rim vertex than `reach` without being joined to the rims within
/// that way. Middles of triangles, no two nearer than `spacing`; that grows until they are `most` at most.
/// Linear in the view.
std::vector<PassingPoint> other_sheets(const HoleSite& site, const std::vector<ReachedVertex>& reached, double reach,
                                       double spacing, std::size_t most);

/// By how much a bulge of 1 turns the surface at the rim (radians; 45 degrees): a disc becomes a dome of 0.2 diameters.
inline constexpr double angle_of_bulge = 0.7853981633974483;

/// The surface around a site, turned about its rims as about a hinge, so that what continues it goes outwards (or
/// inwards): the shape of a patch is changed by changing what it is fitted to. Rim points stay where they are.
class RimHinge {
 public:
  /// @param bulge -1..1, + turns the continuation to the side that the faces look to
  RimHinge(const HoleSite& site, double bulge);

  /// Where a point of the surface around comes to: turned about the nearest rim vertices, nearer ones counting more.
  Vec3 place(const Vec3& point) const;

  /// Its normal there.
  Vec3 normal(const Vec3& point, const Vec3& normal) const;

 private:
  struct Turn {
    Vec3 about = Vec3::Zero();  ///< unit
    Vec3 pivot = Vec3::Zero();
    double weight = 0;
  };
  std::vector<Turn> turns_at(const Vec3& point) const;

  std::vector<Vec3> points_;
  std::vector<Vec3> tangents_;  ///< unit, along the polygon of the site
  implicit::PointTree tree_;
  double angle_;
};

/// Places one after the other, but for those to which one taken is nearer than the spacing there.
/// @param place of a number below `count` @param spacing there
/// @return the numbers taken, or nothing when they are more than `most`
template <typename Place, typename Spacing>
std::optional<std::vector<std::size_t>> spread_out(std::size_t count, const Place& place, const Spacing& spacing,
                                                   std::size_t most) {
  std::vector<std::size_t> taken;
  for (std::size_t i = 0; i < count; ++i) {
    const double least = spacing(i);
    const Vec3 here = place(i);
    // The last one taken is most likely too near.
    const bool is_free = std::all_of(taken.rbegin(), taken.rend(),
                                     [&](std::size_t j) { return (here - place(j)).squaredNorm() >= least * least; });
    if (!is_free) continue;
    if (taken.size() == most) return std::nullopt;
    taken.push_back(i);
  }
  return taken;
}

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
bool continues_curvature(const HoleSite& site);

/// Fits one radial basis function to the surface around the rims: vertices within max(4 edges, reach × size) along the
/// surface, the sparser the farther away, rims included. A bulge that the site asks for turns them about the rims
/// first; places that the patch is to go through are met exactly. Where r^5 is safe, normals count at a few of the
/// places alone: the other places give the rest, and a fit takes a tenth of the time.
///
/// Fitted again with ten times the smoothing when a rim vertex that isn't a centre lies half an edge off (half of what
/// the centres resolve, for rims with more edges than centres; on rough surfaces five times the roughness, if that is
/// more); nothing when that doesn't help either, or there is nothing to fit.
std::optional<RimField> fit_rims(const HoleSite& site, const RimFitOptions& how);

}  // namespace croquis::hole_filling
