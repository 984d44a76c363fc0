// SPDX-License-Identifier: GPL-3.0-or-later
#include "operators/subdivide_settings.h"

#include <numbers>
#include <string>

#include "operators/choice_parameter.h"

namespace croquis {
namespace {

using namespace subdivision;

constexpr int most_levels = 10;

ParameterDescription flag(const std::string& name, const std::string& sentence) {
  return {name, ParameterType::Flag, false, 0, 0, {}, "", sentence};
}

/// The preset's rules, except where a parameter sets another value.
Rules read_rules(const ParameterValues& parameters) {
  Rules rules = Rules::of(text_of(parameters, "preset") == "paper" ? Preset::Paper : Preset::Refined);
  const std::string& weights = text_of(parameters, "weights");
  if (weights == "classical") rules.weights = Weights::Classical;
  if (weights == "average") rules.weights = Weights::Average;
  const std::string& profile = text_of(parameters, "profile");
  if (profile == "clamped") rules.profile = Profile::Clamped;
  if (profile == "plain") rules.profile = Profile::Plain;
  const std::string& ends = text_of(parameters, "chain-ends");
  if (ends == "smooth") rules.chain_ends = ChainEnds::Smooth;
  if (ends == "retract") rules.chain_ends = ChainEnds::Retract;
  if (ends == "pin") rules.chain_ends = ChainEnds::Pin;
  const std::string& corners = text_of(parameters, "boundary-corners");
  if (corners == "corner") rules.boundary_corners = BoundaryCorners::Corner;
  if (corners == "smooth") rules.boundary_corners = BoundaryCorners::Smooth;
  return rules;
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
  return {choice("scheme", {"doo-sabin", "catmull-clark", "loop"},
                 "Rules of refinement; loop cuts polygons into triangles first."),
          choice("preset", {"refined", "paper"},
                 "refined for round faces and smooth ends of chains, paper for Lee, Joo, Hong 2002; doo-sabin only."),
          choice("weights", {"preset", "classical", "average"}, "How the corners of a face weigh in its new points."),
          choice("profile", {"preset", "clamped", "plain"},
                 "Rows of faces beside a chain: clamped halves them at each level, plain keeps three quarters."),
          choice("chain-ends", {"preset", "smooth", "retract", "pin"},
                 "Where a chain of sharp edges ends in a surface: it runs out, draws back, or stays."),
          choice("boundary-corners", {"preset", "corner", "smooth"},
                 "Boundary vertices with a single face stay, or are rounded with the boundary."),
          {"levels",
           ParameterType::Integer,
           std::int64_t{defaults.plan.levels},
           0,
           most_levels,
           {},
           "",
           "How often the cage is refined; each level has about four times the faces."},
          {"sharp-angle",
           ParameterType::Number,
           0.0,
           0,
           180,
           {},
           "degrees",
           "Edges without a tag become sharp where faces meet at more than this; 0 for none."},
          {"keep-kinks",
           ParameterType::Number,
           180.0,
           0,
           180,
           {},
           "degrees",
           "Chains that turn by more than this at a vertex of the cage keep a corner there; 180 for none."},
          flag("limit", "Move the vertices to where they would end after endless refinement."),
          flag("provenance", "Attach to faces and vertices which element of the cage they come from; doo-sabin only.")};
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
