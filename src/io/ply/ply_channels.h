// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/ply/ply_columns.h"

namespace croquis {

/// Turns the scalar columns that are left in the table (those with values) into channels of the mesh, joining the parts
/// of normals, colours, texture coordinates and name_0 name_1 …
void add_scalar_channels(PlyTable& table, Domain domain, PolyMesh& mesh);

/// Turns face lists with the same number of values for each corner into corner channels; an empty list means "none"
/// for floating types. Other lists are passed over with a warning.
void add_corner_channels(PlyTable& faces, PolyMesh& mesh, ReadContext& context);

}  // namespace croquis
