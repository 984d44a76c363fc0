// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "croquis/geometry/attribute_network.h"

namespace croquis {

/// A row of points between two nodes, which is to become curves.
struct CurveChain {
  std::string name;       ///< of its curves: as it is, or "NAME/1", "NAME/2" … where it takes several
  Index from = no_index;  ///< nodes of the network, at the row's ends
  Index to = no_index;
  std::vector<Vec3> points;             ///< at least 2, neighbours different, ends at the nodes
  std::optional<Vec3> start_direction;  ///< unit, along the row
  std::optional<Vec3> end_direction;
};

/// A curve that was made, and which of its row's points lie along it.
struct ChainCurve {
  Index curve = no_index;
  std::size_t first = 0;
  std::size_t last = 0;
};

/// Makes curves of rows of points, and names that are free.
class ChainCurves {
 public:
  /// @param network   grows; its nodes and curves are taken to have different names
  /// @param tolerance model units, > 0
  ChainCurves(AttributeNetwork& network, double tolerance) : network_(network), tolerance_(tolerance) {}

  Index add_node(const Vec3& point);

  /// The curves of a row, in its order, with nodes between them.
  std::vector<ChainCurve> add(const CurveChain& chain);

 private:
  std::string free_name(const std::string& name);

  AttributeNetwork& network_;
  double tolerance_;
  std::set<std::string> names_;
};

}  // namespace croquis
