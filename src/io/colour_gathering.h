// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "croquis/geometry/poly_mesh.h"

namespace croquis {

/// Colours of OFF's vertices or faces, of which some may have none; what type they are is known at the end.
class ColourGathering {
 public:
  /// @param words three or four numbers. @return false when one is no number
  bool add(std::size_t element, std::span<const std::string_view> words);

  /// Appends the channel: bytes when every element has integers 0..255, else numbers 0..1 with NaN for none.
  void finish(PolyMesh& mesh, Domain domain);

 private:
  std::vector<double> values_;  // four per element, up to the last that has a colour
  std::size_t width_ = 3;
  std::size_t count_ = 0;
  bool whole_ = true;  // no value was written with a point or an exponent
};

}  // namespace croquis
