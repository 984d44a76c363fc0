// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "croquis/geometry/poly_mesh.h"
#include "io/read_context.h"
#include "io/text.h"

namespace croquis {

/// Reads `t crease` and `t corner` as OpenSubdiv's shape files have them: NAME, INTS/FLOATS/STRINGS, and so many values
/// (`t crease 2/1/0 A B SHARPNESS`, `t corner 1/1/0 V SHARPNESS`). Vertices count from 0, 10 and more is infinite.
///
/// One statement may tag several edges or vertices, with one sharpness for all or one for each. A corner is a pin;
/// where its sharpness isn't infinite there is a W_TAG_SHARPNESS. Malformed ones are E_SYNTAX. Whether such edges
/// exist is not checked. `t settled 1/0/0 V` is our own: the channel "settled_corner", by which a refinement that
/// goes on from a file knows corners that an earlier one has made; others pass over tags that they don't know.
class ObjTagReader {
 public:
  /// @return the name of a tag of another kind, else nothing
  std::string_view read(WordReader& words, std::int64_t line, ReadContext& context);

  /// Puts the tags, and the channel if there are settled corners, into the mesh, whose vertices are complete.
  void finish(PolyMesh& mesh, ReadContext& context);

 private:
  struct Settled {
    Index vertex;
    std::int64_t line;
  };

  MeshTags tags_;
  std::vector<Settled> settled_;
};

/// The statements that read back as these tags; sets are left out.
/// @param settled the channel "settled_corner" of vertices, or null
void append_obj_tags(const MeshTags& tags, const AttributeChannel* settled, int precision, std::string& text);

inline constexpr const char* settled_channel_name = "settled_corner";

}  // namespace croquis
