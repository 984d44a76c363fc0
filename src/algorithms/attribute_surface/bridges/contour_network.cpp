// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/attribute_surface/contour_network.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "algorithms/attribute_surface/bridges/chain_curves.h"
#include "croquis/base/error.h"
#include "croquis/geometry/bezier_fit.h"
#include "croquis/geometry/bounds.h"
#include "croquis/geometry/disjoint_sets.h"
#include "croquis/geometry/drawing.h"
#include "croquis/geometry/polyline.h"

namespace croquis {
namespace {

/// A stroke by its arc length, samples at one place taken once.
class StrokePath {
 public:
  explicit StrokePath(const Stroke& stroke);

  bool closed() const { return closed_; }
  double length() const { return lengths_.back(); }
  const std::vector<Vec2>& points() const { return points_; }

  /// The place at an arc length; of closed paths any, of open ones cut to 0..length().
  Vec2 at(double length) const;

  /// Arc lengths of places where the path turns by more than `angle` between what comes `reach` before and after.
  std::vector<double> corners(double angle, double reach) const;

  /// The points from one arc length to another, both included; from >= to runs on over the beginning of a closed path.
  std::vector<Vec2> part(double from, double to) const;

  struct Nearest {
    double length = 0;    ///< arc length
    double distance = 0;  ///< sketch units; infinite where all is shut out
  };

  /// The nearest place that isn't within `shut` of arc length around `around` (shut 0: none is shut out).
  Nearest nearest(const Vec2& point, double around = 0, double shut = 0) const;

 private:
  std::size_t segments() const { return lengths_.size() - 1; }
  const Vec2& end_of(std::size_t segment) const { return points_[(segment + 1) % points_.size()]; }
  double wrapped(double length) const;
  double along(double a, double b) const;  ///< the shorter way between two arc lengths

  std::vector<Vec2> points_;
  std::vector<double> lengths_;  ///< arc length at the beginning of each segment, and the whole
  bool closed_;
};

StrokePath::StrokePath(const Stroke& stroke) : closed_(stroke.closed) {
  for (const StrokeSample& sample : stroke.samples) {
    if (points_.empty() || sample.position != points_.back()) points_.push_back(sample.position);
  }
  while (closed_ && points_.size() > 1 && points_.back() == points_.front()) points_.pop_back();
  closed_ = closed_ && points_.size() > 2;
  lengths_ = arc_lengths(points_, closed_);
}

double StrokePath::wrapped(double length) const {
  if (!closed_) return std::clamp(length, 0.0, this->length());
  const double turns = std::floor(length / this->length());
  return std::clamp(length - turns * this->length(), 0.0, this->length());
}

double StrokePath::along(double a, double b) const {
  const double straight = std::abs(a - b);
  return closed_ ? std::min(straight, length() - straight) : straight;
}

Vec2 StrokePath::at(double length) const {
  const double s = wrapped(length);
  const auto after = std::upper_bound(lengths_.begin(), lengths_.end() - 1, s);
  const auto k = std::min<std::size_t>(static_cast<std::size_t>(after - lengths_.begin()) - 1, segments() - 1);
  const double span = lengths_[k + 1] - lengths_[k];
  const double t = span > 0 ? (s - lengths_[k]) / span : 0;
  if (t <= 0) return points_[k];
  return t >= 1 ? end_of(k) : Vec2(points_[k] + t * (end_of(k) - points_[k]));
}

std::vector<double> StrokePath::corners(double angle, double reach) const {
  std::vector<std::pair<double, double>> turns;  // less the angle, so that sorting puts the sharpest first
  for (std::size_t i = closed_ ? 0 : 1; i + (closed_ ? 0 : 1) < points_.size(); ++i) {
    const double s = lengths_[i];
    const Vec2 arriving = points_[i] - at(s - reach), leaving = at(s + reach) - points_[i];
    const double turn = std::abs(std::atan2(cross(arriving, leaving), arriving.dot(leaving)));
    if (turn > angle) turns.emplace_back(-turn, s);
  }
  std::ranges::sort(turns);
  std::vector<double> found;
  for (const auto& [turn, s] : turns) {
    const auto near = [&, at = s](double other) { return along(other, at) < reach; };
    const bool at_end = !closed_ && (s < reach || length() - s < reach);
    if (!at_end && std::ranges::none_of(found, near)) found.push_back(s);
  }
  std::ranges::sort(found);
  return found;
}

std::vector<Vec2> StrokePath::part(double from, double to) const {
  const double end = to > from ? to : to + length();
  std::vector<Vec2> result{at(from)};
  const auto add = [&](const Vec2& point) {
    if (point != result.back()) result.push_back(point);
  };
  for (const double turn : {0.0, length()}) {
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const double s = lengths_[i] + turn;
      if (s > from && s < end) add(points_[i]);
    }
  }
  add(at(to));
  return result;
}

StrokePath::Nearest StrokePath::nearest(const Vec2& point, double around, double shut) const {
  Nearest best{0, std::numeric_limits<double>::infinity()};
  for (std::size_t k = 0; k < segments(); ++k) {
    const double t = nearest_parameter(point, points_[k], end_of(k));
    const double s = lengths_[k] + t * (lengths_[k + 1] - lengths_[k]);
    const double distance = (points_[k] + t * (end_of(k) - points_[k]) - point).norm();
    if (distance < best.distance && (shut <= 0 || along(s, around) > shut)) best = {s, distance};
  }
  return best;
}

constexpr double corner_reach = 4;  // × tolerance: arc length over which a turn counts as one corner
constexpr double least_return = 3;  // × join: strokes so short don't close in themselves
constexpr std::size_t closed_parts = 4;
constexpr std::size_t direction_samples = 16;  // reach of a direction at a smooth cut: length of the path / this

/// A place where a stroke is cut.
struct StrokeCut {
  std::size_t path = 0;
  double length = 0;  ///< arc length
  Vec2 place = Vec2::Zero();
  bool is_end = false;
};

/// Finds where strokes are cut and which cuts are one node.
class CutFinder {
 public:
  CutFinder(const std::vector<StrokePath>& paths, double join) : paths_(paths), join_(join) {}

  void add_ends_and_corners(double angle, double reach) {
    for (std::size_t p = 0; p < paths_.size(); ++p) {
      const StrokePath& path = paths_[p];
      if (!path.closed()) add(p, 0, true);
      for (const double s : path.corners(angle, reach)) add(p, s, false);
      if (!path.closed()) add(p, path.length(), true);
    }
  }

  void join_cuts() {
    for (std::size_t a = 0; a < cuts_.size(); ++a) {
      for (std::size_t b = a + 1; b < cuts_.size(); ++b) {
        if (may_join(cuts_[a], cuts_[b])) joined_.push_back({a, b});
      }
    }
  }

  /// Ends that met no corner may lie on a stroke that isn't among those they met.
  void join_ends_to_strokes(Progress& progress) {
    const std::vector<Index> node_of = nodes().first;
    std::map<Index, std::set<std::size_t>> met;  // paths, by node
    std::set<Index> fixed;                       // nodes that are at corners
    for (std::size_t c = 0; c < cuts_.size(); ++c) {
      met[node_of[c]].insert(cuts_[c].path);
      if (!cuts_[c].is_end) fixed.insert(node_of[c]);
    }
    for (std::size_t c = 0; c < node_of.size(); ++c) {
      progress.check();
      if (cuts_[c].is_end && !fixed.contains(node_of[c])) join_end_to_stroke(c, met[node_of[c]]);
    }
  }

  std::vector<StrokeCut> take_cuts() { return std::move(cuts_); }

  /// Per cut the number of its node, and where the nodes are.
  std::pair<std::vector<Index>, std::vector<Vec2>> nodes() const {
    DisjointSets sets(cuts_.size());
    for (const auto& [a, b] : joined_) sets.unite(static_cast<Index>(a), static_cast<Index>(b));
    std::vector<Index> node_of;
    const Index count = sets.number(node_of);
    std::vector<Vec2> ends(count, Vec2::Zero()), others = ends;
    std::vector<double> end_count(count, 0), other_count = end_count;
    for (std::size_t c = 0; c < cuts_.size(); ++c) {
      const Index node = node_of[c];
      (cuts_[c].is_end ? ends : others)[node] += cuts_[c].place;
      (cuts_[c].is_end ? end_count : other_count)[node] += 1;
    }
    for (Index node = 0; node < count; ++node)
      ends[node] = other_count[node] > 0 ? Vec2(others[node] / other_count[node]) : Vec2(ends[node] / end_count[node]);
    return {std::move(node_of), std::move(ends)};
  }

 private:
  void add(std::size_t path, double length, bool is_end) {
    cuts_.push_back({path, length, paths_[path].at(length), is_end});
  }

  bool may_join(const StrokeCut& a, const StrokeCut& b) const {
    if (!a.is_end && !b.is_end) return false;
    if ((a.place - b.place).norm() > join_) return false;
    return a.path != b.path || std::abs(a.length - b.length) > least_return * join_;
  }

  /// @param met paths that the end shares a node with, its own among them
  void join_end_to_stroke(std::size_t end, const std::set<std::size_t>& met) {
    const StrokeCut cut = cuts_[end];
    StrokePath::Nearest best{0, join_};
    std::size_t on = paths_.size();
    for (std::size_t p = 0; p < paths_.size(); ++p) {
      const bool own = p == cut.path;
      if (met.contains(p) && !(own && met.size() == 1)) continue;
      const auto near = paths_[p].nearest(cut.place, own ? cut.length : 0, own ? least_return * join_ : 0);
      if (near.distance > best.distance || (on < paths_.size() && near.distance == best.distance)) continue;
      best = near;
      on = p;
    }
    if (on == paths_.size()) return;
    const Vec2 place = paths_[on].at(best.length);
    for (std::size_t c = 0; c < cuts_.size(); ++c) {  // another end may have cut it there already
      if (c != end && cuts_[c].path == on && (cuts_[c].place - place).norm() <= join_)
        return joined_.push_back({c, end});
    }
    joined_.push_back({end, cuts_.size()});
    add(on, best.length, false);
  }

  const std::vector<StrokePath>& paths_;
  double join_;
  std::vector<StrokeCut> cuts_;
  std::vector<std::pair<std::size_t, std::size_t>> joined_;
};

Vec3 on_sheet(const Vec2& place) { return {place.x(), place.y(), 0}; }

/// Ends moved to the nodes, the rest by what arc length leaves of that.
std::vector<Vec3> moved_row(const std::vector<Vec2>& row, const Vec2& from, const Vec2& to) {
  std::vector<double> lengths{0};
  for (std::size_t i = 1; i < row.size(); ++i) lengths.push_back(lengths.back() + (row[i] - row[i - 1]).norm());
  const Vec2 at_start = from - row.front(), at_end = to - row.back();
  std::vector<Vec3> moved{on_sheet(from)};
  for (std::size_t i = 1; i < row.size(); ++i) {
    const double t = lengths[i] / lengths.back();
    const Vec2 place = i + 1 == row.size() ? to : Vec2(row[i] + (1 - t) * at_start + t * at_end);
    const Vec3 point = on_sheet(place);
    if (point != moved.back()) moved.push_back(point);
  }
  return moved;
}

class ContourNetworkMaker {
 public:
  ContourNetworkMaker(const Drawing& drawing, const ContourNetworkOptions& options, Progress& progress)
      : drawing_(drawing), options_(options), progress_(progress) {
    const BoundingBox box = bounds_of(drawing);
    diagonal_ = box ? ((*box)[1] - (*box)[0]).norm() : 0;
  }

  ContourNetwork run() {
    take_strokes();
    const double tolerance = options_.tolerance * diagonal_;
    CutFinder finder(paths_, options_.join * diagonal_);
    finder.add_ends_and_corners(options_.corner, corner_reach * tolerance);
    finder.join_cuts();
    finder.join_ends_to_strokes(progress_);
    std::vector<Vec2> places;
    std::tie(node_of_, places) = finder.nodes();
    cuts_ = finder.take_cuts();
    ChainCurves curves(result_.network, tolerance);
    for (const Vec2& place : places) curves.add_node(on_sheet(place));
    for (std::size_t p = 0; p < paths_.size(); ++p) {
      progress_.check();
      add_curves(p, curves);
    }
    move_to_plane();
    result_.network.name = drawing_.file;
    progress_.report(1);
    return std::move(result_);
  }

 private:
  void take_strokes() {
    for (std::size_t s = 0; s < drawing_.strokes.size(); ++s) {
      StrokePath path(drawing_.strokes[s]);
      if (path.points().size() > 1 && path.length() > options_.tolerance * diagonal_) {
        paths_.push_back(std::move(path));
        names_.push_back(drawing_.strokes[s].id);
      } else {
        leave_out(drawing_.strokes[s]);
      }
    }
    if (!paths_.empty()) return;
    Findings findings{make_error(Category::Geometry, "E_NO_STROKES",
                                 "The drawing has no stroke that is long enough to become a curve.")};
    findings.insert(findings.end(), result_.warnings.begin(), result_.warnings.end());
    throw Error(std::move(findings));
  }

  void leave_out(const Stroke& stroke) {
    const std::optional<std::string> file =
        drawing_.file.empty() ? std::nullopt : std::optional<std::string>(drawing_.file);
    result_.warnings.push_back(
        make_warning(Category::Geometry, "STROKE_LEFT_OUT",
                     "Stroke " + stroke.id +
                         " is left out: it is no longer than the tolerance of curves; draw it longer, or delete it.",
                     {{SubjectKind::Stroke, stroke.id, file, stroke.line, {}}}));
  }

  /// Where a path is cut: arc length and node, ascending.
  std::vector<std::pair<double, Index>> cuts_of(std::size_t path) const {
    std::vector<std::pair<double, Index>> cuts;
    for (std::size_t c = 0; c < cuts_.size(); ++c) {
      if (cuts_[c].path == path) cuts.emplace_back(cuts_[c].length, node_of_[c]);
    }
    std::ranges::sort(cuts);
    return cuts;
  }

  void add_curves(std::size_t p, ChainCurves& curves) {
    const StrokePath& path = paths_[p];
    std::vector<std::pair<double, Index>> cuts = cuts_of(p);
    if (cuts.empty()) return add_round(p, {0, 0, no_index, no_index}, curves);
    if (path.closed()) cuts.push_back({cuts.front().first + path.length(), cuts.front().second});
    const std::size_t parts = cuts.size() - 1;
    for (std::size_t k = 0; k < parts; ++k) {
      Part part{cuts[k].first, cuts[k + 1].first, cuts[k].second, cuts[k + 1].second, {}};
      if (parts > 1) part.suffix = "/" + std::to_string(k + 1);
      const bool is_round = part.from == part.to;
      if (is_round && part.end - part.begin <= least_return * options_.join * diagonal_) continue;  // within its node
      is_round ? add_round(p, part, curves) : add_part(p, part, curves);
    }
  }

  struct Part {
    double begin = 0;  ///< arc length of the path
    double end = 0;
    Index from = no_index;
    Index to = no_index;
    std::string suffix = {};
    std::optional<Vec3> leaving = {};
    std::optional<Vec3> arriving = {};
  };

  /// A part that ends where it began, in no node or in one: cut into smooth parts.
  void add_round(std::size_t p, Part whole, ChainCurves& curves) {
    const StrokePath& path = paths_[p];
    const bool is_free = whole.from == no_index;
    if (is_free) whole.end = path.length();
    const double step = (whole.end - whole.begin) / static_cast<double>(closed_parts);
    std::vector<Index> nodes;
    std::vector<std::optional<Vec3>> directions;
    for (std::size_t k = 0; k < closed_parts; ++k) {
      const double at = whole.begin + static_cast<double>(k) * step;
      const bool is_smooth = k > 0 || is_free;
      nodes.push_back(is_smooth ? curves.add_node(on_sheet(path.at(at))) : whole.from);
      directions.push_back(is_smooth ? direction_at(path, at) : std::nullopt);
    }
    for (std::size_t k = 0; k < closed_parts; ++k) {
      const std::size_t next = (k + 1) % closed_parts;
      const double begin = whole.begin + static_cast<double>(k) * step;
      add_part(p,
               {begin, begin + step, nodes[k], nodes[next], whole.suffix + "/" + std::to_string(k + 1), directions[k],
                directions[next]},
               curves);
    }
  }

  static std::optional<Vec3> direction_at(const StrokePath& path, double at) {
    const double reach = path.length() / direction_samples;
    const Vec2 before = path.at(at - reach), here = path.at(at), after = path.at(at + reach);
    const std::array<Vec3, 3> row{on_sheet(before), on_sheet(here), on_sheet(after)};
    const Vec3 direction = row_direction(row, 1, reach);
    return direction == Vec3::Zero() ? std::nullopt : std::optional(direction);
  }

  /// Nodes lie on the sheet until all is moved to the plane.
  Vec2 place_of(Index node) const { return result_.network.nodes[node].point.head<2>(); }

  void add_part(std::size_t p, const Part& part, ChainCurves& curves) {
    const std::vector<Vec2> row = paths_[p].part(part.begin, part.end);
    CurveChain chain{names_[p] + part.suffix, part.from, part.to, {}, part.leaving, part.arriving};
    chain.points = moved_row(row, place_of(part.from), place_of(part.to));
    if (chain.points.size() > 1) curves.add(chain);
  }

  void move_to_plane() {
    const DrawingPlane& plane = drawing_.plane;
    const auto to_space = [&](const Vec3& p) { return Vec3(plane.origin + p.x() * plane.u + p.y() * plane.v); };
    for (AttributeNode& node : result_.network.nodes) node.point = to_space(node.point);
    for (AttributeCurve& curve : result_.network.curves) {
      for (Vec3& point : curve.control) point = to_space(point);
    }
  }

  const Drawing& drawing_;
  const ContourNetworkOptions& options_;
  Progress& progress_;
  double diagonal_ = 0;
  ContourNetwork result_;
  std::vector<StrokePath> paths_;
  std::vector<std::string> names_;  ///< per path
  std::vector<StrokeCut> cuts_;
  std::vector<Index> node_of_;  ///< per cut
};

}  // namespace

ContourNetwork network_of_contours(const Drawing& drawing, const ContourNetworkOptions& options, Progress& progress) {
  return ContourNetworkMaker(drawing, options, progress).run();
}

}  // namespace croquis
