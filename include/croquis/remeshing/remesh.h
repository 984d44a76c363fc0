// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "croquis/hole_filling/fill_holes.h"

namespace croquis::remeshing {

/// How the whole model is remeshed. Lengths "× cell" are fractions of the cubes' edge.
struct RemeshOptions {
  /// Which holes (selection, only, max_diameter, requests that fill or leave), kernel and smoothing (implicit), preset,
  /// marks, precision, threads; and by which patches openings are closed that the field leaves.
  hole_filling::FillOptions fill;

  double overlap = 0.25;         ///< how much larger than their boxes domains are, 0..1
  std::size_t leaf_points = 40;  ///< a box with more points of its own is cut in eight
  std::size_t min_points = 30;   ///< a domain with fewer takes so many nearest ones
  std::size_t max_points = 300;  ///< a domain with more is thinned; 2000 at most
  double cell = 1;      ///< edge of the cubes, × mean edge of the mesh (a 40th of its diagonal, if that is less)
  int smoothing = 2;    ///< rounds of smoothing with projection (Yoo 2005, eq. 9)
  int refine = 0;       ///< every triangle is cut in four so often (4 at most), with projection
  double chord = 0;     ///< refine ends once edges are as near to the surface as this, model units; 0: never
  double snap = 0;      ///< vertices within this distance of one given move there, × cell; usual 0.3
  double adaptive = 0;  ///< faces are merged where the surface is flat, by so much × cell at most; 0: none are, usual
                        ///< 0.1, 1 at most
  double min_component = 0;      ///< smaller pieces of the mesh are left out, as fraction of its triangles
  std::size_t slab_points = 0;   ///< that a slab of the model has, about: no bit of the result depends on it. 0: usual
  std::size_t memory_limit = 0;  ///< bytes; a model that needs more at least is refused. 0: none
};

/// The options as a preset has them; those for single values may be changed afterwards.
///
/// Paper: r^2 log r, offset points outside alone, boxes of equal size, 10 % overlap, and no boxes around holes. Noisy:
/// ten times the smoothing of values, six times that of gradients. Sharp: cubes of half the size, and vertices within
/// 0.3 of one move onto those given, so that edges that were drawn stay; edges inside holes come out round.
RemeshOptions remesh_preset(hole_filling::Preset preset);

/// What the result was proven to be.
struct RemeshChecks {
  std::size_t components = 0;          ///< pieces that came out
  std::size_t open_loops = 0;          ///< rims of the result, wanted or not
  std::size_t failed_loops = 0;        ///< of these, the ones where no rim was left open on purpose
  std::size_t repaired_loops = 0;      ///< openings of the field that were closed by patches
  std::size_t self_intersections = 0;  ///< pairs of faces
  std::size_t piece_crossings = 0;     ///< of these, the ones of different pieces, or of solids of several
  std::size_t united_pieces = 0;       ///< pieces given that crossed others and are one solid with these
  std::size_t joined_views = 0;        ///< sheets given that go on in others and became one surface with these,
                                       ///< islands in their holes left out
  std::size_t turned_views = 0;        ///< sheets that faced the other way than those that they lie upon
  std::size_t lost_points = 0;         ///< vertices given that no new one is within 1.25 cells of
  std::size_t loose_points = 0;        ///< new vertices farther than half a cell off the scan, but in holes
  std::size_t far_points = 0;          ///< new vertices farther than a twentieth of the model's diagonal off the scan
  double far_share = 0;                ///< of the area: faces at these, 0..1
  bool manifold = false;               ///< no edge of more than two faces, no vertex of more than one fan
};

struct RemeshResult {
  PolyMesh
      mesh;  ///< triangles; vertices with their channels from the mesh given, "confidence" and, for faces, "patch_id"
  hole_filling::HoleAnalysis analysis;              ///< of the mesh given
  std::vector<hole_filling::HoleOutcome> outcomes;  ///< per hole of the analysis
  std::size_t domains = 0;                          ///< with points, those of holes included
  hole_filling::DomainPointCounts points_per_domain;
  RemeshChecks checks;
  std::size_t slabs = 0;            ///< that the piece with most of them was made in
  std::size_t predicted_bytes = 0;  ///< see predicted_remesh_bytes
  std::size_t predicted_faces = 0;  ///< of cells as asked for, at most about; smaller ones of retries give more
  std::size_t full_faces = 0;       ///< before faces were merged (adaptive)
  double coarsening = 1;            ///< what cells were larger by than asked for, so that faces aren't too many
  Findings warnings;
};

/// The most that remesh_surface will hold at a time, in bytes, the mesh given not counted: also while pieces that come
/// out torn are tried with smaller cells, or that cross are made one solid. Such tries are left out where they would
/// exceed the limit, or 1.5 GB without one. Linear, and allocates nothing.
std::size_t predicted_remesh_bytes(const PolyMesh& mesh, const RemeshOptions& options);

/// Remeshes a model from one function (Yoo 2005): radial basis functions fitted in small overlapping domains to its
/// vertices and normals, one larger domain for each hole, blended; the zero set polygonised from every vertex,
/// smoothed, and verified. Holes that are chosen are closed, the others stay open.
///
/// Pieces that the mesh doesn't join, and no hole that is filled does, get functions of their own: they never grow
/// together, however near (under Preset::Paper one function has them all). Sheets that go on in one another along their
/// rims, as overlapping views of one thing do, are one piece: these rims are no holes, but what all of them leave open
/// is. Only where the surfaces made cross each other, these pieces are polygonised again as one solid: the union of
/// what they enclose, less their cavities. Openings that the field leaves are distinguished from rims left open, and
/// closed by patches, of a model made once more without those holes (where requests name some, with larger boxes
/// first); what stays open all the same is a hole with FillAction::Failed. Vertices have the channels of the nearest
/// place of the mesh; channels of faces and corners end here.
///
/// Near-linear in vertices and in triangles of the result. The same for any number of threads.
/// @throws Error as fill_holes; E_PARAMETER for options out of range; E_MEMORY (Category::Limit) before anything large
///         is allocated
/// @throws Cancelled
RemeshResult remesh_surface(const PolyMesh& mesh, const RemeshOptions& options, Progress& progress);

}  // namespace croquis::remeshing
