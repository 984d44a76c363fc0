// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <functional>
#include <iomanip>
#include <numbers>
#include <vector>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <Eigen/SVD>

#include "bench/bench_surface.h"
#include "support/attribute_surface/exact_patches.h"
#include "support/attribute_surface/surfaces.h"

namespace croquis::bench {
namespace {

using namespace croquis::test;

/// What the user points at: a place of the true surface, and where it is pulled to.
struct Click {
  Vec3 place = Vec3::Zero();
  Vec3 normal = Vec3::UnitZ();
  Vec3 pulled = Vec3::Zero();
};

/// How a bump lies to the click that made it; lengths relative to the mean side.
struct Bump {
  double lateral = 0;     ///< from the click to the surface under the footprint, along the true surface
  double lean = 0;        ///< radians, between the pull and the true normal
  double offset = 0;      ///< of the region where the bump is at least half as high
  double anisotropy = 1;  ///< of that region: its length over its width
};

using FindFootprint = std::function<Vec2(const FaceSurface& base, const Click& click)>;

Vec3 mean_of(const std::vector<Vec3>& points) {
  Vec3 sum = Vec3::Zero();
  for (const Vec3& point : points) sum += point / static_cast<double>(points.size());
  return sum;
}

/// The corners in space, in the order of the domain's.
std::vector<Vec3> corners_in_space(const FaceSurface& face) {
  std::vector<Vec3> corners;
  for (std::size_t side = 0; side < face.frame().sides.size(); ++side)
    corners.push_back(face.at(face.side_place(side, 0)));
  return corners;
}

/// Coordinates in the plane of a loop's corners, seen from where its normal points to.
struct LoopPlane {
  explicit LoopPlane(const std::vector<Vec3>& corners) : origin(mean_of(corners)) {
    Vec3 normal = Vec3::Zero();
    for (std::size_t i = 0; i < corners.size(); ++i)
      normal += (corners[i] - origin).cross(corners[(i + 1) % corners.size()] - origin);
    u = normal.normalized().unitOrthogonal();
    v = normal.normalized().cross(u);
  }
  Vec2 operator()(const Vec3& point) const { return {u.dot(point - origin), v.dot(point - origin)}; }

  Vec3 origin, u, v;
};

/// Into the domain, towards its middle, where it is outside.
Vec2 kept_inside(const DomainPolygon& domain, Vec2 place) {
  const double limit = 1e-3 / static_cast<double>(domain.corners.size());
  for (int step = 0; step < 200 && distance_inside(domain, place) < limit; ++step)
    place += 0.05 * (domain.middle - place);
  return place;
}

/// The best map of the corners' places in their plane onto those of the domain, at the click.
Vec2 projected(const FaceSurface& base, const Click& click, bool affine) {
  const std::vector<Vec3> corners = corners_in_space(base);
  const DomainPolygon& domain = base.domain();
  const LoopPlane plane(corners);
  Eigen::Matrix2d both = Eigen::Matrix2d::Zero(), own = Eigen::Matrix2d::Zero();
  for (std::size_t i = 0; i < corners.size(); ++i) {
    both += (domain.corners[i] - domain.middle) * plane(corners[i]).transpose();
    own += plane(corners[i]) * plane(corners[i]).transpose();
  }
  Eigen::Matrix2d map = both * own.inverse();
  if (!affine) {
    const Eigen::JacobiSVD<Eigen::Matrix2d> decomposition(both, Eigen::ComputeFullU | Eigen::ComputeFullV);
    Eigen::Matrix2d turn = decomposition.matrixU() * decomposition.matrixV().transpose();
    if (turn.determinant() < 0) {
      const Vec2 signs(1, -1);
      turn = decomposition.matrixU() * signs.asDiagonal() * decomposition.matrixV().transpose();
    }
    map = turn / base.sigma();
  }
  return kept_inside(domain, domain.middle + map * plane(click.pulled));
}

/// Three places of the true surface, and where they are pulled to: a tenth of the mean side upwards.
std::vector<Click> clicks_on(const ExactPatch& patch, const FaceSurface& face, double side) {
  std::vector<Click> clicks;
  for (const FanPlace& fan : {FanPlace{0, 0.3, 0.25}, FanPlace{1, 0.15, 0.45}, FanPlace{2, 0.4, 0.1}}) {
    const SurfacePlace near = face.evaluate(place_in(face.domain(), fan));
    Click click;
    click.place = patch.nearest(near.point);
    const Vec3 above = click.place + 1e-3 * side * near.du.cross(near.dv).normalized();
    click.normal = (above - patch.nearest(above)).normalized();
    click.pulled = click.place + 0.1 * side * click.normal;
    clicks.push_back(click);
  }
  return clicks;
}

/// Places of the domain near a footprint, as far as bumps are half as high.
std::vector<DomainSample> samples_around(const DomainPolygon& domain, const Vec2& footprint, double reach) {
  constexpr int steps = 80;
  std::vector<DomainSample> samples;
  for (int i = 0; i < steps * steps; ++i) {
    const Vec2 offset((i % steps + 0.5) / steps - 0.5, (i / steps + 0.5) / steps - 0.5);
    const Vec2 place = footprint + 4 * reach * offset;
    if (distance_inside(domain, place) > 0) samples.push_back({place, 1});
  }
  return samples;
}

Bump bump_of(const FaceSurface& base, const Click& click, const Vec2& footprint, double side) {
  const FaceSurface face = base.with({{click.pulled, footprint, {}, PointProfile::Smooth, {}}}, {});
  const auto along_surface = [&](const Vec3& offset) { return Vec3(offset - offset.dot(click.normal) * click.normal); };
  const Vec3 pull = click.pulled - base.at(footprint);
  Bump bump;
  bump.lateral = along_surface(pull).norm() / side;
  bump.lean = angle_between(pull, click.normal);

  double area = 0;
  Vec3 middle = Vec3::Zero();
  Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
  for (const DomainSample& sample :
       samples_around(base.domain(), footprint, face.points()[0].radius.value() / base.sigma())) {
    const SurfacePlace place = base.evaluate(sample.place);
    if ((face.at(sample.place) - place.point).norm() < 0.5 * pull.norm()) continue;
    const double piece = sample.area * place.du.cross(place.dv).norm();
    const Vec3 offset = along_surface(place.point - click.place);
    area += piece;
    middle += piece * offset;
    squares += piece * offset * offset.transpose();
  }
  middle /= area;
  bump.offset = middle.norm() / side;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(squares / area - middle * middle.transpose());
  bump.anisotropy = std::sqrt(axes.eigenvalues()[2] / std::max(1e-12 * side * side, axes.eigenvalues()[1]));
  return bump;
}

/// Arithmetic means over all patches and clicks; of anisotropies geometric ones.
Bump mean_bump(AttributeDomain domain, const FindFootprint& find) {
  AttributeSurfaceOptions options;
  options.domain = domain;
  Bump mean;
  double count = 0, logarithms = 0;
  for (const ExactPatch& patch : exact_patches()) {
    const FaceSurface base = first_surface(patch.network, options);
    const FaceSurface reference = first_surface(patch.network);
    const double side = base.sigma() / static_cast<double>(base.frame().sides.size());
    for (const Click& click : clicks_on(patch, reference, side)) {
      const Bump bump = bump_of(base, click, find(base, click), side);
      mean.lateral += bump.lateral;
      mean.lean += bump.lean;
      mean.offset += bump.offset;
      logarithms += std::log(bump.anisotropy);
      ++count;
    }
  }
  return {mean.lateral / count, mean.lean / count, mean.offset / count, std::exp(logarithms / count)};
}

void print(std::ostream& out, const char* name, const FindFootprint& find) {
  const Bump uniform = mean_bump(AttributeDomain::Uniform, find);
  const Bump chordlength = mean_bump(AttributeDomain::Chordlength, find);
  const double degree = std::numbers::pi / 180;
  out << "| " << name << " | " << std::setprecision(4) << uniform.lateral << " / " << chordlength.lateral << " | "
      << std::setprecision(1) << uniform.lean / degree << " / " << chordlength.lean / degree << " | "
      << std::setprecision(3) << uniform.offset << " / " << chordlength.offset << " | " << std::setprecision(2)
      << uniform.anisotropy << " / " << chordlength.anisotropy << " |" << std::endl;
}

}  // namespace

void bench_surface_placement(std::ostream& out) {
  out << "Points pulled off the same patches, three on each; uniform / chordlength, lengths relative to the mean "
         "side.\n"
      << "Lateral: how far beside the click the surface is moved. Lean: of the pull against the normal. Offset and "
         "anisotropy of\nthe region that is moved by half as much or more.\n\n"
      << "| footprint found by | lateral | lean, degrees | offset | anisotropy |\n|---|---|---|---|---|\n"
      << std::fixed;
  print(out, "plane projection, rigid",
        [](const FaceSurface& base, const Click& click) { return projected(base, click, false); });
  print(out, "plane projection, affine",
        [](const FaceSurface& base, const Click& click) { return projected(base, click, true); });
  print(out, "nearest place of the surface",
        [](const FaceSurface& base, const Click& click) { return nearest_base_place(base, click.pulled).place; });
  out << std::endl;
}

}  // namespace croquis::bench
