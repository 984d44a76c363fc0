// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/remeshing/flat_faces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "algorithms/remeshing/edge_collapse.h"
#include "algorithms/remeshing/improvement.h"
#include "algorithms/remeshing/surface_parts.h"
#include "croquis/base/parallel.h"
#include "croquis/geometry/triangle_fans.h"
#include "croquis/geometry/triangle_tree.h"

namespace croquis::remeshing {
namespace {

using Triangles = std::vector<std::array<Vec3, 3>>;

constexpr double longest_edge_made = 16;  // × cell: longer ones save hardly any faces
constexpr double points_within = 0.95;    // × what is allowed: between vertices it may be a little more
constexpr double between_samples = 0.25;  // × cell
constexpr int most_halvings = 2;          // of what is allowed around faults; then it is left as it was
constexpr int most_rounds = 8;            // of that; then whole parts are left as they were

constexpr std::size_t triangles_per_part = 256;
constexpr double least_part = 0.02;       // × distance: what is cut no further
constexpr double on_plane = 1e-6;         // × distance: corners so near to a plane lie on it
constexpr std::size_t most_corners = 12;  // of a convex part: those with more are halved first

/// A convex polygon. Parts that have been cut off have one corner more at most.
struct ConvexPart {
  std::array<Vec3, most_corners + 4> corners;
  std::size_t count = 0;

  std::span<const Vec3> all() const { return {corners.data(), count}; }
  void add(const Vec3& corner) { corners[count++] = corner; }

  Vec3 middle() const {
    Vec3 sum = Vec3::Zero();
    for (const Vec3& p : all()) sum += p;
    return sum / static_cast<double>(count);
  }
};

/// What of a part lies on the positive side of a plane, and what on the other one.
/// @param unit its normal @param slack what is no farther from it counts as on it
std::array<ConvexPart, 2> sides_of(const ConvexPart& part, const Vec3& origin, const Vec3& unit, double slack) {
  std::array<ConvexPart, 2> sides;
  const auto height = [&](const Vec3& p) {
    const double here = unit.dot(p - origin);
    return std::abs(here) <= slack ? 0.0 : here;
  };
  Vec3 last = part.corners[part.count - 1];
  double before = height(last);
  bool is_above = false, is_below = false;
  for (const Vec3& p : part.all()) {
    const double here = height(p);
    if (here * before < 0) {
      const Vec3 crossing = last + before / (before - here) * (p - last);
      for (ConvexPart& side : sides) side.add(crossing);
    }
    if (here >= 0) sides[0].add(p);
    if (here <= 0) sides[1].add(p);
    is_above = is_above || here > 0;
    is_below = is_below || here < 0;
    before = here;
    last = p;
  }
  if (!is_above) sides[0].count = 0;
  if (!is_below) sides[1].count = 0;
  return sides;
}

/// That a triangle lies within a distance of a surface.
class Proof {
 public:
  Proof(const TriangleTree& surface, double distance) : surface_(surface), distance_(distance) {}

  bool holds(const std::array<Vec3, 3>& triangle, Index guess) {
    ConvexPart whole;
    for (const Vec3& corner : triangle) whole.add(corner);
    if (guess != no_index && is_near(whole, surface_.triangle(guess))) return true;
    open_ = {whole};
    while (!open_.empty()) {
      const ConvexPart part = open_.back();
      open_.pop_back();
      if (!look_at(part)) return false;
    }
    return true;
  }

 private:
  /// False when a part can't be proven; else what of it is still open has been put there.
  bool look_at(const ConvexPart& part) {
    const Vec3 middle = part.middle();
    const TriangleFoot foot = surface_.nearest(middle, distance_);
    if (foot.triangle == no_index) return false;
    const std::array<Vec3, 3>& near = surface_.triangle(foot.triangle);
    if (is_near(part, near)) return true;
    double radius = 0;
    for (const Vec3& p : part.all()) radius = std::max(radius, (p - middle).norm());
    if (foot.distance + radius <= distance_) return true;
    if (radius < least_part * distance_) return false;
    if (part.count > most_corners || !cut_along(part, near)) halve(part);
    return true;
  }

  bool is_near(const ConvexPart& part, const std::array<Vec3, 3>& near) const {
    return std::ranges::all_of(part.all(),
                               [&](const Vec3& p) { return foot_on_triangle(near, p).distance <= distance_; });
  }

  /// Cuts along the upright planes through a triangle's edges. @return false when none of them meets the part
  bool cut_along(const ConvexPart& part, const std::array<Vec3, 3>& near) {
    const Vec3 normal = (near[1] - near[0]).cross(near[2] - near[0]);
    ConvexPart over = part;
    bool is_cut = false;
    for (std::size_t e = 0; e < 3; ++e) {
      const Vec3 outwards = (near[(e + 1) % 3] - near[e]).cross(normal);
      if (!(outwards.norm() > 0)) continue;
      const auto [beyond, rest] = sides_of(over, near[e], outwards.normalized(), on_plane * distance_);
      if (beyond.count == 0 || rest.count == 0) continue;
      open_.push_back(beyond);
      over = rest;
      is_cut = true;
    }
    if (is_cut && !is_near(over, near)) open_.push_back(over);
    return is_cut;
  }

  void halve(const ConvexPart& part) {
    std::size_t a = 0, b = 0;
    const auto between = [&](std::size_t i, std::size_t j) { return Vec3(part.corners[i] - part.corners[j]); };
    for (std::size_t i = 0; i < part.count; ++i)
      for (std::size_t j = 0; j < i; ++j)
        if (between(i, j).squaredNorm() > between(a, b).squaredNorm()) a = i, b = j;
    const Vec3 middle = 0.5 * (part.corners[a] + part.corners[b]);
    for (const ConvexPart& half : sides_of(part, middle, between(a, b).normalized(), 0)) open_.push_back(half);
  }

  const TriangleTree& surface_;
  double distance_;
  std::vector<ConvexPart> open_;
};

/// Places of a triangle but its corners, so far apart at most.
void add_places(const std::array<Vec3, 3>& t, double apart, std::vector<Vec3>& places) {
  const double longest = std::max({(t[1] - t[0]).norm(), (t[2] - t[1]).norm(), (t[0] - t[2]).norm()});
  const int count = std::max(static_cast<int>(std::ceil(longest / apart)), 2);
  for (int i = 0; i <= count; ++i) {
    for (int j = 0; i + j <= count; ++j) {
      if (i == count || j == count || i + j == 0) continue;
      places.push_back(t[0] + (i * (t[1] - t[0]) + j * (t[2] - t[0])) / count);
    }
  }
}

/// Collapses edges, looks at what came out, and does it again with less allowed around faults, until there are none.
class Merging {
 public:
  Merging(const RemeshModel& model, const PolyMesh& made, const std::vector<RemeshPart>& parts,
          const std::vector<PieceShape>& shapes)
      : model_(model), made_(made), parts_(parts), shapes_(shapes), off_(model.options.adaptive * model.cell) {}

  MergedFaces run(std::span<const std::int32_t> labels, Progress& progress) {
    give_roles(labels, progress.step("merge flat faces", 0.01));
    proven_.resize(made_.face_count());
    halvings_.assign(roles_.size(), 0);
    const CollapseLimits limits{points_within * off_, longest_edge_made * model_.cell, halvings_};
    for (int round = 0;; ++round) {
      const double share = round == 0 ? 0.7 : 0.05;
      Progress collapsing = progress.step("merge flat faces", 0.5 * share);
      merged_ = collapse_edges(made_, roles_, limits, collapsing);
      faults_.clear();
      face_faults_.clear();
      part_faults_.clear();
      look_for_gone(progress.step("compare surfaces", 0.1 * share));
      look_at_changed(progress.step("compare surfaces", 0.2 * share));
      look_at_cuts(progress.step("look for cuts", 0.1 * share));
      look_at_scan(progress.step("compare with the scan", 0.1 * share));
      look_at_extents();
      if (!allow_less(round >= most_rounds)) return rest();
    }
  }

 private:
  void give_roles(std::span<const std::int32_t> labels, Progress progress) {
    const TriangleFans fans(made_.vertex_count(), made_.corners);
    const std::vector<TriangleFans::Link> links = fans.links(model_.threads(), progress);
    roles_.assign(made_.vertex_count(), VertexRole::Fenced);
    for (std::size_t v = 0; v < roles_.size(); ++v) {
      const auto fan = fans.at(v);
      const auto is_elsewhere = [&](Index corner) { return labels[corner / 3] != labels[fan.front() / 3]; };
      if (links[v] == TriangleFans::Link::Path) roles_[v] = VertexRole::Kept;
      if (links[v] == TriangleFans::Link::Cycle)
        roles_[v] = std::ranges::any_of(fan, is_elsewhere) ? VertexRole::Kept : VertexRole::Free;
    }
    for (const RemeshPart& part : parts_) {
      if (part.is_solid) continue;
      for (const LooseVertex& loose : shapes_[part.pieces.front()].loose)
        roles_[part.first_vertex + loose.vertex] = VertexRole::Fenced;
    }
  }

  /// The merged triangles of a part, over the vertices that they use.
  PolyMesh merged_surface(const RemeshPart& part) const {
    const auto number_of = [&](std::size_t face) {
      return static_cast<std::size_t>(std::ranges::lower_bound(merged_.face_of, face) - merged_.face_of.begin());
    };
    const std::size_t first = number_of(part.first_face), last = number_of(part.first_face + part.face_count);
    std::vector<Index> number(part.vertex_count, no_index);
    PolyMesh mesh;
    for (std::size_t t = first; t < last; ++t) {
      for (const Index v : merged_.triangles[t]) {
        Index& own = number[v - part.first_vertex];
        if (own == no_index) {
          own = static_cast<Index>(mesh.positions.size());
          mesh.positions.push_back(made_.positions[v]);
        }
        mesh.corners.push_back(own);
      }
    }
    set_triangle_offsets(mesh);
    return mesh;
  }

  /// Whether all that has gone is near to what is left.
  void look_for_gone(Progress progress) {
    Triangles left, gone;
    std::vector<Index> gone_at, guesses;
    std::vector<std::uint8_t> stays(made_.face_count(), 0);
    for (Index t = 0; t < merged_.triangles.size(); ++t) {
      left.push_back(merged_places(t));
      if (!is_changed(t)) stays[merged_.face_of[t]] = 1;
    }
    for (Index f = 0; f < stays.size(); ++f) {
      if (stays[f] != 0) continue;
      const auto face = made_.face(f);
      gone.push_back(places_of(made_.positions, face));
      gone_at.push_back(f);
      guesses.push_back(std::min({merged_.home[face[0]], merged_.home[face[1]], merged_.home[face[2]]}));
    }
    const TriangleTree tree(std::move(left), progress);
    for (const Index i : faces_beyond(gone, guesses, tree, off_, model_.threads(), progress))
      face_faults_.push_back(gone_at[i]);
  }

  /// Whether all that has been merged is near to what was there. What was proven in an earlier round holds.
  void look_at_changed(Progress progress) {
    Triangles changed;
    fresh_.clear();
    for (Index t = 0; t < merged_.triangles.size(); ++t) {
      if (!is_changed(t) || proven_[merged_.face_of[t]] == merged_.triangles[t]) continue;
      changed.push_back(merged_places(t));
      fresh_.push_back(t);
      proven_[merged_.face_of[t]] = merged_.triangles[t];
    }
    const TriangleTree tree(places_of(made_), progress);
    for (const Index i : faces_beyond(changed, {}, tree, off_, model_.threads(), progress)) refuse(fresh_[i]);
  }

  void look_at_cuts(Progress progress) {
    PolyMesh mesh;
    mesh.positions = made_.positions;
    for (const auto& triangle : merged_.triangles)
      mesh.corners.insert(mesh.corners.end(), triangle.begin(), triangle.end());
    set_triangle_offsets(mesh);
    for (const auto& pair : find_cuts(mesh, model_.threads(), std::move(progress))) {
      if (!is_changed(pair[0]) && !is_changed(pair[1])) continue;  // did so before
      faults_.insert(faults_.end(), pair.begin(), pair.end());
    }
  }

  /// Places that are off the scan; of a solid those that are off all of its pieces.
  std::vector<std::uint8_t> off_scan(const RemeshPart& part, const PolyMesh& places, Progress& progress) const {
    std::vector<std::uint8_t> is_off(places.vertex_count(), 1);
    for (const std::size_t number : part.pieces) {
      const RemeshPiece& piece = model_.pieces.pieces[number];
      const RemeshPoints points = model_.points_of(piece);
      UnbackedVertices unbacked =
          unbacked_in(model_, piece, points, places, shapes_[number].openings.holes(), progress.silent());
      for (const LooseVertex& loose : unbacked.loose) unbacked.is_far[loose.vertex] = 1;
      for (std::size_t i = 0; i < is_off.size(); ++i) is_off[i] &= unbacked.is_far[i];
    }
    return is_off;
  }

  /// Vertices were looked at when they were made; what lies between them follows: triangles that aren't near to the
  /// scan with all their points are looked at place by place, since they may lie in holes.
  void look_at_scan(Progress progress) {
    Triangles given, fresh;
    for (const auto& triangle : model_.analysis.view.triangles)
      given.push_back(places_of(model_.mesh.positions, triangle));
    for (const Index t : fresh_) fresh.push_back(merged_places(t));
    const TriangleTree tree(std::move(given), progress);
    const std::vector<Index> doubtful = faces_beyond(fresh, {}, tree, near_of(model_), model_.threads(), progress);
    auto next = doubtful.begin();
    for (const RemeshPart& part : parts_) {
      PolyMesh places;
      std::vector<Index> triangle_at;
      for (; next != doubtful.end() && merged_.face_of[fresh_[*next]] < part.first_face + part.face_count; ++next) {
        add_places(fresh[*next], between_samples * model_.cell, places.positions);
        triangle_at.resize(places.positions.size(), fresh_[*next]);
      }
      if (places.positions.empty()) continue;
      const std::vector<std::uint8_t> is_off = off_scan(part, places, progress);
      for (std::size_t i = 0; i < is_off.size(); ++i)
        if (is_off[i] != 0) refuse(triangle_at[i]);
    }
  }

  void look_at_extents() {
    for (const RemeshPart& part : parts_) {
      const PieceShape& shape = shapes_[part.pieces.front()];
      if (part.is_solid || !shape.given || shape.change.any()) continue;
      const PolyMesh mesh = merged_surface(part);
      if (mesh.face_count() == part.face_count) continue;
      const RemeshPiece& piece = model_.pieces.pieces[part.pieces.front()];
      const PieceExtent extent = extent_of_surface(mesh, shape.is_closed());
      if (change_of(*shape.given, extent, model_.analysis, piece, model_.cell).any()) part_faults_.push_back(&part);
    }
  }

  void spare(std::span<const Index> vertices) {
    for (const Index v : vertices) {
      if (std::exchange(is_spared_[v], std::uint8_t{1}) != 0) continue;
      if (++halvings_[v] > most_halvings) roles_[v] = VertexRole::Fenced;
    }
  }

  /// Less is allowed around faults, at last nothing. What is at fault wasn't there before: at least one of the vertices
  /// around it has gone. @return whether there were any
  bool allow_less(bool whole_parts) {
    if (faults_.empty() && face_faults_.empty() && part_faults_.empty()) return false;
    is_spared_.assign(roles_.size(), 0);
    for (const RemeshPart* part : part_faults_)
      for (std::size_t v = 0; v < part->vertex_count; ++v)
        spare(std::array{static_cast<Index>(part->first_vertex + v)});
    std::vector<std::uint8_t> is_fault(merged_.triangles.size(), 0);
    for (const Index t : faults_) is_fault[t] = 1;
    for (const Index f : face_faults_)
      for (const Index v : made_.face(f))
        if (merged_.home[v] != no_index) is_fault[merged_.home[v]] = 1;
    for (Index v = 0; v < roles_.size(); ++v)
      if (merged_.home[v] != no_index && is_fault[merged_.home[v]] != 0) spare(std::array{v});
    std::vector<Index> faces = face_faults_;
    for (Index t = 0; t < is_fault.size(); ++t) {
      if (is_fault[t] == 0) continue;
      spare(merged_.triangles[t]);
      faces.push_back(merged_.face_of[t]);
    }
    for (const Index f : faces) {
      spare(made_.face(f));
      if (!whole_parts) continue;
      const RemeshPart& part = *(std::ranges::upper_bound(parts_, std::size_t{f}, {}, &RemeshPart::first_face) - 1);
      std::fill_n(roles_.begin() + static_cast<std::ptrdiff_t>(part.first_vertex), part.vertex_count,
                  VertexRole::Fenced);
    }
    return true;
  }

  /// What is left, numbered anew.
  MergedFaces rest() {
    MergedFaces result;
    result.face_of = std::move(merged_.face_of);
    std::vector<Index> number(made_.vertex_count(), no_index);
    for (const auto& triangle : merged_.triangles)
      for (const Index v : triangle) number[v] = 0;
    for (Index v = 0; v < number.size(); ++v) {
      if (number[v] == no_index) continue;
      number[v] = static_cast<Index>(result.vertex_of.size());
      result.vertex_of.push_back(v);
      result.mesh.positions.push_back(made_.positions[v]);
    }
    for (const auto& triangle : merged_.triangles)
      for (const Index v : triangle) result.mesh.corners.push_back(number[v]);
    set_triangle_offsets(result.mesh);
    return result;
  }

  bool is_changed(std::size_t t) const {
    return !std::ranges::equal(merged_.triangles[t], made_.face(merged_.face_of[t]));
  }
  std::array<Vec3, 3> merged_places(std::size_t t) const { return places_of(made_.positions, merged_.triangles[t]); }
  void refuse(Index t) {
    faults_.push_back(t);
    proven_[merged_.face_of[t]] = {};
  }

  const RemeshModel& model_;
  const PolyMesh& made_;
  const std::vector<RemeshPart>& parts_;
  const std::vector<PieceShape>& shapes_;
  double off_;
  std::vector<VertexRole> roles_;
  std::vector<std::uint8_t> halvings_, is_spared_;  // per vertex
  CollapsedMesh merged_;
  std::vector<std::array<Index, 3>> proven_;  // per face: what was merged in its place, and is near to surface and scan
  std::vector<Index> fresh_;                  // merged triangles that weren't there in earlier rounds, ascending
  std::vector<Index> faults_;                 // of merged triangles
  std::vector<Index> face_faults_;            // of faces made that nothing is near to
  std::vector<const RemeshPart*> part_faults_;  // of parts with another extent
};
}  // namespace

std::vector<Index> faces_beyond(std::span<const std::array<Vec3, 3>> triangles, std::span<const Index> guesses,
                                const TriangleTree& surface, double distance, int threads, Progress& progress) {
  std::vector<std::uint8_t> is_beyond(triangles.size());
  for_each_part(triangles.size(), triangles_per_part, threads, progress, [&](std::size_t begin, std::size_t end) {
    Proof proof(surface, distance);
    for (std::size_t t = begin; t < end; ++t)
      is_beyond[t] = proof.holds(triangles[t], guesses.empty() ? no_index : guesses[t]) ? 0 : 1;
  });
  std::vector<Index> beyond;
  for (Index t = 0; t < is_beyond.size(); ++t)
    if (is_beyond[t] != 0) beyond.push_back(t);
  return beyond;
}

MergedFaces merge_flat_faces(const RemeshModel& model, const PolyMesh& made, const std::vector<RemeshPart>& parts,
                             const std::vector<PieceShape>& shapes, std::span<const std::int32_t> labels,
                             Progress progress) {
  return Merging(model, made, parts, shapes).run(labels, progress);
}

}  // namespace croquis::remeshing
