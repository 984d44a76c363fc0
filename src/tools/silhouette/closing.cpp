// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/silhouette/closing.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <Eigen/Geometry>

#include "croquis/geometry/polyline.h"
#include "croquis/geometry/predicates.h"
#include "croquis/tools/silhouette/stroke_edit.h"
#include "tools/pointer/segment_distance.h"
#include "tools/silhouette/stroke_places.h"

namespace croquis {
namespace {

/// How far from the ends a seam is looked for, in distances at which ends close by themselves; and at least, in parts
/// of what an end may run past the beginning.
constexpr double reach_in_distances = 3;
constexpr double reach_in_overlaps = 1.2;

/// Ends of loops too small for that distance close within this part of their length.
constexpr double small_loop_share = 0.12;

/// A stroke that winds or wriggles counts as no longer than this many diagonals of its box; a circle has 2.2.
constexpr double most_lengths = 4;

/// At the seam, directions are taken over half the distance at which ends close by themselves to both sides, of large
/// loops over this part of their length. Where an end heads for is estimated from more of it, but never by more than
/// the other.
constexpr double seam_share = 0.0075;
constexpr double most_heading_share = 1.0 / 16;

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
  Seam(std::span<const StrokeSample> samples, const CloseOptions& options) : places_(places_of(samples)) {
    lengths_ = arc_lengths(places_, false);
    const double distance = options.distance * options.units_per_pixel;
    const bool is_small = total() <= options.times_longer * distance;
    near_ = is_small ? 0 : distance;
    const double least = is_small ? small_loop_share * total() : distance;
    const double size = std::min(total(), most_lengths * diagonal());
    along_ = std::max(least, options.share * size);
    aside_ = std::max(least, options.aside_share * size);
    seam_ = std::max(least / 2, seam_share * total());
    reach_ = std::min(std::max(reach_in_distances * least, reach_in_overlaps * along_), total() / 4);
  }

  double total() const { return lengths_.back(); }

  bool ends_are_near() const { return gap().norm() <= near_; }

  /// The tail stops short of the beginning, and would go on into it. Ends that only face each other may have something
  /// drawn between them later.
  bool heads_for_beginning() const {
    const Vec2 head = head_direction();
    const Vec2 tail = tail_direction();
    if (head.dot(tail) <= along) return false;
    const Vec2 forward = (head + tail).normalized();
    const double ahead = gap().dot(forward);
    const double aside = (gap() - ahead * forward).norm();
    return ahead > 0 && ahead <= along_ && aside <= aside_;
  }

  /// Both ends, drawn on straight, meet at a corner near them. Sides of a limb are about parallel, and don't.
  bool heads_for_corner() const {
    const Vec2 head = head_direction();
    const Vec2 tail = tail_direction();
    const double turn = cross(head, tail);
    if (gap().norm() > along_ || turn == 0) return false;
    const double before_head = cross(gap(), tail) / turn;
    const double beyond_tail = cross(head, gap()) / turn;
    return std::abs(before_head) <= along_ && std::abs(beyond_tail) <= along_;
  }

  /// The tail runs across the beginning.
  bool ends_cross() const {
    for (std::size_t i = 1; i < places_.size() && lengths_[i] <= along_; ++i) {
      for (std::size_t k = places_.size() - 1; k > i && total() - lengths_[k - 1] <= along_; --k) {
        if (segments_cross(places_[i - 1], places_[i], places_[k - 1], places_[k])) return true;
      }
    }
    return false;
  }

  /// The tail runs past the beginning, beside it and the same way.
  bool overlaps() const {
    for (const std::size_t i : heads()) {
      for (const std::size_t k : tails()) {
        const bool near = (places_[i] - places_[k]).norm() <= aside_;
        if (near && direction(i, seam_).dot(direction(k, seam_)) > along) return true;
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
  double diagonal() const {
    Eigen::AlignedBox2d box;
    for (const Vec2& place : places_) box.extend(place);
    return box.diagonal().norm();
  }

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

  /// Where the beginning leaves for, and where the end heads for.
  Vec2 head_direction() const { return direction(0, std::min(aside_ / 2, most_heading_share * total())); }
  Vec2 tail_direction() const {
    return direction(places_.size() - 1, std::min(aside_ / 2, most_heading_share * total()));
  }

  /// Unit direction around a sample, over an arc length to both sides.
  Vec2 direction(std::size_t i, double half) const {
    std::size_t before = i;
    std::size_t after = i;
    while (before > 0 && lengths_[i] - lengths_[before] < half) --before;
    while (after + 1 < places_.size() && lengths_[after] - lengths_[i] < half) ++after;
    const Vec2 chord = places_[after] - places_[before];
    return chord.norm() > 0 ? Vec2(chord.normalized()) : Vec2(1, 0);
  }

  bool folds(const Closing& closing) const {
    const Vec2 step = places_[closing.first] - places_[closing.last];
    const Vec2 head = direction(closing.first, seam_);
    const Vec2 tail = direction(closing.last, seam_);
    if (step.norm() <= no_step * 2 * seam_) return false;
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
  double near_ = 0;   ///< a gap that closes by itself
  double along_ = 0;  ///< the largest that closes, and the longest overlap
  double aside_ = 0;  ///< how far aside of each other ends that close may lie
  double seam_ = 0;   ///< directions at the seam are taken so far to both sides
  double reach_ = 0;  ///< how far from the ends the seam may lie
};

}  // namespace

std::optional<Closing> find_closing(std::span<const StrokeSample> samples, const CloseOptions& options) {
  if (samples.size() < 3) return std::nullopt;
  const Seam seam(samples, options);
  if (seam.total() <= options.least_length * options.units_per_pixel) return std::nullopt;
  const bool closes = seam.ends_are_near() || seam.heads_for_beginning() || seam.overlaps() ||
                      seam.heads_for_corner() || seam.ends_cross();
  return closes ? std::optional(seam.best()) : std::nullopt;
}

bool passes_behind(const Drawing& drawing, std::span<const StrokeSample> samples, const CloseOptions& options) {
  if (samples.empty()) return false;
  const Vec2& first = samples.front().position;
  const Vec2& last = samples.back().position;
  const PickReach reach{options.distance, options.units_per_pixel};
  int between = 0;
  for (const Stroke& stroke : drawing.strokes) {
    for (std::size_t i = 0; i < segment_count(stroke); ++i)
      between += segments_cross(first, last, segment_begin(stroke, i), segment_end(stroke, i)) ? 1 : 0;
  }
  // One line between them is an edge that the outline crosses; what passes before it has two.
  if (between >= 2) return true;
  const bool near = (last - first).norm() <= reach.units();
  return !near && nearest_stroke(drawing, first, reach) && nearest_stroke(drawing, last, reach);
}

bool ends_meet(std::span<const StrokeSample> samples, const CloseOptions& options) {
  return find_closing(samples, options).has_value();
}

}  // namespace croquis
