// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/obj/obj_corner_table.h"

#include <algorithm>
#include <limits>

#include "io/channel_values.h"

namespace croquis {

void ObjCornerTable::add(const double (&values)[3], int given) {
  values_.insert(values_.end(), values, values + 3);
  width_ = std::max(width_, given);
}

void ObjCornerTable::corner_added(Index entry, std::size_t corners_before) {
  if (entry == no_index && entries_.empty()) return;
  entries_.resize(corners_before, no_index);
  entries_.push_back(entry);
}

bool ObjCornerTable::follows_vertices(const PolyMesh& mesh) const {
  return size() == mesh.vertex_count() && entries_ == mesh.corners;
}

void ObjCornerTable::finish(PolyMesh& mesh) {
  const bool on_vertices = follows_vertices(mesh);
  if (size() == 0 || !(used() || on_vertices)) return;
  const auto width = static_cast<std::size_t>(width_);
  const std::size_t count = on_vertices ? size() : mesh.corners.size();
  entries_.resize(mesh.corners.size(), no_index);
  std::vector<double> values(count * width, std::numeric_limits<double>::quiet_NaN());
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t entry = on_vertices ? i : entries_[i];
    if (entry == no_index) continue;
    std::copy_n(values_.begin() + static_cast<std::ptrdiff_t>(3 * entry), width,
                values.begin() + static_cast<std::ptrdiff_t>(i * width));
  }
  mesh.channels.push_back(
      make_channel(name_, on_vertices ? Domain::Vertex : Domain::Corner, width_, std::move(values)));
}

}  // namespace croquis
