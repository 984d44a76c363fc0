// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/attribute_surface/network/loop_curves.h"

#include <optional>
#include <utility>

#include "croquis/attribute_surface/curve_edit.h"
#include "croquis/base/stage_key.h"
#include "croquis/base/text.h"
#include "croquis/geometry/disjoint_sets.h"

namespace croquis {
namespace {

/// Ends of curves by number: 2 × curve, + 1 for the end.
Index end_number(Index curve, bool end) { return 2 * curve + (end ? 1 : 0); }

Vec3 drawn_end(const AttributeNetwork& network, Index number) {
  const std::vector<Vec3> control = control_polygon(network, network.curves[number / 2]);
  return number % 2 == 0 ? control.front() : control.back();
}

Index node_of(const AttributeNetwork& network, Index number) {
  const AttributeCurve& curve = network.curves[number / 2];
  return number % 2 == 0 ? curve.from : curve.to;
}

/// Which ends are one corner: those of one node, and those that follow each other in a loop within the tolerance.
class Corners {
 public:
  Corners(const AttributeNetwork& network, double tolerance)
      : network_(network),
        tolerance_(tolerance),
        end_count_(2 * static_cast<Index>(network.curves.size())),
        sets_(end_count_ + network.nodes.size()) {
    for (Index end = 0; end < end_count_; ++end) {
      const Index node = node_of(network, end);
      if (node != no_index) sets_.unite(end, end_count_ + node);
    }
    for (const AttributeFace& face : network.faces) join_loop(face.loop);
  }

  /// Numbers from 0 in the order of the ends.
  std::size_t number_of(Index end) {
    const Index root = sets_.root(end);
    if (numbers_.empty()) numbers_.resize(end_count_ + network_.nodes.size(), none);
    if (numbers_[root] == none) numbers_[root] = count_++;
    return numbers_[root];
  }
  std::size_t count() const { return count_; }

  /// Where the ends of that corner belong: its first node, else its first end.
  const Vec3& place_of(Index end) {
    if (places_.empty()) find_places();
    return *places_[sets_.root(end)];
  }

 private:
  static constexpr std::size_t none = ~std::size_t{0};

  void join_loop(const std::vector<AttributeSide>& loop) {
    for (std::size_t i = 0; i < loop.size() && loop.size() > 1; ++i) {
      const AttributeSide& next = loop[(i + 1) % loop.size()];
      const Index end = end_number(loop[i].curve, !loop[i].reversed);
      const Index start = end_number(next.curve, next.reversed);
      if ((place_as_drawn(end) - place_as_drawn(start)).norm() <= tolerance_) sets_.unite(end, start);
    }
  }

  Vec3 place_as_drawn(Index end) const {
    const Index node = node_of(network_, end);
    return node != no_index ? network_.nodes[node].point : drawn_end(network_, end);
  }

  void find_places() {
    places_.resize(end_count_ + network_.nodes.size());
    for (Index node = 0; node < network_.nodes.size(); ++node) {
      auto& place = places_[sets_.root(end_count_ + node)];
      if (!place) place = network_.nodes[node].point;
    }
    for (Index end = 0; end < end_count_; ++end) {
      auto& place = places_[sets_.root(end)];
      if (!place) place = drawn_end(network_, end);
    }
  }

  const AttributeNetwork& network_;
  double tolerance_;
  Index end_count_;  ///< ends come first in the sets, then nodes
  DisjointSets sets_;
  std::vector<std::size_t> numbers_;
  std::vector<std::optional<Vec3>> places_;
  std::size_t count_ = 0;
};

/// One curve with what is to be said about it.
class MetCurve {
 public:
  MetCurve(const AttributeNetwork& network, double tolerance, Findings& findings)
      : network_(network), tolerance_(tolerance), findings_(findings) {}

  /// Null: it failed.
  std::shared_ptr<const ArcLengthCurve> make(Index index, const Vec3& start, const Vec3& end, StageCache* cache) {
    const AttributeCurve& curve = network_.curves[index];
    std::vector<Vec3> control = control_polygon(network_, curve);
    const double start_gap = (control.front() - start).norm();
    const double end_gap = (control.back() - end).norm();
    if (start_gap > tolerance_) report_gap(curve, "start", start_gap);
    if (end_gap > tolerance_) report_gap(curve, "end", end_gap);
    if (start_gap > tolerance_ || end_gap > tolerance_) return nullptr;
    if (start_gap > 0) report_snap(curve, "start", start_gap);
    if (end_gap > 0) report_snap(curve, "end", end_gap);
    control = with_ends_moved(std::move(control), start, end);
    const double length = bezier_length(control);
    if (length <= tolerance_) {
      report_length(curve, length);
      return nullptr;
    }
    StageKey key;
    key.add(control);
    return cached<ArcLengthCurve>(
        cache, "attribute surface curve", key, [&] { return ArcLengthCurve(control); },
        [](const ArcLengthCurve& made) { return made.byte_size(); });
  }

 private:
  void report_gap(const AttributeCurve& curve, const char* which, double gap) {
    findings_.push_back(make_error(Category::Geometry, "E_GAP",
                                   "The " + std::string(which) + " of curve " + quoted(curve.id) + " is " +
                                       length_text(network_, gap) + " away from its node, more than the tolerance of " +
                                       length_text(network_, tolerance_) + ": move it there, or raise the tolerance.",
                                   {subject_of(SubjectKind::Curve, curve.id)}));
  }

  void report_snap(const AttributeCurve& curve, const char* which, double gap) {
    findings_.push_back(make_warning(Category::Geometry, "W_SNAP",
                                     "The " + std::string(which) + " of curve " + quoted(curve.id) + " was moved by " +
                                         length_text(network_, gap) + " to where it meets the others.",
                                     {subject_of(SubjectKind::Curve, curve.id)}));
  }

  void report_length(const AttributeCurve& curve, double length) {
    findings_.push_back(make_error(Category::Geometry, "E_ZERO_LENGTH",
                                   "Curve " + quoted(curve.id) + " is only " + length_text(network_, length) +
                                       " long, not more than the tolerance: delete it, or move its ends apart.",
                                   {subject_of(SubjectKind::Curve, curve.id)}));
  }

  const AttributeNetwork& network_;
  double tolerance_;
  Findings& findings_;
};

}  // namespace

std::string quoted(const std::string& id) { return '"' + id + '"'; }

std::string rounded_text(double number) { return number_text(number, 4); }

std::string length_text(const AttributeNetwork& network, double length) {
  return rounded_text(length) + (network.units.empty() ? "" : " " + network.units);
}

Subject subject_of(SubjectKind kind, const std::string& id) {
  Subject subject;
  subject.kind = kind;
  subject.id = id;
  return subject;
}

std::vector<Vec3> with_ends_moved(std::vector<Vec3> control, const Vec3& start, const Vec3& end) {
  const Vec3 start_move = start - control.front();
  const Vec3 end_move = end - control.back();
  control = with_ends_moved_by(std::move(control), start_move, end_move);
  control.front() = start;
  control.back() = end;
  return control;
}

LoopCurves meet_ends(const AttributeNetwork& network, double tolerance, StageCache* cache, Findings& findings) {
  Corners corners(network, tolerance);
  MetCurve met(network, tolerance, findings);
  LoopCurves result;
  for (Index i = 0; i < network.curves.size(); ++i) {
    const Index start = end_number(i, false);
    const Index end = end_number(i, true);
    result.curves.push_back({met.make(i, corners.place_of(start), corners.place_of(end), cache),
                             {corners.number_of(start), corners.number_of(end)}});
  }
  result.corners = corners.count();
  return result;
}

}  // namespace croquis
