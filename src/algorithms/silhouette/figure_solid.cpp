// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/figure_solid.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <string>
#include <utility>

#include "algorithms/silhouette/sampling/rims.h"
#include "algorithms/silhouette/skeleton/chordal_axis.h"
#include "algorithms/silhouette/skeleton/rest_depths.h"
#include "algorithms/silhouette/stage.h"
#include "algorithms/silhouette/strokes/drawing_findings.h"
#include "algorithms/silhouette/surface/certificate.h"
#include "algorithms/silhouette/surface/inflation.h"
#include "algorithms/silhouette/surface/sheet_mesh.h"
#include "croquis/geometry/disjoint_sets.h"

namespace croquis::silhouette {
namespace {

/// How often a figure is made again with less attached. What fails then is left apart with all that hangs together with
/// it.
constexpr int max_joining_rounds = 6;

const char* sentence_of(JoinFault fault) {
  switch (fault) {
    case JoinFault::DontMeet:
      return " could not be joined, since their surfaces don't meet, and were kept apart: let them sink deeper, or "
             "draw them further over one another";
    case JoinFault::Unsolved:
      return " could not be joined, since no depth holds them together, and were kept apart: attach fewer parts, or "
             "draw thin ones wider";
    case JoinFault::Unsound: break;
  }
  return " could not be joined to one sound surface and were kept apart: change how deep they sink, or draw them "
         "further over one another";
}

/// A figure to be made solid.
struct FigureTask {
  const LabelledFigure& figure;
  const Drawing& drawing;
  FigureSettings settings;  ///< attachments that failed are released
};

Finding not_joined(const FigureTask& task, const FailedJoin& failed) {
  const FigureObject& a = task.figure.objects[failed.pair.first];
  const FigureObject& b = task.figure.objects[failed.pair.second];
  std::vector<Subject> subjects = object_subjects(a, task.drawing);
  std::ranges::move(object_subjects(b, task.drawing), std::back_inserter(subjects));
  return make_warning(Category::Geometry, "W_ATTACH",
                      "The attached objects \"" + a.name + "\" and \"" + b.name + "\"" + sentence_of(failed.fault),
                      std::move(subjects));
}

Finding not_copied(const FigureTask& task, Index object, const std::string& sentence) {
  const FigureObject& copied = task.figure.objects[object];
  return make_warning(Category::Geometry, "W_FAR_COPY", "The copy of \"" + copied.name + sentence,
                      object_subjects(copied, task.drawing));
}

/// One solve of a figure with given attachments.
struct SolvedFigure {
  Skeleton skeleton;
  DepthResult depth;
  std::shared_ptr<const SheetBasis> basis;
  InflatedSheets sheets;
};

std::shared_ptr<const SheetBasis> sheet_basis(const FigureTask& task, const Skeleton& skeleton, Progress& progress) {
  const std::vector<Index> thin = thin_objects(task.settings.depth.thickness);
  StageKey key;
  if (task.settings.cache != nullptr) {
    add_shape(task.figure, key);
    add_shape(skeleton, key);
    key.add(task.settings.quality).add(thin);
  }
  return cached<SheetBasis>(
      task.settings.cache, "silhouette sheets", key,
      [&] { return make_sheet_basis(task.figure, skeleton, task.settings.quality, thin, progress); },
      [](const SheetBasis& basis) { return bytes_of(basis); });
}

void solve_once(const FigureTask& task, const Skeleton& axis, const DepthSettings& depth, SolvedFigure& solved,
                Progress& progress) {
  solved.skeleton = axis;
  Progress solving = progress.step("depth", 0.15);
  solved.depth = solve_depth(solved.skeleton, task.figure, depth, solving);
  Progress inflating = progress.step("inflate", 0.45);
  solved.basis = sheet_basis(task, solved.skeleton, inflating);
  Progress raising = progress.step("inflate", 0.4);
  solved.sheets = raise_sheets(solved.skeleton, *solved.basis, depth, raising);
}

/// Objects whose depths aren't exact enough, ascending.
std::vector<Index> unsolved(const FigureTask& task, const SolvedFigure& solved) {
  std::vector<Index> objects;
  for (Index object = 0; object < task.figure.objects.size(); ++object) {
    const auto exact = [&](const std::vector<double>& uncertainty) {
      return object >= uncertainty.size() || uncertainty[object] <= task.settings.depth.options.accuracy;
    };
    if (!exact(solved.depth.uncertainty) || !exact(solved.sheets.uncertainty)) objects.push_back(object);
  }
  return objects;
}

/// Where the depths of an object aren't found exactly enough, they are sought again: with parts that are equally hard
/// to move, and then with parts that are held as near to their places as can be.
SolvedFigure solve(const FigureTask& task, const Skeleton& axis, Progress& progress) {
  SolvedFigure solved;
  DepthSettings depth = task.settings.depth;
  Progress first = progress.step("depth", 0.8);
  solve_once(task, axis, depth, solved, first);
  for (int firmness = 1; firmness <= 2 && !unsolved(task, solved).empty(); ++firmness) {
    depth.equally_stiff = true;
    if (firmness == 2) depth.object_weights.assign(task.figure.objects.size(), {depth.options.weight_curvature, 1, 1});
    Progress again = progress.step("depth", 0.1);
    solve_once(task, axis, depth, solved, again);
  }
  for (const auto& [node, z] : solved.sheets.lowered_nodes) solved.skeleton.nodes[node].z = z;
  return solved;
}

/// What the sheets of one solve become with some triangles.
struct SurfacedFigure {
  FigureShells shells;
  std::map<Index, double> mirrored;  ///< see FigureSolid
  double depth_ratio = 0;
  Findings refusals;
};

void refuse(const FigureTask& task, Index object, const char* code, const std::string& before, const std::string& after,
            SurfacedFigure& made) {
  const FigureObject& refused = task.figure.objects[object];
  made.refusals.push_back(make_error(Category::Geometry, code, before + " \"" + refused.name + "\" " + after,
                                     object_subjects(refused, task.drawing)));
}

DepthRange depth_range(const Shell& surface) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  DepthRange range{surface.objects.front(), infinity, -infinity};
  for (const Vec3& position : surface.mesh.positions) {
    if (!std::isfinite(position.z())) return {range.object, -infinity, infinity};
    range.low = std::min(range.low, position.z());
    range.high = std::max(range.high, position.z());
  }
  return range;
}

/// Takes out the surfaces whose depths aren't exact enough, or more than explained. @return their objects, ascending
std::vector<Index> refuse_unsolved(const FigureTask& task, const SolvedFigure& solved, std::vector<Shell>& surfaces,
                                   SurfacedFigure& made) {
  const DepthOptions& options = task.settings.depth.options;
  std::vector<Index> refused = unsolved(task, solved);
  for (const Index object : refused) {
    refuse(task, object, "E_NOT_SOLVED", "The depth of",
           "could not be worked out exactly enough: draw its thin parts wider, or its lines further apart", made);
  }
  const auto is_refused = [&](Index object) { return std::ranges::binary_search(refused, object); };
  std::vector<DepthRange> ranges;
  for (const Shell& surface : surfaces) {
    if (!is_refused(surface.objects.front())) ranges.push_back(depth_range(surface));
  }
  const double gap = options.minimum_gap * solved.skeleton.scale;
  const double explained = explained_depth(task.figure, solved.skeleton, gap, task.settings.depth.thickness);
  const std::vector<Index> too_deep = objects_too_deep(ranges, options.depth_allowance * explained);
  for (const Index object : too_deep) {
    refuse(task, object, "E_NOT_SOLVED", "The depth found for",
           "is more than the widths of what lies over what explain: raise the weight of distance, or draw fewer parts "
           "over one another",
           made);
  }
  refused.insert(refused.end(), too_deep.begin(), too_deep.end());
  std::ranges::sort(refused);
  std::erase_if(surfaces, [&](const Shell& surface) { return is_refused(surface.objects.front()); });
  std::erase_if(ranges, [&](const DepthRange& range) { return is_refused(range.object); });
  if (explained > 0 && !ranges.empty()) {
    made.depth_ratio =
        (std::ranges::max(ranges, {}, &DepthRange::high).high - std::ranges::min(ranges, {}, &DepthRange::low).low) /
        explained;
  }
  return refused;
}

/// Attachments of these objects, or else all: what held them wrongly is among them.
std::vector<FailedJoin> pairs_of(const std::vector<Index>& objects, const Attachments& attachments) {
  std::vector<FailedJoin> own;
  std::vector<FailedJoin> all;
  for (const ObjectPair& pair : attachments.pairs(Hold::Joined)) {
    all.push_back({pair, JoinFault::Unsolved});
    if (std::ranges::binary_search(objects, pair.first) || std::ranges::binary_search(objects, pair.second)) {
      own.push_back(all.back());
    }
  }
  return own.empty() ? all : own;
}

/// Per object what is wrong with its surface. Attached objects are checked together once they are joined.
std::vector<std::string> check_surfaces(const FigureTask& task, const SolvedFigure& solved,
                                        const std::vector<Shell>& surfaces, const SheetMesh& mesh, Progress& progress) {
  std::vector<std::string> faults;
  std::vector<const PolyMesh*> meshes;
  for (const Shell& surface : surfaces) {
    faults.push_back(topology_fault(surface.mesh, task.figure.objects[surface.objects.front()].euler_region, progress));
    meshes.push_back(&surface.mesh);
  }
  if (task.settings.depth.attachments.any(Hold::Joined)) return faults;
  const bool in_order = sheets_in_order(solved.sheets, Rounding::None, task.figure.unit);
  for (const Rounding rounding : {Rounding::None, Rounding::Grid}) {
    progress.check();
    if (in_order && mesh_in_order(mesh, rounding, task.figure.unit)) continue;
    for (const auto& pair : meeting_faces(meshes, rounding, task.figure.unit, progress)) {
      for (const MeshFace& place : pair) {
        if (faults[place.mesh].empty()) faults[place.mesh] = "intersects itself or another one";
      }
    }
  }
  return faults;
}

/// Per pair with a rounded seam, sketch units.
std::map<ObjectPair, double> seam_radii(const FigureTask& task, const Skeleton& skeleton) {
  const std::vector<double> radius = object_radii(skeleton);
  std::map<ObjectPair, double> radii;
  for (const auto& [pair, how] : task.settings.depth.attachments.held) {
    if (how.hold != Hold::Joined || how.blend <= 0) continue;
    radii[pair] = how.blend * std::min(radius[pair.first], radius[pair.second]);
  }
  return radii;
}

SurfacedFigure surfaced(const FigureTask& task, const SolvedFigure& solved, const SheetMesh& mesh, Progress& progress) {
  SurfacedFigure made;
  const bool checks = task.settings.quality == Quality::Final;
  const Attachments& attachments = task.settings.depth.attachments;
  std::vector<Shell> surfaces = object_surfaces(task.figure, mesh);
  const std::vector<Index> refused = refuse_unsolved(task, solved, surfaces, made);
  if (!refused.empty() && attachments.any(Hold::Joined)) {
    // Attached parts may be held too weakly: apart, each part is pulled to the sketch plane by itself.
    made.shells.failed = pairs_of(refused, attachments);
    return made;
  }
  HeldSurfaces held{std::move(surfaces), {}, attachments, seam_radii(task, solved.skeleton)};
  held.faults.resize(held.surfaces.size());
  if (checks) held.faults = check_surfaces(task, solved, held.surfaces, mesh, progress);
  const std::vector<Index> alone = add_far_copies(task.figure, task.settings.copied, held);
  for (const Shell& surface : held.surfaces) {
    const Index object = surface.objects.front();
    if (!is_copy(task.figure, object)) continue;
    const auto own = std::ranges::find(held.surfaces, std::vector{drawn_object(task.figure, object)}, &Shell::objects);
    made.mirrored[own->objects.front()] = (middle_depth(surface.mesh) + middle_depth(own->mesh)) / 2;
  }
  if (!checks) held.attachments = {};
  made.shells = make_shells(task.figure, std::move(held), progress);
  for (const Index object : alone) {
    made.refusals.push_back(not_copied(
        task, object,
        "\" on the far side is left out, since it belongs to nothing: attach it to a part that isn't copied"));
  }
  for (const Index object : made.shells.lost) {
    made.mirrored.erase(object);
    made.refusals.push_back(not_copied(
        task, object,
        "\" on the far side is left out, since it would cut through another part: draw it further away, or attach it"));
  }
  for (const auto& [object, fault] : made.shells.refused) {
    refuse(task, object, "E_NOT_CERTIFIED", "The surface of",
           fault + ": draw its lines further apart, or lower the resolution step", made);
  }
  return made;
}

/// Makes the shells and checks them. Where even triangles spoil a surface, the sheets keep their own. Where pairs can't
/// be joined nothing else counts: triangles of their own hardly ever help these.
SurfacedFigure finish(const FigureTask& task, const SolvedFigure& solved, Progress& progress) {
  Progress improving = progress.step("triangles", 0.2);
  const SheetMesh own = make_sheet_mesh(solved.sheets, solved.basis->objects);
  if (task.settings.quality == Quality::Draft) return surfaced(task, solved, own, improving);
  SheetMesh even = own;
  improve_triangles(even, improving);
  Progress checking = progress.step("check", 0.7);
  SurfacedFigure made = surfaced(task, solved, even, checking);
  if (!made.shells.failed.empty() || made.shells.refused.empty()) return made;
  Progress again = progress.step("check", 0.1);
  return surfaced(task, solved, own, again);
}

Overlap overlap_with_drawing(const LabelledFigure& figure, const std::vector<Shell>& shells) {
  std::vector<const PolyMesh*> meshes;
  std::vector<SidedOutline> outlines;
  for (const Shell& shell : shells) {
    meshes.push_back(&shell.mesh);
    for (const Index object : shell.objects) {
      for (const Index c : figure.objects[object].contours) {
        outlines.push_back({figure.raw_contours[c], figure.contours[c].side});
      }
    }
  }
  return silhouette_overlap(meshes, outlines);
}

FigureSolid figure_solid(const FigureTask& task, SolvedFigure solved, SurfacedFigure made) {
  FigureSolid solid;
  solid.shells = std::move(made.shells.shells);
  solid.held = task.settings.depth.attachments;
  for (auto& [pair, how] : solid.held.held) how.blend = 0;
  for (const Shell& shell : solid.shells) {
    for (const auto& [pair, share] : shell.blends) {
      solid.held.held[pair].blend = share * task.settings.depth.attachments.held.at(pair).blend;
    }
  }
  solid.findings = std::move(made.refusals);
  std::ranges::move(depth_findings(solved.depth, solved.skeleton, task.figure, task.drawing),
                    std::back_inserter(solid.findings));
  solid.diagnostics.skeleton_vertices = solved.skeleton.nodes.size();
  solid.diagnostics.collision_constraints = solved.depth.rows;
  solid.diagnostics.scale = solved.skeleton.scale;
  solid.diagnostics.minimum_gap = least_gap(solved.sheets);
  solid.diagnostics.solver_iterations = std::max(solved.depth.iterations, solved.sheets.iterations);
  solid.diagnostics.solver_residual = std::max(solved.depth.residual, solved.sheets.residual);
  solid.diagnostics.depth_ratio = made.depth_ratio;
  if (task.settings.quality == Quality::Final) solid.overlap = overlap_with_drawing(task.figure, solid.shells);
  solid.skeleton = std::move(solved.skeleton);
  solid.sheets = std::make_shared<const InflatedSheets>(std::move(solved.sheets));
  solid.mirrored = std::move(made.mirrored);
  return solid;
}

std::shared_ptr<const Skeleton> make_axis(const FigureTask& task, Progress& progress) {
  const double spacing = task.settings.depth.options.node_spacing;
  StageKey key;
  if (task.settings.cache != nullptr) {
    add_shape(task.figure, key);
    key.add(spacing);
  }
  return cached<Skeleton>(
      task.settings.cache, "silhouette axis", key, [&] { return chordal_axis(task.figure, spacing, progress); },
      [](const Skeleton& skeleton) { return bytes_of(skeleton); });
}

/// All joined pairs of the groups of objects that failed ones belong to, group by group.
std::vector<FailedJoin> whole_groups(const LabelledFigure& figure, const Attachments& attachments,
                                     const std::vector<FailedJoin>& failed) {
  DisjointSets groups(figure.objects.size());
  const std::vector<ObjectPair> pairs = attachments.pairs(Hold::Joined);
  for (const auto& [a, b] : pairs) groups.unite(a, b);
  std::vector<FailedJoin> all;
  for (Index group = 0; group < figure.objects.size(); ++group) {
    const auto in_group = [&](const ObjectPair& pair) { return groups.root(pair.first) == group; };
    const auto found = std::ranges::find_if(failed, in_group, &FailedJoin::pair);
    if (found == failed.end()) continue;
    for (const ObjectPair& pair : pairs) {
      if (in_group(pair)) all.push_back({pair, found->fault});
    }
  }
  return all;
}

FigureSolid solidify(FigureTask task, Progress& progress) {
  Attachments& attachments = task.settings.depth.attachments;
  Progress finding_axis = progress.step("skeleton", 0.05);
  const std::shared_ptr<const Skeleton> axis = make_axis(task, finding_axis);
  Findings warnings;
  for (int round = 1;; ++round) {
    // Every repetition has fewer pairs, so they end.
    const double share = attachments.any(Hold::Joined) ? 0.35 : 0.75;
    Progress solving = progress.step("solve", share);
    SolvedFigure solved = solve(task, *axis, solving);
    Progress checking = progress.step("finish", share / 4);
    SurfacedFigure made = finish(task, solved, checking);
    std::vector<FailedJoin> failed = std::move(made.shells.failed);
    if (failed.empty()) {
      FigureSolid solid = figure_solid(task, std::move(solved), std::move(made));
      std::ranges::move(warnings, std::back_inserter(solid.findings));
      return solid;
    }
    if (round >= max_joining_rounds) failed = whole_groups(task.figure, attachments, failed);
    for (const FailedJoin& join : failed) {
      if (join.copied) {
        if (std::erase(task.settings.copied, *join.copied) == 0) continue;
        warnings.push_back(not_copied(task, *join.copied,
                                      "\" on the far side is left out, since it has no sound union with what it "
                                      "belongs to: draw it further away"));
        continue;
      }
      warnings.push_back(not_joined(task, join));
      attachments.held.erase(join.pair);
    }
  }
}

std::size_t bytes_of_solid(const FigureSolid& solid) {
  const InflatedSheets& sheets = *solid.sheets;
  std::size_t bytes = bytes_of(solid.skeleton) + bytes_of(sheets.sampling) +
                      sizeof(double) * static_cast<std::size_t>(sheets.z.size() + sheets.thickness.size());
  for (const Shell& shell : solid.shells) bytes += bytes_of(shell.mesh) + 4 * shell.face_objects.size();
  return bytes;
}

}  // namespace

std::vector<Subject> object_subjects(const FigureObject& object, const Drawing& drawing) {
  std::vector<Subject> subjects;
  for (const Index stroke : object.strokes) subjects.push_back(stroke_subject(drawing, stroke));
  return subjects;
}

std::shared_ptr<const FigureSolid> make_figure_solid(const LabelledFigure& figure, const Drawing& drawing,
                                                     const FigureSettings& settings, Progress& progress) {
  StageKey key;
  if (settings.cache != nullptr) {
    add_shape(figure, key);
    add_names(figure, drawing, key);
    key.add(settings.depth).add(settings.quality).add(settings.copied);
  }
  return cached<FigureSolid>(
      settings.cache, "silhouette solid", key,
      [&] {
        return solidify({figure, drawing, settings}, progress);
      },
      [](const FigureSolid& solid) { return bytes_of_solid(solid); });
}

}  // namespace croquis::silhouette
