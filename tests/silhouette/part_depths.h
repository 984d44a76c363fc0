// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include "croquis/silhouette/solid.h"

/// How the parts of a solid lie behind one another, measured on its mesh.
namespace croquis::test {

struct PartDepth {
  std::string name;
  double low = 0;  ///< sketch units, along z
  double high = 0;
  double slope = 0;  ///< of the plane that is nearest to its vertices along z: rise per length

  double depth() const { return high - low; }
  double middle() const { return (low + high) / 2; }
};

/// One per object, in the order of the mesh's labels. Of joined objects only what can be seen counts.
std::vector<PartDepth> part_depths(const silhouette::Solid& solid);

/// The same by the names of objects.
std::map<std::string, PartDepth> depths_by_name(const silhouette::Solid& solid);

/// From the first of their middles to the last, over the sum of their depths: 0 where all lie in one plane, and below 1
/// in a stack of parts that touch.
double middle_spread(const std::vector<PartDepth>& parts);

double steepest(const std::vector<PartDepth>& parts);

}  // namespace croquis::test
