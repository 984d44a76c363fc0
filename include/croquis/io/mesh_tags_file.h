// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "croquis/base/finding.h"
#include "croquis/base/report.h"
#include "croquis/geometry/mesh_tags.h"

/// Tags of a mesh in the format croquis-tags-1, which is JSON once it is written:
///
///     {"format": "croquis-tags-1", "index_base": 0,
///      "edges": [{"v": [A, B], "sharpness": NUMBER or "inf"}], "pins": [VERTEX],
///      "sets": [{"name": TEXT, "sharpness": NUMBER or "inf", "edges": [[A, B]], "pins": [VERTEX]}]}
///
/// All but `format` may be absent; `sets` is written only where there are some.
namespace croquis {

Report report_of(const MeshTags& tags);

struct MeshTagsReadResult {
  MeshTags tags;
  Findings warnings;  ///< W_IGNORED, for each name of a member that the format doesn't have
};

/// Reads tags whatever their index_base, which is 0 or 1. Whether they fit a mesh is not looked at. O(#tags log #names)
/// @throws Error Malformed, all findings together (at most 100), each naming its place (such as `edges[3].v`): E_SYNTAX
///         for another format and for what isn't of this one, E_INDEX for vertices below index_base or above 32 bits
MeshTagsReadResult read_mesh_tags(const Report& report);

}  // namespace croquis
