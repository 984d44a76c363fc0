// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "algorithms/subdivision/refinement/new_points.h"
#include "algorithms/subdivision/refinement/sectors.h"
#include "algorithms/subdivision/refinement/tag_classes.h"

namespace croquis::subdivision {

/// Which elements of a level take the plain rules.
struct PlainParts {
  Compaction edges;              ///< both ends plain: their face is a quad
  Compaction vertices;           ///< plain, with plain edges: their face and all its neighbours are plain too
  Compaction faces;              ///< without corners that aren't plain
  std::vector<Index> bordering;  ///< plain vertices with edges that aren't, ascending
};

PlainParts find_plain_parts(const HalfEdges& mesh, const CornerFaces& around, const TagClasses& classes);

/// New faces listed corner by corner.
struct FaceList {
  std::vector<Index> offsets = {0};
  std::vector<Index> vertices;
  std::vector<FaceOrigin> origins;

  std::size_t size() const { return origins.size(); }
  std::span<const Index> operator[](std::size_t f) const {
    return std::span(vertices).subspan(offsets[f], offsets[f + 1] - offsets[f]);
  }
};

/// What the tagged neighbourhood needs, together; references to what lives during one refinement.
struct Neighbourhood {
  const Level& level;
  const CornerFaces& around;
  const TagClasses& classes;
  const Sectors& sectors;
  const NewPoints& points;
};

/// The new faces of all edges and vertices that aren't plain, and the bands. Vertices that follow one another are
/// dropped when equal, faces left with two corners too: the edges on both sides then are one.
FaceList list_special_faces(const Neighbourhood& near, const PlainParts& plain);

}  // namespace croquis::subdivision
