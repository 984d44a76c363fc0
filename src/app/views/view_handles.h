// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

class QToolButton;

namespace croquis::app {

class ChipPlaces;
class Views;

/// Buttons in a corner of the view under the pointer, which a drag rotates, pans and zooms it with: for pens, which
/// have no other buttons, and for whoever doesn't know the keys.
class ViewHandles {
 public:
  explicit ViewHandles(Views& views);

  void place(ChipPlaces& places);

 private:
  Views& views_;
  std::array<QToolButton*, 3> buttons_{};
};

}  // namespace croquis::app
