// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "croquis/geometry/vector.h"

namespace croquis::subdivision {

/// The numbers 0 … count-1 without a few: those kept are numbered again in their order.
///
/// Costs memory for what is left out only, since that is little: tagged neighbourhoods are lines on a surface.
class Compaction {
 public:
  Compaction() = default;

  /// @param left_out below `count`, in any order, possibly repeated
  Compaction(std::vector<Index> left_out, std::size_t count) : left_out_(std::move(left_out)) {
    std::sort(left_out_.begin(), left_out_.end());
    left_out_.erase(std::unique(left_out_.begin(), left_out_.end()), left_out_.end());
    count_ = static_cast<Index>(count);
  }

  const std::vector<Index>& left_out() const { return left_out_; }  ///< ascending
  Index kept_count() const { return count_ - static_cast<Index>(left_out_.size()); }

  bool keeps(Index element) const { return !std::binary_search(left_out_.begin(), left_out_.end(), element); }

  /// How many of those left out come before `element`.
  Index left_out_before(Index element) const {
    return static_cast<Index>(std::lower_bound(left_out_.begin(), left_out_.end(), element) - left_out_.begin());
  }

  /// The new number of a kept element.
  Index rank(Index element) const { return element - left_out_before(element); }

  /// The kept element of that new number.
  Index element(Index rank) const {
    Index low = 0, high = static_cast<Index>(left_out_.size());  // the first left out that comes after the element
    while (low < high) {
      const Index middle = low + (high - low) / 2;
      if (left_out_[middle] - middle <= rank) {
        low = middle + 1;
      } else {
        high = middle;
      }
    }
    return rank + low;
  }

  /// Calls use(begin, end, rank of begin) for each run of kept elements that follow one another; long runs are cut, so
  /// that the caller can look up from its work.
  template <typename Use>
  void for_each_run(Use&& use) const {
    constexpr Index longest = 1u << 16;
    Index begin = 0;
    for (std::size_t i = 0; i <= left_out_.size(); ++i) {
      const Index end = i < left_out_.size() ? left_out_[i] : count_;
      for (; begin < end; begin = std::min(end, begin + longest)) {
        use(begin, std::min(end, begin + longest), begin - static_cast<Index>(i));
      }
      begin = end + 1;
    }
  }

 private:
  std::vector<Index> left_out_;
  Index count_ = 0;
};

}  // namespace croquis::subdivision
