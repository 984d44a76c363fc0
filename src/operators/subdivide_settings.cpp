// SPDX-License-Identifier: GPL-3.0-or-later
#include "operators/subdivide_settings.h"

#include <array>
#include <numbers>
#include <string>
#include <utility>

#include "operators/choice_parameter.h"

namespace croquis {
namespace {

using namespace subdivision;

constexpr int most_levels = 10;

/// A rule of which presets have a value of their own.
template <std::size_t size>
ParameterDescription rule(const std::string& name, const std::array<const char*, size>& choices,
                          const std::string& sentence, const std::string& title, std::vector<std::string> words) {
  words.emplace_back("as the quality");
  return choice_or_preset(name, choices, sentence).titled(title, std::move(words)).at(ParameterPlace::Expert);
}

// In the order of the enumerations that they stand for.
constexpr std::array<const char*, 2> weights_names = {"classical", "average"};
constexpr std::array<const char*, 2> profile_names = {"clamped", "plain"};
constexpr std::array<const char*, 3> chain_ends_names = {"smooth", "retract", "pin"};
constexpr std::array<const char*, 2> boundary_corners_names = {"corner", "smooth"};

Rules read_rules(const ParameterValues& parameters) {
  return {named<Weights>(weights_names, text_of(parameters, "weights")),
          named<Profile>(profile_names, text_of(parameters, "profile")),
          named<ChainEnds>(chain_ends_names, text_of(parameters, "chain-ends")),
          named<BoundaryCorners>(boundary_corners_names, text_of(parameters, "boundary-corners"))};
}

ParameterDescription subdivide_preset_choice() {
  ParameterDescription preset =
      choice_parameter("preset", {"refined", "paper"},
                       "refined for round faces and smooth ends of chains, paper for Lee, Joo, Hong 2002; doo-sabin "
                       "only.")
          .titled("Quality", {"refined", "as published in 2002"});
  const Rules paper = Rules::of(Preset::Paper);
  const auto name = [](const auto& names, auto value) { return std::string(names[static_cast<std::size_t>(value)]); };
  preset.presets["paper"] = {{"weights", name(weights_names, paper.weights)},
                             {"profile", name(profile_names, paper.profile)},
                             {"chain-ends", name(chain_ends_names, paper.chain_ends)},
                             {"boundary-corners", name(boundary_corners_names, paper.boundary_corners)}};
  return preset;
}

}  // namespace

const char* to_string(SubdivisionScheme scheme) {
  switch (scheme) {
    case SubdivisionScheme::DooSabin: return "doo-sabin";
    case SubdivisionScheme::CatmullClark: return "catmull-clark";
    case SubdivisionScheme::Loop: return "loop";
  }
  return "";
}

std::vector<ParameterDescription> subdivide_parameters() {
  const SubdivideSettings defaults;
  return {
      choice_parameter("scheme", {"doo-sabin", "catmull-clark", "loop"},
                       "Rules of refinement; loop cuts polygons into triangles first.")
          .titled("Smoothing", {"Soft (Doo-Sabin)", "Standard (Catmull-Clark)", "Triangles (Loop)"}),
      subdivide_preset_choice(),
      rule("weights", weights_names, "How the corners of a face weigh in its new points.", "Corners of faces",
           {"classical", "all the same"}),
      rule("profile", profile_names,
           "Rows of faces beside a chain: clamped halves them at each level, plain keeps three quarters.",
           "Beside sharp edges", {"half as wide", "three quarters as wide"}),
      rule("chain-ends", chain_ends_names,
           "Where a chain of sharp edges ends in a surface: it runs out, draws back, or stays.", "Ends of sharp edges",
           {"run out", "draw back", "stay"}),
      rule("boundary-corners", boundary_corners_names,
           "Boundary vertices with a single face stay, or are rounded with the boundary.", "Corners of borders",
           {"stay", "rounded"}),
      integer_parameter("levels", defaults.plan.levels, 0, most_levels, "",
                        "How often the cage is refined; each level has about four times the faces.")
          .titled("Level"),
      number_parameter("sharp-angle", 0, 0, 180, "degrees",
                       "Edges without a tag become sharp where faces meet at more than this; 0 for none.")
          .titled("Sharp above"),
      number_parameter("keep-kinks", 180, 0, 180, "degrees",
                       "Chains that turn by more than this at a vertex of the cage keep a corner there; 180 for none.")
          .titled("Corners of sharp edges above")
          .at(ParameterPlace::Expert),
      flag_parameter("limit", false, "Move the vertices to where they would end after endless refinement.")
          .titled("On the final surface")
          .at(ParameterPlace::Expert),
      flag_parameter("provenance", false,
                     "Attach to faces and vertices which element of the cage they come from; doo-sabin only.")
          .at(ParameterPlace::Nowhere)};
}

SubdivideSettings read_subdivide_settings(const ParameterValues& parameters) {
  SubdivideSettings settings;
  const std::string& scheme = text_of(parameters, "scheme");
  if (scheme == "catmull-clark") settings.plan.scheme = SubdivisionScheme::CatmullClark;
  if (scheme == "loop") settings.plan.scheme = SubdivisionScheme::Loop;
  settings.plan.rules = read_rules(parameters);
  settings.plan.levels = static_cast<int>(integer_of(parameters, "levels"));
  settings.sharp_angle = number_of(parameters, "sharp-angle") * std::numbers::pi / 180;
  settings.keep_kinks = number_of(parameters, "keep-kinks") * std::numbers::pi / 180;
  settings.limit = flag_of(parameters, "limit");
  settings.provenance = flag_of(parameters, "provenance");
  return settings;
}

}  // namespace croquis
