// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "croquis/geometry/poly_mesh.h"

namespace croquis {

/// Gathers what a format can't hold, for the one warning that goes with the written file.
class FormatLoss {
 public:
  explicit FormatLoss(std::string format) : format_(std::move(format)) {}

  void note(std::string what) { parts_.push_back(std::move(what)); }
  void note_channel(const AttributeChannel& channel);

  /// Every channel of the mesh that is not among those written.
  void note_others(const PolyMesh& mesh, const std::vector<const AttributeChannel*>& written);

  /// That polygons are cut into triangles, if some are.
  void note_polygons(const PolyMesh& mesh);

  /// All tags, if there are any.
  void note_tags(const MeshTags& tags);

  /// That tags go into named sets, if some do.
  void note_sets(const MeshTags& tags);

  /// Nothing, or one W_FORMAT_LOSS.
  Findings warnings() const;

 private:
  std::string format_;
  std::vector<std::string> parts_;
};

}  // namespace croquis
