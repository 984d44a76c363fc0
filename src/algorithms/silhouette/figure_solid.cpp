// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/figure_solid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include "algorithms/silhouette/depth_guard.h"
#include "algorithms/silhouette/mesh_append.h"
#include "algorithms/silhouette/skeleton/chordal_axis.h"
#include "algorithms/silhouette/skeleton/depth_findings.h"
#include "algorithms/silhouette/stage.h"
#include "algorithms/silhouette/surface/certificate.h"
#include "algorithms/silhouette/surface/inflation.h"
#include "algorithms/silhouette/surface/sheet_surface.h"
#include "algorithms/silhouette/surface/skeleton_curves.h"
#include "algorithms/silhouette/surface/surface_union.h"
#include "croquis/geometry/disjoint_sets.h"

namespace croquis::silhouette {
namespace {

/// Joined surfaces show what their parts show, but for rounding; a union that lost a part of them is no union.
constexpr double least_kept_silhouette = 0.99;

/// u: seams' edges shorter than that may go.
constexpr double sliver = 0.25;

Finding about_group(const LabelledFigure& figure, const Drawing& drawing, const std::vector<Index>& group,
                    const std::string& code, const std::string& sentence) {
  std::string names;
  std::vector<Subject> subjects;
  for (const Index object : group) {
    names += (names.empty() ? "\"" : ", \"") + figure.objects[object].name + "\"";
    for (Subject& subject : object_subjects(figure.objects[object], drawing)) subjects.push_back(std::move(subject));
  }
  return make_warning(Category::Geometry, code, "The attached objects " + names + " " + sentence, std::move(subjects));
}

Finding not_joined(const LabelledFigure& figure, const Drawing& drawing, const std::vector<Index>& group) {
  return about_group(figure, drawing, group, "W_ATTACH",
                     "could not be joined to one sound surface and were kept apart: attach fewer of them, or change "
                     "how deep they sink");
}

Finding still_apart(const LabelledFigure& figure, const Drawing& drawing, const FigureShell& shell) {
  return about_group(figure, drawing, shell.objects, "W_ATTACH_APART",
                     "stay in " + std::to_string(shell.pieces) +
                         " pieces that don't meet: let them sink deeper, or draw them further over one another");
}

/// One solve of a figure with given attachments.
class Attempt {
 public:
  Attempt(const LabelledFigure& figure, const Drawing& drawing, const FigureSettings& settings)
      : figure_(figure),
        drawing_(drawing),
        settings_(settings.depth),
        quality_(settings.quality),
        cache_(settings.cache) {}

  void solve(Skeleton axis, Progress& progress) {
    skeleton_ = std::move(axis);
    Progress solving = progress.step("depth", 0.15);
    depth_ = solve_depth(skeleton_, figure_, settings_, solving);
    Progress inflating = progress.step("inflate", 0.45);
    const std::shared_ptr<const SheetBasis> basis = sheet_basis(inflating);
    Progress raising = progress.step("inflate", 0.4);
    sheets_ = raise_sheets(skeleton_, *basis, settings_, raising);
  }

  /// Makes the shells and checks them.
  /// @return groups of attached objects that have no sound surface; then nothing else counts
  std::vector<std::vector<Index>> make_shells(Progress& progress) {
    std::vector<ObjectSurface> surfaces = object_surfaces(figure_, sheets_);
    // Attached parts may be held too weakly: apart, each part is pulled to the sketch plane by itself.
    if (!refuse_unsolved(surfaces) && !settings_.attachments.empty()) return settings_.attachments.groups();
    if (quality_ == Quality::Draft) {
      for (const ObjectSurface& surface : surfaces) add_single(surface, {});
      return {};
    }
    std::vector<std::string> faults = check_surfaces(surfaces, progress);
    std::vector<std::vector<Index>> failed;
    for (const std::vector<Index>& group : settings_.attachments.groups()) {
      if (!join(group, surfaces, faults, progress)) failed.push_back(group);
    }
    if (!failed.empty()) return failed;
    for (std::size_t s = 0; s < surfaces.size(); ++s) {
      if (!settings_.attachments.involves(surfaces[s].object)) add_single(surfaces[s], faults[s]);
    }
    std::sort(shells_.begin(), shells_.end(),
              [](const FigureShell& a, const FigureShell& b) { return a.objects.front() < b.objects.front(); });
    return settings_.attachments.empty() ? failed : check_apart(progress);
  }

  FigureSolid take() {
    FigureSolid solid;
    solid.attachments = settings_.attachments;
    add_findings(solid);
    add_diagnostics(solid.diagnostics);
    append_skeleton(skeleton_, solid.skeleton);
    if (quality_ == Quality::Final) solid.overlap = overlap_with_drawing();
    solid.shells = std::move(shells_);
    return solid;
  }

 private:
  std::shared_ptr<const SheetBasis> sheet_basis(Progress& progress) const {
    StageKey key;
    if (cache_ != nullptr) {
      add_shape(figure_, key);
      add_shape(skeleton_, key);
      key.add(quality_);
    }
    return cached<SheetBasis>(
        cache_, "silhouette sheets", key, [&] { return make_sheet_basis(figure_, skeleton_, quality_, progress); },
        [](const SheetBasis& basis) { return bytes_of(basis); });
  }

  /// Takes out the surfaces whose depths aren't exact enough; true when all are.
  bool refuse_unsolved(std::vector<ObjectSurface>& surfaces) {
    const bool solved = std::max(depth_.uncertainty, sheets_.uncertainty) <= settings_.options.accuracy;
    std::vector<DepthRange> ranges;
    for (const ObjectSurface& surface : surfaces) ranges.push_back(depth_range(surface));
    const double gap = settings_.options.minimum_gap * skeleton_.scale;
    const double most = settings_.options.depth_allowance * explained_depth(figure_, skeleton_, gap);
    const std::vector<Index> deep = objects_too_deep(std::move(ranges), solved ? most : -1);
    for (const Index object : deep) refuse_depth(object, solved);
    std::erase_if(surfaces, [&](const ObjectSurface& surface) {
      return std::binary_search(deep.begin(), deep.end(), surface.object);
    });
    return deep.empty();
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
  std::vector<std::string> check_surfaces(const std::vector<ObjectSurface>& surfaces, Progress& progress) const {
    std::vector<CertificateInput> inputs;
    for (const ObjectSurface& surface : surfaces) {
      inputs.push_back({&surface.mesh, figure_.objects[surface.object].euler_region});
    }
    std::vector<std::string> faults = certify_topology(inputs, progress);
    if (!settings_.attachments.empty()) return faults;
    for (const Rounding rounding : {Rounding::None, Rounding::Grid}) {
      progress.check();
      if (!sheets_in_order(sheets_, rounding, figure_.unit)) {
        certify_apart(inputs, rounding, figure_.unit, faults, progress);
      }
    }
    return faults;
  }

  std::vector<SidedOutline> outlines_of(const std::vector<Index>& objects) const {
    std::vector<SidedOutline> outlines;
    for (const Index object : objects) {
      for (const Index c : figure_.objects[object].contours) {
        SidedOutline outline{{}, figure_.contours[c].side};
        for (const Index v : figure_.contours[c].vertices) outline.points.push_back(figure_.points[v]);
        outlines.push_back(std::move(outline));
      }
    }
    return outlines;
  }

  bool join(const std::vector<Index>& group, const std::vector<ObjectSurface>& surfaces,
            const std::vector<std::string>& faults, Progress& progress) {
    std::vector<UnionPart> parts;
    for (const Index object : group) {
      if (!faults[object].empty()) return false;
      parts.push_back({&surfaces[object].mesh, object});
    }
    std::optional<SurfaceUnion> joined = unite_surfaces(parts, sliver * figure_.unit, progress);
    if (!joined) return false;
    const CertificateInput input{&joined->mesh, std::nullopt};
    if (!certify_topology({&input, 1}, progress).front().empty()) return false;
    if (silhouette_overlap(joined->mesh, outlines_of(group)).ratio() < least_kept_silhouette) return false;
    // A closed surface of triangles has three edges for every two faces.
    const int euler = static_cast<int>(joined->mesh.vertex_count()) - static_cast<int>(joined->mesh.face_count() / 2);
    const std::size_t pieces = piece_count(joined->mesh);
    shells_.push_back({std::move(joined->mesh), group, std::move(joined->face_objects), euler, pieces});
    return true;
  }

  static std::size_t piece_count(const PolyMesh& mesh) {
    DisjointSets sets(mesh.vertex_count());
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
      sets.unite(mesh.face(f)[0], mesh.face(f)[1]);
      sets.unite(mesh.face(f)[0], mesh.face(f)[2]);
    }
    std::size_t count = 0;
    for (Index v = 0; v < mesh.vertex_count(); ++v) count += sets.root(v) == v ? 1U : 0U;
    return count;
  }

  void add_single(const ObjectSurface& surface, const std::string& fault) {
    if (fault.empty()) {
      // certify_topology has counted the mesh's Euler number and found it to be this.
      shells_.push_back({surface.mesh, {surface.object}, {}, 2 * figure_.objects[surface.object].euler_region, 1});
    } else {
      refuse(surface.object, fault);
    }
  }

  void refuse(Index object, const std::string& fault) {
    refusals_.push_back(make_error(Category::Geometry, "E_NOT_CERTIFIED",
                                   "The surface of \"" + figure_.objects[object].name + "\" " + fault +
                                       ": draw its lines further apart, or lower the resolution step",
                                   object_subjects(figure_.objects[object], drawing_)));
  }

  /// Nothing is proven about joined surfaces: they are tested on the numbers as they are and as files may round them.
  std::vector<std::vector<Index>> check_apart(Progress& progress) {
    std::vector<CertificateInput> inputs;
    for (const FigureShell& shell : shells_) inputs.push_back({&shell.mesh, std::nullopt});
    std::vector<std::string> faults(shells_.size());
    for (const Rounding rounding : {Rounding::None, Rounding::Grid}) {
      certify_apart(inputs, rounding, figure_.unit, faults, progress);
    }
    std::vector<std::vector<Index>> failed;
    for (std::size_t s = 0; s < shells_.size(); ++s) {
      if (!faults[s].empty() && shells_[s].objects.size() > 1) failed.push_back(shells_[s].objects);
    }
    for (std::size_t s = shells_.size(); failed.empty() && s-- > 0;) {
      if (faults[s].empty()) continue;
      refuse(shells_[s].objects.front(), faults[s]);
      shells_.erase(shells_.begin() + static_cast<std::ptrdiff_t>(s));
    }
    return failed;
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
    for (const FigureShell& shell : shells_) {
      if (shell.pieces > 1) solid.findings.push_back(still_apart(figure_, drawing_, shell));
    }
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
  }

  const LabelledFigure& figure_;
  const Drawing& drawing_;
  const DepthSettings& settings_;
  Quality quality_;
  StageCache* cache_;
  Skeleton skeleton_;
  DepthResult depth_;
  InflatedSheets sheets_;
  std::vector<FigureShell> shells_;
  Findings refusals_;
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

FigureSolid solidify(const LabelledFigure& figure, const Drawing& drawing, FigureSettings settings,
                     Progress& progress) {
  Progress finding_axis = progress.step("skeleton", 0.05);
  const std::shared_ptr<const Skeleton> axis = make_axis(figure, settings, finding_axis);
  Findings warnings;
  for (;;) {
    // Every repetition has one group less, so they end.
    const double share = settings.depth.attachments.empty() ? 0.75 : 0.35;
    Progress solving = progress.step("solve", share);
    Attempt attempt(figure, drawing, settings);
    attempt.solve(*axis, solving);
    Progress checking = progress.step("check", share / 4);
    const std::vector<std::vector<Index>> failed = attempt.make_shells(checking);
    if (failed.empty()) {
      FigureSolid solid = attempt.take();
      solid.findings.insert(solid.findings.end(), warnings.begin(), warnings.end());
      return solid;
    }
    for (const std::vector<Index>& group : failed) {
      warnings.push_back(not_joined(figure, drawing, group));
      settings.depth.attachments = settings.depth.attachments.without(group);
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
    key.add(settings.depth).add(settings.quality);
  }
  return cached<FigureSolid>(
      settings.cache, "silhouette solid", key, [&] { return solidify(figure, drawing, settings, progress); },
      [](const FigureSolid& solid) { return bytes_of_solid(solid); });
}

}  // namespace croquis::silhouette
