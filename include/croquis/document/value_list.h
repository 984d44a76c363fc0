// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "croquis/base/report.h"
#include "croquis/geometry/attribute_network.h"
#include "croquis/geometry/brep.h"
#include "croquis/geometry/camera.h"
#include "croquis/geometry/curve_network.h"
#include "croquis/geometry/drawing.h"
#include "croquis/geometry/perspective_drawing.h"
#include "croquis/geometry/picture_file.h"
#include "croquis/geometry/poly_mesh.h"

/// All types of values, one line each: the type, and the name of its row in the table (ValueTraits::Mesh) and of its
/// ValueType. The row itself stands in src/document/values/<type>_value.cpp; docs/adding-a-value.md shows how to write
/// one. Nothing else lists the types.
// clang-format off
#define CROQUIS_VALUE_TYPES(line)            \
  line(PolyMesh, Mesh)                       \
  line(Drawing, Drawing)                     \
  line(Report, Report)                       \
  line(Camera, Camera)                       \
  line(PerspectiveDrawing, PerspectiveDrawing) \
  line(CurveNetwork, CurveNetwork)           \
  line(Brep, Brep)                           \
  line(AttributeNetwork, AttributeNetwork)   \
  line(PictureFile, PictureFile)
// clang-format on
