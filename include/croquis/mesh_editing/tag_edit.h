// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "croquis/geometry/edge_channels.h"
#include "croquis/geometry/mesh_tags.h"
#include "croquis/mesh_editing/mesh_selection.h"

/// Every change that the tools make to a mesh's tags: pure functions from tags to tags. Tags that they don't name stay
/// as they are, in their order. Sharpness: 0 is none; from greatest_sharpness on it is infinite. O((#tags + #elements)
/// log #tags), and linear in the mesh where all edges are asked for.
///
/// The rim of a mesh is sharp in all schemes without a tag. A tag on it changes no picture while it is a rim; it makes
/// the edge sharp as soon as something is built on to it.
namespace croquis {

/// Edges that have a tag.
Elements tagged_edges(const MeshTags& tags, const MeshTopology& topology);

/// Gives edges that sharpness. With 0 they lose their tags, and with them their places in sets.
MeshTags with_sharpness(const MeshTags& tags, const MeshTopology& topology, std::span<const Index> edges,
                        double sharpness);

/// Adds to each edge's own sharpness. Infinite ones come down from greatest_sharpness.
MeshTags with_sharpness_changed(const MeshTags& tags, const MeshTopology& topology, std::span<const Index> edges,
                                double by);

/// Pins vertices, or lets them go; those let go leave their sets.
MeshTags with_pins(const MeshTags& tags, std::span<const Index> vertices, bool pinned);

// ---- Sets: an edge or pin is in one set at most. Sets left without members vanish.

const CreaseSet* find_set(const MeshTags& tags, std::string_view name);  ///< or null

/// A name that no set has: "crease set 1" …
std::string new_set_name(const MeshTags& tags);

/// Makes a set of edges and vertices, which get tags and pins for it and leave the sets they were in.
/// @throws Error (E_INPUT) when the name is empty or taken, the sharpness is none, or there are no members
MeshTags with_set(const MeshTags& tags, const MeshTopology& topology, const std::string& name,
                  std::span<const Index> edges, std::span<const Index> vertices, double sharpness);

/// @throws Error (E_INPUT) when there is no such set, or the new name is empty or taken
MeshTags with_set_renamed(const MeshTags& tags, std::string_view name, const std::string& new_name);

/// Gives the set, and all edges in it, a sharpness; with 0 they lose their tags, and the set its edges.
/// @throws Error (E_INPUT) when there is no such set
MeshTags with_set_sharpness(const MeshTags& tags, std::string_view name, double sharpness);

/// Puts the members of the second set into the first one, whose sharpness they get.
/// @throws Error (E_INPUT) when there is no such set, or both are the same
MeshTags with_sets_merged(const MeshTags& tags, std::string_view into, std::string_view from);

/// Forgets a set. @param untag its members also lose their tags and pins
/// @throws Error (E_INPUT) when there is no such set
MeshTags without_set(const MeshTags& tags, std::string_view name, bool untag);

/// Members of a set that are edges of the mesh.
Elements set_edges(const CreaseSet& set, const MeshTopology& topology);
/// Pinned members of a set.
Elements set_vertices(const CreaseSet& set, const MeshTopology& topology);

}  // namespace croquis
