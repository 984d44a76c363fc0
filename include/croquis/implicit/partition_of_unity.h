// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "croquis/base/progress.h"
#include "croquis/implicit/box_weight.h"
#include "croquis/implicit/field.h"
#include "croquis/implicit/local_fit.h"

namespace croquis::implicit {

/// How space is cut into domains and how these are weighted.
struct DomainOptions {
  std::size_t leaf_points = 40;  ///< a box with more points of its own is cut in eight
  std::size_t min_points = 30;   ///< a domain with fewer takes so many nearest points
  std::size_t max_points = 300;  ///< a domain with more is thinned; 2000 at most
  int max_depth = 20;            ///< of the tree
  double overlap = 0.25;         ///< how much larger a domain is than its box, in total per axis, as fraction; 0..1
  bool equal_boxes = false;      ///< all boxes with points of one size (Yoo 2005), else as large as their points allow

  double data_weight = 1000;    ///< factor of the weights of domains with points in their box
  double filler_weight = 1e-4;  ///< of those without: they rule only where nothing else does; 0: none of them

  /// Fits of kernels without gradients get offset points at this distance, model units; 0: half the mean spacing.
  double offset = 0;
  bool offset_both_sides = true;  ///< false: outside only, as in Yoo 2005

  FitOptions fit;
  bool borrow = false;  ///< points and normals aren't copied: they have to outlive the field
  bool lazy = false;    ///< domains are fitted when they are first needed, or by fit_between, not at once
  int threads = 0;      ///< of the fitting; 0: as many as the machine has. The result is the same for any
};

/// A domain of the caller's own beside those of the points, as for a hole: its box has to contain the whole rim.
struct ExtraDomain {
  Box box;
  Constraints constraints;  ///< used as they are
  double weight = 1;        ///< factor; between filler and data it rules exactly where there are no data
};

struct DomainReport {
  std::size_t data_domains = 0;
  std::size_t filler_domains = 0;
  std::size_t extra_domains = 0;
  std::size_t fitted = 0;       ///< domains fitted so far; fillers are fitted when they are first needed
  std::size_t fits = 0;         ///< made so far: more than `fitted` where some were forgotten
  std::size_t min_centres = 0;  ///< over the data domains
  std::size_t median_centres = 0;
  std::size_t max_centres = 0;
  std::size_t merged = 0;          ///< duplicate points left out, over all data domains
  std::size_t rank_revealing = 0;  ///< fits that were nearly singular
  std::size_t bytes = 0;           ///< held by tree and fits
};

/// A field over many points: radial basis functions over overlapping boxes, blended with smooth weights
/// F = sum w_i f_i, w_i = W_i / sum W_j (Yoo 2005, section 3; eq. 8), twice continuously differentiable.
///
/// The boxes are the leaves of an octree over points and extra boxes, grown by the overlap. F is defined in the tree's
/// box grown by half of its size; NaN elsewhere.
/// Fitting is near-linear in the number of points. Evaluation is thread-safe and costs one fit's evaluation per
/// overlapping domain (1 to 8). Values depend on the input alone: not on threads, order of queries or machine.
class PartitionOfUnity {
 public:
  /// Cuts space and fits every domain with points and every extra one.
  /// @param positions #N >= 1, finite
  /// @param normals   #N, unit length, outwards; 0 where unknown. None at all: Kernel::Hermite has nothing to go by
  /// @throws Error (E_NO_POINTS, E_NOT_FINITE, E_COUNT, E_PARAMETER), Cancelled (asked for at every domain)
  PartitionOfUnity(std::span<const Vec3> positions, std::span<const Vec3> normals, std::vector<ExtraDomain> extras,
                   const DomainOptions& options, Progress& progress);
  ~PartitionOfUnity();
  PartitionOfUnity(PartitionOfUnity&&) noexcept;
  PartitionOfUnity& operator=(PartitionOfUnity&&) noexcept;

  /// @param gradients full gradients, sum w_i grad f_i + sum f_i grad w_i; as many as points, or none
  void evaluate(std::span<const Vec3> points, std::span<double> values, std::span<Vec3> gradients = {}) const;

  /// Gradients without the second sum: cheaper, and enough to project onto the surface.
  void evaluate_for_projection(std::span<const Vec3> points, std::span<double> values, std::span<Vec3> gradients) const;

  double value(const Vec3& point) const;
  Vec3 gradient(const Vec3& point) const;

  /// This as a field. It must outlive what it returns.
  Field field() const;
  Field projection_field() const;  ///< with the gradients of evaluate_for_projection

  /// Fits the domains with points, and the extra ones, whose boxes reach into [low, high] along an axis.
  /// @throws Cancelled
  void fit_between(int axis, double low, double high, Progress& progress);

  /// Frees the fits of domains whose boxes end below a place along an axis. They are made again when they are needed
  /// again: values stay the same. Not while others evaluate.
  void forget_below(int axis, double place);

  /// Boxes of all domains as grown, data and fillers in the tree's order, then the extra ones.
  std::vector<Box> domain_boxes() const;

  DomainReport report() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace croquis::implicit
