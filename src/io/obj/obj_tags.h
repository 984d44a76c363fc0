// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "croquis/geometry/mesh_tags.h"
#include "io/read_context.h"
#include "io/text.h"

namespace croquis {

/// Reads `t crease` and `t corner` as OpenSubdiv's shape files have them: NAME, INTS/FLOATS/STRINGS, and so many values
/// (`t crease 2/1/0 A B SHARPNESS`, `t corner 1/1/0 V SHARPNESS`). Vertices count from 0, 10 and more is infinite.
///
/// One statement may tag several edges or vertices, with one sharpness for all or one for each. A corner is a pin;
/// where its sharpness isn't infinite a W_TAG_SHARPNESS says so. Malformed ones are E_SYNTAX. Whether there are such
/// edges is not looked at.
/// @return the name of a tag of another kind, else nothing
std::string_view read_obj_tag(WordReader& words, std::int64_t line, MeshTags& tags, ReadContext& context);

/// The statements that read back as these tags; sets are left out.
void append_obj_tags(const MeshTags& tags, int precision, std::string& text);

}  // namespace croquis
