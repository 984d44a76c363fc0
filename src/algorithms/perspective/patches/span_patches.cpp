// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include <Eigen/Geometry>

#include "croquis/perspective/gregory_patches.h"

namespace croquis {
namespace {

/// Steepest rise of a spoke from a side towards the middle of the face, radians.
constexpr double steepest_spoke = 1.9;

/// A patch is looked at in so many cells each way for folds.
constexpr int fold_cells = 8;

/// Moves of the middle of a folded face.
constexpr int most_moves = 20;

Vec3 middle_direction(const std::array<Vec3, 4>& p) { return (p[3] + p[2] - p[1] - p[0]).normalized(); }

/// A side of a face in two halves that meet at its middle.
struct FaceSide {
  PatchSide first, second;
  bool whole = true;  ///< one cubic, `full`
  std::array<Vec3, 4> full{};
  Vec3 middle = Vec3::Zero();
  Vec3 tangent = Vec3::Zero();  ///< unit, along the side at its middle
  Vec3 inwards = Vec3::Zero();  ///< unit, into the face at the middle: where the spoke starts
  double handle = 0;            ///< length of the spoke's handles
};

/// What is at the middle of a face.
struct FaceMiddle {
  Vec3 point = Vec3::Zero();
  Vec3 normal = Vec3::Zero();
};

/// How far a patch is from folding over: the least cosine between normals of neighbouring places; negative if it does.
double least_turn(const GregoryPatch& patch) {
  double least = 1;
  std::vector<Vec3> before(fold_cells + 1, Vec3::Zero());
  for (int j = 0; j <= fold_cells; ++j) {
    Vec3 left = Vec3::Zero();
    for (int i = 0; i <= fold_cells; ++i) {
      const Vec3 normal = patch.at(static_cast<double>(i) / fold_cells, static_cast<double>(j) / fold_cells).normal();
      Vec3& below = before[static_cast<std::size_t>(i)];
      if (!normal.isZero(0) && !left.isZero(0)) least = std::min(least, normal.dot(left));
      if (!normal.isZero(0) && !below.isZero(0)) least = std::min(least, normal.dot(below));
      left = below = normal;
    }
  }
  return least;
}

class FaceSpanner {
 public:
  FaceSpanner(const Brep& brep, const BrepFace& face, const PatchOptions& options)
      : brep_(brep), face_(face), options_(options) {
    const std::vector<Index> halves = brep.around(face.loops[0]);
    for (std::size_t i = 0; i < halves.size(); ++i) {
      const Index before = halves[(i + halves.size() - 1) % halves.size()];
      sides_.push_back(make_side(halves[i], before, halves[(i + 1) % halves.size()]));
    }
  }

  /// The patches; `folded` tells whether one of them folds over.
  std::vector<GregoryPatch> run(bool& folded) {
    const bool single = sides_.size() == 4 && std::ranges::all_of(sides_, &FaceSide::whole);
    if (single) {
      std::vector<GregoryPatch> patches = {span_patch({whole(0), whole(1), whole(2), whole(3)}, options_)};
      folded = least_turn(patches[0]) < 0;
      return patches;
    }
    FaceMiddle middle = first_middle();
    std::vector<GregoryPatch> patches = star(middle);
    double quality = least_of(patches);
    if (quality < 0) improve(middle, patches, quality);
    folded = quality < 0;
    return patches;
  }

 private:
  PatchSide whole(std::size_t i) const {
    const FaceSide& side = sides_[i];
    return {side.full, side.first.common, {side.first.across[0], side.second.across[1]}};
  }

  Vec3 leg_from_start(Index half) const { return cubics(half).front()[1] - cubics(half).front()[0]; }
  Vec3 leg_from_end(Index half) const { return cubics(half).back()[2] - cubics(half).back()[3]; }

  /// The fitted cubics of an edge in the direction of the half-edge.
  std::vector<std::array<Vec3, 4>> cubics(Index half) const {
    const BrepHalfEdge& h = brep_.half_edges[half];
    std::vector<std::array<Vec3, 4>> result;
    for (const RationalCubic& cubic : brep_.edges[h.edge].fitted) {
      result.push_back(h.reversed ? cubic.reversed().points : cubic.points);
    }
    if (h.reversed) std::ranges::reverse(result);
    return result;
  }

  FaceSide make_side(Index half, Index before, Index after) const {
    const std::vector<std::array<Vec3, 4>> parts = cubics(half);
    FaceSide side;
    side.whole = parts.size() == 1;
    side.full = parts[0];
    if (side.whole) {
      const auto [first, second] = RationalCubic{parts[0]}.split(0.5);
      side.first.points = first.points;
      side.second.points = second.points;
    } else {
      side.first.points = parts[0];
      side.second.points = parts[1];
    }
    side.middle = side.first.points[3];
    side.tangent = side.whole ? middle_direction(parts[0]) : Vec3((parts[0][3] - parts[0][2]).normalized());
    set_across(half, side);
    set_inwards(leg_from_end(before), leg_from_start(after), side);
    return side;
  }

  void set_across(Index half, FaceSide& side) const {
    const BrepHalfEdge& h = brep_.half_edges[half];
    const BrepEdge& edge = brep_.edges[h.edge];
    side.first.common = side.second.common = edge.smooth;
    if (!edge.smooth) return;
    const Vec3 start = h.reversed ? Vec3(-edge.across[1]) : edge.across[0];
    const Vec3 end = h.reversed ? Vec3(-edge.across[0]) : edge.across[1];
    side.first.across = {start, (start + end) / 2};
    side.second.across = {(start + end) / 2, end};
  }

  /// Half way between the slopes at the ends, in the common tangent plane if there is one.
  void set_inwards(const Vec3& first_leg, const Vec3& last_leg, FaceSide& side) const {
    Vec3 direction = first_leg + last_leg;
    if (side.first.common) {
      const Vec3 normal = side.first.across[1].cross(side.tangent).normalized();
      direction -= normal.dot(direction) * normal;
    }
    const Vec3 across = direction - side.tangent.dot(direction) * side.tangent;
    if (across.norm() < 1e-3 * (first_leg.norm() + last_leg.norm())) direction = face_.normal.cross(side.tangent);
    side.inwards = direction.normalized();
  }

  /// The first guess: the spokes are arcs of circles that come to the middle at right angles to the face's axis there,
  /// as they do on a sphere; the height of the middle is their mean.
  FaceMiddle first_middle() {
    Vec3 base = Vec3::Zero(), axis = Vec3::Zero();
    for (const FaceSide& side : sides_) base += side.middle / static_cast<double>(sides_.size());
    double scale = 0;
    for (std::size_t i = 0; i < sides_.size(); ++i) {
      const Vec3 a = sides_[i].middle - base, b = sides_[(i + 1) % sides_.size()].middle - base;
      axis += a.cross(b);
      scale += a.norm() * b.norm();
    }
    axis = axis.norm() > 1e-6 * scale ? axis.normalized() : face_.normal;
    double height = 0;
    for (FaceSide& side : sides_) {
      const Vec3 out = side.middle - base - axis.dot(side.middle - base) * axis;
      const double angle = std::clamp(std::atan2(axis.dot(side.inwards), -out.normalized().dot(side.inwards)),
                                      -steepest_spoke, steepest_spoke);
      const double radius = std::abs(angle) > 1e-6 ? out.norm() / std::sin(std::abs(angle)) : 0;
      side.handle = radius > 0 ? 4.0 / 3.0 * std::tan(std::abs(angle) / 4) * radius : out.norm() / 3;
      height += (axis.dot(side.middle - base) + out.norm() * std::tan(angle / 2)) / static_cast<double>(sides_.size());
    }
    return middle_at(base + height * axis);
  }

  Vec3 tip(std::size_t i) const { return sides_[i].middle + sides_[i].handle * sides_[i].inwards; }

  FaceMiddle middle_at(const Vec3& point) const {
    FaceMiddle middle{point, Vec3::Zero()};
    double scale = 0;
    for (std::size_t i = 0; i < sides_.size(); ++i) {
      const Vec3 a = tip(i) - point, b = tip((i + 1) % sides_.size()) - point;
      middle.normal += a.cross(b);
      scale += a.norm() * b.norm();
    }
    if (middle.normal.norm() <= 1e-6 * scale) middle.normal = face_.normal;  // two sides: the spokes are one line
    middle.normal.normalize();
    return middle;
  }

  /// From the middle of side i to the middle of the face, seen by the patch of that side's start.
  PatchSide spoke(std::size_t i, const FaceMiddle& middle) const {
    const FaceSide& side = sides_[i];
    Vec3 back = tip(i) - middle.point;
    back -= middle.normal.dot(back) * middle.normal;
    back = side.handle * back.normalized();
    PatchSide result;
    result.points = {side.middle, tip(i), middle.point + back, middle.point};
    result.common = true;
    result.across = {-side.tangent, middle.normal.cross(-back).normalized()};
    return result;
  }

  static PatchSide turned_side(const PatchSide& side) {
    return {{side.points[3], side.points[2], side.points[1], side.points[0]},
            side.common,
            {-side.across[1], -side.across[0]}};
  }

  std::vector<GregoryPatch> star(const FaceMiddle& middle) const {
    std::vector<GregoryPatch> patches;
    const std::size_t n = sides_.size();
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t before = (i + n - 1) % n;
      patches.push_back(span_patch(
          {sides_[i].first, spoke(i, middle), turned_side(spoke(before, middle)), sides_[before].second}, options_));
    }
    return patches;
  }

  static double least_of(const std::vector<GregoryPatch>& patches) {
    double least = 1;
    for (const GregoryPatch& patch : patches) least = std::min(least, least_turn(patch));
    return least;
  }

  /// Moves the middle uphill of the least turn, by halving steps along the axes.
  void improve(FaceMiddle& middle, std::vector<GregoryPatch>& patches, double& quality) const {
    double step = 0;
    for (const FaceSide& side : sides_) step = std::max(step, (side.middle - middle.point).norm() / 4);
    for (int move = 0; move < most_moves && quality < 0; ++move) {
      bool better = false;
      for (int direction = 0; direction < 6; ++direction) {
        const Vec3 by = (direction % 2 == 0 ? step : -step) * Vec3::Unit(direction / 2);
        const FaceMiddle trial = middle_at(middle.point + by);
        std::vector<GregoryPatch> trial_patches = star(trial);
        const double trial_quality = least_of(trial_patches);
        if (trial_quality <= quality) continue;
        middle = trial;
        patches = std::move(trial_patches);
        quality = trial_quality;
        better = true;
      }
      if (!better) step /= 2;
    }
  }

  const Brep& brep_;
  const BrepFace& face_;
  const PatchOptions& options_;
  std::vector<FaceSide> sides_;
};

Finding patch_folded(const Brep& brep, Index face) {
  std::vector<Subject> subjects = {numbered_subject(SubjectKind::Face, face)};
  std::string ids;
  for (const Index half : brep.around(brep.faces[face].loops[0])) {
    Subject subject;
    subject.kind = SubjectKind::Stroke;
    subject.id = brep.edges[brep.half_edges[half].edge].id;
    ids += (ids.empty() ? "" : ", ") + subject.id;
    subjects.push_back(std::move(subject));
  }
  return make_warning(Category::Geometry, "PATCH_FOLDED",
                      "The smooth surface inside the strokes " + ids +
                          " folds over: divide the face by another stroke or make its outline less bent.",
                      std::move(subjects));
}

}  // namespace

Findings span_patches(Brep& brep, const PatchOptions& options) {
  Findings findings;
  for (Index f = 0; f < brep.faces.size(); ++f) {
    BrepFace& face = brep.faces[f];
    face.patches.clear();
    if (face.planar) continue;
    bool folded = false;
    face.patches = FaceSpanner(brep, face, options).run(folded);
    if (folded) findings.push_back(patch_folded(brep, f));
  }
  return findings;
}

}  // namespace croquis
