// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <limits>
#include <span>
#include <type_traits>
#include <vector>

#include "croquis/geometry/mesh_topology.h"
#include "croquis/geometry/poly_mesh.h"

/// Values of channels: as their types store them, of edges when the faces of a mesh change, and tags as edges' values.
namespace croquis {

/// The value as a channel of that type stores it: whole numbers are rounded and kept within what the type can hold;
/// what is no number is the least of them.
template <typename T>
T stored_value(double value) {
  if constexpr (std::is_floating_point_v<T>) {
    return static_cast<T>(value);
  } else {
    if (!(value > static_cast<double>(std::numeric_limits<T>::min()))) return std::numeric_limits<T>::min();
    if (value >= static_cast<double>(std::numeric_limits<T>::max())) return std::numeric_limits<T>::max();
    return static_cast<T>(std::round(value));
  }
}

/// The edge between two vertices, or no_index; also where a vertex isn't there. O(valence of the first).
Index find_edge(const MeshTopology& topology, Index a, Index b);

/// 0 for what isn't above 0, infinite from greatest_sharpness on.
double normal_sharpness(double sharpness);

/// Sharpness of each edge, 0 without a tag; tags on what is no edge are left out. Of two tags on an edge the sharper
/// one counts.
/// @return #E, see normal_sharpness
std::vector<double> edge_sharpness(const MeshTags& tags, const MeshTopology& topology);

/// The channel with element i taken from element sources[i]. An element without a source (no_index) gets NaN, "none
/// here", in a floating channel and 0 in others.
/// @param channel of as many values as its elements times its width
AttributeChannel gathered(const AttributeChannel& channel, std::span<const Index> sources);

/// Gives the edge channels of a mesh whose faces have changed the values of its own edges: each takes that of the edge
/// that joined the same vertices before, or none (see gathered). Nothing happens where there are no edge channels.
/// @param before        the mesh that the values were made for
/// @param vertex_source per vertex of `after` its number in `before`, or no_index; empty: the same vertices
/// @param after         its edge channels still hold the values of `before`; those of another length are left alone
void renumber_edge_channels(const PolyMesh& before, std::span<const Index> vertex_source, PolyMesh& after);

}  // namespace croquis
