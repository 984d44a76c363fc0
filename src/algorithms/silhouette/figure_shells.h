// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "algorithms/silhouette/joining/part_joining.h"
#include "algorithms/silhouette/skeleton/attachments.h"
#include "algorithms/silhouette/surface/sheet_surface.h"
#include "croquis/base/progress.h"
#include "croquis/geometry/poly_mesh.h"
#include "croquis/silhouette/labelled_figure.h"

namespace croquis::silhouette {

/// A closed surface: of one object, or of several joined.
struct FigureShell {
  PolyMesh mesh;
  std::vector<Index> objects;           ///< of the figure, ascending
  std::vector<Index> face_objects;      ///< per face; empty: all are the only object's
  int euler = 0;                        ///< counted
  std::map<ObjectPair, double> blends;  ///< radii of its rounded seams, in parts of what was asked for
};

struct FigureShells {
  std::vector<FigureShell> shells;                     ///< the sound ones, by their first objects
  std::vector<std::pair<Index, std::string>> refused;  ///< objects, and what is wrong with their surfaces
  std::vector<FailedJoin> failed;  ///< pairs to be kept apart; where there are any, the rest doesn't count
};

/// The surface of one object and what is wrong with it, empty for nothing.
struct CheckedSurface {
  const ObjectSurface* surface = nullptr;
  std::string fault;
};

/// Joins the surfaces of attached objects and checks what comes of them: closed, manifold, showing what was drawn,
/// apart from all others on the numbers as they are and as files may round them. Without attachments nothing is checked
/// here.
/// Seams are rounded where that leaves everything sound, else those at fault with half the radius and so on, else not
/// at all.
/// @param surfaces per object that has one, in the figure's order
/// @param seams    radii of seams by pairs, sketch units; those of other pairs stay sharp
/// @throws Cancelled
FigureShells make_shells(const LabelledFigure& figure, const std::vector<CheckedSurface>& surfaces,
                         const Attachments& attachments, const std::map<ObjectPair, double>& seams, Progress& progress);

}  // namespace croquis::silhouette
