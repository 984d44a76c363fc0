// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/skeleton/depth.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <span>
#include <tuple>
#include <utility>

#include "algorithms/silhouette/skeleton/rest_depths.h"
#include "algorithms/silhouette/strokes/drawing_findings.h"
#include "croquis/geometry/disjoint_sets.h"
#include "croquis/solver/sparse_rows.h"

namespace croquis::silhouette {
namespace {

/// Shortfalls below this part of L disappear in the sheets' own gap; more is worth a warning.
constexpr double noticeable = 0.01;

/// Stretches of chords shorter than this, or nearer to the node, in L: a joining edge would have no useful direction.
constexpr double least_stretch = 1e-3;

/// Gives a part's nodes their heights, and their objects what the solve left open.
void take_over(const LeastSquaresSolution& solution, const DepthPart& part, Skeleton& skeleton,
               std::vector<double>& uncertainty) {
  const bool found = solution.converged && !solution.singular_objective;
  for (std::size_t n = 0; n < part.nodes.size(); ++n) {
    const auto column = static_cast<Eigen::Index>(3 * n);
    SkeletonNode& node = skeleton.nodes[part.nodes[n]];
    node.z = solution.x[column] * skeleton.scale;
    node.gradient = solution.x.segment<2>(column + 1);
    const double own = found ? solution.remaining_step.segment<3>(column).lpNorm<Eigen::Infinity>()
                             : std::numeric_limits<double>::infinity();
    if (node.object >= uncertainty.size()) uncertainty.resize(node.object + 1, 0);
    uncertainty[node.object] = std::max(uncertainty[node.object], own);
  }
}

void solve_all(Skeleton& skeleton, const LabelledFigure& figure, const DepthSettings& settings, Progress& progress,
               DepthResult& result) {
  const std::vector<CollisionRow> rows = collision_rows(skeleton, figure, settings);
  skeleton.rest = rest_depths(skeleton, object_bounds(skeleton, rows), settings, progress);
  const std::vector<DepthPart> parts = depth_parts(skeleton, rows);
  result.rows = rows.size();
  result.uncertainty.clear();
  for (const DepthPart& part : parts) {
    Progress step = progress.step("depth", 1 / static_cast<double>(parts.size()));
    const LeastSquaresSolution solution = solve_least_squares(depth_problem(skeleton, part, rows, settings), {}, step);
    result.iterations = std::max(result.iterations, solution.iterations);
    result.factorisations += solution.factorisations;
    result.residual = std::max({result.residual, solution.primal_residual, solution.dual_residual});
    take_over(solution, part, skeleton, result.uncertainty);
  }
  result.collisions.clear();
  for (const CollisionRow& row : rows) {
    const double shortfall = row.bound - (skeleton.nodes[row.upper].z - skeleton.nodes[row.lower].z);
    if (shortfall > noticeable * skeleton.scale) result.collisions.push_back({row.upper, row.lower, shortfall});
  }
}

/// Height of a node's circle above a place beside its centre. Near the rim of the circle, where it would vanish, a
/// little is left so that a sheet differs from its edge.
double height_over(const SkeletonNode& node, const Vec2& place) {
  constexpr double farthest = 0.95;
  const double aside = std::min((place - node.position).norm() / node.radius, farthest);
  return node.radius * std::sqrt(1 - aside * aside);
}

/// Splits a node's chord at the borders of the panels that it passes through: each panel but the node's own gets a node
/// in the middle of the chord's stretch there, joined to the old one and as thick as the old one's circle is there. A
/// chord that spans places of opposite order may then tilt instead of making rows that contradict each other.
/// @return whether it passed through more than one panel
bool split_chord(Index index, const LabelledFigure& figure, Skeleton& skeleton) {
  const SkeletonNode whole = skeleton.nodes[index];
  SkeletonNode kept = whole;
  kept.crossed.clear();
  kept.parts.clear();
  const double least = least_stretch * skeleton.scale;
  for (std::size_t i = 0; i < whole.crossed.size(); ++i) {
    const SheetPlace& place = whole.crossed[i];
    const ChordPart& part = whole.parts[i];
    const bool own =
        place.layer == whole.place.layer && figure.faces[place.triangle] == figure.faces[whole.place.triangle];
    const bool stays = own || part.length < least || (part.middle - whole.position).norm() < least;
    SkeletonNode& node = stays ? kept : skeleton.nodes.emplace_back();
    node.crossed.push_back(place);
    node.parts.push_back(part);
    if (stays) continue;
    node.position = part.middle;
    node.radius = height_over(whole, part.middle);
    node.chord = whole.chord;
    node.place = place;
    node.object = whole.object;
    skeleton.edges.push_back({index, static_cast<Index>(skeleton.nodes.size() - 1)});
  }
  const bool changed = kept.crossed.size() < whole.crossed.size();
  skeleton.nodes[index] = std::move(kept);
  return changed;
}

/// The stroke of a node's object that has a sample nearest to a place.
Index nearest_stroke(const SkeletonNode& node, const LabelledFigure& figure, const Drawing& drawing, const Vec2& at) {
  Index nearest = no_index;
  double least = std::numeric_limits<double>::infinity();
  for (const Index stroke : figure.objects[node.object].strokes) {
    for (const StrokeSample& sample : drawing.strokes[stroke].samples) {
      const double distance = (sample.position - at).squaredNorm();
      if (distance >= least) continue;
      least = distance;
      nearest = stroke;
    }
  }
  return nearest;
}

/// The worst pair of every place: pairs that share a node, or whose nodes are neighbours, are one place.
std::vector<DepthCollision> worst_by_place(const DepthResult& result, const Skeleton& skeleton) {
  std::vector<bool> involved(skeleton.nodes.size(), false);
  DisjointSets places(skeleton.nodes.size());
  for (const DepthCollision& collision : result.collisions) {
    involved[collision.upper] = involved[collision.lower] = true;
    places.unite(collision.upper, collision.lower);
  }
  for (const auto& [i, k] : skeleton.edges) {
    if (involved[i] && involved[k]) places.unite(i, k);
  }
  std::vector<DepthCollision> worst(skeleton.nodes.size());
  for (const DepthCollision& collision : result.collisions) {
    DepthCollision& place = worst[places.root(collision.upper)];
    if (collision.shortfall > place.shortfall) place = collision;
  }
  std::erase_if(worst, [](const DepthCollision& collision) { return collision.shortfall == 0; });
  return worst;
}

}  // namespace

DepthWeights depth_weights(const DepthSettings& settings, Index object) {
  constexpr double least = 1e-3;  // less, and an object could float away
  const DepthOptions& options = settings.options;
  DepthWeights weights{options.weight_curvature, options.weight_orientation, options.weight_distance};
  if (object < settings.object_weights.size()) weights = settings.object_weights[object];
  for (double* weight : {&weights.curvature, &weights.orientation, &weights.distance}) {
    *weight = std::clamp(*weight, least, 1.0);
  }
  return weights;
}

DepthResult solve_depth(Skeleton& skeleton, const LabelledFigure& figure, const DepthSettings& settings,
                        Progress& progress) {
  DepthResult result;
  Progress first = progress.step("depth", 0.7);
  solve_all(skeleton, figure, settings, first, result);
  std::set<Index> nodes;
  for (const DepthCollision& collision : result.collisions) nodes.insert({collision.upper, collision.lower});
  for (const Index node : nodes) {
    if (split_chord(node, figure, skeleton)) ++result.split_chords;
  }
  if (result.split_chords > 0) {
    Progress second = progress.step("depth", 0.3);
    solve_all(skeleton, figure, settings, second, result);
  }
  progress.report(1);
  return result;
}

Findings depth_findings(const DepthResult& result, const Skeleton& skeleton, const LabelledFigure& figure,
                        const Drawing& drawing) {
  Findings findings;
  for (const DepthCollision& collision : worst_by_place(result, skeleton)) {
    std::vector<Subject> subjects;
    for (const Index n : {collision.upper, collision.lower}) {
      const SkeletonNode& node = skeleton.nodes[n];
      std::set<Index> strokes;
      for (const Vec2& end : node.chord) strokes.insert(nearest_stroke(node, figure, drawing, end));
      strokes.erase(no_index);
      for (const Index stroke : strokes) subjects.push_back(stroke_subject(drawing, stroke, node.position));
    }
    findings.push_back(make_warning(Category::Geometry, "W_COLLISION",
                                    "Two parts that lie over one another are nearer than the minimum gap: draw them "
                                    "thinner, further apart, or reduce the minimum gap",
                                    std::move(subjects)));
  }
  return findings;
}

namespace {

/// A node's chord passes through a panel.
struct PanelNode {
  Index face = 0;
  Index layer = 0;
  Index node = 0;

  auto operator<=>(const PanelNode&) const = default;
  bool same_panel(const PanelNode& other) const { return face == other.face && layer == other.layer; }
};

std::vector<PanelNode> nodes_by_panel(const Skeleton& skeleton, const LabelledFigure& figure) {
  std::vector<PanelNode> entries;
  for (Index n = 0; n < skeleton.nodes.size(); ++n) {
    for (const SheetPlace& place : skeleton.nodes[n].crossed) {
      entries.push_back({figure.faces[place.triangle], place.layer, n});
    }
  }
  std::sort(entries.begin(), entries.end());
  return entries;
}

/// Where a node's part of the contour lies: the ends of its chord, and of a branch's last node the tip beyond it.
std::vector<std::vector<Vec2>> rim_places(const Skeleton& skeleton) {
  std::vector<std::vector<Vec2>> places;
  for (const SkeletonNode& node : skeleton.nodes) places.emplace_back(node.chord.begin(), node.chord.end());
  const std::vector<std::vector<Index>> neighbours = skeleton.neighbours();
  for (Index n = 0; n < places.size(); ++n) {
    if (neighbours[n].size() != 1) continue;
    const SkeletonNode& node = skeleton.nodes[n];
    const Vec2 outward = node.position - skeleton.nodes[neighbours[n].front()].position;
    places[n].push_back(node.position + node.radius * outward.normalized());
  }
  return places;
}

/// A section of a limb.
struct Section {
  double half_width = 0;
  double half_depth = 0;

  double height(double offset) const {
    const double part = offset / half_width;
    return half_depth * std::sqrt(std::max(0.0, 1 - part * part));
  }
};

/// How far apart in depth two sections touch whose middles are so far apart in the plane; 0 where they never do.
double touching_distance(const Section& a, const Section& b, double offset) {
  const double width = a.half_width + b.half_width;
  if (offset >= width) return 0;
  const double depth = a.half_depth + b.half_depth;
  // Ellipses of one shape touch as circles do.
  if (a.half_depth * b.half_width == b.half_depth * a.half_width) {
    return depth / width * std::sqrt(width * width - offset * offset);
  }
  // The sum of their heights over one place is concave: halving by the golden section, to a millionth.
  constexpr int steps = 30;
  constexpr double golden = 0.618033988749895;
  double low = std::max(-a.half_width, offset - b.half_width);
  double high = std::min(a.half_width, offset + b.half_width);
  const auto sum = [&](double x) { return a.height(x) + b.height(offset - x); };
  for (int step = 0; step < steps; ++step) {
    const double left = high - golden * (high - low);
    const double right = low + golden * (high - low);
    if (sum(left) < sum(right)) {
      low = left;
    } else {
      high = right;
    }
  }
  return sum((low + high) / 2);
}

/// Of a ball of that radius, away from its centre; 0 outside it.
double ball_height(double radius, const Vec2& offset) {
  return std::sqrt(std::max(0.0, radius * radius - offset.squaredNorm()));
}

/// Along z, of the middles of joined parts where two of their nodes lie over one another.
double attached_height(double kappa, const SkeletonNode& a, const SkeletonNode& b, const DepthSettings& settings) {
  const double deep_a = settings.thickness_of(a.object) * a.radius;
  const double deep_b = settings.thickness_of(b.object) * b.radius;
  const double wide = attached_distance(kappa, a.radius, b.radius);
  return attached_distance(kappa, deep_a, deep_b) / wide * ball_height(wide, a.position - b.position);
}

/// @param upper_rim the upper node's places of the contour
CollisionRow row_between(Index upper, Index lower, const Skeleton& skeleton, const LabelledFigure& figure,
                         const DepthSettings& settings, std::span<const Vec2> upper_rim) {
  const SkeletonNode& a = skeleton.nodes[upper];
  const SkeletonNode& b = skeleton.nodes[lower];
  const Vec2 offset = a.position - b.position;
  const auto kappa = settings.attachments.kappa(a.object, b.object);
  if (kappa) {
    double bound = attached_height(*kappa, a, b, settings);
    for (const Vec2& place : upper_rim) {
      bound = std::max(bound, settings.thickness_of(b.object) * ball_height(b.radius, place - b.position));
    }
    return {upper, lower, bound, attached_height(1, a, b, settings)};
  }
  double gap = settings.options.minimum_gap * skeleton.scale;
  if (settings.attachments.resting(a.object, b.object)) gap = std::min(gap, resting_gap(skeleton.scale, figure.unit));
  const auto section = [&](const SkeletonNode& node) -> Section {
    return {node.radius + gap / 2, settings.thickness_of(node.object) * node.radius + gap / 2};
  };
  return {upper, lower, touching_distance(section(a), section(b), offset.norm()), 0};
}

}  // namespace

std::vector<CollisionRow> collision_rows(const Skeleton& skeleton, const LabelledFigure& figure,
                                         const DepthSettings& settings) {
  const bool joined = settings.attachments.any(Hold::Joined);
  const std::vector<PanelNode> entries = nodes_by_panel(skeleton, figure);
  const std::vector<std::vector<Vec2>> rims = rim_places(skeleton);
  std::vector<CollisionRow> rows;
  std::vector<std::span<const PanelNode>> stack;  // panels of this face that lie above
  for (std::size_t begin = 0, end = 0; begin < entries.size(); begin = end) {
    while (end < entries.size() && entries[end].same_panel(entries[begin])) ++end;
    const std::span<const PanelNode> panel(entries.data() + begin, end - begin);
    const PanelNode& here = entries[begin];
    std::erase_if(stack, [&](const auto& above) {
      return above.front().face != here.face || (!joined && above.front().layer + 1 != here.layer);
    });
    for (const auto& above : stack) {
      for (const PanelNode& upper : above) {
        for (const PanelNode& lower : panel) {
          if (upper.node == lower.node) continue;
          const CollisionRow row = row_between(upper.node, lower.node, skeleton, figure, settings, rims[upper.node]);
          if (row.bound > 0) rows.push_back(row);
        }
      }
    }
    stack.push_back(panel);
  }
  const auto ends = [](const CollisionRow& row) { return std::tie(row.upper, row.lower); };
  std::sort(rows.begin(), rows.end(), [&](const auto& a, const auto& b) { return ends(a) < ends(b); });
  const auto same = [&](const auto& a, const auto& b) { return ends(a) == ends(b); };
  rows.erase(std::unique(rows.begin(), rows.end(), same), rows.end());
  return rows;
}

namespace {

/// factor times the change of the gradient in a direction.
EdgeRow gradient_change(double factor, const Vec2& direction) {
  const Vec2 w = factor * direction;
  return {0, -w.x(), -w.y(), 0, w.x(), w.y()};
}

/// Adds a row over both ends of an edge.
/// @param ends in the part
void add_edge_row(const std::array<Index, 2>& ends, const EdgeRow& row, double factor, SparseRows& rows) {
  std::array<SparseRows::Entry, 6> entries;
  for (Index i = 0; i < 6; ++i) entries[i] = {3 * ends[i / 3] + i % 3, factor * row[i]};
  rows.add(entries);
}

/// What an object's rows are multiplied by.
DepthWeights row_weights(const DepthSettings& settings, const std::vector<double>& stiffness, Index object) {
  const DepthWeights own = depth_weights(settings, object);
  const double factor = object < stiffness.size() ? stiffness[object] : 1;
  return {own.curvature * factor, own.orientation * factor, own.distance * factor};
}

/// s_i / L: half the length of the edges at each node; a node without edges stands for a disk of its radius.
std::vector<double> node_lengths(const Skeleton& skeleton, const DepthPart& part) {
  std::vector<double> lengths(part.nodes.size(), 0);
  for (const Index e : part.edges) {
    const auto& [i, k] = skeleton.edges[e];
    const double half = (skeleton.nodes[k].position - skeleton.nodes[i].position).norm() / 2;
    lengths[part.local(i)] += half;
    lengths[part.local(k)] += half;
  }
  for (std::size_t n = 0; n < lengths.size(); ++n) {
    if (lengths[n] == 0) lengths[n] = skeleton.nodes[part.nodes[n]].radius;
    lengths[n] /= skeleton.scale;
  }
  return lengths;
}

}  // namespace

EdgeRow continuity_row(const Vec2& along) {
  const double l = along.norm();
  const Vec2 t = along / l;
  return {-2 / l, -t.x(), -t.y(), 2 / l, -t.x(), -t.y()};
}

std::array<EdgeRow, 2> curvature_rows(const Vec2& along, double scale, double poisson) {
  const double l = along.norm();
  const Vec2 t = along / l;
  return {gradient_change(std::sqrt(scale / l * (1 - poisson * poisson)), t),
          gradient_change(std::sqrt(scale / l * 2 * (1 - poisson)), left_of(t))};
}

Index DepthPart::local(Index node) const {
  return static_cast<Index>(std::lower_bound(nodes.begin(), nodes.end(), node) - nodes.begin());
}

std::vector<DepthPart> depth_parts(const Skeleton& skeleton, std::span<const CollisionRow> rows) {
  DisjointSets sets(skeleton.nodes.size());
  for (const auto& [i, k] : skeleton.edges) sets.unite(i, k);
  for (const CollisionRow& row : rows) sets.unite(row.upper, row.lower);
  std::vector<Index> part_of;
  std::vector<DepthPart> parts(sets.number(part_of));
  for (Index n = 0; n < skeleton.nodes.size(); ++n) parts[part_of[n]].nodes.push_back(n);
  for (Index e = 0; e < skeleton.edges.size(); ++e) parts[part_of[skeleton.edges[e][0]]].edges.push_back(e);
  for (Index q = 0; q < rows.size(); ++q) parts[part_of[rows[q].upper]].rows.push_back(q);
  return parts;
}

LeastSquaresProblem depth_problem(const Skeleton& skeleton, const DepthPart& part, std::span<const CollisionRow> rows,
                                  const DepthSettings& settings) {
  const std::vector<double> stiffness = settings.equally_stiff ? std::vector<double>{} : row_stiffness(skeleton);
  SparseRows objective, equalities, inequalities;
  for (const Index e : part.edges) {
    const auto& [i, k] = skeleton.edges[e];
    const Vec2 along = (skeleton.nodes[k].position - skeleton.nodes[i].position) / skeleton.scale;
    const double weight = row_weights(settings, stiffness, skeleton.nodes[i].object).curvature;
    const std::array<Index, 2> ends{part.local(i), part.local(k)};
    add_edge_row(ends, continuity_row(along), 1, equalities);
    for (const EdgeRow& row : curvature_rows(along, 1)) add_edge_row(ends, row, weight, objective);
  }
  const std::vector<double> lengths = node_lengths(skeleton, part);
  std::vector<double> target(static_cast<std::size_t>(objective.size()), 0);
  for (Index n = 0; n < part.nodes.size(); ++n) {
    const Index object = skeleton.nodes[part.nodes[n]].object;
    const DepthWeights weights = row_weights(settings, stiffness, object);
    const double root = std::sqrt(lengths[n]);
    const double height = object < skeleton.rest.size() ? skeleton.rest[object] / skeleton.scale : 0;
    target.insert(target.end(), {weights.distance * root * height, 0, 0});
    objective.add({{3 * n, weights.distance * root}});
    objective.add({{3 * n + 1, weights.orientation * root}});
    objective.add({{3 * n + 2, weights.orientation * root}});
  }
  LeastSquaresProblem problem;
  problem.objective = objective.matrix(3 * part.nodes.size());
  problem.target = Eigen::Map<const Eigen::VectorXd>(target.data(), static_cast<Eigen::Index>(target.size()));
  problem.equalities = equalities.matrix(3 * part.nodes.size());
  problem.inequality_bounds.resize(static_cast<Eigen::Index>(part.rows.size()));
  for (const Index q : part.rows) {
    const CollisionRow& row = rows[q];
    problem.inequality_bounds[inequalities.size()] = row.bound / skeleton.scale;
    inequalities.add({{3 * part.local(row.upper), 1}, {3 * part.local(row.lower), -1}});
  }
  problem.inequalities = inequalities.matrix(3 * part.nodes.size());
  return problem;
}

}  // namespace croquis::silhouette
