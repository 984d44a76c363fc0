// SPDX-License-Identifier: GPL-3.0-or-later
#include "implicit/domain_points.h"

#include <algorithm>
#include <cmath>

#include "croquis/implicit/offset_points.h"
#include "implicit/thinning.h"

namespace croquis::implicit {
namespace {

/// The mean distance of a point to its nearest neighbour.
double mean_spacing(const PointTree& tree, std::span<const Vec3> positions) {
  double sum = 0;
  for (const Vec3& position : positions) {
    const std::vector<Index> nearest = tree.nearest(position, 2);
    if (nearest.size() == 2) sum += (positions[nearest[1]] - position).norm();
  }
  return sum / static_cast<double>(positions.size());
}

}  // namespace

DomainPoints::DomainPoints(std::span<const Vec3> positions, std::span<const Vec3> normals, const DomainOptions& options,
                           Progress& progress)
    : options_(options), positions_(positions), normals_(normals), tree_(positions, options.threads, progress) {
  if (!options.borrow) {
    own_positions_.assign(positions.begin(), positions.end());
    own_normals_.assign(normals.begin(), normals.end());
    positions_ = own_positions_;
    normals_ = own_normals_;
  }
  if (!takes_gradients(options.fit.kernel) && !normals_.empty()) make_offsets();
}

void DomainPoints::make_offsets() {
  const double distance = options_.offset > 0 ? options_.offset : 0.5 * mean_spacing(tree_, positions_);
  if (!(distance > 0)) return;  // all points at one place: there is no offset to choose
  OffsetOptions options;
  options.distance = distance;
  options.both_sides = options_.offset_both_sides;
  OffsetPoints points = with_offset_points(positions_, normals_, options);
  first_offset_.assign(positions_.size() + 1, positions_.size());
  for (const Index origin : points.origins) ++first_offset_[origin + 1];
  // Counts become ends: offset points come in the order of their origins.
  std::size_t end = positions_.size();
  for (std::size_t i = 0; i < positions_.size(); ++i) {
    first_offset_[i] = end;
    end += first_offset_[i + 1] - positions_.size();
  }
  first_offset_.back() = end;
  offsets_ = std::move(points.constraints);
}

Constraints DomainPoints::of(const Box& box, std::size_t most) const {
  std::vector<Index> chosen = tree_.inside(box);
  if (chosen.size() < options_.min_points) {
    chosen = tree_.nearest(box.middle(), options_.min_points);
  } else if (chosen.size() > most) {
    chosen = thinned(positions_, std::move(chosen), box, most);
  }
  std::sort(chosen.begin(), chosen.end());
  Constraints constraints;
  for (const Index i : chosen) constraints.positions.push_back(positions_[i]);
  if (takes_gradients(options_.fit.kernel) && !normals_.empty()) {
    for (const Index i : chosen) constraints.gradients.push_back(normals_[i]);
  }
  if (first_offset_.empty()) return constraints;
  constraints.values.assign(chosen.size(), 0.0);
  for (const Index i : chosen) {
    for (std::size_t k = first_offset_[i]; k < first_offset_[i + 1]; ++k) {
      constraints.positions.push_back(offsets_.positions[k]);
      constraints.values.push_back(offsets_.values[k]);
    }
  }
  return constraints;
}

std::size_t DomainPoints::bytes() const {
  return (own_positions_.capacity() + own_normals_.capacity() + offsets_.positions.capacity()) * sizeof(Vec3) +
         offsets_.values.capacity() * sizeof(double) + first_offset_.capacity() * sizeof(std::size_t) + tree_.bytes();
}

}  // namespace croquis::implicit
