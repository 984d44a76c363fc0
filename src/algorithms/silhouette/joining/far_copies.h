// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include "algorithms/silhouette/surface/shell.h"
#include "croquis/silhouette/labelled_figure.h"

/// Second ones of parts on the far side of a body: the legs and ears that a drawing from the side hides.
namespace croquis::silhouette {

/// Copies are numbered behind all objects that were drawn, in the same order.
inline Index copy_of(const LabelledFigure& figure, Index object) {
  return object + static_cast<Index>(figure.objects.size());
}
inline bool is_copy(const LabelledFigure& figure, Index object) { return object >= figure.objects.size(); }

/// The object that was drawn, of a copy or of itself.
inline Index drawn_object(const LabelledFigure& figure, Index object) {
  return is_copy(figure, object) ? object - static_cast<Index>(figure.objects.size()) : object;
}

/// Surfaces of single objects and how they are held together.
struct HeldSurfaces {
  std::vector<Shell> surfaces;
  std::vector<std::string> faults;     ///< per surface, empty for nothing
  Attachments attachments;             ///< of the figure's objects
  std::map<ObjectPair, double> seams;  ///< their radii
};

/// Sheets have as many vertices in front as behind: their mean lies in the middle.
double middle_depth(const PolyMesh& surface);

/// Adds the copies: an object's surface mirrored at the plane in the middle of the depth of what it belongs to, which
/// is the nearest object along attachments that isn't copied itself. x and y of its vertices are the same numbers. A
/// copy is held as its object is, by that one and by other copies.
/// @param copied ascending, objects of the figure; those whose surface isn't there have no copy
/// @return the objects that belong to nothing, and so have no copy, ascending
std::vector<Index> add_far_copies(const LabelledFigure& figure, const std::vector<Index>& copied, HeldSurfaces& held);

}  // namespace croquis::silhouette
