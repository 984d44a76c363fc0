// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace croquis {

/// How many holes of which size a scan has, for a slider of the largest hole to be filled. The scale is logarithmic:
/// scans have many tiny holes and a few large ones.
class HoleHistogram {
 public:
  HoleHistogram() = default;

  /// @param diameters model units; those that aren't finite and above 0 are left out
  /// @param bin_count at least 1; fewer come out where all diameters are equal (one), none where there is no diameter
  /// O(n log n).
  explicit HoleHistogram(std::span<const double> diameters, std::size_t bin_count = 24);

  struct Bin {
    double low = 0;   ///< model units; inclusive
    double high = 0;  ///< exclusive, of the last bin inclusive
    std::size_t count = 0;
  };
  const std::vector<Bin>& bins() const { return bins_; }  ///< from small to large, without gaps
  std::size_t highest() const;                            ///< the largest count of a bin

  bool empty() const { return sorted_.empty(); }
  std::size_t size() const { return sorted_.size(); }
  double least() const { return empty() ? 0 : sorted_.front(); }
  double greatest() const { return empty() ? 0 : sorted_.back(); }

  /// How many diameters are at most that. O(log n).
  std::size_t count_up_to(double diameter) const;

  // ---- The slider
  /// Where a diameter stands, 0 at the smallest to 1 at the largest; clamped.
  double position(double diameter) const;

  /// The diameter at a place of the slider.
  double diameter(double position) const;

  /// The same, but drawn to the nearest diameter that a hole has, if it is within that much of the slider: a hair more
  /// than it, so that a number rounded to six digits still takes this hole in, but not the next one where the two
  /// differ.
  double snapped(double position, double within = 0.02) const;

 private:
  std::vector<double> sorted_;
  std::vector<Bin> bins_;
};

}  // namespace croquis
