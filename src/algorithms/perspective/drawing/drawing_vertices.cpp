// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/perspective/drawing_vertices.h"

#include <algorithm>
#include <map>
#include <ranges>
#include <tuple>
#include <utility>

#include "algorithms/perspective/drawing/end_linkage.h"
#include "algorithms/perspective/stroke_words.h"
#include "croquis/base/limits.h"
#include "croquis/geometry/perspective_drawing.h"

namespace croquis {
namespace {

/// What a stroke looks like, whichever way it was drawn: its control points in the direction whose points come first.
/// Equal for equal strokes only.
struct StrokeLook {
  std::vector<double> points;
  StrokeGroup group = StrokeGroup::Unknown;
  StrokeRole role = StrokeRole::Edge;
  double weight = 1;

  auto operator<=>(const StrokeLook&) const = default;
};

constexpr int samples_per_cubic = 24;

std::vector<PictureCubic> turned_pieces(std::vector<PictureCubic> pieces) {
  std::ranges::reverse(pieces);
  for (PictureCubic& piece : pieces) std::ranges::reverse(piece);
  return pieces;
}

std::vector<double> coordinates_of(const std::vector<PictureCubic>& pieces) {
  std::vector<double> result;
  for (const PictureCubic& piece : pieces) {
    for (const Vec2& point : piece) result.insert(result.end(), {point.x(), point.y()});
  }
  return result;
}

Vec2 point_of(const PictureCubic& p, double t) {
  const double s = 1 - t;
  return s * s * s * p[0] + 3 * s * s * t * p[1] + 3 * s * t * t * p[2] + t * t * t * p[3];
}

/// Polyline of a stroke whose ends are moved.
std::vector<Vec2> samples_of(const std::vector<PictureCubic>& pieces, const Vec2& start, const Vec2& end) {
  std::vector<Vec2> samples{start};
  const Vec2 first = start - pieces.front()[0], last = end - pieces.back()[3];
  const auto count = static_cast<double>(pieces.size() * samples_per_cubic);
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    for (int k = 1; k <= samples_per_cubic; ++k) {
      const double way = static_cast<double>(i * samples_per_cubic + static_cast<std::size_t>(k)) / count;
      const Vec2 shift = (1 - way) * first + way * last;
      samples.emplace_back(point_of(pieces[i], static_cast<double>(k) / samples_per_cubic) + shift);
    }
  }
  return samples;
}

double distance_to(const Vec2& point, const std::vector<Vec2>& line) {
  double best = (point - line[0]).squaredNorm();
  for (std::size_t i = 1; i < line.size(); ++i) {
    const Vec2 step = line[i] - line[i - 1];
    const double square = step.squaredNorm();
    const double t = square > 0 ? std::clamp((point - line[i - 1]).dot(step) / square, 0.0, 1.0) : 0.0;
    best = std::min(best, (point - line[i - 1] - t * step).squaredNorm());
  }
  return std::sqrt(best);
}

StrokeLook look_of(const PerspectiveStroke& stroke) {
  std::vector<double> forwards = coordinates_of(stroke.pieces);
  std::vector<double> backwards = coordinates_of(turned_pieces(stroke.pieces));
  return {std::min(std::move(forwards), std::move(backwards)), stroke.group, stroke.role, stroke.weight};
}

/// Largest distance between two strokes that join the same places, as point sets; the second one's ends are moved onto
/// the first one's. Px. @param turned the second one runs the other way
double distance_between(const PerspectiveStroke& a, const PerspectiveStroke& b, bool turned) {
  const std::vector<Vec2> first = samples_of(a.pieces, a.start(), a.end());
  const std::vector<Vec2> second = samples_of(turned ? turned_pieces(b.pieces) : b.pieces, a.start(), a.end());
  double largest = 0;
  for (const Vec2& point : first) largest = std::max(largest, distance_to(point, second));
  for (const Vec2& point : second) largest = std::max(largest, distance_to(point, first));
  return largest;
}

constexpr double shortest_stroke = 4e-4;     // × diagonal; half a pixel of an ordinary sheet
constexpr double duplicate_distance = 8e-4;  // × diagonal; one pixel of an ordinary sheet

bool has_vertices(const PerspectiveStroke& stroke) { return stroke.role == StrokeRole::Edge || stroke.link; }

bool is_usable(const PerspectiveStroke& stroke) {
  return std::ranges::all_of(
      stroke.pieces, [](const PictureCubic& piece) { return std::ranges::all_of(piece, are_usable_numbers<Vec2>); });
}

/// How far the stroke gets from where it begins or ends.
double reach_of(const PerspectiveStroke& stroke) {
  double reach = 0;
  for (const PictureCubic& piece : stroke.pieces) {
    for (const Vec2& point : piece) {
      reach = std::max({reach, (point - stroke.start()).norm(), (point - stroke.end()).norm()});
    }
  }
  return reach;
}

struct UseSentence {
  const char* code;
  std::string text;
};

UseSentence sentence_of(StrokeUse use) {
  switch (use) {
    case StrokeUse::NotFinite:
      return {"NOT_FINITE",
              std::string(" has a coordinate that ") + unusable_words + ", and is left out: draw it again."};
    case StrokeUse::ZeroLength:
      return {"ZERO_LENGTH", " is no longer than a point and is left out: delete it or draw it longer."};
    case StrokeUse::UnknownGroup:
      return {"UNKNOWN_GROUP",
              " is left out, since it isn't clear along which axis or in which plane it runs: give it a group."};
    default: return {"DUPLICATE_STROKE", " joins the same vertices along the same line as "};
  }
}

class VertexFinder {
 public:
  VertexFinder(const PerspectiveDrawing& drawing, const DrawingVertexOptions& options)
      : drawing_(drawing), options_(options) {}

  DrawingVertices find() {
    result_.uses.assign(drawing_.strokes.size(), StrokeUse::Used);
    result_.of_stroke.assign(drawing_.strokes.size(), {no_index, no_index});
    for (Index i = 0; i < drawing_.strokes.size(); ++i) judge(i);
    collect_ends();
    make_vertices();
    if (leave_out_duplicates()) {
      collect_ends();
      make_vertices();
    }
    warn_of_short_strokes();
    std::stable_sort(result_.warnings.begin(), result_.warnings.end(),
                     [](const Finding& a, const Finding& b) { return a.subjects[0].id < b.subjects[0].id; });
    return std::move(result_);
  }

 private:
  /// A stroke's end, and all that decides where it stands in the order of ends.
  struct End {
    StrokeEnd end;
    Vec2 place;
    const std::string* name;
  };

  const PerspectiveStroke& stroke(Index i) const { return drawing_.strokes[i]; }

  void leave_out(Index i, StrokeUse use) {
    const UseSentence sentence = sentence_of(use);
    result_.uses[i] = use;
    result_.warnings.push_back(make_warning(Category::Geometry, sentence.code, "Stroke " + stroke(i).id + sentence.text,
                                            {stroke_subject(drawing_, i)}));
  }

  void judge(Index i) {
    if (!is_usable(stroke(i))) {
      leave_out(i, StrokeUse::NotFinite);
    } else if (reach_of(stroke(i)) < shortest_stroke * drawing_.diagonal()) {
      leave_out(i, StrokeUse::ZeroLength);
    } else if (stroke(i).group == StrokeGroup::Unknown) {
      leave_out(i, StrokeUse::UnknownGroup);
    }
  }

  /// By geometry; ids only distinguish what looks the same.
  void collect_ends() {
    std::vector<Index> strokes;
    for (Index i = 0; i < drawing_.strokes.size(); ++i) {
      if (result_.is_used(i) && has_vertices(stroke(i))) strokes.push_back(i);
    }
    std::vector<StrokeLook> looks(drawing_.strokes.size());
    for (const Index i : strokes) looks[i] = look_of(stroke(i));
    ends_.clear();
    for (const Index i : strokes) {
      ends_.push_back({{i, false}, stroke(i).start(), &stroke(i).from});
      ends_.push_back({{i, true}, stroke(i).end(), &stroke(i).to});
    }
    std::sort(ends_.begin(), ends_.end(), [&](const End& a, const End& b) {
      if (a.place != b.place) return std::pair(a.place.y(), a.place.x()) < std::pair(b.place.y(), b.place.x());
      const StrokeLook &la = looks[a.end.stroke], &lb = looks[b.end.stroke];
      if (la != lb) return la < lb;
      return std::tie(stroke(a.end.stroke).id, a.end.at_end) < std::tie(stroke(b.end.stroke).id, b.end.at_end);
    });
  }

  void make_vertices() {
    std::map<std::string, Index> names;
    std::vector<LinkagePoint> points;
    for (const End& end : ends_) {
      LinkagePoint point{end.place, end.end.stroke, no_index};
      if (!end.name->empty())
        point.group = names.try_emplace(*end.name, static_cast<Index>(names.size())).first->second;
      points.push_back(point);
    }
    const std::vector<Index> numbers = link_nearest(points, options_.snap * drawing_.diagonal());
    result_.vertices.clear();
    for (std::size_t i = 0; i < ends_.size(); ++i) {
      if (numbers[i] == result_.vertices.size()) result_.vertices.emplace_back();
      DrawingVertex& vertex = result_.vertices[numbers[i]];
      vertex.position += ends_[i].place;
      vertex.ends.push_back(ends_[i].end);
      if (vertex.name.empty()) vertex.name = *ends_[i].name;
      result_.of_stroke[ends_[i].end.stroke][ends_[i].end.at_end ? 1 : 0] = numbers[i];
    }
    for (DrawingVertex& vertex : result_.vertices) vertex.position /= static_cast<double>(vertex.ends.size());
  }

  /// True when the first one is the one to keep: it says more of its direction, weighs more, comes first.
  bool is_better(Index a, Index b) const {
    const auto rank = [&](Index i) { return std::pair(is_parallel(stroke(i).group) ? 0 : 1, -stroke(i).weight); };
    if (rank(a) != rank(b)) return rank(a) < rank(b);
    const StrokeLook look_a = look_of(stroke(a)), look_b = look_of(stroke(b));
    return look_a != look_b ? look_a < look_b : stroke(a).id < stroke(b).id;
  }

  bool are_alike(Index a, Index b) const {
    if (stroke(a).straight && stroke(b).straight) return true;
    const bool turned = result_.of_stroke[a] != result_.of_stroke[b];
    return distance_between(stroke(a), stroke(b), turned) <= duplicate_distance * drawing_.diagonal();
  }

  bool leave_out_duplicates() {
    std::map<std::pair<Index, Index>, std::vector<Index>> edges;
    for (Index i = 0; i < drawing_.strokes.size(); ++i) {
      if (!result_.is_used(i) || stroke(i).role != StrokeRole::Edge) continue;
      const auto [from, to] = result_.of_stroke[i];
      edges[std::minmax({from, to})].push_back(i);
    }
    bool found = false;
    for (auto& [vertices, between] : edges) {
      std::sort(between.begin(), between.end(), [&](Index a, Index b) { return is_better(a, b); });
      for (std::size_t i = 1; i < between.size(); ++i) {
        const auto kept = std::find_if(between.begin(), between.begin() + static_cast<std::ptrdiff_t>(i),
                                       [&](Index k) { return result_.is_used(k) && are_alike(k, between[i]); });
        if (kept == between.begin() + static_cast<std::ptrdiff_t>(i)) continue;
        leave_out(between[i], StrokeUse::Duplicate);
        result_.warnings.back().message += stroke(*kept).id + " and is left out: delete one of the two.";
        result_.warnings.back().subjects.push_back(stroke_subject(drawing_, *kept));
        result_.of_stroke[between[i]] = {no_index, no_index};
        found = true;
      }
    }
    return found;
  }

  /// Where a stroke's own ends are near enough to be one corner, all ends around may be at the wrong one.
  void warn_of_short_strokes() {
    std::vector<Index> strokes;
    for (Index i = 0; i < drawing_.strokes.size(); ++i) {
      const auto [from, to] = result_.of_stroke[i];
      if (from == no_index || to == no_index) continue;
      const DrawingVertex &a = result_.vertices[from], &b = result_.vertices[to];
      const bool named = !a.name.empty() && !b.name.empty();
      if (!named && (a.position - b.position).norm() < options_.snap * drawing_.diagonal()) strokes.push_back(i);
    }
    if (strokes.empty()) return;
    result_.warnings.push_back(make_warning(
        Category::Geometry, "SHORT_STROKE",
        "The two ends of " + stroke_names(drawing_, strokes) +
            " are so near to each other that ends around them may be joined to the wrong one: draw larger, or name "
            "the ends.",
        stroke_subjects(drawing_, strokes)));
  }

  const PerspectiveDrawing& drawing_;
  const DrawingVertexOptions& options_;
  DrawingVertices result_;
  std::vector<End> ends_;  // in an order that doesn't depend on that of the strokes
};

}  // namespace

DrawingVertices find_drawing_vertices(const PerspectiveDrawing& drawing, const DrawingVertexOptions& options) {
  return VertexFinder(drawing, options).find();
}

}  // namespace croquis
