// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/read_context.h"

namespace croquis {

/// Wavefront OBJ (Advanced Visualizer manual, appendix B1): vertices, faces and polylines, and the tags for
/// subdivision that OpenSubdiv's shapes add (see ObjTagReader); free-form geometry, points and display attributes are
/// passed over with a warning.
PolyMesh read_obj(std::string_view bytes, ReadContext& context);

}  // namespace croquis
