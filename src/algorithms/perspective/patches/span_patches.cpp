// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cstddef>

#include "algorithms/perspective/patches/face_division.h"
#include "algorithms/perspective/patches/face_star.h"
#include "algorithms/perspective/patches/star_fairing.h"
#include "croquis/perspective/gregory_patches.h"

namespace croquis {
namespace {

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

Star make_star(const std::vector<FaceSide>& sides, StarShape shape, const PatchOptions& options) {
  Star star{std::move(shape), {}, 0};
  star.patches = star_patches(sides, star.shape, options);
  star.quality = least_turn(star.patches);
  return star;
}

/// Moves the middle of a folded star uphill of the least turn, by halving steps along the axes.
void unfold(const std::vector<FaceSide>& sides, const PatchOptions& options, Star& star) {
  double reach = 0;
  for (const FaceSide& side : sides) reach = std::max(reach, (side.middle - star.shape.middle).norm() / 4);
  for (int move = 0; move < most_moves && star.quality < 0; ++move) {
    bool better = false;
    for (int direction = 0; direction < 6; ++direction) {
      const Vec3 by = (direction % 2 == 0 ? reach : -reach) * Vec3::Unit(direction / 2);
      Star trial = make_star(sides, with_middle(star.shape, sides, star.shape.middle + by), options);
      if (trial.quality <= star.quality) continue;
      star = std::move(trial);
      better = true;
    }
    if (!better) reach /= 2;
  }
}

/// The patches of a face; `folded` tells whether one of them folds over.
std::vector<GregoryPatch> span_face(const Brep& brep, const BrepFace& face, const PatchOptions& options, bool& folded) {
  const std::vector<FaceSide> sides = face_sides(brep, face);
  if (sides.size() == 4 && std::ranges::all_of(sides, &FaceSide::whole)) {
    std::vector<GregoryPatch> patches = {
        span_patch({sides[0].as_one(), sides[1].as_one(), sides[2].as_one(), sides[3].as_one()}, options)};
    folded = least_turn(patches) < 0;
    return patches;
  }
  Star star = make_star(sides, round_star(sides, face.normal), options);
  unfold(sides, options, star);
  if (options.slope == SlopeRule::Fair) {
    Star fair = make_star(sides, fair_star(sides, star.shape, options), options);
    if (fair.quality > 0 || fair.quality >= star.quality) star = std::move(fair);
  }
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
    Subject subject;
    subject.kind = SubjectKind::Stroke;
    subject.id = id;
    named += (named.empty() ? "" : ", ") + id;
    subjects.push_back(std::move(subject));
  }
  return make_warning(Category::Geometry, "PATCH_FOLDED",
                      "The smooth surface inside the strokes " + named +
                          " folds over: divide the face by another stroke or make its outline less bent.",
                      std::move(subjects));
}

bool spans_without_fold(Brep& brep, Index face, const PatchOptions& options) {
  bool folded = false;
  brep.faces[face].patches = span_face(brep, brep.faces[face], options, folded);
  return !folded;
}

/// Spans a face; where it folds, divides it, and its parts again, until no part folds.
/// @param left divisions that may still be tried
bool span_in_parts(Brep& brep, Index face, const PatchOptions& options, int& left) {
  if (spans_without_fold(brep, face, options)) return true;
  for (const FaceDiagonal& diagonal : diagonals(brep, face)) {
    if (--left < 0) return false;
    Brep divided = brep;
    divide_face(divided, face, diagonal, options);
    const auto part = static_cast<Index>(divided.faces.size() - 1);
    if (!span_in_parts(divided, face, options, left) || !span_in_parts(divided, part, options, left)) continue;
    brep = std::move(divided);
    return true;
  }
  return false;
}

}  // namespace

Findings span_patches(Brep& brep, const PatchOptions& options) {
  Findings findings;
  const std::size_t count = brep.faces.size();
  for (Index f = 0; f < count; ++f) {
    brep.faces[f].patches.clear();
    if (brep.faces[f].planar) continue;
    int left = most_divisions;
    if (span_in_parts(brep, f, options, left)) continue;
    findings.push_back(patch_folded(brep, brep.faces[f]));
  }
  return findings;
}

}  // namespace croquis
