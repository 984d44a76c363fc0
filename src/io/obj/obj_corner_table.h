// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "croquis/geometry/poly_mesh.h"

namespace croquis {

/// A table of OBJ's (`vt`, `vn`) and which of its entries each corner uses.
class ObjCornerTable {
 public:
  ObjCornerTable(const char* name, int least_width) : name_(name), width_(least_width) {}

  std::size_t size() const { return values_.size() / 3; }
  void add(const double (&values)[3], int given);

  /// @param entry index into the table, or no_index
  void corner_added(Index entry, std::size_t corners_before);

  /// Some corner uses an entry.
  bool used() const { return !entries_.empty(); }

  /// Appends the channel: on vertices where every corner uses the entry of its vertex' own number, else on corners.
  void finish(PolyMesh& mesh);

 private:
  bool follows_vertices(const PolyMesh& mesh) const;

  const char* name_;
  int width_;
  std::vector<double> values_;  // three per entry
  std::vector<Index> entries_;  // per corner, empty until one is used
};

}  // namespace croquis
