// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cstddef>

#include <Eigen/Dense>

#include "algorithms/perspective/patches/face_division.h"
#include "algorithms/perspective/patches/patch_fairing.h"
#include "algorithms/perspective/patches/star_fairing.h"
#include "croquis/perspective/solid.h"

namespace croquis {
namespace {

/// A slope chosen by proportion may be so many times the ends' mean; else the mean is taken.
constexpr double least_slope = 0.2, greatest_slope = 4;

Vec3 cubic_middle(const std::array<Vec3, 4>& p) { return (p[0] + 3 * p[1] + 3 * p[2] + p[3]) / 8; }

/// A leg as k · across + h · handle, by least squares.
struct LegParts {
  double across, along;
};

LegParts leg_parts(const Vec3& leg, const Vec3& across, const Vec3& handle) {
  const double aa = across.dot(across), ac = across.dot(handle), cc = handle.dot(handle);
  const double determinant = aa * cc - ac * ac;
  if (determinant <= 0) return {0, 0};
  const double la = leg.dot(across), lc = leg.dot(handle);
  return {(la * cc - lc * ac) / determinant, (lc * aa - la * ac) / determinant};
}

/// The slopes across a side are k(t) a(t) + h(t) c(t): k is a quadratic with the free middle coefficient, a and h are
/// linear, c is the side's direction.
struct CommonSlope {
  std::array<Vec3, 2> a;
  std::array<double, 2> k, h;
  std::array<Vec3, 3> c;

  std::array<Vec3, 2> inner(double km) const {
    return {(k[0] * a[1] + 2 * km * a[0]) / 3 + (2 * h[0] * c[1] + h[1] * c[0]) / 3,
            (2 * km * a[1] + k[1] * a[0]) / 3 + (h[0] * c[2] + 2 * h[1] * c[1]) / 3};
  }
};

class PatchSpanner {
 public:
  explicit PatchSpanner(const std::array<PatchSide, 4>& sides) : sides_(sides) {
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t j = 0; j < 3; ++j) patch_.boundary[3 * i + j] = sides[i].points[j];
    }
  }

  GregoryPatch run() {
    for (std::size_t i = 0; i < 4; ++i) {
      if (!sides_[i].common) {
        set_even(i);
        continue;
      }
      slopes_[i] = common_slope(i);
      middle_[i] = proportion(i);
      set_common(i);
    }
    make_fair();
    return patch_;
  }

 private:
  const Vec3& boundary(std::size_t i) const { return patch_.boundary[i % 12]; }
  Vec3 first_leg(std::size_t side) const { return boundary(3 * side + 11) - boundary(3 * side); }
  Vec3 last_leg(std::size_t side) const { return boundary(3 * side + 4) - boundary(3 * side + 3); }

  void set_inner(std::size_t side, const Vec3& first, const Vec3& second) {
    patch_.inner[2 * side] = boundary(3 * side + 1) + first;
    patch_.inner[(2 * side + 3) % 8] = boundary(3 * side + 2) + second;
  }

  void set_even(std::size_t side) {
    const Vec3 first = first_leg(side), last = last_leg(side);
    set_inner(side, (2 * first + last) / 3, (first + 2 * last) / 3);
  }

  void set_common(std::size_t side) {
    const std::array<Vec3, 2> inner = slopes_[side].inner(middle_[side]);
    set_inner(side, inner[0], inner[1]);
  }

  CommonSlope common_slope(std::size_t side) const {
    const std::array<Vec3, 4>& p = sides_[side].points;
    CommonSlope slope{sides_[side].across, {}, {}, {p[1] - p[0], p[2] - p[1], p[3] - p[2]}};
    const LegParts first = leg_parts(first_leg(side), slope.a[0], slope.c[0]);
    const LegParts last = leg_parts(last_leg(side), slope.a[1], slope.c[2]);
    slope.k = {first.across, last.across};
    slope.h = {first.along, last.along};
    return slope;
  }

  double mean(std::size_t side) const { return (slopes_[side].k[0] + slopes_[side].k[1]) / 2; }

  /// The neighbouring sides' mean of handle by chord, times the distance to the opposite side.
  double proportion(std::size_t side) const {
    const std::array<Vec3, 4>&before = sides_[(side + 3) % 4].points, &after = sides_[(side + 1) % 4].points;
    const double rho = ((before[2] - before[3]).norm() / (before[3] - before[0]).norm() +
                        (after[1] - after[0]).norm() / (after[3] - after[0]).norm()) /
                       2;
    const double width = (cubic_middle(sides_[side].points) - cubic_middle(sides_[(side + 2) % 4].points)).norm();
    const CommonSlope& slope = slopes_[side];
    const double km = 2 * rho * width / ((slope.a[0] + slope.a[1]) / 2).norm() - mean(side);
    const double ratio = km / mean(side);
    return ratio > least_slope && ratio < greatest_slope ? km : mean(side);
  }

  /// How a side's inner points move with the middle coefficient.
  Vec3 change(std::size_t side, std::size_t end) const { return 2 * slopes_[side].a[end] / 3; }

  /// Energy is quadratic in the points, and these are linear in the middle coefficients.
  void make_fair();

  const std::array<PatchSide, 4>& sides_;
  GregoryPatch patch_;
  std::array<CommonSlope, 4> slopes_{};
  std::array<double, 4> middle_{};
};

void PatchSpanner::make_fair() {
  const Eigen::Matrix<double, 20, 20>& energy = variation_energy();
  const PatchPoints base_force = energy * points_of(patch_);
  std::array<PatchPoints, 4> force;
  std::array<std::array<int, 2>, 4> row{};
  Eigen::Matrix4d system = Eigen::Matrix4d::Identity();
  Eigen::Vector4d right = Eigen::Vector4d::Zero();
  for (std::size_t i = 0; i < 4; ++i) {
    if (!sides_[i].common) continue;
    row[i] = {static_cast<int>(12 + 2 * i), static_cast<int>(12 + (2 * i + 3) % 8)};
    force[i] = energy.col(row[i][0]) * change(i, 0).transpose() + energy.col(row[i][1]) * change(i, 1).transpose();
  }
  const auto work = [&](const PatchPoints& of, std::size_t side) {
    return of.row(row[side][0]).dot(change(side, 0)) + of.row(row[side][1]).dot(change(side, 1));
  };
  for (std::size_t i = 0; i < 4; ++i) {
    if (!sides_[i].common) continue;
    for (std::size_t j = 0; j < 4; ++j) {
      system(static_cast<int>(i), static_cast<int>(j)) = sides_[j].common ? work(force[i], j) : 0;
    }
    right[static_cast<int>(i)] = -work(base_force, i);
  }
  const Eigen::Vector4d solved = system.ldlt().solve(right);
  for (std::size_t i = 0; i < 4; ++i) {
    if (!sides_[i].common) continue;
    const double km = middle_[i] + solved[static_cast<int>(i)], ratio = km / mean(i);
    if (ratio > least_slope && ratio < greatest_slope) middle_[i] = km;
    set_common(i);
  }
}

/// A patch is looked at in so many cells each way for folds.
constexpr int fold_cells = 8;

/// Moves of the middle of a folded face.
constexpr int most_moves = 20;

/// Divisions that are tried for a folded face and its parts.
constexpr int most_divisions = 30;

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

double least_turn(const std::vector<GregoryPatch>& patches) {
  double least = 1;
  for (const GregoryPatch& patch : patches) least = std::min(least, least_turn(patch));
  return least;
}

/// A star with its patches and how far these are from folding over.
struct Star {
  StarShape shape;
  std::vector<GregoryPatch> patches;
  double quality = 0;
};

Star make_star(const std::vector<FaceSide>& sides, StarShape shape) {
  Star star{std::move(shape), {}, 0};
  star.patches = star_patches(sides, star.shape);
  star.quality = least_turn(star.patches);
  return star;
}

/// Moves the middle of a folded star uphill of the least turn, by halving steps along the axes.
void unfold(const std::vector<FaceSide>& sides, Star& star) {
  double reach = 0;
  for (const FaceSide& side : sides) reach = std::max(reach, (side.middle - star.shape.middle).norm() / 4);
  for (int move = 0; move < most_moves && star.quality < 0; ++move) {
    bool better = false;
    for (int direction = 0; direction < 6; ++direction) {
      const Vec3 by = (direction % 2 == 0 ? reach : -reach) * Vec3::Unit(direction / 2);
      Star trial = make_star(sides, with_middle(star.shape, sides, star.shape.middle + by));
      if (trial.quality <= star.quality) continue;
      star = std::move(trial);
      better = true;
    }
    if (!better) reach /= 2;
  }
}

/// The patches of a face; `folded` says whether one of them folds over.
std::vector<GregoryPatch> span_face(const Brep& brep, const BrepFace& face, bool& folded) {
  const std::vector<FaceSide> sides = face_sides(brep, face);
  if (sides.size() == 4 && std::ranges::all_of(sides, &FaceSide::whole)) {
    std::vector<GregoryPatch> patches = {
        span_patch({sides[0].as_one(), sides[1].as_one(), sides[2].as_one(), sides[3].as_one()})};
    folded = least_turn(patches) < 0;
    return patches;
  }
  Star star = make_star(sides, round_star(sides, face.normal));
  unfold(sides, star);
  Star fair = make_star(sides, fair_star(sides, star.shape));
  if (fair.quality > 0 || fair.quality >= star.quality) star = std::move(fair);
  folded = star.quality < 0;
  return star.patches;
}

/// The edges of a face that were drawn.
std::vector<std::string> strokes_around(const Brep& brep, const BrepFace& face) {
  std::vector<std::string> ids;
  for (const Index half : brep.around(face.loops[0])) {
    const BrepEdge& edge = brep.edges[brep.half_edges[half].edge];
    if (edge.curve != no_index) ids.push_back(edge.id);
  }
  return ids;
}

Finding patch_folded(const Brep& brep, const BrepFace& face) {
  std::vector<Subject> subjects = {numbered_subject(SubjectKind::Face, face.outline)};
  std::string named;
  for (const std::string& id : strokes_around(brep, face)) {
    named += (named.empty() ? "" : ", ") + id;
    subjects.push_back({SubjectKind::Stroke, id, {}, {}, {}});
  }
  return make_warning(Category::Geometry, "PATCH_FOLDED",
                      "The smooth surface inside the strokes " + named +
                          " folds over: divide the face by another stroke or make its outline less bent.",
                      std::move(subjects));
}

bool spans_without_fold(Brep& brep, Index face) {
  bool folded = false;
  brep.faces[face].patches = span_face(brep, brep.faces[face], folded);
  return !folded;
}

/// Spans a face; where it folds, divides it, and its parts again, until no part folds.
/// @param left divisions that may still be tried
bool span_in_parts(Brep& brep, Index face, int& left) {
  if (spans_without_fold(brep, face)) return true;
  for (const FaceDiagonal& diagonal : diagonals(brep, face)) {
    if (--left < 0) return false;
    Brep divided = brep;
    divide_face(divided, face, diagonal);
    const auto part = static_cast<Index>(divided.faces.size() - 1);
    if (!span_in_parts(divided, face, left) || !span_in_parts(divided, part, left)) continue;
    brep = std::move(divided);
    return true;
  }
  return false;
}

}  // namespace

GregoryPatch span_patch(const std::array<PatchSide, 4>& sides) { return PatchSpanner(sides).run(); }

Findings span_patches(Brep& brep) {
  Findings findings;
  const std::size_t count = brep.faces.size();
  for (Index f = 0; f < count; ++f) {
    brep.faces[f].patches.clear();
    if (brep.faces[f].planar) continue;
    int left = most_divisions;
    if (span_in_parts(brep, f, left)) continue;
    findings.push_back(patch_folded(brep, brep.faces[f]));
  }
  return findings;
}

}  // namespace croquis
