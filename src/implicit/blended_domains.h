// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

#include "croquis/implicit/partition_of_unity.h"
#include "croquis/implicit/point_tree.h"
#include "implicit/octree.h"

namespace croquis::implicit {

/// All points of a field, and what a domain takes of them.
class DomainPoints {
 public:
  DomainPoints(std::span<const Vec3> positions, std::span<const Vec3> normals, const DomainOptions& options,
               Progress& progress);

  /// The points in the box, with their normals or, for kernels without gradients, their offset points: if fewer than
  /// min_points, the nearest to its middle instead; if more than `most`, thinned.
  Constraints of(const Box& box, std::size_t most) const;

  /// True when the box holds more than `most` points on the surface.
  bool holds_more_than(std::size_t most, const Box& box) const { return tree_.holds_more_than(most, box); }

  std::span<const Vec3> positions() const { return positions_; }
  std::size_t bytes() const;

 private:
  void make_offsets();

  DomainOptions options_;
  std::vector<Vec3> own_positions_, own_normals_;  // none when they are borrowed
  std::span<const Vec3> positions_, normals_;
  PointTree tree_;
  Constraints offsets_;                    // points off the surface, behind those on it
  std::vector<std::size_t> first_offset_;  // #N+1 into offsets_, or none
};

/// What is evaluated at a place: the value; beside it the gradient's first sum, sum w_i grad f_i; or the whole
/// gradient.
enum class Wanted { Value, FirstSum, Gradient };

/// The domains of a partition of unity, and what they add up to.
class BlendedDomains {
 public:
  BlendedDomains(std::span<const Vec3> positions, std::span<const Vec3> normals, std::vector<ExtraDomain> extras,
                 const DomainOptions& options, Progress& progress);

  /// Fits the domains that have points and the extra ones.
  void fit(Progress& progress) const;

  /// The same, of those that reach into a slab.
  void fit_between(int axis, double low, double high, Progress& progress) const;

  /// Frees the fits of those that end below a place. Not while others evaluate.
  void forget_below(int axis, double place);

  void evaluate(std::span<const Vec3> places, std::span<double> values, std::span<Vec3> gradients, Wanted wanted) const;
  std::vector<Box> boxes() const;
  DomainReport report() const;
  std::size_t domain_count() const;  ///< those that fit() fits

 private:
  /// One box with its fit, which is made when it is first needed.
  struct Domain {
    std::size_t number = 0;
    Box box;
    double weight = 1;
    std::size_t most = 0;                    // points that it takes at most
    std::unique_ptr<const Constraints> own;  // an extra domain's; the others take theirs from the points
    mutable std::unique_ptr<const LocalFit> fit;
    mutable std::atomic<const LocalFit*> ready = nullptr;
    mutable std::uint32_t centres = 0, merged = 0, fits = 0;  // of the fit, also when it was forgotten
    mutable bool rank_revealing = false;
  };

  /// What the domains at one place add up to.
  struct Blend {
    double weight = 0;
    double value = 0;                       // sum of W f
    Vec3 gradient = Vec3::Zero();           // sum of W grad f
    Vec3 weight_gradient = Vec3::Zero();    // sum of grad W
    Vec3 value_times_slope = Vec3::Zero();  // sum of f grad W
    double coverage = 0;                    // sum of W without factors, of all but fillers
    Vec3 coverage_gradient = Vec3::Zero();
  };

  void add_leaf_domains();
  void add_extras(std::vector<ExtraDomain>&& extras);
  bool is_filler(std::size_t domain) const;
  void fit_these(const std::vector<const Domain*>& needed, Progress& progress) const;
  const LocalFit& fit_of(const Domain& domain) const;
  void add(const Domain& domain, const BoxWeight& w, const Vec3& place, Wanted wanted, Blend& blend) const;
  void add_domain(const Domain& domain, const Vec3& place, Wanted wanted, Blend& blend) const;
  void add_filler(const Domain& domain, const Vec3& place, Wanted wanted, const Blend& others, Blend& blend) const;
  Blend blend_at(const Vec3& place, Wanted wanted) const;

  DomainOptions options_;
  DomainPoints points_;
  Octree tree_;
  std::deque<Domain> domains_;                      // one per leaf, then the extra ones
  std::vector<std::vector<Index>> extras_of_leaf_;  // domains whose boxes meet the leaf's cube
  bool has_extras_ = false;

  // One thread makes a fit. Domains share locks: few are made at a time.
  static constexpr std::size_t lock_count = 64;
  mutable std::array<std::mutex, lock_count> locks_;
};

}  // namespace croquis::implicit
