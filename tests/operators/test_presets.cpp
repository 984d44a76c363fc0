// SPDX-License-Identifier: GPL-3.0-or-later
// A value that is given counts, also where it equals the default; presets set what isn't given.
#include <map>
#include <string>
#include <utility>

#include <catch2/catch.hpp>

#include "croquis/base/error.h"
#include "croquis/document/content_hash.h"
#include "croquis/operators/all_operations.h"
#include "support/meshes/cages.h"
#include "support/scans/scans.h"
#include "support/sketches/sketch_errors.h"

namespace croquis {
namespace {

template <typename Content>
Value shared(Content content) {
  return std::make_shared<const Content>(std::move(content));
}

/// A cage with a chain that ends in it, and with boundary corners.
PolyMesh open_cage() {
  PolyMesh cage = test::bolt_open_chain();
  const auto first = static_cast<Index>(cage.vertex_count());
  for (const Vec3& corner : {Vec3(9, 0, 0), Vec3(11, 0, 0), Vec3(11, 1, 0), Vec3(10, 2, 1), Vec3(9, 1, 0)})
    cage.positions.push_back(corner);
  const std::array<Index, 5> corners = {first, first + 1, first + 2, first + 3, first + 4};
  cage.add_face(corners);
  return cage;
}

/// What each operation with presets works on: an input on which every parameter of theirs shows.
std::map<std::string, Values> inputs_by_operation() {
  const Values drawing{{"drawing", shared(test::error_sketch("E_CROSS").drawing)}};
  return {{"fill", {{"scan", shared(test::random_cuts(test::round_sphere(2), 7, 2, 0.25, 0.3).mesh)}}},
          {"inflate", drawing},
          {"cage", drawing},
          {"subdivide", {{"cage", shared(open_cage())}}}};
}

/// Distinguishes results: the mesh's hash, or the codes of why there is none.
std::string outcome_of(const Operation& operation, const Values& inputs, ParameterValues parameters) {
  Progress progress;
  Context context{progress};
  try {
    const ContentHash hash = content_hash(run(operation, inputs, std::move(parameters), context).outputs.at("mesh"));
    return std::to_string(hash.high) + ' ' + std::to_string(hash.low);
  } catch (const Error& error) {
    std::string codes;
    for (const Finding& finding : error.findings()) codes += finding.code + ' ';
    return codes;
  }
}

/// Where the values of presets count: fill has two modes.
std::vector<ParameterValues> modes_of(const OperationDescription& operation) {
  if (operation.id != "fill") return {{}};
  return {{{"mode", std::string("patch")}}, {{"mode", std::string("remesh")}}};
}

TEST_CASE("a default that is given beside a preset has the effect of the given value, in every operation") {
  const Registry registry = all_operations();
  const std::map<std::string, Values> all_inputs = inputs_by_operation();
  std::size_t compared = 0;
  for (const auto& operation : registry.operations()) {
    const OperationDescription description = operation->describe();
    for (const ParameterDescription& chosen : description.parameters) {
      for (const auto& [preset, set] : chosen.presets) {
        const Values& inputs = all_inputs.at(description.id);
        for (const auto& [name, value] : set) {
          const ParameterValue& plain = find_parameter(description.parameters, name)->default_value;
          if (value == plain) continue;
          INFO(description.id << " " << preset << " " << name);
          bool shows = false;
          for (ParameterValues parameters : modes_of(description)) {
            parameters[chosen.name] = preset;
            const std::string by_preset = outcome_of(*operation, inputs, parameters);
            ParameterValues told = parameters, other = parameters;
            told[name] = value;
            CHECK(outcome_of(*operation, inputs, told) == by_preset);
            other[name] = plain;
            shows = shows || outcome_of(*operation, inputs, other) != by_preset;
          }
          CHECK(shows);
          ++compared;
        }
      }
    }
  }
  CHECK(compared == 8);
}

TEST_CASE("what a mode doesn't look at is told where it was given, and not where a preset set it") {
  const Registry registry = all_operations();
  const Values inputs = inputs_by_operation().at("fill");
  const auto unused = [&](ParameterValues parameters) {
    Progress progress;
    Context context{progress};
    std::size_t count = 0;
    for (const Finding& finding : run(*registry.find("fill"), inputs, std::move(parameters), context).warnings)
      count += finding.code == "W_PARAMETER_UNUSED" ? finding.subjects.size() : 0;
    return count;
  };
  CHECK(unused({{"preset", std::string("sharp")}}) == 0);
  CHECK(unused({{"preset", std::string("sharp")}, {"cell", 1.0}, {"refine", std::int64_t{1}}}) == 2);
  CHECK(unused({{"preset", std::string("paper")}, {"mode", std::string("remesh")}, {"bulge", 0.1}}) == 1);
}

}  // namespace
}  // namespace croquis
