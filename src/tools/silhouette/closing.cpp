// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/silhouette/closing.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "croquis/geometry/polyline.h"
#include "tools/pointer/segment_distance.h"

namespace croquis {
namespace {

/// How far from the ends a seam is looked for, in closing distances.
constexpr double reach_in_distances = 3;

/// Places tried on each side of the seam, and pairs of them tested for crossings.
constexpr std::size_t most_places = 24;

/// Cosine of 60 degrees: ends that agree better run along each other.
constexpr double along = 0.5;

/// Cosine of 45 degrees: how steeply the joining piece may step from one end to the other where they run along.
constexpr double steepest_step = 0.7;

/// Of the closing distance: a joining piece shorter than this has no useful direction.
constexpr double no_step = 0.1;

struct ClosingCandidate {
  Closing closing;
  double cost = 0;
};

class Seam {
 public:
  Seam(std::span<const StrokeSample> samples, const CloseOptions& options)
      : near_(options.distance * options.units_per_pixel) {
    for (const StrokeSample& sample : samples) places_.push_back(sample.position);
    lengths_ = arc_lengths(places_, false);
    distance_ = std::max(near_, std::min(options.share * total(), options.farthest * options.units_per_pixel));
    reach_ = std::min(reach_in_distances * distance_, total() / 4);
  }

  double total() const { return lengths_.back(); }

  bool ends_are_near() const { return gap().norm() <= near_; }

  /// The tail stops short of the beginning, and would go on into it. Ends that only face each other may have something
  /// drawn between them later.
  bool heads_for_beginning() const {
    const Vec2 head = direction(0);
    const Vec2 tail = direction(places_.size() - 1);
    const double least = along * gap().norm();
    return gap().norm() <= distance_ && head.dot(tail) > along && gap().dot(head) > least && gap().dot(tail) > least;
  }

  /// The tail runs past the beginning, beside it and the same way.
  bool overlaps() const {
    for (const std::size_t i : heads()) {
      for (const std::size_t k : tails()) {
        const bool near = (places_[i] - places_[k]).norm() <= distance_;
        if (near && direction(i).dot(direction(k)) > along) return true;
      }
    }
    return false;
  }

  /// The cheapest pair of ends that joins well; all samples when there is none.
  Closing best() const {
    std::vector<ClosingCandidate> candidates;
    for (const std::size_t i : heads()) {
      for (const std::size_t k : tails()) {
        const double cut = lengths_[i] + total() - lengths_[k];
        candidates.push_back({{i, k}, (places_[i] - places_[k]).norm() + cut / 2});
      }
    }
    std::stable_sort(candidates.begin(), candidates.end(),
                     [](const ClosingCandidate& a, const ClosingCandidate& b) { return a.cost < b.cost; });
    for (const ClosingCandidate& candidate : candidates) {
      if (!folds(candidate.closing) && !crosses(candidate.closing)) return candidate.closing;
    }
    return {0, places_.size() - 1};
  }

 private:
  Vec2 gap() const { return places_.front() - places_.back(); }  ///< from the end to the beginning

  std::vector<std::size_t> thinned(std::vector<std::size_t> all) const {
    const std::size_t step = 1 + all.size() / most_places;
    std::vector<std::size_t> some;
    for (std::size_t n = 0; n < all.size(); n += step) some.push_back(all[n]);
    return some;
  }
  std::vector<std::size_t> heads() const {
    std::vector<std::size_t> all;
    for (std::size_t i = 0; i < places_.size() && lengths_[i] <= reach_; ++i) all.push_back(i);
    return thinned(std::move(all));
  }
  std::vector<std::size_t> tails() const {
    std::vector<std::size_t> all;
    for (std::size_t i = places_.size(); i-- > 0 && total() - lengths_[i] <= reach_;) all.push_back(i);
    return thinned(std::move(all));
  }

  /// Unit direction around a sample, over half a closing distance to both sides.
  Vec2 direction(std::size_t i) const {
    std::size_t before = i;
    std::size_t after = i;
    while (before > 0 && lengths_[i] - lengths_[before] < distance_ / 2) --before;
    while (after + 1 < places_.size() && lengths_[after] - lengths_[i] < distance_ / 2) ++after;
    const Vec2 chord = places_[after] - places_[before];
    return chord.norm() > 0 ? Vec2(chord.normalized()) : Vec2(1, 0);
  }

  bool folds(const Closing& closing) const {
    const Vec2 step = places_[closing.first] - places_[closing.last];
    const Vec2 head = direction(closing.first);
    const Vec2 tail = direction(closing.last);
    if (step.norm() <= no_step * distance_) return false;
    if (head.dot(tail) > along) return step.dot(head + tail) < steepest_step * step.norm() * (head + tail).norm();
    return false;
  }

  /// Whether the loop crosses itself near its seam.
  bool crosses(const Closing& closing) const {
    std::vector<Vec2> head;
    for (std::size_t i = closing.first; i < places_.size() && lengths_[i] <= reach_; ++i) head.push_back(places_[i]);
    std::vector<Vec2> tail;
    for (std::size_t i = closing.last + 1; i-- > 0 && total() - lengths_[i] <= reach_;) tail.push_back(places_[i]);
    for (std::size_t h = 0; h + 1 < head.size(); ++h) {
      for (std::size_t t = 0; t + 1 < tail.size(); ++t) {
        if (segments_cross(head[h], head[h + 1], tail[t], tail[t + 1])) return true;
      }
      if (h > 0 && segments_cross(head[h], head[h + 1], tail[0], head[0])) return true;
    }
    for (std::size_t t = 1; t + 1 < tail.size(); ++t) {
      if (segments_cross(tail[t], tail[t + 1], tail[0], head[0])) return true;
    }
    return false;
  }

  std::vector<Vec2> places_;
  std::vector<double> lengths_;
  double near_;          ///< a gap that closes by itself
  double distance_ = 0;  ///< the largest that closes
  double reach_ = 0;
};

}  // namespace

std::optional<Closing> find_closing(std::span<const StrokeSample> samples, const CloseOptions& options) {
  if (samples.size() < 3) return std::nullopt;
  const Seam seam(samples, options);
  if (seam.total() <= options.times_longer * options.distance * options.units_per_pixel) return std::nullopt;
  if (!seam.ends_are_near() && !seam.heads_for_beginning() && !seam.overlaps()) return std::nullopt;
  return seam.best();
}

bool ends_meet(std::span<const StrokeSample> samples, const CloseOptions& options) {
  return find_closing(samples, options).has_value();
}

}  // namespace croquis
