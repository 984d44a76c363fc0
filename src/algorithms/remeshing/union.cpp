// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/remeshing/union.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <tuple>
#include <utility>

#include <Eigen/Geometry>

#include "algorithms/remeshing/improvement.h"
#include "algorithms/remeshing/surface_parts.h"
#include "algorithms/remeshing/united_solid.h"
#include "croquis/geometry/disjoint_sets.h"
#include "croquis/geometry/polygon_area.h"

namespace croquis::remeshing {
namespace {

using namespace hole_filling;

constexpr int union_rounds = 4;            // what was united may cross something else
constexpr int union_halvings = 1;          // of the cells, where thin parts get lost or faces still intersect
constexpr double union_margin = 4;         // × cell, around everything
constexpr double cells_per_triangle = 40;  // per triangle of the surfaces given
constexpr double hidden_below = 0.1;       // × cell: vertices deeper inside the solid aren't on its surface
constexpr double least_bubble = 2;         // × cell: smaller shells are what cubes make of surfaces that nearly touch

/// An attempt at a solid of several pieces.
struct Solid {
  RemeshPart part;
  PolyMesh mesh;
  std::size_t cuts = 0, lost = 0;
  bool is_good = false;
  UnionFaults faults;
};

/// Two parts of which faces intersect; the first place found.
struct Crossing {
  std::size_t a = 0, b = 0;
  Vec3 at = Vec3::Zero();
};

/// Appends a mesh, and sets where its part lies. Faces of patches are numbered from its own first one before.
void append(RemeshPart part, PolyMesh mesh, JoinedShapes& joined) {
  PolyMesh& whole = joined.mesh;
  part.first_vertex = whole.vertex_count();
  part.vertex_count = mesh.vertex_count();
  part.first_face = whole.face_count();
  part.face_count = mesh.face_count();
  for (auto& [face, hole] : part.patched) face += part.first_face;
  const auto first = static_cast<Index>(part.first_vertex);
  if (joined.parts.empty()) {
    whole = std::move(mesh);
  } else {
    whole.positions.insert(whole.positions.end(), mesh.positions.begin(), mesh.positions.end());
    for (const Index corner : mesh.corners) whole.corners.push_back(first + corner);
    set_triangle_offsets(whole);
  }
  joined.parts.push_back(std::move(part));
}

JoinedShapes joined_as_they_are(std::vector<PieceShape>& shapes) {
  JoinedShapes joined;
  for (std::size_t p = 0; p < shapes.size(); ++p) {
    joined.cuts += shapes[p].cuts;
    RemeshPart part;
    part.pieces = {p};
    for (const auto& [face, hole] : shapes[p].patched.faces)
      if (hole != no_index) part.patched.emplace_back(face, hole);
    append(std::move(part), std::exchange(shapes[p].mesh, {}), joined);
  }
  return joined;
}

/// Surfaces that are joined in rounds, while some cross.
struct Joining {
  const RemeshModel& model;
  const std::vector<PieceShape>& shapes;
  JoinedShapes joined;
  std::vector<std::unique_ptr<const SignedSurface>> surfaces{shapes.size()};  ///< of pieces that were united
  DisjointSets groups{shapes.size()};                                         ///< of pieces
  std::vector<std::uint8_t> marked = {};                                      ///< parts that cut themselves or others
  std::vector<Crossing> crossings = {};                                       ///< of different parts, each pair once
};

bool may_unite(const Joining& at) {
  double share = 0;
  for (std::size_t i = 0; i < at.marked.size(); ++i)
    for (const std::size_t piece : at.joined.parts[i].pieces)
      share += at.marked[i] != 0 ? at.model.share_of(at.model.pieces.pieces[piece]) : 0;
  return at.model.memory.may_unite(share);
}

const Crossing* crossing_of(const Joining& at, std::size_t part, const std::vector<std::size_t>& others) {
  const auto found = std::ranges::find_if(at.crossings, [&](const Crossing& crossing) {
    if (crossing.a != part && crossing.b != part) return false;
    return std::ranges::find(others, crossing.a == part ? crossing.b : crossing.a) != others.end();
  });
  return found == at.crossings.end() ? nullptr : &*found;
}

/// Finds what intersects and groups the pieces concerned. False when there is nothing, or nothing new can be tried.
bool find_crossings(Joining& at, Progress progress) {
  const auto cuts = find_cuts(at.joined.mesh, at.model.threads(), std::move(progress));
  const std::vector<RemeshPart>& parts = at.joined.parts;
  const auto part_at = [&](Index face) {
    const auto next = std::ranges::upper_bound(parts, std::size_t{face}, {}, &RemeshPart::first_face);
    return static_cast<std::size_t>(next - parts.begin()) - 1;
  };
  at.joined.cuts = cuts.size();
  at.joined.crossings = 0;
  at.marked.assign(parts.size(), 0);
  at.crossings.clear();
  bool is_new = false;
  for (const auto& pair : cuts) {
    const std::size_t a = part_at(pair[0]), b = part_at(pair[1]);
    if (a == b && parts[a].stays) continue;
    at.marked[a] = at.marked[b] = 1;
    if (a != b) {
      ++at.joined.crossings;
      if (crossing_of(at, a, {b}) == nullptr)
        at.crossings.push_back({a, b, at.joined.mesh.positions[at.joined.mesh.face(pair[0])[0]]});
    }
    is_new = is_new || a != b || !parts[a].is_solid;
    at.groups.unite(static_cast<Index>(parts[a].pieces.front()), static_cast<Index>(parts[b].pieces.front()));
  }
  return is_new && !at.model.is_paper() && may_unite(at);
}

/// Marked parts that crossings lead to from one, ascending. Those of earlier groups have been moved away.
std::vector<std::size_t> group_of(Joining& at, std::size_t first) {
  const auto root = [&](std::size_t part) {
    return at.groups.root(static_cast<Index>(at.joined.parts[part].pieces.front()));
  };
  std::vector<std::size_t> group;
  for (std::size_t i = first; i < at.joined.parts.size(); ++i)
    if (at.marked[i] != 0 && !at.joined.parts[i].pieces.empty() && root(i) == root(first)) group.push_back(i);
  return group;
}

void keep(Joining& at, std::size_t number, JoinedShapes& next) {
  RemeshPart& part = at.joined.parts[number];
  for (auto& [face, hole] : part.patched) face -= part.first_face;
  PolyMesh mesh = surface_of(part, at.joined.mesh);
  append(std::move(part), std::move(mesh), next);
}

/// Those that lost much in the solid go, the rest may be one in the next round. Where the largest has lost much
/// itself, they are kept by their areas, the first of equals, each unless it crosses one that is kept.
void keep_largest(Joining& at, std::vector<std::size_t> group, const std::vector<std::size_t>& losing,
                  JoinedShapes& next) {
  std::vector<RemeshPart>& parts = at.joined.parts;
  std::map<std::size_t, double> areas;
  for (const std::size_t part : group)
    for (std::size_t f = parts[part].first_face; f < parts[part].first_face + parts[part].face_count; ++f)
      areas[part] += area_normal(at.joined.mesh, f).norm();
  std::ranges::stable_sort(group, [&](std::size_t a, std::size_t b) { return areas[a] > areas[b]; });
  const auto has_lost = [&](std::size_t part) {
    return std::ranges::find_first_of(parts[part].pieces, losing) != parts[part].pieces.end();
  };
  const bool may_go_on = !losing.empty() && !has_lost(group.front());
  std::vector<std::size_t> kept, gone;
  for (const std::size_t part : group) {
    const bool goes =
        may_go_on ? has_lost(part) && crossing_of(at, part, group) != nullptr : crossing_of(at, part, kept) != nullptr;
    (goes ? gone : kept).push_back(part);
  }
  for (const std::size_t part : gone) {
    const Crossing* crossing = crossing_of(at, part, may_go_on ? group : kept);
    const std::size_t other = crossing->a == part ? crossing->b : crossing->a;
    for (const std::size_t piece : parts[part].pieces)
      next.left_out.push_back({piece, 0, parts[other].pieces.front(), crossing->at});
  }
  std::ranges::sort(kept);
  for (const std::size_t part : kept) {
    parts[part].stays = !may_go_on;
    keep(at, part, next);
  }
}

Solid solid_of(const Joining& at, const SolidMembers& members, const std::vector<std::size_t>& pieces, double cell,
               Progress progress) {
  const UnitedSolid solid(members, cell);
  std::vector<Vec3> seeds;
  std::size_t triangles = 0;
  double smallest = least_bubble * cell;
  for (const SignedSurface* member : members) {
    seeds.insert(seeds.end(), member->mesh().positions.begin(), member->mesh().positions.end());
    triangles += member->mesh().face_count();
    smallest = std::min(smallest, 0.5 * member->box().size().norm());
  }
  implicit::PolygonizerOptions cubes;
  cubes.cell = cell;
  cubes.threads = at.model.threads();
  cubes.bounds = solid.box();
  cubes.origin = cubes.bounds.low;
  cubes.bounds.low.array() -= union_margin * cell;
  cubes.bounds.high.array() += union_margin * cell;
  cubes.max_cells = static_cast<std::size_t>(
      std::min(1e6 + cells_per_triangle * static_cast<double>(triangles) * std::pow(at.model.cell / cell, 2), 5e8));
  cubes.covered = solid.covered();
  cubes.seed_reach = 0;
  Progress polygonizing = progress.step("polygonize", 0.5);
  implicit::Polygonized found = implicit::polygonize(solid.field(), seeds, cubes, polygonizing);
  Solid made;
  made.mesh = cubes.covered ? trimmed(found.mesh, found.covered) : std::move(found.mesh);
  drop_small(made.mesh, smallest);  // bubbles, where no piece is so small
  std::vector<Vec3> given;
  for (const std::size_t p : pieces)
    for (const Index v : at.model.pieces.pieces[p].vertices) given.push_back(at.model.mesh.positions[v]);
  made.cuts = improve(made.mesh, {solid.field(), 0, {}}, given, at.model.options, cell, progress.step("improve", 0.4));
  drop_small(made.mesh, smallest);  // chips of sharp edges shrink
  Progress comparing = progress.step("look for lost detail", 0.1);
  std::vector<Vec3> visible;
  const std::vector<UnitedSolid::Place> places = solid.at(seeds, at.model.threads(), progress.silent());
  for (std::size_t i = 0; i < seeds.size(); ++i)
    if (places[i].value >= -hidden_below * cell) visible.push_back(seeds[i]);
  const std::vector<Index> lost = lost_points(made.mesh, visible, at.model.cell, at.model.threads(), comparing);
  made.lost = lost.size();
  const bool is_torn = !are_few(lost.size(), visible.size());
  if (is_torn) made.part.lost = lost.size();
  if (!lost.empty()) made.part.lost_at = visible[lost.front()];
  made.faults = faults_of(made.mesh, members, at.model.cell, at.model.threads(), comparing);
  // Where it ends at borders it may end a little earlier: no reason for four times the triangles.
  made.is_good = made.faults.none() && made.cuts == 0 && (cubes.covered || !is_torn);
  return made;
}

/// Which piece every vertex lies on, and which faces lie on patches.
void name_places(const Joining& at, const SolidMembers& members, Solid& solid, const Progress& progress) {
  const UnitedSolid united(members, at.model.cell);
  const PolyMesh& mesh = solid.mesh;
  RemeshPart& part = solid.part;
  part.is_solid = true;
  part.piece_at.reserve(mesh.vertex_count());
  for (const UnitedSolid::Place& place : united.at(mesh.positions, at.model.threads(), progress.silent()))
    part.piece_at.push_back(static_cast<Index>(part.pieces[place.member]));
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto [a, b, c] = places_of(mesh.positions, mesh.face(f));
    const Vec3 middle = (a + b + c) / 3;
    const std::size_t piece = part.piece_at[mesh.face(f)[0]];
    const auto& patched = at.shapes[piece].patched.faces;
    if (patched.empty()) continue;
    const Index member = united.at(middle).member;
    if (part.pieces[member] != piece) continue;
    const std::size_t nearest = members[member]->at(middle).triangle;
    const auto found = std::ranges::lower_bound(patched, nearest, {}, [](const auto& p) { return p.first; });
    if (found != patched.end() && found->first == nearest && found->second != no_index)
      part.patched.emplace_back(f, found->second);
  }
}

/// The best solid of some pieces, whose surfaces are known.
Solid united(const Joining& at, std::vector<std::size_t> pieces, Progress& progress) {
  SolidMembers members;
  double finest = at.model.cell, share = 0;
  bool is_closed = true;
  for (const std::size_t p : pieces) {
    members.push_back(at.surfaces[p].get());
    is_closed = is_closed && members.back()->is_closed();
    finest = std::min(finest, at.shapes[p].cell);
    share += at.model.share_of(at.model.pieces.pieces[p]);
  }
  // Closed pieces get the cells of the finest: their thin parts have two sides. Sheets don't need it.
  int halving = is_closed ? static_cast<int>(std::lround(std::log2(at.model.cell / finest))) : 0;
  while (halving > 0 && !at.model.memory.may_halve(share, halving)) --halving;
  Solid best;
  const auto faults = [](const Solid& solid) { return std::tuple(!solid.faults.none(), solid.cuts, solid.lost); };
  for (const int first = halving; halving <= first + union_halvings; ++halving) {
    if (halving > first && !at.model.memory.may_halve(share, halving)) break;
    Solid found = solid_of(at, members, pieces, std::ldexp(at.model.cell, -halving),
                           progress.step("unite pieces that cross", halving == first ? 0.8 : 0.05));
    if (halving == first || faults(found) < faults(best)) best = std::move(found);
    if (best.is_good) break;
  }
  best.part.pieces = std::move(pieces);
  if (best.faults.none()) name_places(at, members, best, progress);
  return best;
}

void unite_groups(Joining& at, Progress progress) {
  JoinedShapes next;
  next.left_out = std::move(at.joined.left_out);
  std::vector<std::uint8_t> is_pending = at.marked;
  for (std::size_t i = 0; i < at.joined.parts.size(); ++i) {
    if (at.marked[i] == 0) keep(at, i, next);
    if (is_pending[i] == 0) continue;
    Progress uniting = progress.step("unite pieces that cross", 1 / static_cast<double>(at.joined.parts.size()));
    const std::vector<std::size_t> group = group_of(at, i);
    std::vector<std::size_t> pieces;
    for (const std::size_t number : group) {
      is_pending[number] = 0;
      const RemeshPart& part = at.joined.parts[number];
      pieces.insert(pieces.end(), part.pieces.begin(), part.pieces.end());
      if (!part.is_solid)
        at.surfaces[part.pieces.front()] =
            std::make_unique<const SignedSurface>(surface_of(part, at.joined.mesh), uniting);
    }
    std::ranges::sort(pieces);
    Solid solid = united(at, std::move(pieces), uniting);
    if (solid.faults.none()) {
      append(std::move(solid.part), std::move(solid.mesh), next);
      continue;
    }
    std::vector<std::size_t> losing;
    if (!solid.faults.leaves_members)
      for (const std::size_t member : solid.faults.losing) losing.push_back(solid.part.pieces[member]);
    keep_largest(at, group, losing, next);
  }
  for (const RemeshPart& part : next.parts) next.united += part.pieces.size() > 1 ? part.pieces.size() : 0;
  at.joined = std::move(next);
}

}  // namespace

PolyMesh surface_of(const RemeshPart& part, const PolyMesh& whole) {
  PolyMesh mesh;
  mesh.positions.assign(whole.positions.begin() + static_cast<std::ptrdiff_t>(part.first_vertex),
                        whole.positions.begin() + static_cast<std::ptrdiff_t>(part.first_vertex + part.vertex_count));
  const auto first = static_cast<Index>(part.first_vertex);
  for (std::size_t c = 3 * part.first_face; c < 3 * (part.first_face + part.face_count); ++c)
    mesh.corners.push_back(whole.corners[c] - first);
  set_triangle_offsets(mesh);
  return mesh;
}

JoinedShapes join_shapes(const RemeshModel& model, std::vector<PieceShape>& shapes, Progress progress) {
  Joining at{model, shapes, joined_as_they_are(shapes)};
  // A piece alone was looked at when it was improved; patches were put in afterwards.
  const bool is_known = shapes.size() == 1 && at.joined.cuts == 0 && shapes[0].patched.closed.empty();
  for (int round = 0; !is_known; ++round) {
    const double share = round == 0 ? 0.4 : 0.02;
    if (!find_crossings(at, progress.step("look for cuts", share)) || round == union_rounds) break;
    unite_groups(at, progress.step("unite pieces that cross", share));
  }
  return std::move(at.joined);
}

}  // namespace croquis::remeshing
