// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/remeshing/simplification/flat_faces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "algorithms/remeshing/remesh_cuts.h"
#include "algorithms/remeshing/simplification/edge_collapse.h"
#include "algorithms/remeshing/simplification/surface_deviation.h"
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

class Merging {
 public:
  Merging(const RemeshModel& model, const PolyMesh& made, const std::vector<RemeshPart>& parts,
          const std::vector<PieceShape>& shapes, std::span<const std::int32_t> labels)
      : model_(model),
        made_(made),
        parts_(parts),
        shapes_(shapes),
        labels_(labels),
        off_(model.options.adaptive * model.cell) {}

  MergedFaces run(Progress& progress);

 private:
  void give_roles(Progress& progress);
  void look_for_gone(Progress& progress);
  void look_at_changed(Progress& progress);
  void look_at_cuts(Progress& progress);
  void look_at_scan(Progress& progress);
  bool look_at_room();
  bool spare_faults(bool whole_parts);
  MergedFaces rest();
  void fence_part(const RemeshPart& part);
  void spare(Index v);
  void spare_face(Index face);

  bool is_changed(std::size_t t) const {
    return !std::ranges::equal(merged_.triangles[t], made_.face(merged_.face_of[t]));
  }
  std::array<Vec3, 3> corners(const std::array<Index, 3>& t) const {
    return {made_.positions[t[0]], made_.positions[t[1]], made_.positions[t[2]]};
  }
  PolyMesh surface_of(const RemeshPart& part) const;
  std::vector<std::uint8_t> off_scan(const RemeshPart& part, const PolyMesh& places, Progress& progress) const;
  void refuse(Index t);
  const RemeshPart& part_at(Index face) const;

  const RemeshModel& model_;
  const PolyMesh& made_;
  const std::vector<RemeshPart>& parts_;
  const std::vector<PieceShape>& shapes_;
  std::span<const std::int32_t> labels_;
  double off_;
  std::vector<VertexRole> roles_;
  std::vector<std::uint8_t> halvings_, is_spared_;  // per vertex
  CollapsedMesh merged_;
  std::vector<std::array<Index, 3>> proven_;  // per face: what was merged in its place, and is near to surface and scan
  std::vector<Index> fresh_;                  // merged triangles that weren't there in earlier rounds, ascending
  std::vector<Index> faults_;                 // of merged triangles
  std::vector<Index> face_faults_;            // of faces made that nothing is near to
};

/// Places of a triangle but its corners, so far apart at most.
void add_samples(const std::array<Vec3, 3>& t, double apart, std::vector<Vec3>& places) {
  const double longest = std::max({(t[1] - t[0]).norm(), (t[2] - t[1]).norm(), (t[0] - t[2]).norm()});
  const int count = std::max(static_cast<int>(std::ceil(longest / apart)), 2);
  for (int i = 0; i <= count; ++i) {
    for (int j = 0; i + j <= count; ++j) {
      if (i == count || j == count || i + j == 0) continue;
      places.push_back(t[0] + (i * (t[1] - t[0]) + j * (t[2] - t[0])) / count);
    }
  }
}

void Merging::give_roles(Progress& progress) {
  const TriangleFans fans(made_.vertex_count(), made_.corners);
  const std::vector<TriangleFans::Link> links = fans.links(model_.threads(), progress);
  roles_.assign(made_.vertex_count(), VertexRole::Fenced);
  for (std::size_t v = 0; v < roles_.size(); ++v) {
    const auto fan = fans.at(v);
    const auto is_elsewhere = [&](Index corner) { return labels_[corner / 3] != labels_[fan.front() / 3]; };
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
PolyMesh Merging::surface_of(const RemeshPart& part) const {
  std::vector<Index> number(part.vertex_count, no_index);
  PolyMesh mesh;
  const auto use = [&](Index v) {
    Index& own = number[v - part.first_vertex];
    if (own == no_index) {
      own = static_cast<Index>(mesh.positions.size());
      mesh.positions.push_back(made_.positions[v]);
    }
    return own;
  };
  const auto first = std::ranges::lower_bound(merged_.face_of, part.first_face);
  const auto last = std::ranges::lower_bound(merged_.face_of, part.first_face + part.face_count);
  for (auto it = first; it != last; ++it) {
    const auto& [a, b, c] = merged_.triangles[static_cast<std::size_t>(it - merged_.face_of.begin())];
    const Index one = use(a), two = use(b), three = use(c);
    mesh.add_triangle(one, two, three);
  }
  return mesh;
}

const RemeshPart& Merging::part_at(Index face) const {
  const auto next = std::ranges::upper_bound(parts_, std::size_t{face}, {}, &RemeshPart::first_face);
  return *(next - 1);
}

/// Whether all that has gone is near to what is left.
void Merging::look_for_gone(Progress& progress) {
  Triangles left, gone;
  std::vector<Index> gone_at, guesses;
  std::vector<std::uint8_t> stays(made_.face_count(), 0);
  for (Index t = 0; t < merged_.triangles.size(); ++t) {
    left.push_back(corners(merged_.triangles[t]));
    if (!is_changed(t)) stays[merged_.face_of[t]] = 1;
  }
  for (Index f = 0; f < stays.size(); ++f) {
    if (stays[f] != 0) continue;
    const auto face = made_.face(f);
    gone.push_back(corners({face[0], face[1], face[2]}));
    gone_at.push_back(f);
    guesses.push_back(std::min({merged_.home[face[0]], merged_.home[face[1]], merged_.home[face[2]]}));
  }
  const TriangleTree tree(std::move(left), progress);
  for (const Index i : faces_beyond(gone, guesses, tree, off_, model_.threads(), progress))
    face_faults_.push_back(gone_at[i]);
}

/// Whether all that has been merged is near to what was there. What was proven in an earlier round holds.
void Merging::look_at_changed(Progress& progress) {
  Triangles changed, before;
  fresh_.clear();
  for (Index t = 0; t < merged_.triangles.size(); ++t) {
    if (!is_changed(t) || proven_[merged_.face_of[t]] == merged_.triangles[t]) continue;
    changed.push_back(corners(merged_.triangles[t]));
    fresh_.push_back(t);
    proven_[merged_.face_of[t]] = merged_.triangles[t];
  }
  before.reserve(made_.face_count());
  for (std::size_t f = 0; f < made_.face_count(); ++f) {
    const auto face = made_.face(f);
    before.push_back(corners({face[0], face[1], face[2]}));
  }
  const TriangleTree tree(std::move(before), progress);
  for (const Index i : faces_beyond(changed, {}, tree, off_, model_.threads(), progress)) refuse(fresh_[i]);
}

void Merging::refuse(Index t) {
  faults_.push_back(t);
  proven_[merged_.face_of[t]] = {};
}

void Merging::look_at_cuts(Progress& progress) {
  PolyMesh mesh;
  mesh.positions = made_.positions;
  for (const auto& [a, b, c] : merged_.triangles) mesh.add_triangle(a, b, c);
  for (const auto& pair : find_cuts(mesh, model_.threads(), progress)) {
    if (!is_changed(pair[0]) && !is_changed(pair[1])) continue;  // did so before
    faults_.insert(faults_.end(), pair.begin(), pair.end());
  }
}

/// Places that are off the scan; of a solid those that are off all of its pieces.
std::vector<std::uint8_t> Merging::off_scan(const RemeshPart& part, const PolyMesh& places, Progress& progress) const {
  std::vector<std::uint8_t> is_off(places.vertex_count(), 1);
  for (const std::size_t number : part.pieces) {
    const RemeshPiece& piece = model_.pieces.pieces[number];
    const RemeshPoints points = points_of(model_.mesh, model_.analysis, piece, model_.normals, model_.edge);
    Strays strays = strays_of(model_, piece, points, places, shapes_[number].openings.holes, progress);
    for (const LooseVertex& loose : strays.loose) strays.vertices[loose.vertex] = 1;
    for (std::size_t i = 0; i < is_off.size(); ++i) is_off[i] &= strays.vertices[i];
  }
  return is_off;
}

/// Vertices were looked at when they were made; what lies between them follows: triangles that aren't near to the scan
/// with all their points are looked at place by place, since they may lie in holes.
void Merging::look_at_scan(Progress& progress) {
  Triangles given, fresh;
  for (const auto& [a, b, c] : model_.analysis.view.triangles)
    given.push_back({model_.mesh.positions[a], model_.mesh.positions[b], model_.mesh.positions[c]});
  for (const Index t : fresh_) fresh.push_back(corners(merged_.triangles[t]));
  const TriangleTree tree(std::move(given), progress);
  const std::vector<Index> doubtful = faces_beyond(fresh, {}, tree, near_of(model_), model_.threads(), progress);
  auto next = doubtful.begin();
  for (const RemeshPart& part : parts_) {
    PolyMesh places;
    std::vector<Index> triangle_at;
    for (; next != doubtful.end() && merged_.face_of[fresh_[*next]] < part.first_face + part.face_count; ++next) {
      add_samples(fresh[*next], between_samples * model_.cell, places.positions);
      triangle_at.resize(places.positions.size(), fresh_[*next]);
    }
    if (places.positions.empty()) continue;
    const std::vector<std::uint8_t> is_off = off_scan(part, places, progress);
    for (std::size_t i = 0; i < is_off.size(); ++i)
      if (is_off[i] != 0) refuse(triangle_at[i]);
  }
}

/// @return whether less is allowed all over a part, therefore
bool Merging::look_at_room() {
  bool is_other = false;
  for (const RemeshPart& part : parts_) {
    const PieceShape& shape = shapes_[part.pieces.front()];
    if (part.is_solid || !shape.given_room || shape.room.any()) continue;
    const PolyMesh mesh = surface_of(part);
    if (mesh.face_count() == part.face_count) continue;
    const RemeshPiece& piece = model_.pieces.pieces[part.pieces.front()];
    const PieceRoom made = room_of_surface(mesh, shape.is_closed());
    if (!change_of(*shape.given_room, made, model_.analysis, piece, model_.cell).any()) continue;
    for (std::size_t v = 0; v < part.vertex_count; ++v) spare(static_cast<Index>(part.first_vertex + v));
    is_other = true;
  }
  return is_other;
}

void Merging::fence_part(const RemeshPart& part) {
  const auto first = roles_.begin() + static_cast<std::ptrdiff_t>(part.first_vertex);
  std::fill(first, first + static_cast<std::ptrdiff_t>(part.vertex_count), VertexRole::Fenced);
}

void Merging::spare(Index v) {
  if (is_spared_[v] != 0) return;
  is_spared_[v] = 1;
  if (++halvings_[v] > most_halvings) roles_[v] = VertexRole::Fenced;
}

void Merging::spare_face(Index face) {
  for (const Index v : made_.face(face)) spare(v);
}

/// Less is allowed around faults, at last nothing. What is at fault wasn't there before: at least one of the vertices
/// around it has gone. @return whether there were any
bool Merging::spare_faults(bool whole_parts) {
  if (faults_.empty() && face_faults_.empty()) return false;
  std::vector<std::uint8_t> is_fault(merged_.triangles.size(), 0);
  for (const Index t : faults_) is_fault[t] = 1;
  for (const Index f : face_faults_) {
    for (const Index v : made_.face(f))
      if (merged_.home[v] != no_index) is_fault[merged_.home[v]] = 1;
    spare_face(f);
    if (whole_parts) fence_part(part_at(f));
  }
  for (Index t = 0; t < is_fault.size(); ++t) {
    if (is_fault[t] == 0) continue;
    for (const Index v : merged_.triangles[t]) spare(v);
    spare_face(merged_.face_of[t]);
    if (whole_parts) fence_part(part_at(merged_.face_of[t]));
  }
  for (Index v = 0; v < roles_.size(); ++v)
    if (merged_.home[v] != no_index && is_fault[merged_.home[v]] != 0) spare(v);
  return true;
}

MergedFaces Merging::run(Progress& progress) {
  give_roles(progress);
  proven_.resize(made_.face_count());
  halvings_.assign(roles_.size(), 0);
  const CollapseLimits limits{points_within * off_, longest_edge_made * model_.cell, halvings_};
  for (int round = 0;; ++round) {
    const double share = round == 0 ? 0.7 : 0.05;
    Progress collapsing = progress.step("merge flat faces", 0.5 * share);
    merged_ = collapse_edges(made_, roles_, limits, collapsing);
    faults_.clear();
    face_faults_.clear();
    Progress searching = progress.step("compare surfaces", 0.1 * share);
    look_for_gone(searching);
    Progress comparing = progress.step("compare surfaces", 0.2 * share);
    look_at_changed(comparing);
    Progress cutting = progress.step("look for cuts", 0.1 * share);
    look_at_cuts(cutting);
    Progress scanning = progress.step("compare with the scan", 0.1 * share);
    look_at_scan(scanning);
    is_spared_.assign(roles_.size(), 0);
    const bool has_other_room = look_at_room();
    if (!spare_faults(round >= most_rounds) && !has_other_room) break;
  }
  return rest();
}

/// What is left, numbered anew.
MergedFaces Merging::rest() {
  MergedFaces result;
  result.face_of = std::move(merged_.face_of);
  std::vector<Index> number(made_.vertex_count(), no_index);
  for (const auto& t : merged_.triangles)
    for (const Index v : t) number[v] = 0;
  for (Index v = 0; v < number.size(); ++v) {
    if (number[v] == no_index) continue;
    number[v] = static_cast<Index>(result.vertex_of.size());
    result.vertex_of.push_back(v);
    result.mesh.positions.push_back(made_.positions[v]);
  }
  for (const auto& [a, b, c] : merged_.triangles) result.mesh.add_triangle(number[a], number[b], number[c]);
  return result;
}

}  // namespace

MergedFaces merge_flat_faces(const RemeshModel& model, const PolyMesh& made, const std::vector<RemeshPart>& parts,
                             const std::vector<PieceShape>& shapes, std::span<const std::int32_t> labels,
                             Progress& progress) {
  return Merging(model, made, parts, shapes, labels).run(progress);
}

}  // namespace croquis::remeshing
