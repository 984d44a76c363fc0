// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "croquis/base/finding.h"
#include "croquis/geometry/mesh_tags.h"
#include "croquis/geometry/vector.h"

namespace croquis {

/// What an attribute's values belong to. Edges are those of the faces in the numbering of MeshTopology: by the lowest
/// corner that starts them, which follows from `face_offsets` and `corners` alone.
enum class Domain { Vertex, Face, Corner, Line, Edge };

/// One named attribute: `width` values per element of its domain, in the type its file had.
///
/// Names with a meaning across formats: "normal" (3), "color" (3 or 4, integer types 0..255, floating 0..1),
/// "uv" (2 or 3), "group", "object" and "material" (1, an index into `labels`), "smoothing_group" (1).
/// A NaN in a floating channel means "none here".
struct AttributeChannel {
  using Data = std::variant<std::vector<std::int8_t>, std::vector<std::uint8_t>, std::vector<std::int16_t>,
                            std::vector<std::uint16_t>, std::vector<std::int32_t>, std::vector<std::uint32_t>,
                            std::vector<float>, std::vector<double>>;

  std::string name;
  Domain domain = Domain::Vertex;
  int width = 1;
  Data data;
  std::vector<std::string> labels;  ///< names of categories, where the values are indices into them

  std::size_t size() const;  ///< number of values, width × elements
};

/// A mesh as a plain value: polygons with any number of corners, polylines, and named attributes.
///
/// It may hold a soup: nothing here promises manifoldness; `validate` lists what is wrong and MeshTopology builds the
/// neighbourhoods. Indices are 0-based.
struct PolyMesh {
  std::vector<Vec3> positions;            ///< #V
  std::vector<Index> face_offsets = {0};  ///< #F+1, ascending: face f has corners [face_offsets[f], face_offsets[f+1])
  std::vector<Index> corners;             ///< #C, the vertex of each corner, faces counter-clockwise from outside
  std::vector<Index> line_offsets = {0};  ///< #L+1, like face_offsets
  std::vector<Index> line_vertices;       ///< the vertices of each polyline in order
  std::vector<AttributeChannel> channels;
  MeshTags tags;  ///< sharp edges and pinned vertices, for subdivision

  std::size_t vertex_count() const { return positions.size(); }
  std::size_t face_count() const { return face_offsets.size() - 1; }
  std::size_t line_count() const { return line_offsets.size() - 1; }

  std::span<const Index> face(std::size_t f) const {
    return {corners.data() + face_offsets[f], corners.data() + face_offsets[f + 1]};
  }
  std::span<const Index> line(std::size_t l) const {
    return {line_vertices.data() + line_offsets[l], line_vertices.data() + line_offsets[l + 1]};
  }

  void add_face(std::span<const Index> vertices);
  void add_triangle(Index a, Index b, Index c);
  void add_line(std::span<const Index> vertices);

  /// Number of elements of a domain. Edges are counted anew each time, in O(#C log #C); all others are known.
  std::size_t element_count(Domain domain) const;

  /// Whether any channel has values of edges: what changes faces then has to renumber these.
  bool has_edge_channels() const;

  /// The channel of that name and domain, or null.
  const AttributeChannel* channel(std::string_view name, Domain domain) const;
  AttributeChannel* channel(std::string_view name, Domain domain);
};

/// What makes the value itself unusable: offsets that descend, indices out of range (E_INDEX), positions that are not
/// finite (E_NOT_FINITE), faces with fewer than 3 or repeated vertices (E_FACE_DEGENERATE), channels of a wrong length
/// (E_COUNT). All of them, each naming its element; at most 100 per kind, the last one saying how many more.
Findings validate(const PolyMesh& mesh);

}  // namespace croquis
