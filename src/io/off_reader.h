// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/read_context.h"

namespace croquis {

/// OFF as Geomview defines it ([ST][C][N]OFF, three dimensions, text): vertices with normals, colours and texture
/// coordinates in that order, faces with colours.
PolyMesh read_off(std::string_view bytes, ReadContext& context);

}  // namespace croquis
