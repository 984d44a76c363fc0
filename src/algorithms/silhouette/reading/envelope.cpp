// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/reading/envelope.h"

#include <algorithm>
#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/boykov_kolmogorov_max_flow.hpp>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <utility>

#include <Eigen/Geometry>

#include "croquis/geometry/disjoint_sets.h"
#include "croquis/geometry/planar_triangulation.h"

namespace croquis::silhouette {
namespace {

// Samples are about this share of the drawing's diagonal apart; edges between them shorter than `ink_steps` of that lie
// on a line.
constexpr double step_share = 1.0 / 250;
constexpr double ink_steps = 1.8;
// Of the directions from a place at least so many must meet a line for it to lie inside, and how much that weighs
// against the length of gaps: a place in the open is worth so many times its area over the diagonal.
constexpr double enclosed_share = 0.78;
constexpr double enclosure_weight = 30;
constexpr double outside_in_frame = -1e3;  // in diagonals: what touches the frame is outside
constexpr int directions = 48;
// What cutting along a line costs of what the same gap would.
constexpr double cut_along_line = 0.02;
// A piece of the inside that lines divide from the rest and a gap from the outside is given up, such as what lies
// between two legs, where that is worth more than it costs: length of lines that come onto the outline, or outside
// altogether, counts so much of that of gaps.
constexpr double line_onto_outline = 0.3;
constexpr double line_outside = 1;
// Smaller regions, in parts of the diagonal's square, are specks.
constexpr double least_area = 0.002;
// No three samples on a line: they are moved by so much of a step.
constexpr double displacement = 1e-3;
constexpr int frame_points = 24;
constexpr double frame_radius = 1.2;

/// The samples of all lines, each place once, and the triangulation of these and of a frame around them.
struct Ink {
  Points points;                              ///< samples, then the frame
  std::vector<Index> stroke;                  ///< per sample: the first on it
  std::vector<std::vector<Index>> of_stroke;  ///< the samples of each
  Eigen::AlignedBox2d box;
  double diagonal = 0;
  double step = 1;
  PlanarTriangulation plane;

  std::pair<Index, Index> edge(std::size_t triangle, std::size_t opposite) const {
    const auto& corners = plane.triangles[triangle];
    return {corners[(opposite + 1) % 3], corners[(opposite + 2) % 3]};
  }
  double edge_length(std::size_t triangle, std::size_t opposite) const {
    const auto [from, to] = edge(triangle, opposite);
    return (points[to] - points[from]).norm();
  }
  bool is_on_line(double length) const { return length <= ink_steps * step; }
};

Ink ink_of(const std::vector<SampledStroke>& strokes) {
  Ink ink;
  for (const SampledStroke& stroke : strokes) {
    for (const Vec2& point : stroke.points) ink.box.extend(point);
  }
  ink.diagonal = ink.box.diagonal().norm();
  ink.step = step_share * ink.diagonal;
  std::map<std::pair<long, long>, Index> at;
  for (Index s = 0; s < strokes.size(); ++s) {
    std::vector<Index>& own = ink.of_stroke.emplace_back();
    for (const double parameter : even_parameters(strokes[s].points, strokes[s].closed, ink.step)) {
      const Vec2 place = point_at(strokes[s].points, parameter);
      const Vec2 cell = (place - ink.box.center()) / (ink.step / 2);
      const std::pair key{std::lround(cell.x()), std::lround(cell.y())};
      const auto [known, fresh] = at.try_emplace(key, static_cast<Index>(ink.points.size()));
      if (fresh) {
        ink.points.push_back(place);
        ink.stroke.push_back(s);
      }
      own.push_back(known->second);
    }
  }
  for (std::size_t i = 0; i < ink.points.size(); ++i) {
    ink.points[i] += displacement * ink.step * Vec2(scattered(2 * i), scattered(2 * i + 1));
  }
  for (int k = 0; k < frame_points; ++k) {
    const double angle = k * 2 * std::numbers::pi / frame_points;
    ink.points.emplace_back(ink.box.center() + frame_radius * ink.diagonal * Vec2(std::cos(angle), std::sin(angle)));
  }
  ink.plane = triangulate(ink.points, {}).triangulation;
  return ink;
}

/// Per triangle what it is worth that it lies inside: its area by the share of all directions in which a line is met.
std::vector<double> worth_inside(const Ink& ink) {
  const double cell = 2 * ink.step;
  const Vec2 half = ink.box.sizes() / (2 * cell);  // cells to both sides of the centre: mirrored drawings are alike
  const int columns = 2 * (static_cast<int>(half.x()) + 1), rows = 2 * (static_cast<int>(half.y()) + 1);
  const Vec2 low = ink.box.center() - cell / 2 * Vec2(columns, rows);
  std::vector<char> filled(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows), 0);
  const auto cell_at = [&](const Vec2& place) -> char* {
    const Vec2 at = (place - low) / cell;
    const int x = static_cast<int>(std::floor(at.x())), y = static_cast<int>(std::floor(at.y()));
    if (x < 0 || y < 0 || x >= columns || y >= rows) return nullptr;
    return &filled[static_cast<std::size_t>(y) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(x)];
  };
  for (std::size_t i = 0; i < ink.stroke.size(); ++i) {
    if (char* there = cell_at(ink.points[i])) *there = 1;
  }
  const auto enclosure = [&](const Vec2& place) {
    int met = 0;
    for (int k = 0; k < directions; ++k) {
      const double angle = (k + 0.5) * 2 * std::numbers::pi / directions;
      const Vec2 stride = 0.7 * cell * Vec2(std::cos(angle), std::sin(angle));
      Vec2 at = place + stride;
      const char* there = cell_at(at);
      while (there != nullptr && *there == 0) there = cell_at(at += stride);
      met += there != nullptr ? 1 : 0;
    }
    return static_cast<double>(met) / directions;
  };
  std::vector<double> worth;
  for (const auto& [i, j, k] : ink.plane.triangles) {
    const Vec2 &a = ink.points[i], &b = ink.points[j], &c = ink.points[k];
    const bool in_frame = std::max({i, j, k}) >= ink.stroke.size();
    const double area = cross(b - a, c - a) / 2;
    worth.push_back(in_frame ? outside_in_frame * ink.diagonal
                             : enclosure_weight * area / ink.diagonal * (enclosure((a + b + c) / 3) - enclosed_share));
  }
  return worth;
}

using CutTraits = boost::adjacency_list_traits<boost::vecS, boost::vecS, boost::directedS>;
using CutNode =
    boost::property<boost::vertex_color_t, boost::default_color_type,
                    boost::property<boost::vertex_distance_t, long,
                                    boost::property<boost::vertex_predecessor_t, CutTraits::edge_descriptor>>>;
using CutEdge = boost::property<boost::edge_capacity_t, double,
                                boost::property<boost::edge_residual_capacity_t, double,
                                                boost::property<boost::edge_reverse_t, CutTraits::edge_descriptor>>>;
using CutGraph = boost::adjacency_list<boost::vecS, boost::vecS, boost::directedS, CutNode, CutEdge>;

/// Per triangle whether it lies inside, by the minimum cut (Boykov and Kolmogorov 2004).
std::vector<char> minimum_cut(const Ink& ink, const std::vector<double>& worth) {
  const std::size_t source = worth.size(), sink = source + 1;  // inside, outside
  CutGraph graph(worth.size() + 2);
  const auto connect = [&](std::size_t from, std::size_t to, double forth, double back) {
    const auto there = add_edge(from, to, graph).first, again = add_edge(to, from, graph).first;
    put(boost::edge_capacity, graph, there, forth);
    put(boost::edge_capacity, graph, again, back);
    put(boost::edge_reverse, graph, there, again);
    put(boost::edge_reverse, graph, again, there);
  };
  for (std::size_t t = 0; t < worth.size(); ++t) {
    worth[t] > 0 ? connect(source, t, worth[t], 0) : connect(t, sink, -worth[t], 0);
    for (std::size_t i = 0; i < 3; ++i) {
      const Index other = ink.plane.neighbours[t][i];
      if (other == no_index || other < t) continue;
      const double length = ink.edge_length(t, i);
      const double cost = ink.is_on_line(length) ? cut_along_line * length : length;
      connect(t, other, cost, cost);
    }
  }
  boost::boykov_kolmogorov_max_flow(graph, source, sink);
  const auto colour = get(boost::vertex_color, graph);
  std::vector<char> inside;
  for (std::size_t t = 0; t < worth.size(); ++t) inside.push_back(colour[t] == colour[source] ? 1 : 0);
  return inside;
}

/// Takes pieces that only lines divide from the rest of the inside, and gaps from the outside, out of it where they
/// are worth less than what they cost, the worst first.
void give_up_pieces(const Ink& ink, const std::vector<double>& worth, std::vector<char>& inside) {
  const auto for_each_inner_edge = [&](const auto& visit) {
    for (Index t = 0; t < inside.size(); ++t) {
      for (std::size_t i = 0; inside[t] != 0 && i < 3; ++i) {
        const Index other = ink.plane.neighbours[t][i];
        visit(t, other, other != no_index && inside[other] != 0, ink.edge_length(t, i));
      }
    }
  };
  DisjointSets pieces(inside.size());
  for_each_inner_edge([&](Index t, Index other, bool within, double length) {
    if (within && !ink.is_on_line(length)) pieces.unite(t, other);
  });
  while (true) {
    std::map<Index, double> gain;
    std::set<Index> open;
    for (Index t = 0; t < inside.size(); ++t) {
      if (inside[t] != 0) gain[pieces.root(t)] -= worth[t];
    }
    for_each_inner_edge([&](Index t, Index other, bool within, double length) {
      const Index piece = pieces.root(t);
      if (ink.is_on_line(length)) {
        if (!within || pieces.root(other) != piece)
          gain[piece] += (within ? line_onto_outline : -line_outside) * length;
      } else if (!within) {
        gain[piece] += length;
        open.insert(piece);
      }
    });
    const auto best = std::ranges::max_element(open, {}, [&](Index piece) { return gain[piece]; });
    if (best == open.end() || gain[*best] <= 0) return;
    for (Index t = 0; t < inside.size(); ++t) {
      if (inside[t] != 0 && pieces.root(t) == *best) inside[t] = 0;
    }
  }
}

void measure_strokes(const Ink& ink, const std::vector<char>& inside, Envelope& result) {
  enum Side : unsigned { Outside = 1, Inside = 2 };
  std::vector<unsigned> touches(ink.points.size(), 0);
  for (std::size_t t = 0; t < inside.size(); ++t) {
    for (const Index v : ink.plane.triangles[t]) touches[v] |= inside[t] != 0 ? Inside : Outside;
  }
  double outlines = 0;
  for (std::size_t s = 0; s < ink.of_stroke.size(); ++s) {
    double on_outline = 0, outside = 0;
    for (const Index v : ink.of_stroke[s]) {
      on_outline += touches[v] == (Inside | Outside) ? 1 : 0;
      outside += (touches[v] & Inside) == 0 ? 1 : 0;
    }
    result.outside[s] = outside / static_cast<double>(ink.of_stroke[s].size());
    result.seen[s] = on_outline;
    outlines += on_outline;
  }
  for (double& seen : result.seen) seen /= std::max(outlines, 1.0);
}

/// Walks round the regions, each with the inside on the left.
void find_regions(const Ink& ink, const std::vector<char>& inside, Envelope& result) {
  std::multimap<Index, Index> next;
  for (std::size_t t = 0; t < inside.size(); ++t) {
    for (std::size_t i = 0; inside[t] != 0 && i < 3; ++i) {
      const Index other = ink.plane.neighbours[t][i];
      if (other == no_index || inside[other] == 0) next.insert(ink.edge(t, i));
    }
  }
  while (!next.empty()) {
    EnclosedRegion region;
    std::map<Index, Index> after;  // the outline's next sample
    for (auto step = next.begin(); step != next.end();) {
      const auto [from, to] = *step;
      region.outline.push_back(ink.points[from]);
      region.stroke.push_back(ink.stroke[from]);
      after[from] = to;
      next.erase(step);
      step = next.find(to);
    }
    region.area = signed_area(region.outline);
    if (region.area < least_area * ink.diagonal * ink.diagonal) continue;
    for (const std::vector<Index>& samples : ink.of_stroke) {
      int shared = 0, left = 0;
      for (std::size_t i = 0; i < samples.size(); ++i) {
        const auto here = after.find(samples[i]);
        if (here == after.end()) continue;
        ++shared;
        if (i + 1 < samples.size() && here->second == samples[i + 1]) ++left;
        if (i > 0 && here->second == samples[i - 1]) --left;
      }
      region.shared.push_back(shared * ink.step);
      region.left.push_back(left * ink.step);
    }
    result.regions.push_back(std::move(region));
  }
  std::ranges::stable_sort(result.regions, std::greater(), &EnclosedRegion::area);
}

}  // namespace

Envelope enclosed_regions(const std::vector<SampledStroke>& strokes) {
  const Ink ink = ink_of(strokes);
  Envelope result;
  result.diagonal = ink.diagonal;
  result.seen.assign(strokes.size(), 0);
  result.outside.assign(strokes.size(), 0);
  if (ink.plane.triangles.empty()) return result;
  const std::vector<double> worth = worth_inside(ink);
  std::vector<char> inside = minimum_cut(ink, worth);
  give_up_pieces(ink, worth, inside);
  measure_strokes(ink, inside, result);
  find_regions(ink, inside, result);
  return result;
}

}  // namespace croquis::silhouette
