// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/reading/envelope.h"

#include <algorithm>
#include <array>
#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/boykov_kolmogorov_max_flow.hpp>
#include <cmath>
#include <map>
#include <numbers>
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

/// The samples of all lines, each place once.
struct Ink {
  Points points;
  std::vector<Index> stroke;                  ///< per point: the first on it
  std::vector<std::vector<Index>> of_stroke;  ///< the points of each
  Eigen::AlignedBox2d box;
  double step = 1;

  explicit Ink(const std::vector<SampledStroke>& strokes) : of_stroke(strokes.size()) {
    for (const SampledStroke& s : strokes) {
      for (const Vec2& point : s.points) box.extend(point);
    }
    step = step_share * box.diagonal().norm();
    for (Index s = 0; s < strokes.size(); ++s) add(strokes[s], s);
    for (std::size_t i = 0; i < points.size(); ++i) {
      points[i] += displacement * step * Vec2(scattered(2 * i), scattered(2 * i + 1));
    }
  }

 private:
  void add(const SampledStroke& line, Index s) {
    for (const double parameter : even_parameters(line.points, line.closed, step)) {
      const Vec2 place = point_at(line.points, parameter);
      const Vec2 cell = (place - box.center()) / (step / 2);
      const std::pair key{std::lround(cell.x()), std::lround(cell.y())};
      const auto [known, fresh] = at_.try_emplace(key, static_cast<Index>(points.size()));
      if (fresh) {
        points.push_back(place);
        stroke.push_back(s);
      }
      of_stroke[s].push_back(known->second);
    }
  }

  std::map<std::pair<long, long>, Index> at_;
};

/// Which cells of a grid hold a line: to look from a place into all directions.
class InkGrid {
 public:
  explicit InkGrid(const Ink& ink) : cell_(2 * ink.step) {
    const Vec2 half = ink.box.sizes() / (2 * cell_);  // cells to both sides of the centre: mirrored drawings are alike
    columns_ = 2 * (static_cast<int>(half.x()) + 1);
    rows_ = 2 * (static_cast<int>(half.y()) + 1);
    low_ = ink.box.center() - cell_ / 2 * Vec2(columns_, rows_);
    filled_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), 0);
    for (const Vec2& point : ink.points) {
      if (char* filled = cell_at(point)) *filled = 1;
    }
  }

  /// The share of all directions in which a line is met.
  double enclosure(const Vec2& place) {
    int met = 0;
    for (int k = 0; k < directions; ++k) {
      const double angle = (k + 0.5) * 2 * std::numbers::pi / directions;
      const Vec2 stride = 0.7 * cell_ * Vec2(std::cos(angle), std::sin(angle));
      Vec2 at = place + stride;
      const char* filled = cell_at(at);
      while (filled != nullptr && *filled == 0) filled = cell_at(at += stride);
      met += filled != nullptr ? 1 : 0;
    }
    return static_cast<double>(met) / directions;
  }

 private:
  char* cell_at(const Vec2& place) {
    const Vec2 at = (place - low_) / cell_;
    const int x = static_cast<int>(std::floor(at.x())), y = static_cast<int>(std::floor(at.y()));
    if (x < 0 || y < 0 || x >= columns_ || y >= rows_) return nullptr;
    return &filled_[static_cast<std::size_t>(y) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(x)];
  }

  Vec2 low_;
  double cell_;
  int columns_ = 1, rows_ = 1;
  std::vector<char> filled_;
};

/// The minimum cut between what is to lie on two sides (Boykov and Kolmogorov 2004).
class Cut {
 public:
  explicit Cut(std::size_t nodes) : graph_(nodes + 2), first_(nodes), second_(nodes + 1) {}

  /// What it costs to have the node on the second side; negative: on the first.
  void prefer_first(std::size_t node, double cost) {
    cost > 0 ? connect(first_, node, cost, 0) : connect(node, second_, -cost, 0);
  }
  void join(std::size_t a, std::size_t b, double cost) { connect(a, b, cost, cost); }

  /// Per node: whether it is on the first side.
  std::vector<char> solve() {
    boost::boykov_kolmogorov_max_flow(graph_, first_, second_);
    const auto colour = get(boost::vertex_color, graph_);
    std::vector<char> on_first(first_, 0);
    for (std::size_t node = 0; node < first_; ++node) on_first[node] = colour[node] == colour[first_] ? 1 : 0;
    return on_first;
  }

 private:
  using Traits = boost::adjacency_list_traits<boost::vecS, boost::vecS, boost::directedS>;
  using VertexProperties =
      boost::property<boost::vertex_color_t, boost::default_color_type,
                      boost::property<boost::vertex_distance_t, long,
                                      boost::property<boost::vertex_predecessor_t, Traits::edge_descriptor>>>;
  using EdgeProperties =
      boost::property<boost::edge_capacity_t, double,
                      boost::property<boost::edge_residual_capacity_t, double,
                                      boost::property<boost::edge_reverse_t, Traits::edge_descriptor>>>;
  using Graph = boost::adjacency_list<boost::vecS, boost::vecS, boost::directedS, VertexProperties, EdgeProperties>;

  void connect(std::size_t from, std::size_t to, double forth, double back) {
    const auto there = add_edge(from, to, graph_).first, again = add_edge(to, from, graph_).first;
    put(boost::edge_capacity, graph_, there, forth);
    put(boost::edge_capacity, graph_, again, back);
    put(boost::edge_reverse, graph_, there, again);
    put(boost::edge_reverse, graph_, again, there);
  }

  Graph graph_;
  std::size_t first_, second_;
};

class EnvelopeSearch {
 public:
  explicit EnvelopeSearch(const std::vector<SampledStroke>& strokes) : ink_(strokes) {
    places_ = ink_.points;
    const double diagonal = ink_.box.diagonal().norm();
    for (int k = 0; k < frame_points; ++k) {
      const double angle = k * 2 * std::numbers::pi / frame_points;
      places_.emplace_back(ink_.box.center() + frame_radius * diagonal * Vec2(std::cos(angle), std::sin(angle)));
    }
    plane_ = triangulate(places_, {}).triangulation;
  }

  Envelope run() {
    Envelope result;
    result.seen.assign(ink_.of_stroke.size(), 0);
    result.outside.assign(ink_.of_stroke.size(), 0);
    if (plane_.triangles.empty()) return result;
    cut();
    give_up_pieces();
    measure_strokes(result);
    find_regions(result);
    return result;
  }

 private:
  bool in_frame(std::size_t triangle) const {
    return std::ranges::any_of(plane_.triangles[triangle], [this](Index v) { return v >= ink_.points.size(); });
  }

  double edge_length(std::size_t triangle, std::size_t opposite) const {
    const auto [from, to] = edge(triangle, opposite);
    return (places_[to] - places_[from]).norm();
  }

  std::pair<Index, Index> edge(std::size_t triangle, std::size_t opposite) const {
    const auto& corners = plane_.triangles[triangle];
    return {corners[(opposite + 1) % 3], corners[(opposite + 2) % 3]};
  }

  bool is_on_line(double length) const { return length <= ink_steps * ink_.step; }

  void cut() {
    const double diagonal = ink_.box.diagonal().norm();
    InkGrid grid(ink_);
    Cut cut(plane_.triangles.size());
    worth_.assign(plane_.triangles.size(), 0);
    for (std::size_t t = 0; t < plane_.triangles.size(); ++t) {
      const auto& [a, b, c] = plane_.triangles[t];
      if (in_frame(t)) {
        cut.prefer_first(t, -1e3 * diagonal);
      } else {
        const double area = cross(places_[b] - places_[a], places_[c] - places_[a]) / 2;
        const double enclosure = grid.enclosure((places_[a] + places_[b] + places_[c]) / 3);
        worth_[t] = enclosure_weight * area / diagonal * (enclosure - enclosed_share);
        cut.prefer_first(t, worth_[t]);
      }
      for (std::size_t i = 0; i < 3; ++i) {
        const Index other = plane_.neighbours[t][i];
        if (other == no_index || other < t) continue;
        const double length = edge_length(t, i);
        cut.join(t, other, is_on_line(length) ? cut_along_line * length : length);
      }
    }
    inside_ = cut.solve();
  }

  void give_up_pieces() {
    DisjointSets pieces(plane_.triangles.size());
    for_each_inner_edge([&](Index t, Index other, double length) {
      if (other != no_index && inside_[other] != 0 && !is_on_line(length)) pieces.unite(t, other);
    });
    while (true) {
      std::map<Index, double> gain, gap;
      for (Index t = 0; t < inside_.size(); ++t) {
        if (inside_[t] != 0) gain[pieces.root(t)] -= worth_[t];
      }
      for_each_inner_edge([&](Index t, Index other, double length) {
        const Index piece = pieces.root(t);
        const bool within = other != no_index && inside_[other] != 0;
        if (is_on_line(length)) {
          if (!within || pieces.root(other) != piece)
            gain[piece] += (within ? line_onto_outline : -line_outside) * length;
        } else if (!within) {
          gain[piece] += length;
          gap[piece] += length;
        }
      });
      Index best = no_index;
      for (const auto& [piece, length] : gap) {
        if (gain[piece] > 0 && (best == no_index || gain[piece] > gain[best])) best = piece;
      }
      if (best == no_index) return;
      for (Index t = 0; t < inside_.size(); ++t) {
        if (inside_[t] != 0 && pieces.root(t) == best) inside_[t] = 0;
      }
    }
  }

  /// Of triangles inside: each edge with the triangle beyond it.
  template <typename Visit>
  void for_each_inner_edge(Visit&& visit) const {
    for (Index t = 0; t < inside_.size(); ++t) {
      for (std::size_t i = 0; inside_[t] != 0 && i < 3; ++i) visit(t, plane_.neighbours[t][i], edge_length(t, i));
    }
  }

  void measure_strokes(Envelope& result) const {
    std::vector<std::array<char, 2>> touches(places_.size(), {0, 0});
    for (std::size_t t = 0; t < plane_.triangles.size(); ++t) {
      for (const Index v : plane_.triangles[t]) touches[v][inside_[t] != 0 ? 1 : 0] = 1;
    }
    double outlines = 0;
    for (std::size_t s = 0; s < ink_.of_stroke.size(); ++s) {
      double on_outline = 0, outside = 0;
      for (const Index v : ink_.of_stroke[s]) {
        on_outline += touches[v][0] != 0 && touches[v][1] != 0 ? 1 : 0;
        outside += touches[v][1] == 0 ? 1 : 0;
      }
      result.outside[s] = outside / static_cast<double>(ink_.of_stroke[s].size());
      result.seen[s] = on_outline;
      outlines += on_outline;
    }
    if (outlines <= 0) return;
    for (double& seen : result.seen) seen /= outlines;
  }

  /// Walks round the regions, each with the inside on the left.
  void find_regions(Envelope& result) const {
    std::multimap<Index, Index> next;
    for (std::size_t t = 0; t < plane_.triangles.size(); ++t) {
      if (inside_[t] == 0) continue;
      for (std::size_t i = 0; i < 3; ++i) {
        const Index other = plane_.neighbours[t][i];
        if (other == no_index || inside_[other] == 0) next.insert(edge(t, i));
      }
    }
    const double diagonal = ink_.box.diagonal().norm();
    while (!next.empty()) {
      EnclosedRegion region;
      std::map<Index, Index> after;  // the outline's next sample
      for (auto step = next.begin(); step != next.end();) {
        const auto [from, to] = *step;
        region.outline.push_back(places_[from]);
        region.stroke.push_back(ink_.stroke[from]);
        after[from] = to;
        next.erase(step);
        step = next.find(to);
      }
      region.area = signed_area(region.outline);
      if (region.area < least_area * diagonal * diagonal) continue;
      for (const std::vector<Index>& points : ink_.of_stroke) {
        int shared = 0, left = 0;
        for (std::size_t i = 0; i < points.size(); ++i) {
          const auto here = after.find(points[i]);
          if (here == after.end()) continue;
          ++shared;
          if (i + 1 < points.size() && here->second == points[i + 1]) ++left;
          if (i > 0 && here->second == points[i - 1]) --left;
        }
        region.shared.push_back(shared * ink_.step);
        region.left.push_back(left * ink_.step);
      }
      result.regions.push_back(std::move(region));
    }
    std::ranges::stable_sort(result.regions, std::greater(), &EnclosedRegion::area);
  }

  Ink ink_;
  Points places_;  ///< samples and frame
  PlanarTriangulation plane_;
  std::vector<double> worth_;  ///< per triangle: of being inside
  std::vector<char> inside_;   ///< per triangle
};

}  // namespace

Envelope enclosed_regions(const std::vector<SampledStroke>& strokes) { return EnvelopeSearch(strokes).run(); }

}  // namespace croquis::silhouette
