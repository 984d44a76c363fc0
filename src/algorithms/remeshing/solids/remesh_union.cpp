// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/remeshing/solids/remesh_union.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <tuple>

#include <Eigen/Geometry>

#include "algorithms/remeshing/remesh_cuts.h"
#include "algorithms/remeshing/remesh_trimming.h"
#include "algorithms/remeshing/solids/union_check.h"
#include "algorithms/remeshing/solids/united_solid.h"
#include "croquis/geometry/disjoint_sets.h"

namespace croquis::remeshing {
namespace {

using namespace hole_filling;

constexpr int rounds = 4;                  // what was united may cross something else
constexpr int union_halvings = 1;          // of the cells, where thin parts get lost or faces still intersect
constexpr double union_margin = 4;         // × cell, around everything
constexpr double cells_per_triangle = 40;  // per triangle of the surfaces given
constexpr double hidden_below = 0.1;       // × cell: vertices deeper inside the solid aren't on its surface
constexpr double least_bubble = 2;         // × cell: smaller shells are what cubes make of surfaces that nearly touch

/// One try at a solid of several pieces.
struct Solid {
  PolyMesh mesh;
  std::size_t cuts = 0, lost = 0;
  Vec3 lost_at = Vec3::Zero();
  bool is_torn = false;  // has lost more than a few places
  bool is_good = false;
  UnionFaults faults;
};

/// Two parts of which faces intersect; the first place found.
struct Crossing {
  std::size_t a = 0, b = 0;
  Vec3 at = Vec3::Zero();
};

class Joining {
 public:
  Joining(const RemeshModel& model, std::vector<PieceShape>& shapes)
      : model_(model), shapes_(shapes), surfaces_(shapes.size()), group_(static_cast<Index>(shapes.size())) {}

  JoinedShapes run(Progress& progress);

 private:
  void join_as_they_are();
  bool needs_a_look() const;
  bool group_by_cuts(Progress& progress);
  void unite_groups(Progress& progress);
  std::vector<std::size_t> group_of(std::size_t first);
  void put_as_it_is(std::size_t number, JoinedShapes& next);
  void keep_largest(std::vector<std::size_t> group, JoinedShapes& next);
  double area_of(std::size_t number) const;
  void leave_out(std::size_t part, const std::vector<std::size_t>& kept, JoinedShapes& next) const;
  const Crossing* crossing_of(std::size_t part, const std::vector<std::size_t>& kept) const;
  void put(RemeshPart part, const PolyMesh& mesh, JoinedShapes& joined) const;
  void keep_surface(const RemeshPart& part, Progress& progress);
  std::optional<std::pair<RemeshPart, PolyMesh>> united(std::vector<std::size_t> pieces, Progress& progress);
  Solid solid_of(const UnitedSolid& solid, std::span<const std::unique_ptr<const SignedSurface>> members,
                 const std::vector<std::size_t>& pieces, double cell, Progress& progress) const;
  std::vector<Vec3> visible(const UnitedSolid& solid, const std::vector<Vec3>& places, double least,
                            const Progress& progress) const;
  void name_places(const UnitedSolid& solid, std::span<const std::unique_ptr<const SignedSurface>> members,
                   const PolyMesh& mesh, RemeshPart& part, const Progress& progress) const;

  const RemeshModel& model_;
  std::vector<PieceShape>& shapes_;
  std::vector<std::unique_ptr<const SignedSurface>> surfaces_;  // of pieces that were united
  DisjointSets group_;
  std::vector<std::uint8_t> marked_;  // of parts: cut themselves or others
  std::vector<Crossing> crossings_;   // of different parts, each pair once
  std::vector<std::size_t> losers_;   // pieces that the last solid that was refused had too little of
  JoinedShapes joined_;
};

JoinedShapes Joining::run(Progress& progress) {
  join_as_they_are();
  for (const PieceShape& shape : shapes_) joined_.cuts += shape.cuts;
  if (!needs_a_look()) return std::move(joined_);
  for (int round = 0; round <= rounds; ++round) {
    Progress looking = progress.step("look for cuts", round == 0 ? 0.4 : 0.02);
    if (!group_by_cuts(looking) || round == rounds) break;
    Progress uniting = progress.step("unite pieces that cross", round == 0 ? 0.4 : 0.02);
    unite_groups(uniting);
  }
  return std::move(joined_);
}

/// A piece alone was looked at when it was improved; patches were put in afterwards.
bool Joining::needs_a_look() const {
  return shapes_.size() > 1 || joined_.cuts > 0 ||
         std::ranges::any_of(shapes_, [](const PieceShape& shape) { return !shape.patched.loops.empty(); });
}

void Joining::join_as_they_are() {
  for (std::size_t p = 0; p < shapes_.size(); ++p) {
    RemeshPart part;
    part.pieces = {p};
    for (const auto& [face, hole] : shapes_[p].patched.faces)
      if (hole != no_index) part.patched.emplace_back(face, hole);
    PolyMesh mesh = std::move(shapes_[p].mesh);
    shapes_[p].mesh = {};
    if (shapes_.size() == 1) {
      part.vertex_count = mesh.vertex_count();
      part.face_count = mesh.face_count();
      joined_.mesh = std::move(mesh);
      joined_.parts.push_back(std::move(part));
    } else {
      put(std::move(part), mesh, joined_);
    }
  }
}

/// Appends a mesh, and lets its part know where. Faces of patches are numbered from its own first one before.
void Joining::put(RemeshPart part, const PolyMesh& mesh, JoinedShapes& joined) const {
  part.first_vertex = joined.mesh.vertex_count();
  part.vertex_count = mesh.vertex_count();
  part.first_face = joined.mesh.face_count();
  part.face_count = mesh.face_count();
  for (auto& [face, hole] : part.patched) face += part.first_face;
  const auto first = static_cast<Index>(part.first_vertex);
  PolyMesh& whole = joined.mesh;
  whole.positions.insert(whole.positions.end(), mesh.positions.begin(), mesh.positions.end());
  for (const Index corner : mesh.corners) whole.corners.push_back(first + corner);
  while (whole.face_offsets.back() < whole.corners.size()) whole.face_offsets.push_back(whole.face_offsets.back() + 3);
  joined.parts.push_back(std::move(part));
}

/// Finds what intersects and joins the pieces concerned. False when there is nothing, or nothing new can be tried.
bool Joining::group_by_cuts(Progress& progress) {
  const auto cuts = find_cuts(joined_.mesh, model_.threads(), progress);
  std::vector<RemeshPart>& parts = joined_.parts;
  const auto part_at = [&](Index face) {
    const auto next = std::ranges::upper_bound(parts, std::size_t{face}, {}, &RemeshPart::first_face);
    return static_cast<std::size_t>(next - parts.begin()) - 1;
  };
  joined_.cuts = cuts.size();
  joined_.crossings = 0;
  marked_.assign(parts.size(), 0);
  bool is_new = false;
  crossings_.clear();
  for (const auto& pair : cuts) {
    const std::size_t a = part_at(pair[0]), b = part_at(pair[1]);
    if (a == b && parts[a].stays) continue;
    marked_[a] = marked_[b] = 1;
    if (a != b) {
      ++joined_.crossings;
      const bool is_known = std::ranges::any_of(
          crossings_, [&](const Crossing& c) { return std::minmax(c.a, c.b) == std::minmax(a, b); });
      if (!is_known) crossings_.push_back({a, b, joined_.mesh.positions[joined_.mesh.face(pair[0])[0]]});
    }
    is_new = is_new || a != b || !parts[a].is_solid;
    group_.unite(static_cast<Index>(parts[a].pieces.front()), static_cast<Index>(parts[b].pieces.front()));
  }
  if (!is_new || model_.options.fill.preset == Preset::Paper) return false;
  double share = 0;
  for (std::size_t i = 0; i < parts.size(); ++i)
    for (const std::size_t piece : parts[i].pieces)
      share += marked_[i] != 0 ? model_.share_of(model_.pieces.pieces[piece]) : 0;
  return model_.memory.may_unite(share);
}

void Joining::keep_surface(const RemeshPart& part, Progress& progress) {
  if (part.is_solid) return;
  surfaces_[part.pieces.front()] =
      std::make_unique<const SignedSurface>(surface_of(part, joined_.mesh), model_.threads(), progress);
}

/// Marked parts that crossings lead to from one, ascending. Those of earlier groups have been moved away.
std::vector<std::size_t> Joining::group_of(std::size_t first) {
  const auto root = [&](std::size_t part) {
    return group_.root(static_cast<Index>(joined_.parts[part].pieces.front()));
  };
  std::vector<std::size_t> group;
  for (std::size_t i = first; i < joined_.parts.size(); ++i)
    if (marked_[i] != 0 && !joined_.parts[i].pieces.empty() && root(i) == root(first)) group.push_back(i);
  return group;
}

void Joining::unite_groups(Progress& progress) {
  JoinedShapes next;
  next.left_out = std::move(joined_.left_out);
  std::vector<std::uint8_t> done(joined_.parts.size(), 0);
  const double share = 1 / static_cast<double>(joined_.parts.size());
  for (std::size_t i = 0; i < joined_.parts.size(); ++i) {
    if (done[i] != 0) continue;
    if (marked_[i] == 0) {
      put_as_it_is(i, next);
      continue;
    }
    Progress uniting = progress.step("unite pieces that cross", share);
    const std::vector<std::size_t> group = group_of(i);
    std::vector<std::size_t> pieces;
    for (const std::size_t part : group) {
      done[part] = 1;
      const RemeshPart& other = joined_.parts[part];
      pieces.insert(pieces.end(), other.pieces.begin(), other.pieces.end());
      keep_surface(other, uniting);
    }
    std::sort(pieces.begin(), pieces.end());
    if (auto solid = united(std::move(pieces), uniting))
      put(std::move(solid->first), solid->second, next);
    else
      keep_largest(group, next);
  }
  for (const RemeshPart& part : next.parts) next.united += part.pieces.size() > 1 ? part.pieces.size() : 0;
  joined_ = std::move(next);
}

void Joining::put_as_it_is(std::size_t number, JoinedShapes& next) {
  RemeshPart& part = joined_.parts[number];
  for (auto& [face, hole] : part.patched) face -= part.first_face;
  const PolyMesh mesh = surface_of(part, joined_.mesh);
  put(std::move(part), mesh, next);
}

const Crossing* Joining::crossing_of(std::size_t part, const std::vector<std::size_t>& kept) const {
  const auto found = std::ranges::find_if(crossings_, [&](const Crossing& c) {
    return (c.a == part && std::ranges::find(kept, c.b) != kept.end()) ||
           (c.b == part && std::ranges::find(kept, c.a) != kept.end());
  });
  return found == crossings_.end() ? nullptr : &*found;
}

void Joining::leave_out(std::size_t part, const std::vector<std::size_t>& kept, JoinedShapes& next) const {
  const Crossing* crossing = crossing_of(part, kept);
  if (crossing == nullptr) return;
  const std::size_t other = crossing->a == part ? crossing->b : crossing->a;
  for (const std::size_t piece : joined_.parts[part].pieces)
    next.left_out.push_back({piece, joined_.parts[other].pieces.front(), crossing->at});
}

double Joining::area_of(std::size_t number) const {
  const RemeshPart& part = joined_.parts[number];
  const std::vector<Vec3>& at = joined_.mesh.positions;
  double area = 0;
  for (std::size_t f = part.first_face; f < part.first_face + part.face_count; ++f) {
    const auto face = joined_.mesh.face(f);
    area += (at[face[1]] - at[face[0]]).cross(at[face[2]] - at[face[0]]).norm() / 2;
  }
  return area;
}

/// Those that lost much in the solid go, the rest may be one in the next round. Where the largest has lost much itself,
/// they are kept by their areas, the first of equals, each unless it crosses one that is kept.
void Joining::keep_largest(std::vector<std::size_t> group, JoinedShapes& next) {
  std::vector<RemeshPart>& parts = joined_.parts;
  std::map<std::size_t, double> areas;
  for (const std::size_t part : group) areas[part] = area_of(part);
  std::ranges::stable_sort(group, [&](std::size_t a, std::size_t b) { return areas[a] > areas[b]; });
  const auto has_lost = [&](std::size_t part) {
    return std::ranges::find_first_of(parts[part].pieces, losers_) != parts[part].pieces.end();
  };
  const bool may_go_on = !losers_.empty() && !has_lost(group.front());
  std::vector<std::size_t> kept, gone;
  for (const std::size_t part : group) {
    const bool goes =
        may_go_on ? has_lost(part) && crossing_of(part, group) != nullptr : crossing_of(part, kept) != nullptr;
    (goes ? gone : kept).push_back(part);
  }
  for (const std::size_t part : gone) leave_out(part, may_go_on ? group : kept, next);
  std::ranges::sort(kept);
  for (const std::size_t part : kept) {
    parts[part].stays = !may_go_on;
    put_as_it_is(part, next);
  }
}

std::optional<std::pair<RemeshPart, PolyMesh>> Joining::united(std::vector<std::size_t> pieces, Progress& progress) {
  std::vector<std::unique_ptr<const SignedSurface>> members;
  double finest = model_.cell, share = 0;
  bool is_closed = true;
  for (const std::size_t p : pieces) {
    is_closed = is_closed && surfaces_[p]->is_closed();
    members.push_back(std::move(surfaces_[p]));
    finest = std::min(finest, shapes_[p].cell);
    share += model_.share_of(model_.pieces.pieces[p]);
  }
  // Closed pieces get the cells of the finest: their thin parts have two sides. Sheets don't need it.
  int halving = is_closed ? static_cast<int>(std::lround(std::log2(model_.cell / finest))) : 0;
  while (halving > 0 && !model_.memory.may_halve(share, halving)) --halving;
  Solid best;
  for (const int first = halving; halving <= first + union_halvings; ++halving) {
    if (halving > first && !model_.memory.may_halve(share, halving)) break;
    const double size = std::ldexp(model_.cell, -halving);
    Progress trying = progress.step("unite pieces that cross", halving == first ? 0.8 : 0.05);
    const UnitedSolid solid(members, size);
    Solid found = solid_of(solid, members, pieces, size, trying);
    const auto is_better = [&] {
      return std::tuple(!found.faults.none(), found.cuts, found.lost) <
             std::tuple(!best.faults.none(), best.cuts, best.lost);
    };
    if (halving == first || is_better()) best = std::move(found);
    if (best.is_good) break;
  }
  const auto give_back = [&] {
    for (std::size_t m = 0; m < members.size(); ++m) surfaces_[pieces[m]] = std::move(members[m]);
  };
  if (!best.faults.none()) {
    give_back();
    losers_.clear();
    if (!best.faults.has_strays)
      for (const std::size_t member : best.faults.losers) losers_.push_back(pieces[member]);
    return std::nullopt;
  }
  RemeshPart part;
  part.is_solid = true;
  part.lost = best.is_torn ? best.lost : 0;
  part.lost_at = best.lost_at;
  part.pieces = pieces;
  name_places(UnitedSolid(members, model_.cell), members, best.mesh, part, progress);
  give_back();
  return std::pair(std::move(part), std::move(best.mesh));
}

/// Parts that are smaller than some cubes, where no piece is so small.
void drop_bubbles(PolyMesh& mesh, double size) {
  const std::vector<Index> parts = parts_of(mesh);
  std::vector<implicit::Box> boxes(parts.size());
  for (Index v = 0; v < parts.size(); ++v) boxes[v] = {mesh.positions[v], mesh.positions[v]};
  for (Index v = 0; v < parts.size(); ++v) {
    boxes[parts[v]].low = boxes[parts[v]].low.cwiseMin(mesh.positions[v]);
    boxes[parts[v]].high = boxes[parts[v]].high.cwiseMax(mesh.positions[v]);
  }
  std::vector<std::uint8_t> removed(mesh.face_count(), 0);
  for (std::size_t f = 0; f < removed.size(); ++f)
    removed[f] = boxes[parts[mesh.corners[3 * f]]].size().norm() < size ? 1 : 0;
  if (std::find(removed.begin(), removed.end(), 1) != removed.end()) mesh = without(mesh, removed);
}

std::vector<Vec3> Joining::visible(const UnitedSolid& solid, const std::vector<Vec3>& places, double least,
                                   const Progress& progress) const {
  Progress silent = progress.silent();
  const std::vector<UnitedSolid::Place> found = solid.at(places, model_.threads(), silent);
  std::vector<Vec3> kept;
  for (std::size_t i = 0; i < places.size(); ++i)
    if (found[i].value >= least) kept.push_back(places[i]);
  return kept;
}

Solid Joining::solid_of(const UnitedSolid& solid, std::span<const std::unique_ptr<const SignedSurface>> members,
                        const std::vector<std::size_t>& pieces, double cell, Progress& progress) const {
  std::vector<Vec3> seeds;
  std::size_t triangles = 0;
  double smallest = least_bubble * cell;
  for (const auto& member : members) {
    seeds.insert(seeds.end(), member->mesh().positions.begin(), member->mesh().positions.end());
    triangles += member->mesh().face_count();
    smallest = std::min(smallest, 0.5 * member->box().size().norm());
  }
  implicit::PolygonizerOptions cubes;
  cubes.cell = cell;
  cubes.threads = model_.threads();
  cubes.bounds = solid.box();
  cubes.origin = cubes.bounds.low;
  cubes.bounds.low.array() -= union_margin * cell;
  cubes.bounds.high.array() += union_margin * cell;
  cubes.max_cells = static_cast<std::size_t>(
      std::min(1e6 + cells_per_triangle * static_cast<double>(triangles) * std::pow(model_.cell / cell, 2), 5e8));
  cubes.covered = solid.covered();
  cubes.seed_reach = 0;
  Progress polygonizing = progress.step("polygonize", 0.5);
  implicit::Polygonized found = implicit::polygonize(solid.field(), seeds, cubes, polygonizing);
  Solid made;
  made.mesh = cubes.covered ? trimmed(found.mesh, found.covered) : std::move(found.mesh);
  drop_bubbles(made.mesh, smallest);
  std::vector<Vec3> given;
  for (const std::size_t p : pieces)
    for (const Index v : model_.pieces.pieces[p].vertices) given.push_back(model_.mesh.positions[v]);
  Progress improving = progress.step("improve", 0.4);
  made.cuts = improve(made.mesh, {solid.field(), 0, {}}, given, improvement_of(model_.options, cell), improving);
  drop_bubbles(made.mesh, smallest);  // chips of sharp edges shrink
  Progress comparing = progress.step("look for lost detail", 0.1);
  seeds = visible(solid, seeds, -hidden_below * cell, comparing);
  const std::vector<Index> lost = lost_points(made.mesh, seeds, model_.cell, model_.threads(), comparing);
  made.lost = lost.size();
  if (!lost.empty()) made.lost_at = seeds[lost.front()];
  made.is_torn = !are_few(lost.size(), seeds.size());
  made.faults = faults_of(made.mesh, members, model_.cell, model_.threads(), comparing);
  // Where it ends at borders it may end a little earlier: no reason for four times the triangles.
  made.is_good = made.faults.none() && made.cuts == 0 && (cubes.covered || !made.is_torn);
  return made;
}

/// Which piece every vertex lies on, and which faces lie on patches.
void Joining::name_places(const UnitedSolid& solid, std::span<const std::unique_ptr<const SignedSurface>> members,
                          const PolyMesh& mesh, RemeshPart& part, const Progress& progress) const {
  part.piece_at.reserve(mesh.vertex_count());
  Progress silent = progress.silent();
  for (const UnitedSolid::Place& place : solid.at(mesh.positions, model_.threads(), silent))
    part.piece_at.push_back(static_cast<Index>(part.pieces[place.member]));
  UnitedSolid::Walk walk(solid);
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    const Vec3 middle = (mesh.positions[face[0]] + mesh.positions[face[1]] + mesh.positions[face[2]]) / 3;
    const std::size_t piece = part.piece_at[face[0]];
    const auto& patched = shapes_[piece].patched.faces;
    if (patched.empty()) continue;
    const Index member = walk.at(middle).member;
    if (part.pieces[member] != piece) continue;
    const std::size_t nearest = members[member]->at(middle).triangle;
    const auto found = std::ranges::lower_bound(patched, nearest, {}, [](const auto& p) { return p.first; });
    if (found != patched.end() && found->first == nearest && found->second != no_index)
      part.patched.emplace_back(f, found->second);
  }
}

}  // namespace

PolyMesh surface_of(const RemeshPart& part, const PolyMesh& whole) {
  PolyMesh mesh;
  mesh.positions.assign(whole.positions.begin() + static_cast<std::ptrdiff_t>(part.first_vertex),
                        whole.positions.begin() + static_cast<std::ptrdiff_t>(part.first_vertex + part.vertex_count));
  const auto first = static_cast<Index>(part.first_vertex);
  for (std::size_t f = part.first_face; f < part.first_face + part.face_count; ++f) {
    const auto face = whole.face(f);
    mesh.add_triangle(face[0] - first, face[1] - first, face[2] - first);
  }
  return mesh;
}

JoinedShapes join_shapes(const RemeshModel& model, std::vector<PieceShape>& shapes, Progress& progress) {
  return Joining(model, shapes).run(progress);
}

}  // namespace croquis::remeshing
