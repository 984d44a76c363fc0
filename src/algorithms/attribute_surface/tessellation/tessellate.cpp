// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <map>
#include <memory>
#include <numeric>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "algorithms/attribute_surface/tessellation/face_samples.h"
#include "croquis/attribute_surface/surface_tessellation.h"
#include "croquis/base/parallel.h"
#include "croquis/base/stage_key.h"
#include "croquis/base/text.h"
#include "croquis/geometry/disjoint_sets.h"

namespace croquis {
namespace {

/// Parts are halved no more often than that.
constexpr int most_halvings = 12;

double distance_to_chord(const Vec3& place, const Vec3& from, const Vec3& to) {
  const Vec3 along = to - from;
  const double square = along.squaredNorm();
  const double t = square > 0 ? std::clamp((place - from).dot(along) / square, 0.0, 1.0) : 0;
  return (place - from - t * along).norm();
}

/// How far a part of a curve is from its chord, at a quarter, half and three quarters.
double chord_error(const ArcLengthCurve& curve, double from, double to) {
  const Vec3 first = curve.at(from), last = curve.at(to);
  double error = 0;
  for (const double part : {0.25, 0.5, 0.75})
    error = std::max(error, distance_to_chord(curve.at(from + part * (to - from)), first, last));
  return error;
}

void halve(const ArcLengthCurve& curve, double tolerance, double from, double to, int halvings,
           std::vector<double>& fractions) {
  if (halvings > 0 && chord_error(curve, from, to) > tolerance) {
    const double middle = 0.5 * (from + to);
    halve(curve, tolerance, from, middle, halvings - 1, fractions);
    halve(curve, tolerance, middle, to, halvings - 1, fractions);
  } else {
    fractions.push_back(to);
  }
}

std::vector<double> even_fractions(std::size_t parts) {
  std::vector<double> fractions;
  for (std::size_t i = 0; i <= parts; ++i) fractions.push_back(static_cast<double>(i) / static_cast<double>(parts));
  return fractions;
}

/// How many parts a curve needs at least, so that no two triangles have the same corners.
class LeastParts {
 public:
  LeastParts(const AttributeNetwork& network, const AttributeSurface& surface)
      : surface_(surface), uses_(network.curves.size(), Use::None) {
    for (std::size_t f = 0; f < surface.faces.size(); ++f) {
      if (surface.faces[f].surface == nullptr) continue;
      const auto& loop = network.faces[f].loop;
      for (const AttributeSide& side : loop)
        uses_[side.curve] = std::max(uses_[side.curve], loop.size() == 2 ? Use::OfTwo : Use::Side);
    }
    for (std::size_t c = 0; c < uses_.size(); ++c) {
      if (is_used(c)) ++curves_between_[ends_of(c)];
    }
  }

  bool is_used(std::size_t curve) const { return uses_[curve] != Use::None; }

  /// Of a face of two curves: the middle is a corner of its domain, so it is a sample.
  bool has_middle(std::size_t curve) const { return uses_[curve] == Use::OfTwo; }

  std::size_t of(std::size_t curve) const {
    const auto ends = ends_of(curve);
    if (ends.first == ends.second) return has_middle(curve) ? 4 : 3;
    return curves_between_.at(ends) > 1 || has_middle(curve) ? 2 : 1;
  }

 private:
  enum class Use { None, Side, OfTwo };

  std::pair<std::size_t, std::size_t> ends_of(std::size_t curve) const {
    return std::minmax(surface_.curves[curve].start, surface_.curves[curve].end);
  }

  const AttributeSurface& surface_;
  std::vector<Use> uses_;
  std::map<std::pair<std::size_t, std::size_t>, int> curves_between_;
};

/// Fractions of the curve's arc length between which chords keep to it.
/// @param least parts, 1 or more
std::vector<double> fractions_by_chords(const ArcLengthCurve& curve, double tolerance, std::size_t least) {
  std::vector<double> fractions{0};
  const std::vector<double> parts = even_fractions(least);
  for (std::size_t i = 0; i + 1 < parts.size(); ++i)
    halve(curve, tolerance, parts[i], parts[i + 1], most_halvings, fractions);
  return fractions;
}

std::vector<double> fractions_of(const ArcLengthCurve& curve, std::size_t index, const LeastParts& least,
                                 const SurfaceTessellationOptions& options) {
  if (options.tolerance) return fractions_by_chords(curve, *options.tolerance, least.of(index));
  std::size_t parts = std::max(options.samples, least.of(index));
  if (least.has_middle(index)) parts += parts % 2;
  return even_fractions(parts);
}

/// The samples of every curve that a loop uses, by curve; none of the others.
std::vector<CurveSamples> sample_curves(const AttributeNetwork& network, const AttributeSurface& surface,
                                        const SurfaceTessellationOptions& options) {
  const LeastParts least(network, surface);
  std::vector<CurveSamples> samples(network.curves.size());
  for (std::size_t c = 0; c < samples.size(); ++c) {
    if (!least.is_used(c)) continue;
    const ArcLengthCurve& curve = *surface.curves[c].curve;
    CurveSamples& made = samples[c];
    if (c < options.given.size() && !options.given[c].at.empty()) {
      made = options.given[c];
    } else {
      made.at = fractions_of(curve, c, least, options);
      made.points.reserve(made.at.size());
      for (const double at : made.at) made.points.push_back(curve.at(at));
    }
    made.points.front() = curve.control().front();
    made.points.back() = curve.control().back();
  }
  return samples;
}

constexpr const char* samples_stage = "samples of a surface";

class SurfaceTessellator {
 public:
  SurfaceTessellator(const AttributeNetwork& network, const AttributeSurface& surface, Progress& progress,
                     const SurfaceTessellationOptions& options)
      : network_(network), surface_(surface), progress_(progress), options_(options) {}

  SurfaceTessellation run() {
    add_curves();
    for (Index f = 0; f < surface_.faces.size(); ++f) {
      if (surface_.faces[f].surface != nullptr) add_part(f);
    }
    make_samples();
    reserve();
    for (std::size_t i = 0; i < samples_.size(); ++i) add_face(result_.parts[i], *samples_[i]);
    finish();
    return std::move(result_);
  }

 private:
  // ---- Curves

  /// The vertices of corners, then those between the ends of curves.
  void add_curves() {
    curves_ = sample_curves(network_, surface_, options_);
    const std::vector<Index> meeting = meeting_corners();
    std::vector<Index> corner_vertices(surface_.corners, no_index);
    const auto vertex_of = [&](std::size_t corner) -> Index& { return corner_vertices[meeting[corner]]; };
    for (std::size_t c = 0; c < curves_.size(); ++c) {
      if (curves_[c].at.empty()) continue;
      add_corner(curves_[c].points.front(), vertex_of(surface_.curves[c].start));
      add_corner(curves_[c].points.back(), vertex_of(surface_.curves[c].end));
    }
    std::vector<Vec3>& positions = result_.mesh.positions;
    curve_vertices_.resize(curves_.size());
    for (std::size_t c = 0; c < curves_.size(); ++c) {
      const CurveSamples& curve = curves_[c];
      if (curve.at.empty()) continue;
      std::vector<Index>& vertices = curve_vertices_[c];
      vertices.push_back(vertex_of(surface_.curves[c].start));
      for (std::size_t i = 1; i + 1 < curve.points.size(); ++i) {
        vertices.push_back(static_cast<Index>(positions.size()));
        positions.push_back(curve.points[i]);
      }
      vertices.push_back(vertex_of(surface_.curves[c].end));
    }
  }

  /// For each corner the lowest of those that are one in a loop: nodes may be nearer to each other than the tolerance.
  std::vector<Index> meeting_corners() const {
    DisjointSets sets(surface_.corners);
    for (std::size_t f = 0; f < surface_.faces.size(); ++f) {
      const auto& loop = network_.faces[f].loop;
      for (std::size_t k = 0; surface_.faces[f].surface != nullptr && k < loop.size(); ++k) {
        const AttributeSide &side = loop[k], &next = loop[(k + 1) % loop.size()];
        const SurfaceCurve &from = surface_.curves[side.curve], &to = surface_.curves[next.curve];
        sets.unite(static_cast<Index>(side.reversed ? from.start : from.end),
                   static_cast<Index>(next.reversed ? to.end : to.start));
      }
    }
    return sets.take_roots();
  }

  void add_corner(const Vec3& place, Index& vertex) {
    if (vertex != no_index) return;
    vertex = static_cast<Index>(result_.mesh.positions.size());
    result_.mesh.positions.push_back(place);
  }

  FaceRim rim_of(const AttributeFace& face) const {
    FaceRim rim;
    for (const AttributeSide& side : face.loop) {
      const std::vector<double>& at = curves_[side.curve].at;
      std::vector<double>& fractions = rim.emplace_back();
      for (std::size_t i = 0; i + 1 < at.size(); ++i)
        fractions.push_back(side.reversed ? 1 - at[at.size() - 1 - i] : at[i]);
    }
    return rim;
  }

  /// Vertices of the mesh along the rim, as rim_of has their fractions.
  void append_rim(const AttributeFace& face, std::vector<Index>& vertices) const {
    for (const AttributeSide& side : face.loop) {
      const std::vector<Index>& along = curve_vertices_[side.curve];
      for (std::size_t i = 0; i + 1 < along.size(); ++i)
        vertices.push_back(side.reversed ? along[along.size() - 1 - i] : along[i]);
    }
  }

  // ---- Faces

  FaceSamples evaluated(const FaceSurface& surface, const FaceRim& rim) const {
    if (!options_.tolerance) return evaluate_places(surface, rim, fan_places(surface, rim, options_.insert_points));
    Progress silent = progress_.silent();
    RefinedPlaces refined =
        refined_places(surface, rim, silent, {*options_.tolerance, options_.insert_points, options_.most_places});
    FaceSamples samples = evaluate_places(surface, rim, std::move(refined.plane));
    samples.error = refined.error;
    return samples;
  }

  /// What the cache has of a face is taken from there.
  void add_part(Index f) {
    result_.parts.emplace_back().face = f;
    rims_.push_back(rim_of(network_.faces[f]));
    StageKey& key = keys_.emplace_back();
    if (options_.cache != nullptr) {
      key.add(surface_.faces[f].content).add(rims_.back()).add(options_.tolerance.value_or(0));
      key.add(options_.insert_points).add(options_.most_places);
    }
    samples_.push_back(kept<FaceSamples>(options_.cache, samples_stage, key));
  }

  /// Faces that the cache doesn't have, on several threads; the cache itself is used by this one alone.
  void make_samples() {
    std::vector<std::size_t> missing;
    for (std::size_t i = 0; i < samples_.size(); ++i) {
      if (samples_[i] == nullptr) missing.push_back(i);
    }
    std::vector<FaceSamples> made(missing.size());
    for_each_part(missing.size(), 1, options_.threads, progress_, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
        made[i] = evaluated(*surface_.faces[result_.parts[missing[i]].face].surface, rims_[missing[i]]);
    });
    for (std::size_t i = 0; i < missing.size(); ++i) {
      samples_[missing[i]] = cached<FaceSamples>(
          options_.cache, samples_stage, keys_[missing[i]], [&] { return std::move(made[i]); },
          [](const FaceSamples& samples) { return samples.byte_size(); });
    }
    for (std::size_t i = 0; i < samples_.size(); ++i) {
      if (samples_[i]->error > 0) note_error(result_.parts[i].face, samples_[i]->error);
    }
  }

  void note_error(Index f, double error) {
    const std::string& id = network_.faces[f].id;
    result_.findings.push_back(make_warning(Category::Limit, "W_TOLERANCE",
                                            "Face \"" + id + "\" keeps only to " + number_text(error) +
                                                ", not to the tolerance of " + number_text(*options_.tolerance) +
                                                ": choose a greater one.",
                                            {{SubjectKind::Face, id, {}, {}, {}}}));
  }

  void reserve() {
    std::size_t vertices = result_.mesh.positions.size(), triangles = 0;
    for (const auto& samples : samples_) {
      vertices += samples->plane.inner_count;
      triangles += samples->plane.triangles.size();
    }
    PolyMesh& mesh = result_.mesh;
    mesh.positions.reserve(vertices);
    mesh.corners.resize(3 * triangles);
    mesh.face_offsets.resize(triangles + 1);
    for (std::size_t t = 0; t <= triangles; ++t) mesh.face_offsets[t] = static_cast<Index>(3 * t);
    normals_.resize(9 * triangles);
    groups_.resize(triangles);
  }

  void add_face(SurfacePart& part, const FaceSamples& samples) {
    PolyMesh& mesh = result_.mesh;
    part.first_triangle = triangle_count_;
    part.triangle_count = samples.plane.triangles.size();
    part.places = samples.plane.places;
    part.vertices.resize(samples.plane.inner_count);
    std::iota(part.vertices.begin(), part.vertices.end(), static_cast<Index>(mesh.positions.size()));
    mesh.positions.insert(mesh.positions.end(), samples.points.begin(), samples.points.end());
    append_rim(network_.faces[part.face], part.vertices);
    for (const auto& triangle : samples.plane.triangles) add_triangle(part, samples, triangle);
  }

  void add_triangle(const SurfacePart& part, const FaceSamples& samples, const std::array<Index, 3>& triangle) {
    const bool flipped = surface_.faces[part.face].flipped;
    const std::size_t first = 3 * triangle_count_;
    for (std::size_t i = 0; i < 3; ++i) {
      const Index local = triangle[flipped && i > 0 ? 3 - i : i];
      result_.mesh.corners[first + i] = part.vertices[local];
      const Vec3& normal = samples.normals[local];
      for (int axis = 0; axis < 3; ++axis)
        normals_[3 * (first + i) + static_cast<std::size_t>(axis)] = flipped ? -normal[axis] : normal[axis];
      if (normal.isZero()) missing_normals_.push_back(first + i);
    }
    groups_[triangle_count_++] = static_cast<std::int32_t>(part.face);
  }

  /// Where the surface has no normal its triangle's stands in.
  void fill_missing_normals() {
    for (const std::size_t corner : missing_normals_) {
      const auto triangle = result_.mesh.face(corner / 3);
      const auto& at = result_.mesh.positions;
      const Vec3& origin = at[triangle[0]];
      const Vec3 normal = unit_or_zero((at[triangle[1]] - origin).cross(at[triangle[2]] - origin));
      for (int axis = 0; axis < 3; ++axis) normals_[3 * corner + static_cast<std::size_t>(axis)] = normal[axis];
    }
  }

  void finish() {
    fill_missing_normals();
    PolyMesh& mesh = result_.mesh;
    mesh.channels.push_back({"normal", Domain::Corner, 3, std::move(normals_), {}});
    std::vector<std::string> names;
    for (const AttributeFace& face : network_.faces) names.push_back(face.id);
    mesh.channels.push_back({"group", Domain::Face, 1, std::move(groups_), std::move(names)});
  }

  const AttributeNetwork& network_;
  const AttributeSurface& surface_;
  Progress& progress_;
  const SurfaceTessellationOptions& options_;
  SurfaceTessellation result_;
  std::vector<CurveSamples> curves_;
  std::vector<std::vector<Index>> curve_vertices_;           ///< by curve, both ends included
  std::vector<FaceRim> rims_;                                ///< of the parts
  std::vector<StageKey> keys_;                               ///< of the parts
  std::vector<std::shared_ptr<const FaceSamples>> samples_;  ///< of the parts
  std::vector<double> normals_;
  std::vector<std::int32_t> groups_;
  std::vector<std::size_t> missing_normals_;  ///< corners
  std::size_t triangle_count_ = 0;
};

}  // namespace

SurfaceTessellation tessellate(const AttributeNetwork& network, const AttributeSurface& surface, Progress& progress,
                               const SurfaceTessellationOptions& options) {
  return SurfaceTessellator(network, surface, progress, options).run();
}

}  // namespace croquis
