// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/read_context.h"

namespace croquis {

/// STL, text or binary, distinguished by the size in the binary header before the word "solid". Equal corners
/// are joined; the facets' own normals are redundant and not kept.
PolyMesh read_stl(std::string_view bytes, ReadContext& context);

}  // namespace croquis
