// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <map>
#include <memory>
#include <numbers>
#include <utility>

#include "croquis/base/described.h"
#include "croquis/base/error.h"
#include "croquis/base/text.h"
#include "croquis/io/surface_places_file.h"
#include "croquis/operators/surface_result.h"
#include "operators/memo_stage_cache.h"
#include "operators/operations.h"

namespace croquis {
namespace {

/// Fan coordinates are that far outside of a domain only by rounding.
constexpr double fan_rounding = 1e-9;

/// Samples of drafts, which are looked at while something is dragged.
constexpr std::size_t draft_samples = 16;

struct SurfaceSettings {
  AttributeSurfaceOptions surface;
  SurfaceTessellationOptions tessellation;
};

std::optional<double> read_fullness(const std::string& text) {
  if (text.empty()) return std::nullopt;
  double fullness = 0;
  if (read_number(text, fullness) && fullness >= -1 && fullness <= 2) return fullness;
  throw Error(refused_value("fullness", text, "a number from -1 to 2, such as 0.7"));
}

void list_surface_parameters(SurfaceSettings& settings, ParameterList& list) {
  list.choice(
          "mode", settings.surface.mode, {"network", "smooth", "position", "paper"},
          "How faces are blended: with common tangent planes at smooth curves, from positions alone, by the paper's "
          "formulas, or as the network says of each.")
      .titled("Patches are", {"each as chosen", "smooth", "creased", "as published in 2006"});
  list.choice(
          "domain", settings.surface.domain, {"network", "chordlength", "uniform"},
          "The polygon that a face is a map of: with its curves' lengths as sides, a regular one, or as the network "
          "says of each.")
      .titled("Sides of patches", {"each as chosen", "as long as the curves", "all the same"})
      .at(ParameterPlace::Expert);
  list.text("fullness", "",
            "How full smooth faces are, -1 to 2: 1 follows the slopes at the sides, 0 is flat; empty: as the network "
            "says.",
            [&](const std::string& text) { settings.surface.fullness = read_fullness(text); })
      .at(ParameterPlace::Nowhere);
  list.integer("samples", settings.tessellation.samples, 1, 1024, "",
               "Parts of each curve, and rings of triangles around the middle of each face.")
      .titled("Edges along a curve");
  list.number("tolerance", settings.tessellation.tolerance, 1e9, {"model units", ParameterLength::Model},
              "Greatest distance of the mesh from the surface: as few triangles as keep to it; 0: rings of triangles.")
      .titled("Off the surface by at most")
      .or_else("no limit");
}

void append_all(const Findings& more, Findings& all) { all.insert(all.end(), more.begin(), more.end()); }

std::string quoted_face(const std::string& id) { return "face \"" + id + '"'; }

/// Questions as places of a network.
class Questions {
 public:
  explicit Questions(const AttributeNetwork& network) : network_(network) {
    for (Index f = 0; f < network.faces.size(); ++f) faces_.emplace(network.faces[f].id, f);
  }

  std::vector<EvaluatedPlace> read(const std::vector<SurfacePlaceQuestion>& questions) {
    std::vector<EvaluatedPlace> places;
    for (std::size_t i = 0; i < questions.size(); ++i) {
      where_ = "Places, places[" + std::to_string(i) + "]: ";
      const SurfacePlaceQuestion& question = questions[i];
      const auto face = faces_.find(question.face);
      if (face == faces_.end()) {
        refuse("E_NO_FACE", quoted_face(question.face) + " isn't there: add it or correct the name.", question.face);
      } else if (check(question, network_.faces[face->second])) {
        places.push_back({face->second, question.fan, {}, Vec3::Zero()});
      }
    }
    if (!errors_.empty()) throw Error(std::move(errors_));
    return places;
  }

 private:
  bool check(const SurfacePlaceQuestion& question, const AttributeFace& face) {
    const FanPlace& fan = question.fan;
    const bool inside = fan.corner < domain_corners(face) && fan.a >= -fan_rounding && fan.b >= -fan_rounding &&
                        fan.a + fan.b <= 1 + fan_rounding;
    if (!inside) {
      refuse("E_SYNTAX",
             "its fan is no place of " + quoted_face(face.id) + ", whose corners are 0 to " +
                 std::to_string(domain_corners(face) - 1) + ": give a corner and two shares whose sum is at most 1.",
             face.id);
    }
    return inside;
  }

  void refuse(const char* code, const std::string& what, const std::string& face) {
    constexpr std::size_t most = 100;
    if (errors_.size() < most)
      errors_.push_back(make_error(Category::Malformed, code, where_ + what, {{SubjectKind::Face, face, {}, {}, {}}}));
  }

  const AttributeNetwork& network_;
  std::map<std::string, Index> faces_;
  std::string where_;
  Findings errors_;
};

/// The questions of the input, where there is one.
std::vector<EvaluatedPlace> read_questions(const Values& inputs, const AttributeNetwork& network, Findings& warnings) {
  const auto given = inputs.find("evaluate");
  if (given == inputs.end()) return {};
  SurfacePlacesReadResult read = read_surface_places(given->second.get<Report>());
  append_all(read.warnings, warnings);
  return Questions(network).read(read.places);
}

void answer(const AttributeSurface& surface, std::vector<EvaluatedPlace>& places) {
  for (EvaluatedPlace& place : places) {
    const auto& face = surface.faces[place.face].surface;
    if (face == nullptr) continue;
    const Vec2 at = place_in(face->domain(), place.fan);
    place.place = face->evaluate(at);
    place.normal = face->normal(at);
  }
}

/// When no face could be evaluated, all that was found says why.
void require_any_face(const AttributeNetwork& network, const AttributeSurface& surface) {
  if (surface.any()) return;
  Findings findings = surface.findings;
  if (!has_errors(findings)) {
    const std::string what = network.faces.empty() ? "The network has no faces: give it loops of curves."
                                                   : "No face of the network could be evaluated.";
    findings.insert(findings.begin(), make_error(Category::Geometry, "E_NO_FACES", what));
  }
  throw Error(std::move(findings));
}

Report patch_list(const AttributeNetwork& network, const SurfaceResult& result) {
  Report list = Report::array();
  for (const PatchMeasures& patch : result.measures.patches) {
    const AttributeFace& face = network.faces[patch.face];
    list.push(to_report(
        fields(named("face", face.id), named("sides", face.loop.size()), named("side_lengths", patch.side_lengths),
               named("beta", patch.beta), named("radius", patch.radius), named("centre_inside", patch.centre_inside),
               named("sigma", patch.sigma), named("anisotropy", patch.anisotropy), named("folded", patch.folded))));
  }
  return list;
}

/// Points and inner curves of two lists may have one id: the larger error counts.
void set_error(const std::string& id, const std::optional<double>& error, Report::Object& errors) {
  if (!error) return;
  for (auto& [known, value] : errors) {
    if (known != id) continue;
    if (value.as_number() < *error) value = *error;
    return;
  }
  errors.emplace_back(id, *error);
}

Report error_list(const AttributeNetwork& network, const SurfaceMeasures& measures) {
  Report::Object errors;
  for (std::size_t p = 0; p < network.points.size(); ++p)
    set_error(network.points[p].id, measures.point_errors[p], errors);
  for (std::size_t f = 0; f < network.faces.size(); ++f) {
    for (std::size_t i = 0; i < measures.inner_errors[f].size(); ++i)
      set_error(network.curves[network.faces[f].inner[i].curve].id, measures.inner_errors[f][i], errors);
  }
  return Report::of_members(std::move(errors));
}

Report evaluated_list(const AttributeNetwork& network, const std::vector<EvaluatedPlace>& places) {
  Report list = Report::array();
  for (const EvaluatedPlace& place : places)
    list.push(to_report(fields(named("face", network.faces[place.face].id), named("fan", report_of(place.fan)),
                               named("p", place.place ? to_report(place.place->point) : Report()),
                               named("normal", place.place ? to_report(place.normal) : Report()))));
  return list;
}

std::string summary_of(const AttributeNetwork& network, const SurfaceResult& result) {
  const std::size_t made = result.measures.patches.size(), all = network.faces.size();
  std::string text = counted(made, "patch", "patches");
  if (made < all) text += ", " + counted(all - made, "face", "faces") + " failed";
  return text;
}

template <class T>
std::size_t bytes_of(const std::vector<T>& list) {
  return list.size() * sizeof(T);
}

Report to_report(const AttributeNetwork& network, const SurfaceResult& result) {
  return to_report(fields(named("summary", summary_of(network, result)), named("patches", patch_list(network, result)),
                          named("boundary_error", result.measures.boundary_error),
                          named("attribute_errors", error_list(network, result.measures)),
                          named("g1_angle_degrees", result.measures.largest_normal_jump * 180 / std::numbers::pi),
                          named("tolerance", result.surface->tolerance),
                          named("evaluated", evaluated_list(network, result.evaluated))));
}

OperationResult compute_surface(const Values& inputs, SurfaceSettings settings, Context& context) {
  const auto& network = inputs.at("network").get<AttributeNetwork>();
  OperationResult result;
  if (context.quality == Quality::Draft) {
    settings.tessellation.samples = std::min(settings.tessellation.samples, draft_samples);
    settings.tessellation.tolerance.reset();
  }
  SurfaceResult details;
  details.network = inputs.at("network").as<AttributeNetwork>();
  details.evaluated = read_questions(inputs, network, result.warnings);
  MemoStageCache cache(context.memo);
  StageCache* kept = context.memo != nullptr ? &cache : nullptr;
  settings.surface.cache = settings.tessellation.cache = kept;
  settings.tessellation.threads = context.threads;

  Progress evaluating = context.progress.step("evaluate the network", 0.3);
  details.surface =
      std::make_shared<const AttributeSurface>(make_attribute_surface(network, evaluating, settings.surface));
  require_any_face(network, *details.surface);
  append_all(details.surface->findings, result.warnings);
  Progress meshing = context.progress.step("make triangles", 0.6);
  SurfaceTessellation made = tessellate(network, *details.surface, meshing, settings.tessellation);
  append_all(made.findings, result.warnings);
  Progress measuring = context.progress.step("measure", 0.1);
  details.measures = measure(network, *details.surface, kept);
  answer(*details.surface, details.evaluated);
  measuring.report(1);

  details.parts = std::move(made.parts);
  result.outputs["mesh"] = std::make_shared<const PolyMesh>(std::move(made.mesh));
  result.outputs["details"] = std::make_shared<const Report>(to_report(network, details));
  result.details = std::move(details);
  return result;
}

}  // namespace

std::size_t byte_size(const SurfaceResult& result) {
  std::size_t bytes = sizeof result + bytes_of(result.evaluated);
  for (const SurfacePart& part : result.parts) bytes += sizeof part + bytes_of(part.vertices) + bytes_of(part.places);
  for (const PatchMeasures& patch : result.measures.patches) bytes += sizeof patch + bytes_of(patch.side_lengths);
  bytes += bytes_of(result.measures.point_errors) + bytes_of(result.measures.normal_jumps);
  if (result.surface == nullptr) return bytes;
  for (const SurfaceFace& face : result.surface->faces) {
    bytes += sizeof face + face.content.capacity();
    if (face.surface != nullptr) bytes += face.surface->byte_size();
  }
  for (const SurfaceCurve& curve : result.surface->curves) {
    bytes += sizeof curve + bytes_of(curve.faces);
    if (curve.curve != nullptr) bytes += curve.curve->byte_size();
  }
  return bytes;
}

std::unique_ptr<const Operation> surface_operation() {
  PortDescription questions{"evaluate", ValueType::Report,
                            "Places of faces whose point and normal are reported, in the format croquis-abs-places/1."};
  questions.optional = true;
  questions.asks = true;
  return operation_of(
      {"surface",
       1,
       "Attribute Surface",
       "Turns a network of curves into smooth patches of any number of sides, which points and curves inside pull.",
       {{"network", ValueType::AttributeNetwork, "Curves, the faces between them, points and slopes."},
        std::move(questions)},
       {{"mesh", ValueType::Mesh, "Triangles of all patches, which share the samples of their curves."},
        {"details", ValueType::Report, "Each patch, errors at curves and points, angles along smooth curves."}}},
      list_surface_parameters, compute_surface);
}

}  // namespace croquis
