// SPDX-License-Identifier: GPL-3.0-or-later
#include "operators/surface/surface_report.h"

#include <numbers>
#include <utility>

#include "croquis/base/text.h"
#include "croquis/io/surface_places_file.h"

namespace croquis {
namespace {

Report patch_list(const AttributeNetwork& network, const SurfaceResult& result) {
  Report list = Report::array();
  for (const PatchMeasures& patch : result.measures.patches) {
    Report entry;
    entry.set("face", network.faces[patch.face].id)
        .set("sides", network.faces[patch.face].loop.size())
        .set("side_lengths", Report::list(patch.side_lengths))
        .set("beta", patch.beta)
        .set("radius", patch.radius)
        .set("centre_inside", patch.centre_inside)
        .set("sigma", patch.sigma)
        .set("anisotropy", patch.anisotropy)
        .set("folded", patch.folded);
    list.push(std::move(entry));
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
  for (const EvaluatedPlace& place : places) {
    Report entry;
    entry.set("face", network.faces[place.face].id)
        .set("fan", report_of(place.fan))
        .set("p", place.place ? Report::list(place.place->point) : Report())
        .set("normal", place.place ? Report::list(place.normal) : Report());
    list.push(std::move(entry));
  }
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

}  // namespace

Report to_report(const AttributeNetwork& network, const SurfaceResult& result) {
  Report report;
  report.set("summary", summary_of(network, result))
      .set("patches", patch_list(network, result))
      .set("boundary_error", result.measures.boundary_error)
      .set("attribute_errors", error_list(network, result.measures))
      .set("g1_angle_degrees", result.measures.largest_normal_jump * 180 / std::numbers::pi)
      .set("tolerance", result.surface->tolerance)
      .set("evaluated", evaluated_list(network, result.evaluated));
  return report;
}

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

}  // namespace croquis
