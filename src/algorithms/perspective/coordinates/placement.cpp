// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/perspective/coordinates/placement.h"

#include <algorithm>
#include <limits>
#include <optional>

#include <Eigen/Geometry>

#include "algorithms/perspective/curves/rational_lift.h"
#include "algorithms/perspective/stroke_words.h"

namespace croquis {
namespace {

/// Of the eye from the known point, or from the origin, where no length is known. Model units.
constexpr double usual_distance = 10;

class Placing {
 public:
  Placing(const PerspectiveDrawing& drawing, const DrawingVertices& vertices, const CameraEstimate& camera,
          const SolvedVertices& solved, Index largest)
      : drawing_(drawing), vertices_(vertices), camera_(camera), solved_(solved), largest_(largest) {}

  Placement place() {
    set_known_scales();
    const Index origin = origin_vertex();
    const Vec3 seen = solved_.solution.position(solved_.table, origin);
    // Pieces without a length of their own are thought as far away as the largest one.
    double common = known_[largest_];
    if (!(common > 0)) common = *std::max_element(known_.begin(), known_.end());
    if (!(common > 0)) common = usual_distance / seen.norm();
    for (const double known : known_) result_.scale.push_back(known > 0 ? known : common);
    const Vec3 point = drawing_.known_point ? drawing_.known_point->point : Vec3(Vec3::Zero());
    result_.eye = point - result_.scale[solved_.table.component[origin]] * seen;
    return std::move(result_);
  }

 private:
  /// Least squares for pieces with several lengths.
  void set_known_scales() {
    std::vector<double> products(solved_.table.components, 0);
    std::vector<double> squares(solved_.table.components, 0);
    for (const KnownLength& known : drawing_.known_lengths) {
      const auto found = std::find_if(drawing_.strokes.begin(), drawing_.strokes.end(),
                                      [&](const PerspectiveStroke& stroke) { return stroke.id == known.stroke; });
      const std::optional<double> length = found == drawing_.strokes.end()
                                               ? std::nullopt
                                               : length_of(static_cast<Index>(found - drawing_.strokes.begin()));
      if (!length || !(*length > 0) || !(known.length > 0)) {
        warn_unused(known);
        continue;
      }
      const auto stroke = static_cast<std::size_t>(found - drawing_.strokes.begin());
      const Index component = solved_.table.component[vertices_.of_stroke[stroke][0]];
      products[component] += *length * known.length;
      squares[component] += *length * *length;
    }
    for (Index c = 0; c < solved_.table.components; ++c)
      known_.push_back(squares[c] > 0 ? products[c] / squares[c] : 0);
  }

  std::optional<double> length_of(Index stroke) const {
    const std::array<Index, 2>& ends = vertices_.of_stroke[stroke];
    if (ends[0] == no_index || ends[1] == no_index) return std::nullopt;
    if (solved_.table.component[ends[0]] != solved_.table.component[ends[1]]) return std::nullopt;
    const Vec3 a = solved_.solution.position(solved_.table, ends[0]);
    const Vec3 b = solved_.solution.position(solved_.table, ends[1]);
    const auto pieces = lifted_stroke(drawing_.strokes[stroke], drawing_.strokes[stroke].group, a, b, camera_.camera);
    if (!pieces) return std::nullopt;
    double sum = 0;
    for (const auto& parts : *pieces) {
      for (const RationalCubic& part : parts) sum += arc_length(part);
    }
    return sum;
  }

  void warn_unused(const KnownLength& known) {
    Subject subject;
    subject.kind = SubjectKind::Stroke;
    subject.id = known.stroke;
    result_.warnings.push_back(
        make_warning(Category::Geometry, "LENGTH_UNUSED",
                     "The known length of stroke " + known.stroke +
                         " can't be used: give the length, more than 0, of an edge that is tied to the others.",
                     {subject}));
  }

  /// The vertex at the known point, else the one nearest to the eye.
  Index origin_vertex() const {
    Index best = 0;
    double least = std::numeric_limits<double>::infinity();
    for (Index v = 0; v < vertices_.vertices.size(); ++v) {
      double distance = 0;
      if (drawing_.known_point) {
        distance = (vertices_.vertices[v].position - drawing_.known_point->at).norm();
      } else if (solved_.table.component[v] == largest_) {
        distance = solved_.solution.position(solved_.table, v).norm();
      } else {
        continue;
      }
      if (distance >= least) continue;
      least = distance;
      best = v;
    }
    return best;
  }

  const PerspectiveDrawing& drawing_;
  const DrawingVertices& vertices_;
  const CameraEstimate& camera_;
  const SolvedVertices& solved_;
  Index largest_;
  std::vector<double> known_;  // scale of each component, 0 where nothing is known
  Placement result_;
};

}  // namespace

Placement placement(const PerspectiveDrawing& drawing, const DrawingVertices& vertices, const CameraEstimate& camera,
                    const SolvedVertices& solved, Index largest_component) {
  return Placing(drawing, vertices, camera, solved, largest_component).place();
}

}  // namespace croquis
