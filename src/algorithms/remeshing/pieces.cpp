// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/remeshing/pieces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include <Eigen/Geometry>

#include "croquis/geometry/disjoint_sets.h"
#include "croquis/hole_filling/hole_choice.h"
#include "croquis/implicit/point_tree.h"

namespace croquis::remeshing {
namespace {

using namespace hole_filling;

constexpr double seam_reach = 3;          // × edge: views between which a row of faces is missing
constexpr double seam_height = 1;         // × edge, along both normals: what views are misplaced by
constexpr double agrees = 0.6;            // cosine
constexpr std::size_t least_seam = 16;    // vertices
constexpr double least_seam_share = 0.1;  // of the shorter rims
constexpr double rim_share = 0.2;         // of a rim that is a view's
constexpr double turned_height = 0.5;     // × edge, in the mean: farther apart are sides of a wall
constexpr double same_height = 0.15;      // × edge, in the mean: no wall is as thin
constexpr double wall_share = 0.8;        // of the rims of both sides of a wall run along the other one

using Pair = std::pair<Index, Index>;

/// Rim vertices of one component beside which another one goes on.
struct Meeting {
  std::size_t count = 0;
  double heights = 0;  // sum, from the rim to the other component
};

/// By a component and the one that it goes on in.
using Meetings = std::map<Pair, Meeting>;

Meeting meeting_at(const Meetings& meetings, Index a, Index b) {
  const auto found = meetings.find({a, b});
  return found == meetings.end() ? Meeting() : found->second;
}

std::size_t count_of(const Meetings& meetings, Index a, Index b) {
  return meeting_at(meetings, a, b).count + meeting_at(meetings, b, a).count;
}

/// What lies beside the rims of all components that have any.
struct Surroundings {
  std::vector<Pair> rims;                          // vertices with their components, ascending
  std::map<Index, std::size_t> rim_size;           // vertices, by component
  Meetings same, opposed;                          // where normals agree, and where they oppose each other
  std::vector<std::pair<Index, Pair>> candidates;  // rim vertices, and the components that agree there, the lower first

  bool is_seam(Index a, Index b, std::size_t count) const {
    const auto shorter = static_cast<double>(std::min(rim_size.at(a), rim_size.at(b)));
    return count >= least_seam && static_cast<double>(count) >= least_seam_share * shorter;
  }
};

/// Components whose whole rim is shorter than the least seam go on in nothing.
void collect_rims(const SurfaceView& view, Surroundings& around) {
  std::vector<Pair>& rims = around.rims;
  for (const Index corner : view.rim_corners) rims.emplace_back(view.origin(corner), view.component[corner / 3]);
  std::ranges::sort(rims);
  rims.erase(std::unique(rims.begin(), rims.end()), rims.end());
  for (const auto& [vertex, component] : rims) ++around.rim_size[component];
  std::erase_if(around.rim_size, [](const auto& rim) { return 2 * rim.second < least_seam; });
  std::erase_if(rims, [&](const Pair& rim) { return !around.rim_size.contains(rim.second); });
}

/// The vertices of components with rims.
struct SheetVertices {
  std::vector<Vec3> normals;     // of all vertices of the mesh
  std::vector<Index> component;  // the same; no_index: none of these
  std::vector<Index> vertices;   // of these components
  std::vector<Vec3> places;      // of these
};

SheetVertices vertices_of_sheets(const PolyMesh& mesh, const SurfaceView& view, const Surroundings& around) {
  SheetVertices sheets;
  sheets.normals.assign(mesh.vertex_count(), Vec3::Zero());
  sheets.component.assign(mesh.vertex_count(), no_index);
  for (std::size_t t = 0; t < view.triangles.size(); ++t) {
    if (!around.rim_size.contains(view.component[t])) continue;
    const auto& [a, b, c] = view.triangles[t];
    const Vec3& at = mesh.positions[a];
    const Vec3 normal = (mesh.positions[b] - at).cross(mesh.positions[c] - at);
    for (const Index v : view.triangles[t]) {
      sheets.normals[v] += normal;
      sheets.component[v] = view.component[t];
    }
  }
  for (Index v = 0; v < sheets.component.size(); ++v) {
    if (sheets.component[v] == no_index) continue;
    sheets.normals[v] = unit_or_zero(sheets.normals[v]);
    sheets.vertices.push_back(v);
    sheets.places.push_back(mesh.positions[v]);
  }
  return sheets;
}

/// What lies beside one rim vertex: the nearest vertex of every other component that goes on there counts.
void look_around(const Pair& rim, const SheetVertices& sheets, const implicit::PointTree& tree,
                 const std::vector<Vec3>& at, double edge, Surroundings& around) {
  const Index vertex = rim.first;
  const Vec3& place = at[vertex];
  const auto height = [&](Index from, Index to) { return (at[to] - at[from]).dot(sheets.normals[from]); };
  const auto distance = [&](Index other) { return (at[other] - place).norm(); };
  const Vec3 reach = Vec3::Constant(seam_reach * edge);
  std::array<std::map<Index, Index>, 2> nearest;  // vertices by component, where normals agree and oppose each other
  for (const Index i : tree.inside({place - reach, place + reach})) {
    const Index other = sheets.vertices[i];
    if (sheets.component[other] == rim.second || distance(other) > seam_reach * edge) continue;
    if (std::max(std::abs(height(vertex, other)), std::abs(height(other, vertex))) > seam_height * edge) continue;
    const double turn = sheets.normals[vertex].dot(sheets.normals[other]);
    if (std::abs(turn) < agrees) continue;
    Index& known = nearest[turn < 0 ? 1 : 0].try_emplace(sheets.component[other], other).first->second;
    if (distance(other) < distance(known)) known = other;
  }
  for (const bool opposed : {false, true}) {
    for (const auto& [component, other] : nearest[opposed ? 1 : 0]) {
      Meeting& meeting = (opposed ? around.opposed : around.same)[{rim.second, component}];
      ++meeting.count;
      meeting.heights += height(vertex, other);
      if (!opposed) around.candidates.emplace_back(vertex, std::minmax(rim.second, component));
    }
  }
}

/// How many vertices say that two components are one surface, whatever side they look to; 0 where they seem to be sides
/// of a wall. What is above one of them is below the other one, unless they are opposed.
ViewPair pair_of(const Surroundings& around, const Pair& pair, bool is_opposed, double edge) {
  const auto& [a, b] = pair;
  const Meetings& meetings = is_opposed ? around.opposed : around.same;
  const Meeting first = meeting_at(meetings, a, b), second = meeting_at(meetings, b, a);
  ViewPair found{a, b, first.count + second.count, is_opposed};
  if (!around.is_seam(a, b, found.count)) return {a, b, 0, is_opposed};
  const auto share = [&](const Meeting& meeting, Index sheet) {
    return static_cast<double>(meeting.count) / static_cast<double>(around.rim_size.at(sheet));
  };
  const bool along_all = std::min(share(first, a), share(second, b)) > wall_share;
  const double height =
      std::abs(first.heights + (is_opposed ? 1 : -1) * second.heights) / static_cast<double>(found.count);
  if (height > (along_all ? same_height : turned_height) * edge) found.count = 0;
  return found;
}

/// Pairs are opposed where more vertices say so than the contrary.
std::vector<Index> turned_views(const Surroundings& around, const std::vector<Pair>& joined,
                                const std::vector<double>& areas, double edge) {
  std::set<Pair> opposed;
  for (const auto& [pair, meeting] : around.opposed) {
    const auto& [a, b] = pair;
    if (count_of(around.opposed, a, b) > count_of(around.same, a, b)) opposed.insert({std::min(a, b), std::max(a, b)});
  }
  std::vector<ViewPair> pairs;
  for (const Pair& pair : opposed) pairs.push_back(pair_of(around, pair, true, edge));
  if (std::ranges::none_of(pairs, [](const ViewPair& pair) { return pair.count > 0; })) return {};
  for (const Pair& pair : joined)
    if (!opposed.contains(pair)) pairs.push_back(pair_of(around, pair, false, edge));
  std::erase_if(pairs, [](const ViewPair& pair) { return pair.count == 0; });
  return minority_of(std::move(pairs), areas);
}

Index component_of(const SurfaceView& view, const Hole& hole) { return view.component[hole.corners.front() / 3]; }

/// Joins components that share a vertex. @return per vertex one of its components, no_index where it isn't used
std::vector<Index> join_at_vertices(std::size_t vertex_count, const SurfaceView& view, DisjointSets& joined) {
  std::vector<Index> component_at(vertex_count, no_index);
  for (std::size_t t = 0; t < view.triangles.size(); ++t) {
    for (const Index vertex : view.triangles[t]) {
      Index& component = component_at[vertex];
      if (component == no_index) component = view.component[t];
      if (component != view.component[t]) joined.unite(component, view.component[t]);
    }
  }
  return component_at;
}

/// Gives joined components that are large enough a piece, with their triangles.
/// @return per component its piece; no_index: it is left out
std::vector<Index> number_pieces(const SurfaceView& view, DisjointSets& joined, double min_component,
                                 RemeshPieces& made) {
  std::vector<std::size_t> triangles(view.component_count, 0);
  for (const Index component : view.component) ++triangles[joined.root(component)];
  const double least = min_component * static_cast<double>(view.triangles.size());
  std::vector<Index> piece_of(view.component_count, no_index);
  for (Index c = 0; c < view.component_count; ++c) {
    const Index root = joined.root(c);
    const bool is_large = static_cast<double>(triangles[root]) >= least;
    if (!is_large) ++made.left_out;
    if (root == c && is_large) {
      piece_of[c] = static_cast<Index>(made.pieces.size());
      made.pieces.emplace_back().triangles.reserve(triangles[c]);
    }
    piece_of[c] = piece_of[root];
  }
  for (Index t = 0; t < view.triangles.size(); ++t) {
    const Index piece = piece_of[view.component[t]];
    if (piece != no_index) made.pieces[piece].triangles.push_back(t);
  }
  return piece_of;
}

/// Counts the views of pieces, and lists their chosen rims at seams.
void list_seams(const HoleAnalysis& analysis, const HoleChoice& choice, const ViewSeams& seams,
                const std::vector<Index>& piece_of, std::vector<RimRule>& rules, RemeshPieces& made) {
  const SurfaceView& view = analysis.view;
  std::vector<std::uint8_t> is_view(view.component_count, 0), is_island(view.component_count, 1);
  for (const auto& [a, b] : seams.joined) is_view[a] = is_view[b] = 1;
  for (const Hole& hole : analysis.holes)
    if (hole.kind != HoleClass::Islands) is_island[component_of(view, hole)] = 0;
  for (Index c = 0; c < view.component_count; ++c) {
    if (is_view[c] == 0 || piece_of[c] == no_index) continue;
    ++made.pieces[piece_of[c]].views;
    made.pieces[piece_of[c]].islands += is_island[c];
  }
  for (const Hole& hole : analysis.holes) {
    if (!choice.is_chosen[hole.id] || !seams.are_along(hole.id)) continue;
    rules[hole.id] = RimRule::Seam;
    const Index piece = piece_of[component_of(view, hole)];
    if (piece != no_index) made.pieces[piece].seams.push_back(hole.id);
  }
}

/// In the plane of the triangle, across its rim edge, as long as that edge.
Vec3 outwards_of(const PolyMesh& mesh, const SurfaceView& view, Index corner) {
  const Vec3& a = mesh.positions[view.origin(corner)];
  const Vec3 along = mesh.positions[view.target(corner)] - a;
  const Vec3 normal = along.cross(mesh.positions[view.origin(SurfaceView::previous(corner))] - a);
  const double area = normal.norm();
  return area > 0 ? Vec3(along.cross(normal) / area) : Vec3(Vec3::Zero());
}

/// At a vertex both edges add up, and the strongest rule holds.
void merge_rims(std::vector<RimPlace>& rims) {
  std::ranges::stable_sort(rims, {}, &RimPlace::vertex);
  std::size_t kept = 0;
  for (const RimPlace& rim : rims) {
    if (kept == 0 || rims[kept - 1].vertex != rim.vertex) {
      rims[kept++] = rim;
      continue;
    }
    RimPlace& known = rims[kept - 1];
    known.outwards += rim.outwards;
    std::tie(known.rule, known.hole) = std::max(std::pair(known.rule, known.hole), std::pair(rim.rule, rim.hole));
  }
  rims.resize(kept);
  for (RimPlace& rim : rims) rim.outwards = unit_or_zero(rim.outwards);
}

void list_rims(const PolyMesh& mesh, const HoleAnalysis& analysis, const ViewSeams& seams,
               const std::vector<Index>& piece_of, const std::vector<RimRule>& rules, RemeshPieces& made) {
  const SurfaceView& view = analysis.view;
  std::vector<std::pair<Index, Index>> holes_of_corners;
  for (const Hole& hole : analysis.holes)
    for (const Index corner : hole.corners) holes_of_corners.emplace_back(corner, hole.id);
  std::ranges::sort(holes_of_corners);
  for (const Index corner : view.rim_corners) {
    const auto found = std::ranges::lower_bound(holes_of_corners, std::pair{corner, Index{0}});
    const bool is_hole = found != holes_of_corners.end() && found->first == corner;
    const RimRule own_rule = is_hole ? rules[found->second] : RimRule::Patch;
    const bool is_view_rim = !is_hole || seams.are_along(found->second);
    const Index piece = piece_of[view.component[corner / 3]];
    if (own_rule != RimRule::Field && piece != no_index) made.pieces[piece].ends = true;
    const Index hole = is_hole && own_rule != RimRule::Open ? found->second : no_index;
    for (const Index vertex : {view.origin(corner), view.target(corner)}) {
      const RimRule rule = is_view_rim && seams.at(vertex) ? RimRule::Seam : own_rule;
      made.rims.push_back({vertex, hole, rule, outwards_of(mesh, view, corner)});
    }
  }
  merge_rims(made.rims);
}

}  // namespace

ViewSeams find_view_seams(const PolyMesh& mesh, const HoleAnalysis& analysis, const std::vector<HoleRequest>& requests,
                          double edge) {
  ViewSeams seams;
  Surroundings around;
  collect_rims(analysis.view, around);
  if (around.rim_size.size() < 2) return seams;
  const SheetVertices sheets = vertices_of_sheets(mesh, analysis.view, around);
  const implicit::PointTree tree(sheets.places);
  for (const Pair& rim : around.rims) look_around(rim, sheets, tree, mesh.positions, edge, around);
  std::set<Pair> joined;
  for (const auto& [vertex, pair] : around.candidates) {
    if (!around.is_seam(pair.first, pair.second, count_of(around.same, pair.first, pair.second))) continue;
    joined.insert(pair);
    seams.vertices.resize(mesh.vertex_count(), 0);
    seams.vertices[vertex] = 1;
  }
  seams.joined.assign(joined.begin(), joined.end());
  seams.turned = turned_views(around, seams.joined, analysis.component_area, edge);
  if (seams.joined.empty()) return seams;
  for (const Hole& hole : analysis.holes) {
    const auto count = std::ranges::count_if(hole.vertices, [&](Index v) { return seams.at(v); });
    const bool is_rim = static_cast<double>(count) > rim_share * static_cast<double>(hole.vertices.size());
    const bool is_named = std::ranges::any_of(requests, [&](const HoleRequest& request) {
      return std::ranges::find(request.holes, hole.id) != request.holes.end();
    });
    seams.rims.push_back(is_rim && !is_named ? 1 : 0);
  }
  return seams;
}

std::vector<Index> minority_of(std::vector<ViewPair> pairs, const std::vector<double>& areas) {
  std::ranges::stable_sort(pairs, std::greater(), &ViewPair::count);
  // Component c as it is has number 2c, turned over 2c + 1: what is in one set agrees.
  DisjointSets agreeing(2 * areas.size());
  for (const auto& [a, b, count, opposed] : pairs) {
    if (agreeing.root(2 * a) / 2 == agreeing.root(2 * b) / 2) continue;
    agreeing.unite(2 * a, opposed ? 2 * b + 1 : 2 * b);
    agreeing.unite(2 * a + 1, opposed ? 2 * b : 2 * b + 1);
  }
  // The lower of both sets of a group has the root 2c of its lowest component c.
  std::vector<std::array<double, 2>> sides(areas.size(), {0, 0});
  for (Index c = 0; c < areas.size(); ++c) sides[agreeing.root(2 * c) / 2][agreeing.root(2 * c) % 2] += areas[c];
  std::vector<Index> turned;
  for (Index c = 0; c < areas.size(); ++c) {
    const Index root = agreeing.root(2 * c);
    const auto& side = sides[root / 2];
    if (root % 2 == (side[1] > side[0] ? 0U : 1U)) turned.push_back(c);
  }
  return turned;
}

std::vector<Index> RemeshPiece::chosen_holes() const {
  std::vector<Index> holes = caps;
  holes.insert(holes.end(), seams.begin(), seams.end());
  for (const std::vector<Index>& group : groups) holes.insert(holes.end(), group.begin(), group.end());
  std::ranges::sort(holes);
  return holes;
}

RemeshPieces make_pieces(const PolyMesh& mesh, const HoleAnalysis& analysis, const HoleChoice& choice,
                         const ViewSeams& seams, const RemeshOptions& options) {
  const SurfaceView& view = analysis.view;
  const bool is_paper = options.fill.preset == Preset::Paper;
  DisjointSets joined(view.component_count);
  const std::vector<Index> component_at = join_at_vertices(mesh.vertex_count(), view, joined);
  for (Index c = 1; is_paper && c < view.component_count; ++c) joined.unite(0, c);
  for (const auto& [a, b] : seams.joined) joined.unite(a, b);
  std::vector<RimRule> rules(analysis.holes.size(), RimRule::Open);
  std::vector<FillJob> jobs = make_jobs(analysis.holes, options.fill, choice.is_chosen);
  for (FillJob& job : jobs) {
    std::erase_if(job.holes, [&](Index hole) { return seams.are_along(hole); });
    job.is_cap = job.is_cap && !is_paper;
    for (const Index hole : job.holes) {
      rules[hole] = job.is_cap ? RimRule::Patch : RimRule::Field;
      for (const Index corner : analysis.holes[hole].corners)
        joined.unite(component_of(view, analysis.holes[job.holes.front()]), view.component[corner / 3]);
    }
  }
  RemeshPieces made;
  const std::vector<Index> piece_of = number_pieces(view, joined, options.min_component, made);
  for (FillJob& job : jobs) {
    const Index number = job.holes.empty() ? no_index : piece_of[component_of(view, analysis.holes[job.holes.front()])];
    if (number == no_index) continue;
    RemeshPiece& piece = made.pieces[number];
    if (job.is_cap)
      piece.caps.insert(piece.caps.end(), job.holes.begin(), job.holes.end());
    else
      piece.groups.push_back(std::move(job.holes));
  }
  for (RemeshPiece& piece : made.pieces) std::ranges::sort(piece.caps);
  list_seams(analysis, choice, seams, piece_of, rules, made);
  for (Index v = 0; v < component_at.size(); ++v) {
    const Index piece = component_at[v] == no_index ? no_index : piece_of[component_at[v]];
    if (piece != no_index) made.pieces[piece].vertices.push_back(v);
  }
  list_rims(mesh, analysis, seams, piece_of, rules, made);
  return made;
}

void leave_to_patches(RemeshPieces& pieces, std::size_t piece,
                      const std::function<bool(const std::vector<Index>&)>& is_left) {
  RemeshPiece& changed = pieces.pieces[piece];
  std::vector<Index> left;
  for (const std::vector<Index>& group : changed.groups)
    if (is_left(group)) left.insert(left.end(), group.begin(), group.end());
  if (left.empty()) return;
  std::erase_if(changed.groups, is_left);
  std::ranges::sort(left);
  changed.caps.insert(changed.caps.end(), left.begin(), left.end());
  std::ranges::sort(changed.caps);
  changed.ends = true;
  for (RimPlace& rim : pieces.rims) {
    if (rim.hole != no_index && std::ranges::binary_search(left, rim.hole)) rim.rule = RimRule::Left;
  }
}

}  // namespace croquis::remeshing
