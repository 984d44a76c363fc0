// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "croquis/geometry/vector.h"

namespace croquis::remeshing {

/// Two components that lie upon each other along their rims.
struct ViewPair {
  Index first = no_index, second = no_index;
  std::size_t count = 0;  ///< of rim vertices where they do
  bool opposed = false;   ///< and face opposite ways there
};

/// Which components are to be turned over so that pairs agree: along the pairs with the largest counts first, each
/// component once; of those that are joined that way the smaller part by area, of two equal ones that without the
/// lowest component. Ascending.
/// @param areas per component
std::vector<Index> minority_of(std::vector<ViewPair> pairs, const std::vector<double>& areas);

}  // namespace croquis::remeshing
