// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "croquis/base/stage_key.h"
#include "croquis/geometry/drawing.h"
#include "croquis/geometry/poly_mesh.h"
#include "croquis/silhouette/labelled_figure.h"

namespace croquis::silhouette {

struct Skeleton;
struct SheetSampling;

// What stages depend on, for their keys.
void add_drawing(const Drawing& drawing, StageKey& key);
/// What skeleton and surface depend on.
void add_shape(const LabelledFigure& figure, StageKey& key);
/// What findings hold besides: names and strokes.
void add_names(const LabelledFigure& figure, const Drawing& drawing, StageKey& key);
/// Without heights.
void add_shape(const Skeleton& skeleton, StageKey& key);

// About what results take in memory.
std::size_t bytes_of(const PolyMesh& mesh);
std::size_t bytes_of(const LabelledDrawing& labelled);
std::size_t bytes_of(const Skeleton& skeleton);
std::size_t bytes_of(const SheetSampling& sheets);

}  // namespace croquis::silhouette
