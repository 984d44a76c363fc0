// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/figure_solid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "algorithms/silhouette/depth_guard.h"
#include "algorithms/silhouette/mesh_append.h"
#include "algorithms/silhouette/sampling/rim_radius.h"
#include "algorithms/silhouette/skeleton/chordal_axis.h"
#include "algorithms/silhouette/stage.h"
#include "algorithms/silhouette/surface/certificate.h"
#include "algorithms/silhouette/surface/inflation.h"
#include "algorithms/silhouette/surface/sheet_improvement.h"
#include "algorithms/silhouette/surface/sheet_surface.h"
#include "algorithms/silhouette/surface/skeleton_curves.h"

namespace croquis::silhouette {
namespace {

/// How often a figure is made again with less attached. What fails then is left apart with all that hangs together with
/// it.
constexpr int max_joining_rounds = 6;

const char* sentence_of(JoinFault fault) {
  switch (fault) {
    case JoinFault::DontMeet:
      return " could not be joined, since their surfaces don't meet, and were kept apart: let them sink deeper, or "
             "draw "
             "them further over one another";
    case JoinFault::Unsolved:
      return " could not be joined, since no depth holds them together, and were kept apart: attach fewer parts, or "
             "draw thin ones wider";
    case JoinFault::Unsound: break;
  }
  return " could not be joined to one sound surface and were kept apart: change how deep they sink, or draw them "
         "further over one another";
}

Finding not_joined(const LabelledFigure& figure, const Drawing& drawing, const FailedJoin& failed) {
  const FigureObject& a = figure.objects[failed.pair.first];
  const FigureObject& b = figure.objects[failed.pair.second];
  std::vector<Subject> subjects = object_subjects(a, drawing);
  for (Subject& subject : object_subjects(b, drawing)) subjects.push_back(std::move(subject));
  return make_warning(Category::Geometry, "W_ATTACH",
                      "The attached objects \"" + a.name + "\" and \"" + b.name + "\"" + sentence_of(failed.fault),
                      std::move(subjects));
}

/// One solve of a figure with given attachments.
class Attempt {
 public:
  Attempt(const LabelledFigure& figure, const Drawing& drawing, const FigureSettings& settings)
      : figure_(figure),
        drawing_(drawing),
        settings_(settings.depth),
        blends_(settings.blends),
        quality_(settings.quality),
        cache_(settings.cache) {}

  /// Where the depths of an object aren't found exactly enough, they are sought again: with parts that are equally hard
  /// to move, and then with parts that are held as near to their places as can be.
  void solve(const Skeleton& axis, Progress& progress) {
    DepthSettings settings = settings_;
    Progress first = progress.step("depth", 0.8);
    solve(axis, settings, first);
    for (int firmness = 1; firmness <= 2 && !unsolved().empty(); ++firmness) {
      settings.equally_stiff = true;
      if (firmness == 2) {
        settings.object_weights.assign(figure_.objects.size(), {settings_.options.weight_curvature, 1, 1});
      }
      Progress again = progress.step("depth", 0.1);
      solve(axis, settings, again);
    }
    for (const auto& [node, z] : sheets_.lowered_nodes) skeleton_.nodes[node].z = z;
  }

  /// Makes the shells and checks them. Where even triangles spoil a surface, the sheets keep their own. Pairs that
  /// can't be joined are left to the next attempt: triangles of their own hardly ever help these.
  /// @return attached pairs that have no sound surface; then nothing else counts
  std::vector<FailedJoin> finish(Progress& progress) {
    Progress improving = progress.step("triangles", 0.2);
    const SheetMesh own = make_sheet_mesh(sheets_, basis_->objects);
    if (quality_ == Quality::Draft) return make_shells_of(own, improving);
    SheetMesh even = own;
    improve_triangles(even, improving);
    Progress checking = progress.step("check", 0.7);
    std::vector<FailedJoin> failed = make_shells_of(even, checking);
    if (!failed.empty() || !unsound_) return failed;
    refusals_.clear();
    Progress again = progress.step("check", 0.1);
    return make_shells_of(own, again);
  }

  FigureSolid take() {
    FigureSolid solid;
    solid.held = {settings_.attachments, made_blends()};
    add_findings(solid);
    add_diagnostics(solid.diagnostics);
    append_skeleton(skeleton_, solid.skeleton);
    if (quality_ == Quality::Final) solid.overlap = overlap_with_drawing();
    solid.shells = std::move(shells_);
    return solid;
  }

 private:
  void solve(const Skeleton& axis, const DepthSettings& settings, Progress& progress) {
    skeleton_ = axis;
    Progress solving = progress.step("depth", 0.15);
    depth_ = solve_depth(skeleton_, figure_, settings, solving);
    Progress inflating = progress.step("inflate", 0.45);
    basis_ = sheet_basis(inflating);
    Progress raising = progress.step("inflate", 0.4);
    sheets_ = raise_sheets(skeleton_, *basis_, settings, raising);
  }

  /// Objects whose depths aren't exact enough, ascending.
  std::vector<Index> unsolved() const {
    std::vector<Index> objects;
    for (Index object = 0; object < figure_.objects.size(); ++object) {
      const auto exact = [&](const std::vector<double>& uncertainty) {
        return object >= uncertainty.size() || uncertainty[object] <= settings_.options.accuracy;
      };
      if (!exact(depth_.uncertainty) || !exact(sheets_.uncertainty)) objects.push_back(object);
    }
    return objects;
  }

  std::vector<FailedJoin> make_shells_of(const SheetMesh& mesh, Progress& progress) {
    std::vector<ObjectSurface> surfaces = object_surfaces(figure_, mesh);
    const std::vector<Index> unsolved = refuse_unsolved(surfaces);
    // Attached parts may be held too weakly: apart, each part is pulled to the sketch plane by itself.
    if (!unsolved.empty() && !settings_.attachments.empty()) return pairs_of(unsolved);
    std::vector<std::string> faults(surfaces.size());
    if (quality_ == Quality::Final) faults = check_surfaces(surfaces, mesh, progress);
    std::vector<CheckedSurface> checked;
    checked.reserve(surfaces.size());
    for (std::size_t s = 0; s < surfaces.size(); ++s) checked.push_back({&surfaces[s], std::move(faults[s])});
    const bool joins = quality_ == Quality::Final;
    FigureShells made =
        make_shells(figure_, checked, joins ? settings_.attachments : Attachments{}, seam_radii(), progress);
    for (const auto& [object, fault] : made.refused) refuse(object, fault);
    unsound_ = !made.refused.empty();
    shells_ = std::move(made.shells);
    return std::move(made.failed);
  }

  std::shared_ptr<const SheetBasis> sheet_basis(Progress& progress) const {
    const std::vector<Index> thin = thin_objects(settings_.thickness);
    StageKey key;
    if (cache_ != nullptr) {
      add_shape(figure_, key);
      add_shape(skeleton_, key);
      key.add(quality_).add(thin);
    }
    return cached<SheetBasis>(
        cache_, "silhouette sheets", key,
        [&] { return make_sheet_basis(figure_, skeleton_, quality_, thin, progress); },
        [](const SheetBasis& basis) { return bytes_of(basis); });
  }

  /// Takes out the surfaces whose depths aren't exact enough, or more than explained. @return their objects, ascending
  std::vector<Index> refuse_unsolved(std::vector<ObjectSurface>& surfaces) {
    std::vector<Index> refused = unsolved();
    const auto is_refused = [&](const ObjectSurface& surface) {
      return std::binary_search(refused.begin(), refused.end(), surface.object);
    };
    for (const Index object : refused) refuse_depth(object, false);
    std::erase_if(surfaces, is_refused);
    std::vector<DepthRange> ranges;
    ranges.reserve(surfaces.size());
    for (const ObjectSurface& surface : surfaces) ranges.push_back(depth_range(surface));
    const double gap = settings_.options.minimum_gap * skeleton_.scale;
    const double explained = explained_depth(figure_, skeleton_, gap, settings_.thickness);
    for (const Index object : objects_too_deep(std::move(ranges), settings_.options.depth_allowance * explained)) {
      refuse_depth(object, true);
      refused.push_back(object);
    }
    std::sort(refused.begin(), refused.end());
    std::erase_if(surfaces, is_refused);
    depth_ratio_ = explained > 0 ? depth_of(surfaces) / explained : 0;
    return refused;
  }

  /// Attachments of these objects, or else all: what held them wrongly is among them.
  std::vector<FailedJoin> pairs_of(const std::vector<Index>& objects) const {
    std::vector<FailedJoin> own;
    std::vector<FailedJoin> all;
    for (const auto& [pair, kappa] : settings_.attachments.pairs()) {
      all.push_back({pair, JoinFault::Unsolved});
      if (std::binary_search(objects.begin(), objects.end(), pair.first) ||
          std::binary_search(objects.begin(), objects.end(), pair.second)) {
        own.push_back(all.back());
      }
    }
    return own.empty() ? all : own;
  }

  /// Of all of them together.
  static double depth_of(const std::vector<ObjectSurface>& surfaces) {
    if (surfaces.empty()) return 0;
    DepthRange all = depth_range(surfaces.front());
    for (const ObjectSurface& surface : surfaces) {
      const DepthRange own = depth_range(surface);
      all.low = std::min(all.low, own.low);
      all.high = std::max(all.high, own.high);
    }
    return all.high - all.low;
  }

  /// Per pair with a rounded seam, sketch units.
  std::map<ObjectPair, double> seam_radii() const {
    const std::vector<double> radius = object_radii(skeleton_);
    std::map<ObjectPair, double> radii;
    for (const auto& [pair, blend] : blends_) {
      if (settings_.attachments.kappa(pair.first, pair.second)) {
        radii[pair] = blend * std::min(radius[pair.first], radius[pair.second]);
      }
    }
    return radii;
  }

  /// What became of the seams that were to be rounded.
  std::map<ObjectPair, double> made_blends() const {
    std::map<ObjectPair, double> blends;
    for (const FigureShell& shell : shells_) {
      for (const auto& [pair, share] : shell.blends) blends[pair] = share * blends_.at(pair);
    }
    return blends;
  }

  static DepthRange depth_range(const ObjectSurface& surface) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    DepthRange range{surface.object, infinity, -infinity};
    for (const Vec3& position : surface.mesh.positions) {
      if (!std::isfinite(position.z())) return {surface.object, -infinity, infinity};
      range.low = std::min(range.low, position.z());
      range.high = std::max(range.high, position.z());
    }
    return range;
  }

  void refuse_depth(Index object, bool solved) {
    const std::string& name = figure_.objects[object].name;
    const std::string sentence =
        solved ? "The depth found for \"" + name +
                     "\" is more than the widths of what lies over what explain: raise the weight of distance, or draw "
                     "fewer parts over one another"
               : "The depth of \"" + name +
                     "\" could not be worked out exactly enough: draw its thin parts wider, or its lines further apart";
    refusals_.push_back(
        make_error(Category::Geometry, "E_NOT_SOLVED", sentence, object_subjects(figure_.objects[object], drawing_)));
  }

  /// Per object what is wrong with its surface. Attached objects are checked together once they are joined.
  std::vector<std::string> check_surfaces(const std::vector<ObjectSurface>& surfaces, const SheetMesh& mesh,
                                          Progress& progress) const {
    std::vector<CertificateInput> inputs;
    inputs.reserve(surfaces.size());
    for (const ObjectSurface& surface : surfaces) {
      inputs.push_back({&surface.mesh, figure_.objects[surface.object].euler_region});
    }
    std::vector<std::string> faults = certify_topology(inputs, progress);
    if (!settings_.attachments.empty()) return faults;
    const bool in_order = sheets_in_order(sheets_, Rounding::None, figure_.unit);
    for (const Rounding rounding : {Rounding::None, Rounding::Grid}) {
      progress.check();
      if (!in_order || !mesh_in_order(mesh, rounding, figure_.unit)) {
        certify_apart(inputs, rounding, figure_.unit, faults, progress);
      }
    }
    return faults;
  }

  void refuse(Index object, const std::string& fault) {
    refusals_.push_back(make_error(Category::Geometry, "E_NOT_CERTIFIED",
                                   "The surface of \"" + figure_.objects[object].name + "\" " + fault +
                                       ": draw its lines further apart, or lower the resolution step",
                                   object_subjects(figure_.objects[object], drawing_)));
  }

  Overlap overlap_with_drawing() const {
    PolyMesh valid;
    std::vector<SidedOutline> outlines;
    for (const FigureShell& shell : shells_) {
      append_triangles(shell.mesh, valid);
      for (const Index object : shell.objects) {
        for (const Index c : figure_.objects[object].contours) {
          outlines.push_back({figure_.raw_contours[c], figure_.contours[c].side});
        }
      }
    }
    return silhouette_overlap(valid, outlines);
  }

  void add_findings(FigureSolid& solid) const {
    solid.findings = refusals_;
    const Findings depths = depth_findings(depth_, skeleton_, figure_, drawing_);
    solid.findings.insert(solid.findings.end(), depths.begin(), depths.end());
  }

  void add_diagnostics(SolidDiagnostics& diagnostics) const {
    diagnostics.skeleton_vertices = skeleton_.nodes.size();
    diagnostics.collision_constraints = depth_.rows;
    diagnostics.scale = skeleton_.scale;
    diagnostics.minimum_gap = least_gap(sheets_);
    diagnostics.solver_iterations = std::max(depth_.iterations, sheets_.iterations);
    diagnostics.solver_residual = std::max(depth_.residual, sheets_.residual);
    diagnostics.depth_ratio = depth_ratio_;
  }

  const LabelledFigure& figure_;
  const Drawing& drawing_;
  const DepthSettings& settings_;
  const std::map<Attachments::Pair, double>& blends_;
  Quality quality_;
  StageCache* cache_;
  Skeleton skeleton_;
  DepthResult depth_;
  std::shared_ptr<const SheetBasis> basis_;
  InflatedSheets sheets_;
  double depth_ratio_ = 0;
  std::vector<FigureShell> shells_;
  Findings refusals_;
  bool unsound_ = false;  ///< a surface failed the checks
};

std::shared_ptr<const Skeleton> make_axis(const LabelledFigure& figure, const FigureSettings& settings,
                                          Progress& progress) {
  const double spacing = settings.depth.options.node_spacing;
  StageKey key;
  if (settings.cache != nullptr) {
    add_shape(figure, key);
    key.add(spacing);
  }
  return cached<Skeleton>(
      settings.cache, "silhouette axis", key, [&] { return chordal_axis(figure, spacing, progress); },
      [](const Skeleton& skeleton) { return bytes_of(skeleton); });
}

/// All attachments of the groups that these pairs belong to.
std::vector<FailedJoin> whole_groups(const Attachments& attachments, const std::vector<FailedJoin>& failed) {
  std::vector<FailedJoin> all;
  for (const std::vector<Index>& group : attachments.groups()) {
    const auto in_group = [&](Index object) { return std::binary_search(group.begin(), group.end(), object); };
    const auto found =
        std::find_if(failed.begin(), failed.end(), [&](const FailedJoin& join) { return in_group(join.pair.first); });
    if (found == failed.end()) continue;
    for (const auto& [pair, kappa] : attachments.pairs()) {
      if (in_group(pair.first)) all.push_back({pair, found->fault});
    }
  }
  return all;
}

FigureSolid solidify(const LabelledFigure& figure, const Drawing& drawing, FigureSettings settings,
                     Progress& progress) {
  Progress finding_axis = progress.step("skeleton", 0.05);
  const std::shared_ptr<const Skeleton> axis = make_axis(figure, settings, finding_axis);
  Findings warnings;
  for (int round = 1;; ++round) {
    // Every repetition has fewer pairs, so they end.
    const double share = settings.depth.attachments.empty() ? 0.75 : 0.35;
    Progress solving = progress.step("solve", share);
    Attempt attempt(figure, drawing, settings);
    attempt.solve(*axis, solving);
    Progress checking = progress.step("finish", share / 4);
    std::vector<FailedJoin> failed = attempt.finish(checking);
    if (failed.empty()) {
      FigureSolid solid = attempt.take();
      solid.findings.insert(solid.findings.end(), warnings.begin(), warnings.end());
      return solid;
    }
    if (round >= max_joining_rounds) failed = whole_groups(settings.depth.attachments, failed);
    for (const FailedJoin& join : failed) {
      warnings.push_back(not_joined(figure, drawing, join));
      settings.depth.attachments.release(join.pair.first, join.pair.second);
    }
  }
}

std::size_t bytes_of_solid(const FigureSolid& solid) {
  std::size_t bytes = bytes_of(solid.skeleton);
  for (const FigureShell& shell : solid.shells) bytes += bytes_of(shell.mesh) + 4 * shell.face_objects.size();
  return bytes;
}

}  // namespace

std::vector<Subject> object_subjects(const FigureObject& object, const Drawing& drawing) {
  std::vector<Subject> subjects;
  for (const Index s : object.strokes) {
    const Stroke& stroke = drawing.strokes[s];
    Subject subject{SubjectKind::Stroke, stroke.id, {}, stroke.line, {}};
    if (!drawing.file.empty()) subject.file = drawing.file;
    subjects.push_back(std::move(subject));
  }
  return subjects;
}

std::shared_ptr<const FigureSolid> make_figure_solid(const LabelledFigure& figure, const Drawing& drawing,
                                                     const FigureSettings& settings, Progress& progress) {
  StageKey key;
  if (settings.cache != nullptr) {
    add_shape(figure, key);
    add_names(figure, drawing, key);
    key.add(settings.depth).add(settings.quality).add(settings.blends);
  }
  return cached<FigureSolid>(
      settings.cache, "silhouette solid", key, [&] { return solidify(figure, drawing, settings, progress); },
      [](const FigureSolid& solid) { return bytes_of_solid(solid); });
}

}  // namespace croquis::silhouette
