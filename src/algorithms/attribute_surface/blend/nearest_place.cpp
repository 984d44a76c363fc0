// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include "croquis/attribute_surface/face_surface.h"

namespace croquis {
namespace {

/// A map from the domain, with or without what lies on it.
class SearchedSurface {
 public:
  SearchedSurface(const FaceSurface& surface, bool base, const Vec3& point)
      : surface_(surface),
        base_(base),
        point_(point),
        limit_(1e-3 / static_cast<double>(surface.domain().corners.size())) {}

  double limit() const { return limit_; }
  const DomainPolygon& polygon() const { return surface_.domain(); }

  double distance(const Vec2& place) const {
    return ((base_ ? surface_.base_at(place) : surface_.at(place)) - point_).norm();
  }

  /// Of half the square of the distance.
  Vec2 gradient(const Vec2& place) const {
    const SurfacePlace at = base_ ? surface_.evaluate_base(place) : surface_.evaluate(place);
    return {at.du.dot(at.point - point_), at.dv.dot(at.point - point_)};
  }

  /// By differences of the gradient: where the point is far off the surface, its curvature counts, too.
  Eigen::Matrix2d hessian(const Vec2& place) const {
    const double step = std::min(1e-5, 0.5 * limit_);
    Eigen::Matrix2d result;
    for (int i = 0; i < 2; ++i) {
      const Vec2 move = step * Vec2::Unit(i);
      result.col(i) = (gradient(place + move) - gradient(place - move)) / (2 * step);
    }
    return 0.5 * (result + result.transpose());
  }

 private:
  const FaceSurface& surface_;
  bool base_;
  Vec3 point_;
  double limit_;
};

/// The nearest place that keeps the limit from all sides. A few rounds settle corners.
Vec2 kept_inside(const DomainPolygon& polygon, const Vec2& place, double limit) {
  Vec2 result = place;
  for (int round = 0; round < 8; ++round) {
    bool moved = false;
    for (std::size_t i = 0; i < polygon.corners.size(); ++i) {
      const Vec2& from = polygon.corners[i];
      const Vec2 inwards = left_of((polygon.corners[(i + 1) % polygon.corners.size()] - from).normalized());
      const double lack = limit - (result - from).dot(inwards);
      if (lack <= 1e-15) continue;
      result += lack * inwards;
      moved = true;
    }
    if (!moved) return result;
  }
  const double depth = distance_inside(polygon, result);
  if (depth >= limit) return result;
  const double middle_depth = distance_inside(polygon, polygon.middle);
  const double part = std::min(1.0, (limit - depth) / (middle_depth - depth));
  return result + part * (polygon.middle - result);
}

Vec2 best_of_grid(const SearchedSurface& surface) {
  constexpr std::size_t rings = 6;
  const DomainPolygon& polygon = surface.polygon();
  Vec2 best = polygon.middle;
  double least = surface.distance(best);
  for (std::size_t corner = 0; corner < polygon.corners.size(); ++corner) {
    for (std::size_t ring = 1; ring <= rings; ++ring) {
      for (std::size_t part = 0; part < ring; ++part) {
        const double b = 0.98 * static_cast<double>(part) / rings;
        const Vec2 place = place_in(polygon, {corner, 0.98 * static_cast<double>(ring) / rings - b, b});
        const double distance = surface.distance(place);
        if (distance < least) best = place;
        least = std::min(least, distance);
      }
    }
  }
  return best;
}

/// Newton's step where it leads downwards, else along the steepest way by the matrix made positive.
Vec2 downward_step(const Vec2& gradient, const Eigen::Matrix2d& hessian) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(hessian);
  const double largest = solver.eigenvalues().cwiseAbs().maxCoeff();
  if (!(largest > 0)) return Vec2::Zero();
  const Vec2 sizes = solver.eigenvalues().cwiseAbs().cwiseMax(1e-8 * largest);
  return -(solver.eigenvectors() * (solver.eigenvectors().transpose() * gradient).cwiseQuotient(sizes));
}

/// At the limit only the way along it is left for a step that leads out.
Vec2 along_the_limit(const SearchedSurface& surface, const Vec2& place, const Vec2& gradient,
                     const Eigen::Matrix2d& hessian) {
  const DomainPolygon& polygon = surface.polygon();
  Vec2 step = downward_step(gradient, hessian);
  for (std::size_t i = 0; i < polygon.corners.size(); ++i) {
    const Vec2& from = polygon.corners[i];
    const Vec2 along = (polygon.corners[(i + 1) % polygon.corners.size()] - from).normalized();
    const Vec2 inwards = left_of(along);
    const bool at_limit = (place - from).dot(inwards) <= surface.limit() * (1 + 1e-9);
    if (!at_limit || step.dot(inwards) >= 0 || -gradient.dot(inwards) >= 0) continue;
    const double curvature = along.dot(hessian * along);
    step = -gradient.dot(along) / std::max(std::abs(curvature), 1e-12) * along;
  }
  return step;
}

/// Distances of a far point hardly differ between near places, but gradients do: plain steps of Newton's while these
/// fall.
Vec2 polished(const SearchedSurface& surface, const Vec2& start) {
  Vec2 place = start;
  double size = surface.gradient(place).norm();
  for (int i = 0; i < 4; ++i) {
    const Vec2 next = place + downward_step(surface.gradient(place), surface.hessian(place));
    if (distance_inside(surface.polygon(), next) < surface.limit()) return place;
    const double next_size = surface.gradient(next).norm();
    if (next_size >= size) return place;
    place = next;
    size = next_size;
  }
  return place;
}

NearestPlace result_at(const SearchedSurface& surface, const Vec2& place) {
  const bool at_limit = distance_inside(surface.polygon(), place) <= surface.limit() * (1 + 1e-6);
  const Vec2 exact = at_limit ? place : polished(surface, place);
  return {exact, surface.distance(exact), at_limit};
}

NearestPlace search(const SearchedSurface& surface, const std::optional<Vec2>& guess) {
  const DomainPolygon& polygon = surface.polygon();
  Vec2 place = kept_inside(polygon, guess ? *guess : best_of_grid(surface), surface.limit());
  double distance = surface.distance(place);
  for (int i = 0; i < 60; ++i) {
    const Vec2 step = along_the_limit(surface, place, surface.gradient(place), surface.hessian(place));
    bool better = false;
    double length = std::min(1.0, 0.1 / std::max(1e-300, step.norm()));
    for (int halving = 0; halving < 30 && !better; ++halving, length *= 0.5) {
      const Vec2 next = kept_inside(polygon, place + length * step, surface.limit());
      const double next_distance = surface.distance(next);
      better = next_distance < distance;
      if (!better) continue;
      const double moved = (next - place).norm();
      place = next;
      distance = next_distance;
      if (moved < 1e-12) return result_at(surface, place);
    }
    if (!better) break;
  }
  return result_at(surface, place);
}

}  // namespace

NearestPlace nearest_place(const FaceSurface& surface, const Vec3& point, const std::optional<Vec2>& guess) {
  return search(SearchedSurface(surface, false, point), guess);
}

NearestPlace nearest_base_place(const FaceSurface& surface, const Vec3& point, const std::optional<Vec2>& guess) {
  return search(SearchedSurface(surface, true, point), guess);
}

}  // namespace croquis
