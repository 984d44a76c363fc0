// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>
#include <mutex>
#include <string>
#include <utility>

#include "croquis/base/described.h"
#include "croquis/base/stage_key.h"
#include "croquis/document/content_hash.h"
#include "croquis/document/memo.h"
#include "croquis/subdivision/fairing.h"
#include "operators/operations.h"
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

struct FairSettings {
  FairingOptions options;
  double weight = 1;  ///< × the usual one
};

void list_fair_parameters(FairSettings& settings, ParameterList& list) {
  FairingOptions& options = settings.options;
  list.number("weight", settings.weight, 1e-4, 1e4, "/ (median edge length)²",
              "How much the points are held back: low values make the surface fairer, high ones leave it.")
      .titled("Hold back", {"smooth", "unchanged"});
  list.integer("levels", options.levels, 0, 4, "", "Level of subdivision at which the bending is measured.")
      .titled("Level that is looked at")
      .at(ParameterPlace::Expert);
  list.choice("chains", options.fair_chains, {"hold", "fair"},
              "The points of sharp edges hold, or are evened out along their chains.")
      .titled("Sharp edges", {"stay", "are evened out"});
  list.choice_of("planes", 0, {"keep", "free"},
                 "Flat faces beside sharp edges and flat chains keep their planes, or not.",
                 [&](std::size_t chosen) { options.keep_planes = chosen == 0; })
      .titled("Flat faces", {"stay flat", "may bend"});
  list.choice_of("preset", 0, {"refined", "paper"}, "Rules of the Doo-Sabin surface.",
                 [&](std::size_t preset) { options.rules = Rules::of(static_cast<Preset>(preset)); })
      .titled("Quality", {"refined", "as published in 2002"})
      .at(ParameterPlace::Expert);
}

ContentHash hash_of(const std::shared_ptr<const PolyMesh>& mesh, const FairingOptions& options) {
  ContentHasher hasher;
  hasher.add("fair/1");
  hasher.add(content_hash(Value(mesh)));
  hasher.add(StageKey().add(options).bytes());
  return hasher.digest();
}

OperationResult compute_fair(const Values& inputs, FairSettings settings, Context& context) {
  OperationResult result;
  const auto mesh = tagged_cage(inputs, result.warnings);
  const FairingOptions& options = settings.options;
  Progress preparing = context.progress.step("prepare", 0.6);
  const auto make = [&] { return KeptFairing{.fairing = std::make_unique<Fairing>(*mesh, options, preparing)}; };
  const auto kept = memoized<KeptFairing>(context.memo, hash_of(mesh, options), make,
                                          [&](const KeptFairing&) { return byte_size_of(*mesh, options); });
  Progress solving = context.progress.step("solve", 0.4);
  const std::lock_guard lock(*kept->mutex);
  Fairing& fairing = *kept->fairing;
  const double weight = settings.weight * fairing.default_weight();
  FairCage fair = fairing.solve(weight, solving);
  result.warnings.insert(result.warnings.end(), fairing.warnings().begin(), fairing.warnings().end());
  result.outputs["details"] = std::make_shared<const Report>(
      to_report(fields(named("free_points", fairing.free_point_count()), named("weight", weight),
                       named("energy_before", fair.energy_before), named("energy", fair.energy),
                       named("greatest_move", fair.greatest_move), named("mean_move", fair.mean_move))));
  result.outputs["mesh"] = std::make_shared<const PolyMesh>(std::move(fair.mesh));
  context.progress.report(1);
  return result;
}

}  // namespace

std::unique_ptr<const Operation> fair_operation() {
  return operation_of(
      {"fair",
       1,
       "Even Out",
       "Moves the points of a cage so that its Doo-Sabin surface bends less and more evenly.",
       {{"cage", ValueType::Mesh, "Polygons with their tags; pins, boundaries and sharp edges hold."}, tags_input()},
       {{"mesh", ValueType::Mesh, "The cage with moved points, and its tags."},
        {"details", ValueType::Report, "How far points moved, and how much less the surface bends."}}},
      list_fair_parameters, compute_fair);
}

}  // namespace croquis
