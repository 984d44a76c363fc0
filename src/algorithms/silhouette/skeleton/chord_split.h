// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "algorithms/silhouette/skeleton/skeleton.h"
#include "croquis/silhouette/labelled_figure.h"

namespace croquis::silhouette {

/// Splits the chords of nodes at the borders of the panels that they pass through: each panel but the node's own gets a
/// node of its own in the middle of the chord's stretch there, joined to the old node,
/// as thick as the old node's circle is there. A chord that spans places of
/// opposite order may then tilt instead of making rows that contradict each other.
/// @return number of chords split; a chord within one panel isn't
std::size_t split_chords(std::span<const Index> nodes, const LabelledFigure& figure, Skeleton& skeleton);

}  // namespace croquis::silhouette
