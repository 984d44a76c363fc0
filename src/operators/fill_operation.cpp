// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>
#include <span>
#include <string>
#include <utility>

#include "croquis/document/content_hash.h"
#include "croquis/hole_filling/hole_choice.h"
#include "operators/fill_report.h"
#include "operators/fill_settings.h"
#include "operators/memo_stage_cache.h"
#include "operators/operations.h"

namespace croquis {
namespace {

using hole_filling::FillOptions;
using hole_filling::Hole;
using hole_filling::HoleAnalysis;
using remeshing::RemeshOptions;
using remeshing::RemeshResult;

OperationResult outputs_of(std::span<const Hole> holes, FillResult details, std::shared_ptr<const PolyMesh> mesh,
                           Findings warnings) {
  OperationResult result;
  result.outputs["details"] = std::make_shared<const Report>(to_report(details));
  result.outputs["rims"] = std::make_shared<const PolyMesh>(rim_lines(*details.scan, holes));
  result.outputs["mesh"] = std::move(mesh);
  result.warnings = std::move(warnings);
  result.details = std::move(details);
  return result;
}

/// What filling would begin with: nothing is made, and the mesh stays as it is.
OperationResult list_holes(const std::shared_ptr<const PolyMesh>& scan, const FillOptions& options,
                           Progress& progress) {
  HoleAnalysis analysis = hole_filling::analyse_holes(*scan, progress, options.analysis);
  FillResult details = result_of_listing(scan, analysis, choose_holes(analysis.holes, options));
  return outputs_of(analysis.holes, std::move(details), scan, std::move(analysis.warnings));
}

/// @param made by the algorithm; its mesh and warnings are taken
template <typename Made>
OperationResult outputs_of(Made& made, FillResult details) {
  auto mesh = std::make_shared<const PolyMesh>(std::move(made.mesh));
  return outputs_of(made.analysis.holes, std::move(details), std::move(mesh), std::move(made.warnings));
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
  hole_filling::FillResult filled = hole_filling::fill_holes(*scan, options, context.progress);
  FillResult details = result_of_filling(scan, filled);
  return outputs_of(filled, std::move(details));
}

OperationResult remesh_scan(const std::shared_ptr<const PolyMesh>& scan, const FillSettings& settings,
                            Context& context) {
  RemeshOptions options = settings.options;
  options.fill.threads = context.threads;
  RemeshResult made = remeshing::remesh_surface(*scan, options, context.progress);
  FillResult details = result_of_remeshing(scan, made);
  return outputs_of(made, std::move(details));
}

OperationResult compute_fill(const Values& inputs, const ParameterValues& parameters, Context& context) {
  const auto scan = inputs.at("scan").as<PolyMesh>();
  const FillSettings settings = read_fill_settings(parameters);
  OperationResult result = settings.list_only ? list_holes(scan, settings.options.fill, context.progress)
                           : settings.remesh  ? remesh_scan(scan, settings, context)
                                              : patch_holes(scan, settings, context);
  if (settings.list_only) return result;
  const Findings unused = unused_parameters(parameters);
  result.warnings.insert(result.warnings.begin(), unused.begin(), unused.end());
  return result;
}

}  // namespace

std::unique_ptr<const Operation> fill_operation() {
  OperationDescription description{
      "fill",
      1,
      "Fill Holes",
      "Closes the holes of a scan by patches that continue the surface and leaves everything else as it is, or "
      "remeshes the whole model.",
      {{"scan", ValueType::Mesh, "Any mesh, dirty ones too; it isn't changed."}},
      {{"mesh", ValueType::Mesh,
        "The scan's vertices and faces, then those of the patches, or the model remeshed: patch_id is the "
        "patch of a face, confidence how well the surface around backs a vertex."},
       {"rims", ValueType::Mesh, "The rims of the scan's holes as closed polylines, in the order of their numbers."},
       {"details", ValueType::Report, "Every hole with its measures and what became of it."}},
      parameters_of(list_fill_parameters),
      "list"};
  description.inputs.front().is_raw = true;
  description.outputs.front().joins_seams = true;
  return std::make_unique<Operation>(std::move(description), compute_fill);
}

}  // namespace croquis
