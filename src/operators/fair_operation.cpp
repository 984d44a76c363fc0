// SPDX-License-Identifier: GPL-3.0-or-later
#include "operators/fair_operation.h"

#include <memory>
#include <mutex>
#include <string>
#include <utility>

#include "croquis/base/stage_key.h"
#include "croquis/document/content_hash.h"
#include "croquis/document/memo.h"
#include "croquis/io/mesh_tags_file.h"
#include "croquis/operators/fair_result.h"
#include "croquis/subdivision/fairing.h"
#include "operators/subdivide_tags.h"

namespace croquis {
namespace {

using namespace subdivision;

/// What a weight doesn't change, shared by all evaluations that drag the slider: one of them solves at a time.
struct KeptFairing {
  std::unique_ptr<std::mutex> mutex = std::make_unique<std::mutex>();
  std::unique_ptr<Fairing> fairing;
};

/// Rows of the finest level, a dozen weights each, and their factorisation.
std::size_t byte_size_of(const PolyMesh& mesh, const FairingOptions& options) {
  constexpr std::size_t bytes_per_point = 1000;
  return bytes_per_point * mesh.vertex_count() * (std::size_t{1} << (2 * options.levels));
}

FairingOptions read_options(const ParameterValues& parameters) {
  FairingOptions options;
  const bool paper = text_of(parameters, "preset") == "paper";
  options.rules = Rules::of(paper ? Preset::Paper : Preset::Refined);
  options.levels = static_cast<int>(integer_of(parameters, "levels"));
  options.fair_chains = text_of(parameters, "chains") == "fair";
  options.keep_planes = text_of(parameters, "planes") == "keep";
  return options;
}

ContentHash hash_of(const std::shared_ptr<const PolyMesh>& mesh, const FairingOptions& options) {
  ContentHasher hasher;
  hasher.add("fair/1");
  hasher.add(content_hash(Value(mesh)));
  hasher.add(StageKey().add(options).bytes());
  return hasher.digest();
}

Report to_report(const FairResult& result) {
  Report details;
  details.set("free_points", result.free_points)
      .set("weight", result.weight)
      .set("energy_before", result.energy_before)
      .set("energy", result.energy)
      .set("greatest_move", result.greatest_move)
      .set("mean_move", result.mean_move);
  return details;
}

/// The cage with the tags of the other input, where that is there.
std::shared_ptr<const PolyMesh> tagged_cage(const Values& inputs, Findings& warnings) {
  const auto cage = inputs.at("cage").as<PolyMesh>();
  const auto tags = inputs.find("tags");
  if (tags == inputs.end()) return cage;
  MeshTagsReadResult read = read_mesh_tags(tags->second.get<Report>());
  warnings = std::move(read.warnings);
  PolyMesh mesh = *cage;
  mesh.tags = united_tags(mesh.tags, read.tags);
  return std::make_shared<const PolyMesh>(std::move(mesh));
}

}  // namespace

OperationDescription FairOperation::describe() const {
  const FairingOptions defaults;
  return {
      "fair",
      1,
      "Even Out",
      "Moves the points of a cage so that its Doo-Sabin surface bends less and more evenly.",
      {{"cage", ValueType::Mesh, "Polygons with their tags; pins, boundaries and sharp edges hold."},
       {"tags", ValueType::Report,
        "Sharp edges and pins (croquis-tags-1), added to the cage's own; of two tags of an edge these count.", false,
        true}},
      {{"mesh", ValueType::Mesh, "The cage with moved points, and its tags."},
       {"details", ValueType::Report, "How far points moved, and how much less the surface bends."}},
      {number_parameter("weight", 1, 1e-4, 1e4, "/ (median edge length)²",
                        "How much the points are held back: low values make the surface fairer, high ones leave it.")
           .titled("Hold back"),
       integer_parameter("levels", defaults.levels, 0, 4, "", "Level of subdivision at which the bending is measured.")
           .titled("Level that is looked at")
           .at(ParameterPlace::Expert),
       choice_parameter("chains", {"hold", "fair"},
                        "The points of sharp edges hold, or are evened out along their chains.")
           .titled("Sharp edges", {"stay", "are evened out"}),
       choice_parameter("planes", {"keep", "free"},
                        "Flat faces beside sharp edges and flat chains keep their planes, or not.")
           .titled("Flat faces", {"stay flat", "may bend"}),
       choice_parameter("preset", {"refined", "paper"}, "Rules of the Doo-Sabin surface.")
           .titled("Quality", {"refined", "as published in 2002"})
           .at(ParameterPlace::Expert)}};
}

OperationResult FairOperation::compute(const Values& inputs, const ParameterValues& parameters,
                                       Context& context) const {
  OperationResult result;
  const auto mesh = tagged_cage(inputs, result.warnings);
  const FairingOptions options = read_options(parameters);
  Progress preparing = context.progress.step("prepare", 0.6);
  const auto make = [&] { return KeptFairing{.fairing = std::make_unique<Fairing>(*mesh, options, preparing)}; };
  const auto kept = memoized<KeptFairing>(context.memo, hash_of(mesh, options), make,
                                          [&](const KeptFairing&) { return byte_size_of(*mesh, options); });
  Progress solving = context.progress.step("solve", 0.4);
  const std::lock_guard lock(*kept->mutex);
  Fairing& fairing = *kept->fairing;
  const double weight = number_of(parameters, "weight") * fairing.default_weight();
  FairCage fair = fairing.solve(weight, solving);
  result.warnings.insert(result.warnings.end(), fairing.warnings().begin(), fairing.warnings().end());
  const FairResult details{fairing.free_point_count(), weight,        fair.energy_before, fair.energy,
                           fair.greatest_move,         fair.mean_move};
  result.outputs["details"] = std::make_shared<const Report>(to_report(details));
  result.details = details;
  result.outputs["mesh"] = std::make_shared<const PolyMesh>(std::move(fair.mesh));
  context.progress.report(1);
  return result;
}

}  // namespace croquis
