// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "croquis/geometry/poly_mesh.h"

namespace croquis {

/// The code of the error of edits whose elements have the numbers of a mesh that is joined in another way.
inline constexpr const char* connectivity_code = "E_CONNECTIVITY";

/// A name for how the faces of a mesh are joined: positions don't count. Numbers of elements mean the same in meshes of
/// one name. O(#corners)
std::string connectivity_name(const PolyMesh& mesh);

}  // namespace croquis
