// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "croquis/attribute_surface/surface_measures.h"

namespace croquis {

/// What can be measured of one face alone.
struct FaceMeasures {
  PatchMeasures patch;        ///< without the face's number and its folds
  double boundary_error = 0;  ///< model units

  std::size_t byte_size() const { return sizeof *this + patch.side_lengths.size() * sizeof(double); }
};

FaceMeasures measure_face(const FaceSurface& surface);

}  // namespace croquis
