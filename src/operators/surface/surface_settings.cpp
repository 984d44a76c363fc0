// SPDX-License-Identifier: GPL-3.0-or-later
#include "operators/surface/surface_settings.h"

#include <algorithm>
#include <optional>
#include <string>

#include "croquis/base/error.h"
#include "croquis/base/text.h"

namespace croquis {
namespace {

/// The choice that leaves a property as the network has it.
constexpr const char* as_in_network = "network";
/// Samples of drafts, which are looked at while something is dragged.
constexpr std::size_t draft_samples = 16;

std::optional<AttributeMode> mode_of(const std::string& name) {
  if (name == "smooth") return AttributeMode::Smooth;
  if (name == "position") return AttributeMode::Position;
  if (name == "paper") return AttributeMode::Paper;
  return std::nullopt;
}

std::optional<AttributeDomain> domain_of(const std::string& name) {
  if (name == "chordlength") return AttributeDomain::Chordlength;
  if (name == "uniform") return AttributeDomain::Uniform;
  return std::nullopt;
}

std::optional<double> read_fullness(const std::string& text) {
  if (text.empty()) return std::nullopt;
  double fullness = 0;
  if (read_number(text, fullness) && fullness >= -1 && fullness <= 2) return fullness;
  throw Error(make_error(Category::Usage, "E_PARAMETER",
                         "'" + text + "' is no value for fullness: it takes a number from -1 to 2, such as 0.7.",
                         {{SubjectKind::Parameter, "fullness", {}, {}, {}}}));
}

}  // namespace

std::vector<ParameterDescription> surface_parameters() {
  return {
      choice_parameter("mode", {as_in_network, "smooth", "position", "paper"},
                       "How faces are blended: with common tangent planes at smooth curves, from positions alone, by "
                       "the paper's formulas, or as the network says of each.")
          .titled("Patches are", {"each as chosen", "smooth", "creased", "as published in 2006"}),
      choice_parameter("domain", {as_in_network, "chordlength", "uniform"},
                       "The polygon that a face is a map of: with its curves' lengths as sides, a regular one, or as "
                       "the network says of each.")
          .titled("Sides of patches", {"each as chosen", "as long as the curves", "all the same"})
          .at(ParameterPlace::Expert),
      text_parameter("fullness", "",
                     "How full smooth faces are, -1 to 2: 1 follows the slopes at the sides, 0 is flat; empty: as the "
                     "network says.")
          .at(ParameterPlace::Nowhere),
      integer_parameter("samples", 16, 1, 1024, "",
                        "Parts of each curve, and rings of triangles around the middle of each face.")
          .titled("Edges along a curve"),
      number_parameter("tolerance", 0, 0, 1e9, "model units",
                       "Greatest distance of the mesh from the surface: as few triangles as keep to it; 0: rings of "
                       "triangles.")
          .titled("Off the surface by at most")};
}

SurfaceSettings read_surface_settings(const ParameterValues& parameters, Quality quality) {
  SurfaceSettings settings;
  settings.surface.mode = mode_of(text_of(parameters, "mode"));
  settings.surface.domain = domain_of(text_of(parameters, "domain"));
  settings.surface.fullness = read_fullness(text_of(parameters, "fullness"));
  settings.tessellation.samples = static_cast<std::size_t>(integer_of(parameters, "samples"));
  if (quality == Quality::Draft) {
    settings.tessellation.samples = std::min(settings.tessellation.samples, draft_samples);
  } else if (const double tolerance = number_of(parameters, "tolerance"); tolerance > 0) {
    settings.tessellation.tolerance = tolerance;
  }
  return settings;
}

}  // namespace croquis
