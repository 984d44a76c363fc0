// SPDX-License-Identifier: GPL-3.0-or-later
#include "operators/fill_operation.h"

#include <string>
#include <utility>

#include "croquis/document/content_hash.h"
#include "croquis/hole_filling/hole_choice.h"
#include "operators/fill_report.h"
#include "operators/fill_settings.h"
#include "operators/memo_stage_cache.h"

namespace croquis {
namespace {

using namespace hole_filling;
using namespace remeshing;

/// What filling would begin with: nothing is made, and the mesh stays as it is.
OperationResult list_holes(std::shared_ptr<const PolyMesh> scan, const FillOptions& options, Progress& progress) {
  HoleAnalysis analysis = analyse_holes(*scan, progress, options.analysis);
  const HoleChoice choice = choose_holes(analysis.holes, options);
  OperationResult result;
  result.outputs["details"] = std::make_shared<const Report>(list_details(*scan, analysis.holes, choice));
  result.outputs["rims"] = std::make_shared<const PolyMesh>(rim_lines(*scan, analysis.holes));
  result.outputs["mesh"] = std::move(scan);
  result.warnings = std::move(analysis.warnings);
  return result;
}

/// @param made a FillResult or RemeshResult, whose mesh and warnings are taken
template <typename Result>
OperationResult outputs_of(const PolyMesh& scan, Result& made, Report details) {
  OperationResult result;
  result.outputs["details"] = std::make_shared<const Report>(std::move(details));
  result.outputs["rims"] = std::make_shared<const PolyMesh>(rim_lines(scan, made.analysis.holes));
  result.outputs["mesh"] = std::make_shared<const PolyMesh>(std::move(made.mesh));
  result.warnings = std::move(made.warnings);
  return result;
}

/// Distinguishes the scan from all others in the memo.
std::string key_of(const std::shared_ptr<const PolyMesh>& scan) {
  const ContentHash hash = content_hash(Value(scan));
  return std::to_string(hash.high) + ' ' + std::to_string(hash.low);
}

OperationResult patch_holes(const std::shared_ptr<const PolyMesh>& scan, const FillSettings& settings,
                            Context& context) {
  FillOptions options = settings.options.fill;
  options.threads = context.threads;
  MemoStageCache cache(context.memo);
  if (context.memo != nullptr) {
    options.cache = &cache;
    options.scan_key = key_of(scan);
  }
  FillResult filled = fill_holes(*scan, options, context.progress);
  return outputs_of(*scan, filled, fill_details(*scan, filled));
}

OperationResult remesh_scan(const PolyMesh& scan, const FillSettings& settings, Context& context) {
  RemeshOptions options = settings.options;
  options.fill.threads = context.threads;
  RemeshResult made = remesh_surface(scan, options, context.progress);
  return outputs_of(scan, made, remesh_details(made));
}

}  // namespace

OperationDescription FillOperation::describe() const {
  PortDescription scan{"scan", ValueType::Mesh, "Any mesh, dirty ones too; it isn't changed."};
  scan.is_raw = true;
  PortDescription mesh{"mesh", ValueType::Mesh,
                       "The scan's vertices and faces, then those of the patches, or the model remeshed: faces tell "
                       "theirs by patch_id, vertices "
                       "how well the surface around backs them by confidence."};
  mesh.counts_self_intersections = true;
  return {
      "fill",
      1,
      "Fill Holes",
      "Closes the holes of a scan by patches that continue the surface and leaves everything else as it is, or "
      "remeshes "
      "the whole model.",
      {std::move(scan)},
      {std::move(mesh),
       {"rims", ValueType::Mesh, "The rims of the scan's holes as closed polylines, in the order of their numbers."},
       {"details", ValueType::Report, "Every hole with its measures and what became of it."}},
      fill_parameters(),
      "list"};
}

OperationResult FillOperation::compute(const Values& inputs, const ParameterValues& parameters,
                                       Context& context) const {
  const auto& scan = std::get<std::shared_ptr<const PolyMesh>>(inputs.at("scan"));
  const FillSettings settings = read_fill_settings(parameters);
  OperationResult result = settings.list_only ? list_holes(scan, settings.options.fill, context.progress)
                           : settings.remesh  ? remesh_scan(*scan, settings, context)
                                              : patch_holes(scan, settings, context);
  result.warnings.insert(result.warnings.begin(), settings.warnings.begin(), settings.warnings.end());
  return result;
}

}  // namespace croquis
