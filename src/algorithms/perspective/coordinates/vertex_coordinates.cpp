// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/perspective/vertex_coordinates.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <set>
#include <vector>

#include <Eigen/Geometry>

#include "algorithms/perspective/camera/sheet_frame.h"
#include "algorithms/perspective/coordinates/contradiction_search.h"
#include "algorithms/perspective/coordinates/plane_merging.h"
#include "algorithms/perspective/curves/rational_lift.h"
#include "algorithms/perspective/stroke_words.h"

namespace croquis {
namespace {

/// From coordinates relative to the eye, each component with a scale of its own, to the world.
struct Placement {
  std::vector<double> scale;  ///< model units, of each component
  Vec3 eye = Vec3::Zero();    ///< model units
  Findings warnings;          ///< LENGTH_UNUSED
};

/// Of the eye from the known point, or from the origin, where no length is known. Model units.
constexpr double usual_distance = 10;

std::optional<double> lifted_length(const PerspectiveDrawing& drawing, const DrawingVertices& vertices,
                                    const Camera& camera, const SolvedVertices& solved, Index stroke) {
  const auto [start, end] = vertices.of_stroke[stroke];
  if (start == no_index || end == no_index || solved.table.component[start] != solved.table.component[end])
    return std::nullopt;
  const PerspectiveStroke& drawn = drawing.strokes[stroke];
  const auto pieces = lifted_stroke(drawn, drawn.group, solved.solution.position(solved.table, start),
                                    solved.solution.position(solved.table, end), camera);
  if (!pieces) return std::nullopt;
  double sum = 0;
  for (const auto& parts : *pieces) {
    for (const RationalCubic& part : parts) sum += arc_length(part);
  }
  return sum;
}

/// The scale of each component, 0 where nothing is known: least squares for pieces with several lengths.
std::vector<double> known_scales(const PerspectiveDrawing& drawing, const DrawingVertices& vertices,
                                 const Camera& camera, const SolvedVertices& solved, Findings& warnings) {
  std::vector<double> products(solved.table.components, 0), squares = products, scales = products;
  for (const KnownLength& known : drawing.known_lengths) {
    const auto found = std::ranges::find(drawing.strokes, known.stroke, &PerspectiveStroke::id);
    const auto stroke = static_cast<Index>(found - drawing.strokes.begin());
    const std::optional<double> length =
        found == drawing.strokes.end() ? std::nullopt : lifted_length(drawing, vertices, camera, solved, stroke);
    if (!length || !(*length > 0) || !(known.length > 0)) {
      warnings.push_back(
          make_warning(Category::Geometry, "LENGTH_UNUSED",
                       "The known length of stroke " + known.stroke +
                           " can't be used: give the length, more than 0, of an edge that is tied to the others.",
                       {{SubjectKind::Stroke, known.stroke, {}, {}, {}}}));
      continue;
    }
    const Index component = solved.table.component[vertices.of_stroke[stroke][0]];
    products[component] += *length * known.length;
    squares[component] += *length * *length;
  }
  for (Index c = 0; c < scales.size(); ++c) scales[c] = squares[c] > 0 ? products[c] / squares[c] : 0;
  return scales;
}

/// The vertex at the known point, else the one of the largest component that is nearest to the eye.
Index origin_vertex(const PerspectiveDrawing& drawing, const DrawingVertices& vertices, const SolvedVertices& solved,
                    Index largest) {
  Index best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (Index v = 0; v < vertices.vertices.size(); ++v) {
    if (!drawing.known_point && solved.table.component[v] != largest) continue;
    const double distance = drawing.known_point ? (vertices.vertices[v].position - drawing.known_point->at).norm()
                                                : solved.solution.position(solved.table, v).norm();
    if (distance >= least) continue;
    least = distance;
    best = v;
  }
  return best;
}

Placement placement(const PerspectiveDrawing& drawing, const DrawingVertices& vertices, const CameraEstimate& camera,
                    const SolvedVertices& solved, Index largest) {
  Placement result;
  const std::vector<double> known = known_scales(drawing, vertices, camera.camera, solved, result.warnings);
  const Index origin = origin_vertex(drawing, vertices, solved, largest);
  const Vec3 seen = solved.solution.position(solved.table, origin);
  // Pieces without a length of their own are thought as far away as the largest one.
  double common = known[largest];
  if (!(common > 0)) common = *std::ranges::max_element(known);
  if (!(common > 0)) common = usual_distance / seen.norm();
  for (const double scale : known) result.scale.push_back(scale > 0 ? scale : common);
  const Vec3 point = drawing.known_point ? drawing.known_point->point : Vec3(Vec3::Zero());
  result.eye = point - result.scale[solved.table.component[origin]] * seen;
  return result;
}

/// Drawings are never judged as more exact than this, u.
constexpr double least_sigma = 0.15;

class CoordinateSolve {
 public:
  CoordinateSolve(const PerspectiveDrawing& drawing, const DrawingVertices& vertices, const CameraEstimate& camera,
                  std::span<const StrokeGroup> groups, const CoordinateOptions& options)
      : drawing_(drawing),
        vertices_(vertices),
        camera_(camera),
        options_(options),
        unit_(SheetFrame(drawing).unit),
        tied_(tied_vertices(drawing, vertices, camera, groups)) {}

  VertexCoordinates run(std::span<const PromotedStroke> promoted, Progress& progress) {
    std::vector<StrokeGroup> drawn = tied_.ties.groups;
    for (const PromotedStroke& stroke : promoted) drawn[stroke.stroke] = drawing_.strokes[stroke.stroke].group;
    const double sigma = camera_.sigma / unit_;
    result_.contradictions = resolve_contradictions(tied_, drawn, sigma, drawing_, vertices_, options_, progress);
    progress.report(0.5);
    solved_ = solved(tied_);
    if (options_.merge_planes) result_.merged = merge_planes(tied_, solved_, sigma, options_, progress);
    for (const PromotedStroke& stroke : promoted) {
      if (tied_.ties.groups[stroke.stroke] == stroke.group) result_.promoted.push_back(stroke);
    }
    result_.groups = tied_.ties.groups;
    place();
    add_warnings(sigma);
    progress.report(1);
    return std::move(result_);
  }

 private:
  /// Numbers components so that the largest one is 0.
  void number_components() {
    std::vector<std::size_t> sizes(solved_.table.components, 0);
    for (const Index c : solved_.table.component) ++sizes[c];
    std::vector<Index> order(sizes.size());
    for (Index c = 0; c < order.size(); ++c) order[c] = c;
    std::stable_sort(order.begin(), order.end(), [&](Index a, Index b) { return sizes[a] > sizes[b]; });
    std::vector<Index> number(order.size());
    for (Index i = 0; i < order.size(); ++i) number[order[i]] = i;
    largest_ = order.front();
    for (const Index c : solved_.table.component) result_.component.push_back(number[c]);
  }

  void place() {
    const ClassTable& table = solved_.table;
    number_components();
    Placement placed = placement(drawing_, vertices_, camera_, solved_, largest_);
    result_.warnings = std::move(placed.warnings);
    result_.camera = camera_.camera;
    result_.camera.eye = placed.eye;
    result_.classes = table.of_vertex;
    result_.class_values.resize(table.class_count());
    for (Index v = 0; v < table.vertex_count(); ++v) {
      for (int k = 0; k < 3; ++k) {
        const Index c = table.of_vertex[v][static_cast<std::size_t>(k)];
        result_.class_values[c] = placed.eye[k] + placed.scale[table.component[v]] * solved_.solution.values[c];
      }
    }
    for (Index v = 0; v < table.vertex_count(); ++v) {
      const std::array<Index, 3>& at = table.of_vertex[v];
      result_.positions.emplace_back(result_.class_values[at[0]], result_.class_values[at[1]],
                                     result_.class_values[at[2]]);
      result_.residuals.push_back(unit_ * solved_.solution.residuals[v]);
      result_.in_front.push_back(tied_.seen.rotation.row(2).dot(solved_.solution.position(table, v)) > 0);
    }
    result_.rms = unit_ * solved_.solution.rms();
    for (MergedPlanes& merged : result_.merged) merged.distance *= placed.scale[table.component[merged.vertex]];
    scale_ = std::move(placed.scale);
  }

  void add_warnings(double sigma) {
    if (solved_.table.components > 1) warn_disconnected();
    for (const Contradiction& contradiction : result_.contradictions) warn_contradiction(contradiction);
    if (!solved_.solution.in_front) warn_not_in_front();
    add_deviations(std::max(sigma, least_sigma));
  }

  std::vector<Index> strokes_at(const std::vector<bool>& wanted) const {
    std::vector<Index> strokes;
    for (std::size_t s = 0; s < vertices_.of_stroke.size(); ++s) {
      const auto [a, b] = vertices_.of_stroke[s];
      if (a != no_index && b != no_index && (wanted[a] || wanted[b])) strokes.push_back(static_cast<Index>(s));
    }
    return strokes;
  }

  void warn_disconnected() {
    std::vector<bool> apart;
    for (const Index c : result_.component) apart.push_back(c != 0);
    const std::vector<Index> strokes = strokes_at(apart);
    result_.warnings.push_back(
        make_warning(Category::Geometry, "DISCONNECTED",
                     "Nothing ties " + stroke_names(drawing_, strokes) +
                         " to the rest, so how far away they are is a guess: draw a link stroke between them.",
                     stroke_subjects(drawing_, strokes)));
  }

  void warn_contradiction(const Contradiction& contradiction) {
    const PerspectiveStroke& stroke = drawing_.strokes[contradiction.stroke];
    std::string sentence = "Stroke " + stroke.id + " is drawn as " + group_words(stroke.group);
    if (contradiction.fix != StrokeGroup::Unknown) {
      sentence += " but fits " + group_words(contradiction.fix) + ": give it that group.";
    } else if (contradiction.split != no_index) {
      sentence += ", which contradicts the rest: two corners seem to be drawn at one place there, move them apart.";
    } else {
      sentence += ", which contradicts the rest: check its group and its ends.";
    }
    result_.warnings.push_back(make_warning(Category::Geometry, "CONTRADICTION", std::move(sentence),
                                            {stroke_subject(drawing_, contradiction.stroke)}));
  }

  void warn_not_in_front() {
    std::vector<bool> behind;
    for (const bool in_front : result_.in_front) behind.push_back(!in_front);
    const std::vector<Index> strokes = strokes_at(behind);
    result_.warnings.push_back(
        make_warning(Category::Geometry, "NOT_IN_FRONT",
                     "Ends of " + stroke_names(drawing_, strokes) + " would lie behind the eye: check groups and ends.",
                     stroke_subjects(drawing_, strokes)));
  }

  void add_deviations(double sigma) {
    result_.deviations = depth_deviations(tied_.seen, solved_.table, solved_.solution);
    std::vector<double> diagonals;
    for (Index c = 0; c < solved_.table.components; ++c) diagonals.push_back(component_diagonal(solved_, c));
    std::set<Index> grazing;
    for (Index v = 0; v < result_.deviations.size(); ++v) {
      const Index component = solved_.table.component[v];
      const bool uncertain = sigma * result_.deviations[v] > options_.grazing_deviation * diagonals[component];
      if (uncertain && diagonals[component] > 0) add_grazing_strokes(v, grazing);
      result_.deviations[v] *= sigma * scale_[component];
    }
    if (grazing.empty()) return;
    const std::vector<Index> strokes(grazing.begin(), grazing.end());
    result_.warnings.push_back(
        make_warning(Category::Geometry, "GRAZING",
                     "The depth of " + stroke_names(drawing_, strokes) +
                         " is uncertain, their plane is seen from its edge: tie their ends by further strokes.",
                     stroke_subjects(drawing_, strokes)));
  }

  void add_grazing_strokes(Index vertex, std::set<Index>& strokes) const {
    const Vec3 ray = tied_.seen.ray(vertex);
    for (const StrokeEnd& end : vertices_.vertices[vertex].ends) {
      const StrokeGroup group = tied_.ties.groups[end.stroke];
      if (group == StrokeGroup::Unknown || is_parallel(group)) continue;
      const int axis = axis_of(group);
      const double along = std::hypot(ray[(axis + 1) % 3], ray[(axis + 2) % 3]);
      if (std::atan2(std::abs(ray[axis]), along) < options_.grazing) strokes.insert(end.stroke);
    }
  }

  const PerspectiveDrawing& drawing_;
  const DrawingVertices& vertices_;
  const CameraEstimate& camera_;
  const CoordinateOptions& options_;
  double unit_;  // px per u
  TiedVertices tied_;
  SolvedVertices solved_;
  Index largest_ = 0;          // component of the table
  std::vector<double> scale_;  // of the table's components
  VertexCoordinates result_;
};

}  // namespace

VertexCoordinates solve_coordinates(const PerspectiveDrawing& drawing, const DrawingVertices& vertices,
                                    const CameraEstimate& camera, std::span<const StrokeGroup> groups,
                                    std::span<const PromotedStroke> promoted, const CoordinateOptions& options,
                                    Progress& progress) {
  if (vertices.vertices.empty()) {
    VertexCoordinates nothing;
    nothing.camera = camera.camera;
    nothing.groups.assign(groups.begin(), groups.end());
    return nothing;
  }
  return CoordinateSolve(drawing, vertices, camera, groups, options).run(promoted, progress);
}

}  // namespace croquis
