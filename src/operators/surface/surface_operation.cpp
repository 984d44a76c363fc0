// SPDX-License-Identifier: GPL-3.0-or-later
#include "operators/surface/surface_operation.h"

#include <map>
#include <memory>
#include <utility>

#include "croquis/base/error.h"
#include "croquis/io/surface_places_file.h"
#include "croquis/operators/surface_result.h"
#include "operators/memo_stage_cache.h"
#include "operators/surface/surface_report.h"
#include "operators/surface/surface_settings.h"

namespace croquis {
namespace {

/// Fan coordinates are that far outside of a domain only by rounding.
constexpr double fan_rounding = 1e-9;

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

}  // namespace

OperationDescription SurfaceOperation::describe() const {
  PortDescription questions{"evaluate", ValueType::Report,
                            "Places of faces whose point and normal are told, in the format croquis-abs-places/1."};
  questions.optional = true;
  questions.asks = true;
  return {"surface",
          1,
          "Attribute Surface",
          "Turns a network of curves into smooth patches of any number of sides, which points and curves inside pull.",
          {{"network", ValueType::AttributeNetwork, "Curves, the faces between them, points and slopes."},
           std::move(questions)},
          {{"mesh", ValueType::Mesh, "Triangles of all patches, which share the samples of their curves."},
           {"details", ValueType::Report, "Each patch, errors at curves and points, angles along smooth curves."}},
          surface_parameters()};
}

OperationResult SurfaceOperation::compute(const Values& inputs, const ParameterValues& parameters,
                                          Context& context) const {
  const auto& network = inputs.at("network").get<AttributeNetwork>();
  OperationResult result;
  SurfaceSettings settings = read_surface_settings(parameters, context.quality);
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

}  // namespace croquis
