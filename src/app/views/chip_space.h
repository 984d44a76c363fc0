// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QRect>
#include <optional>
#include <vector>

namespace croquis::app {

/// Places for labels and buttons over a view: none covers another. The first ones get the places they want.
class ChipSpace {
 public:
  /// Takes the free place nearest to the wanted one. Nothing when there is none.
  /// @param bounds that it has to stay within. O(n^3) in the chips near by, O(n) where the wanted place is free.
  std::optional<QRect> take(const QRect& wanted, const QRect& bounds);

 private:
  bool is_free(const QRect& place) const;

  std::vector<QRect> taken_;
};

}  // namespace croquis::app
