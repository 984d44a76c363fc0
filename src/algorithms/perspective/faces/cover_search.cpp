// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/perspective/faces/cover_search.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <numeric>
#include <tuple>
#include <utility>
#include <vector>

#include "algorithms/perspective/faces/shells.h"
#include "algorithms/perspective/faces/solid_graph.h"
#include "croquis/geometry/vector.h"

namespace croquis {
namespace {

/// Something to choose: its cost and the rows that it covers.
struct CoverColumn {
  double cost = 0;
  std::vector<Index> rows;
};

struct EdgePrices {
  std::vector<double> price;    ///< per row
  std::vector<double> reduced;  ///< per column: cost less the prices of its rows
  double bound = 0;             ///< no choice that covers every row twice costs less
};

constexpr int most_price_steps = 200;
constexpr int patience = 12;              ///< steps without a better bound before steps are halved
constexpr double least_step = 0.01;       ///< × Polyak's length
constexpr double starting_price = -0.25;  ///< a quadrilateral's, per side

/// The bound that the prices give; fills the reduced costs and how far each row is from being covered twice.
double price_bound(const std::vector<CoverColumn>& columns, const std::vector<double>& price,
                   std::vector<double>& reduced, std::vector<double>& lack) {
  double bound = 0;
  for (const double p : price) bound += 2 * p;
  std::ranges::fill(lack, 2.0);
  for (std::size_t c = 0; c < columns.size(); ++c) {
    double cost = columns[c].cost;
    for (const Index row : columns[c].rows) cost -= price[row];
    reduced[c] = cost;
    if (cost >= 0) continue;
    bound += cost;
    for (const Index row : columns[c].rows) lack[row] -= 1;
  }
  return bound;
}

/// Lagrange multipliers of "every row twice", by subgradient steps of Polyak's length.
/// @param goal about what the best choice costs; the nearer, the faster
EdgePrices price_rows(const std::vector<CoverColumn>& columns, std::size_t row_count, double goal) {
  std::vector<double> price(row_count, starting_price), reduced(columns.size()), lack(row_count);
  EdgePrices best{price, reduced, -1e300};
  double scale = 1;
  int waited = 0;
  for (int step = 0; step < most_price_steps && scale > least_step; ++step) {
    const double bound = price_bound(columns, price, reduced, lack);
    if (bound > best.bound + 1e-9) {
      best = {price, reduced, bound};
      waited = 0;
    } else if (++waited >= patience) {
      scale /= 2;
      waited = 0;
      price = best.price;
      price_bound(columns, price, reduced, lack);
    }
    double squares = 0;
    for (const double l : lack) squares += l * l;
    if (squares == 0 || best.bound >= goal - 1e-9) break;
    const double length = scale * std::max(goal - bound, 0.05) / squares;
    for (std::size_t row = 0; row < row_count; ++row) price[row] += length * lack[row];
  }
  return best;
}

/// Which edges follow each other around each vertex by the faces chosen so far. Faces can be taken back, last first.
class VertexLinks {
 public:
  /// @param edges of the graph, that take part
  VertexLinks(const SolidGraph& graph, const std::vector<Index>& edges)
      : graph_(graph), degree_(graph.points.size(), 0), parent_(2 * graph.edges.size()), size_(parent_.size()) {
    for (const Index e : edges) {
      ++degree_[graph.edges[e].start];
      ++degree_[graph.edges[e].end];
    }
    clear();
  }

  void clear() {
    std::iota(parent_.begin(), parent_.end(), Index{0});
    std::ranges::fill(size_, 1);
    joined_.clear();
    marks_.clear();
  }

  /// @param strict whether a circle around a vertex must have all edges that meet there
  /// @return whether the face fits the others; it is added in any case
  bool add(const FaceCandidate& face, bool strict) {
    marks_.push_back(joined_.size());
    bool fits = true;
    for (const std::vector<Index>& loop : face.loops) {
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const Index from = SolidGraph::twin(loop[i]), to = loop[(i + 1) % loop.size()];
        fits = join(from, to) || !strict ? fits : false;
      }
    }
    return fits;
  }

  void take_back() {
    while (joined_.size() > marks_.back()) {
      const Index child = joined_.back();
      joined_.pop_back();
      size_[parent_[child]] -= size_[child];
      parent_[child] = child;
    }
    marks_.pop_back();
  }

 private:
  Index root(Index half) const {
    while (parent_[half] != half) half = parent_[half];
    return half;
  }

  /// False if that closes a circle without all edges of the vertex.
  bool join(Index a, Index b) {
    Index low = root(a), high = root(b);
    if (low == high) return size_[low] == degree_[graph_.origin(a)];
    if (size_[low] > size_[high]) std::swap(low, high);
    parent_[low] = high;
    size_[high] += size_[low];
    joined_.push_back(low);
    return true;
  }

  const SolidGraph& graph_;
  std::vector<Index> degree_, parent_, size_;
  std::vector<Index> joined_;
  std::vector<std::size_t> marks_;
};

/// What a cover by flat quadrilaterals costs per edge.
constexpr double goal_of_quadrilaterals = -0.5;

constexpr double cost_rounding = 1e-9;

/// If there is a cover the first one is found in few nodes; what is likely to have none shouldn't take long.
constexpr std::size_t dive_share = 10;

/// Nodes between two looks at the cancel flag.
constexpr std::size_t nodes_per_check = 256;

bool is_better(const Cover& a, const Cover& b) {
  if (std::abs(a.cost - b.cost) > cost_rounding) return a.cost < b.cost;
  if (std::abs(a.deviation - b.deviation) > cost_rounding) return a.deviation < b.deviation;
  return a.chosen < b.chosen;
}

enum class ColumnState : std::uint8_t { Free, Chosen, Out };

/// The depth-first search. Columns are the members of the problem, then in partial covers two open sides per edge.
class CoverSearch {
 public:
  CoverSearch(const CoverProblem& problem, Progress& progress)
      : problem_(problem), progress_(progress), links_(problem.graph, problem.edges) {
    for (Index r = 0; r < problem.edges.size(); ++r) row_of_[problem.edges[r]] = r;
    for (const Index member : problem.members) {
      const FaceCandidate& face = problem.candidates[member];
      CoverColumn column{face.cost - 1, {}};
      for (const Index e : face.edges) column.rows.push_back(row_of_.at(e));
      columns_.push_back(std::move(column));
    }
    if (problem.partial) {
      for (Index r = 0; r < problem.edges.size(); ++r) {
        columns_.push_back({open_side_cost, {r}});
        columns_.push_back({second_open_side_cost, {r}});
      }
    }
    for (Index c = 0; c < problem.members.size(); ++c) {
      if (face(c).plane == no_index) continue;
      for (const Index region : face(c).regions) in_region_[{face(c).plane, region}].push_back(c);
    }
  }

  CoverResult run() {
    const std::size_t rows = problem_.edges.size();
    const double guess = goal_of_quadrilaterals * static_cast<double>(rows);
    if (!reset(price_rows(columns_, rows, guess).price)) return std::move(result_);
    dive_ = true;
    branch();
    dive_ = false;
    if (result_.covers.empty()) return std::move(result_);
    result_.limited = false;
    const EdgePrices prices = price_rows(columns_, rows, result_.covers[0].cost);
    if (reset(prices.price) && drop_dear()) branch();
    return std::move(result_);
  }

 private:
  bool is_open_side(Index column) const { return column >= problem_.members.size(); }
  bool is_second_open_side(Index column) const {
    return is_open_side(column) && (column - problem_.members.size()) % 2 == 1;
  }
  const FaceCandidate& face(Index column) const { return problem_.candidates[problem_.members[column]]; }

  /// Nothing chosen but the fixed faces; false if these don't fit.
  bool reset(const std::vector<double>& price) {
    const std::size_t rows = problem_.edges.size();
    state_.assign(columns_.size(), ColumnState::Free);
    demand_.assign(rows, 2);
    free_.assign(rows, 0);
    on_row_.assign(rows, {});
    reduced_.resize(columns_.size());
    trail_.clear();
    links_.clear();
    cost_ = bound_ = 0;
    for (const double p : price) bound_ += 2 * p;
    for (Index c = 0; c < columns_.size(); ++c) {
      reduced_[c] = columns_[c].cost;
      for (const Index r : columns_[c].rows) {
        reduced_[c] -= price[r];
        on_row_[r].push_back(c);
        ++free_[r];
      }
      bound_ += std::min(reduced_[c], 0.0);
    }
    order_rows();
    pending_.clear();
    for (const Index f : problem_.fixed) {
      const auto column = static_cast<Index>(std::ranges::lower_bound(problem_.members, f) - problem_.members.begin());
      if (!choose(column)) return false;
    }
    for (Index r = 0; r < rows; ++r) pending_.push_back(r);
    return propagate();
  }

  /// Columns of a row are tried in this order.
  void order_rows() {
    const auto key = [&](Index c) {
      return std::tuple(reduced_[c], columns_[c].cost, is_open_side(c) ? 0.0 : face(c).deviation, c);
    };
    for (std::vector<Index>& columns : on_row_) std::ranges::sort(columns, {}, key);
  }

  double limit() const {
    if (result_.covers.empty()) return std::numeric_limits<double>::infinity();
    return result_.covers[0].cost + problem_.margin + cost_rounding;
  }

  /// Columns that no cover within the margin has.
  bool drop_dear() {
    for (Index c = 0; c < columns_.size(); ++c) {
      if (state_[c] == ColumnState::Free && bound_ + std::max(reduced_[c], 0.0) > limit()) remove(c);
    }
    return propagate();
  }

  void remove(Index column) {
    if (state_[column] != ColumnState::Free) return;
    state_[column] = ColumnState::Out;
    trail_.push_back(column);
    bound_ -= std::min(reduced_[column], 0.0);
    for (const Index r : columns_[column].rows) {
      --free_[r];
      pending_.push_back(r);
    }
    // Without an edge's first open side there is no second one.
    if (is_open_side(column) && !is_second_open_side(column)) remove(column + 1);
  }

  bool choose(Index column) {
    if (state_[column] == ColumnState::Chosen) return true;
    if (state_[column] == ColumnState::Out) return false;
    if (is_second_open_side(column) && !choose(column - 1)) return false;
    state_[column] = ColumnState::Chosen;
    trail_.push_back(column);
    cost_ += columns_[column].cost;
    bound_ += std::max(reduced_[column], 0.0);
    bool fits = true;
    for (const Index r : columns_[column].rows) {
      --free_[r];
      fits = fits && demand_[r] > 0;
      --demand_[r];
      pending_.push_back(r);
    }
    if (is_open_side(column)) return fits;
    if (fits) remove_overlapping(column);
    return links_.add(face(column), !problem_.partial) && fits;
  }

  void remove_overlapping(Index column) {
    if (face(column).plane == no_index) return;
    for (const Index region : face(column).regions) {
      for (const Index other : in_region_.at({face(column).plane, region})) remove(other);
    }
  }

  /// Draws the conclusions; false when the state fits no cover that is good enough.
  bool propagate() {
    bool fits = bound_ <= limit();
    while (fits && !pending_.empty()) {
      const Index r = pending_.back();
      pending_.pop_back();
      if (demand_[r] < 0 || free_[r] < demand_[r]) {
        fits = false;
      } else if (demand_[r] == 0 && free_[r] > 0) {
        for (const Index c : on_row_[r]) remove(c);
      } else if (demand_[r] > 0 && free_[r] == demand_[r]) {
        for (const Index c : on_row_[r]) fits = fits && (state_[c] != ColumnState::Free || choose(c));
      }
      fits = fits && bound_ <= limit();
    }
    pending_.clear();
    return fits;
  }

  void undo_to(std::size_t length) {
    while (trail_.size() > length) {
      const Index column = trail_.back();
      trail_.pop_back();
      const bool chosen = state_[column] == ColumnState::Chosen;
      state_[column] = ColumnState::Free;
      for (const Index r : columns_[column].rows) {
        ++free_[r];
        demand_[r] += chosen ? 1 : 0;
      }
      if (!chosen) {
        bound_ += std::min(reduced_[column], 0.0);
        continue;
      }
      cost_ -= columns_[column].cost;
      bound_ -= std::max(reduced_[column], 0.0);
      if (!is_open_side(column)) links_.take_back();
    }
  }

  Index row_to_decide() const {
    Index best = no_index;
    for (Index r = 0; r < demand_.size(); ++r) {
      if (demand_[r] > 0 && (best == no_index || free_[r] - demand_[r] < free_[best] - demand_[best])) best = r;
    }
    return best;
  }

  bool done() const { return result_.limited || (dive_ && !result_.covers.empty()); }

  void branch() {
    const Index row = row_to_decide();
    if (row == no_index) {
      record();
      return;
    }
    const std::size_t outer = trail_.size();
    for (const Index column : on_row_[row]) {
      if (state_[column] != ColumnState::Free) continue;
      if (++result_.nodes > (dive_ ? problem_.node_limit / dive_share : problem_.node_limit)) result_.limited = true;
      if (result_.nodes % nodes_per_check == 0) progress_.check();
      if (done()) break;
      const std::size_t inner = trail_.size();
      if (choose(column) && propagate()) branch();
      pending_.clear();
      undo_to(inner);
      remove(column);
      if (!propagate()) break;
      if (demand_[row] == 0 || free_[row] == 0) {  // the conclusions chose for this row: go on with the others
        branch();
        break;
      }
    }
    undo_to(outer);
  }

  void record() {
    Cover cover;
    for (Index c = 0; c < problem_.members.size(); ++c) {
      if (state_[c] != ColumnState::Chosen) continue;
      cover.chosen.push_back(problem_.members[c]);
      cover.deviation = std::max(cover.deviation, face(c).deviation);
    }
    cover.cost = cost_;
    std::vector<Cover>& covers = result_.covers;
    if (std::ranges::any_of(covers, [&](const Cover& c) { return c.chosen == cover.chosen; })) return;
    if (!can_agree(problem_.candidates, cover.chosen)) return;
    covers.push_back(std::move(cover));
    std::ranges::sort(covers, is_better);
    while (covers.size() > problem_.max_covers) covers.pop_back();
    while (covers.back().cost > limit()) covers.pop_back();
  }

  const CoverProblem& problem_;
  Progress& progress_;
  VertexLinks links_;
  std::vector<CoverColumn> columns_;
  std::map<Index, Index> row_of_;
  std::map<std::pair<Index, Index>, std::vector<Index>> in_region_;
  std::vector<std::vector<Index>> on_row_;
  std::vector<ColumnState> state_;
  std::vector<int> demand_, free_;  // sides without a face, and columns that could give one
  std::vector<double> reduced_;
  std::vector<Index> trail_, pending_;
  double cost_ = 0, bound_ = 0;
  bool dive_ = false;
  CoverResult result_;
};

}  // namespace

CoverResult search_covers(const CoverProblem& problem, Progress& progress) {
  return CoverSearch(problem, progress).run();
}

}  // namespace croquis
