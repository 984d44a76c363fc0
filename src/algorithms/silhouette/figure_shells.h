// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "algorithms/silhouette/joining/part_joining.h"
#include "algorithms/silhouette/skeleton/attachments.h"
#include "algorithms/silhouette/surface/shell.h"
#include "croquis/base/progress.h"
#include "croquis/silhouette/labelled_figure.h"

namespace croquis::silhouette {

struct FigureShells {
  std::vector<Shell> shells;                           ///< the sound ones, by their first objects
  std::vector<std::pair<Index, std::string>> refused;  ///< objects, and what is wrong with their surfaces
  std::vector<FailedJoin> failed;  ///< pairs to be kept apart; where there are any, the rest doesn't count
};

/// Joins the surfaces of attached objects and checks what comes of them: closed, manifold, showing what was drawn,
/// apart from all others on the numbers as they are and as files may round them. Without attachments nothing is checked
/// here.
/// Seams are rounded where that leaves everything sound, else those at fault with half the radius and so on, else not
/// at all.
/// @param surfaces of single objects, in the figure's order
/// @param faults   per surface what is wrong with it, empty for nothing
/// @param seams    radii of seams by pairs, sketch units; those of other pairs stay sharp
/// @throws Cancelled
FigureShells make_shells(const LabelledFigure& figure, std::vector<Shell> surfaces,
                         const std::vector<std::string>& faults, const Attachments& attachments,
                         const std::map<ObjectPair, double>& seams, Progress& progress);

}  // namespace croquis::silhouette
