// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/solid_files.h"

#include <algorithm>
#include <filesystem>
#include <memory>
#include <numbers>
#include <utility>

#include "cli/files.h"
#include "croquis/base/described.h"
#include "croquis/base/error.h"
#include "croquis/geometry/perspective_drawing.h"
#include "croquis/perspective/bicubic_fit.h"
#include "step/step_file.h"

namespace croquis::cli {
namespace {

std::shared_ptr<const Brep> solid_of(const Values& outputs) {
  for (const auto& [name, value] : outputs) {
    if (const auto brep = value.as<Brep>()) return brep;
  }
  return nullptr;
}

std::string unit_of(const Values& inputs) {
  for (const auto& [name, value] : inputs) {
    const auto drawing = value.as<PerspectiveDrawing>();
    if (drawing && length_unit_named(drawing->unit)) return drawing->unit;
  }
  return "mm";
}

/// The ids that the report's faces have.
std::vector<std::string> face_names(const CommandResult& result) {
  std::vector<std::string> names;
  const Report* faces = result.details ? result.details->find("faces") : nullptr;
  if (faces == nullptr) return names;
  for (const Report& face : faces->as_array()) names.push_back(face.at("id").as_string());
  return names;
}

Report fit_report(const BicubicFit& fit) {
  return to_report(fields(named("u_knots", fit.spline.u_knots), named("v_knots", fit.spline.v_knots),
                          named("points", fit.spline.points), named("error", fit.error),
                          named("angle_degrees", fit.angle * 180 / std::numbers::pi),
                          named("within_tolerance", fit.within)));
}

}  // namespace

bool has_exact_solid(const OperationDescription& description) {
  return std::ranges::find(description.outputs, ValueType::Brep, &PortDescription::type) != description.outputs.end();
}

bool writes_step(const OperationDescription& description, const Invocation& invocation) {
  const std::string& named = invocation.output_format;
  if (!has_exact_solid(description) || !is_step_path(named.empty() ? invocation.output : "." + named)) return false;
  if (const std::string why = why_no_step(); !why.empty()) throw Error(make_error(Category::Usage, "E_NO_STEP", why));
  return true;
}

void stage_step(const Invocation& invocation, const Values& inputs, const Values& outputs, CommandResult& result,
                Progress& progress) {
  const std::string unit = unit_of(inputs);
  StepOptions options;
  options.unit = *length_unit_named(unit);
  options.face_names = face_names(result);
  const std::filesystem::path path = invocation.output == "-" ? invocation.input : invocation.output;
  if (path != "-") options.name = path.stem().string();
  StepFile file = write_step(*solid_of(outputs), options, progress);
  if (result.details)
    result.details->set("step", to_report(fields(named("unit", unit), named("faces", file.faces),
                                                 named("edges", file.edges), named("error", file.error))));
  stage_file(invocation.output, std::move(file.bytes), result);
}

Report with_fits(const Report& report, const Values& outputs, Progress& progress) {
  const std::shared_ptr<const Brep> brep = solid_of(outputs);
  const Report* patches = report.find("patches");
  if (!brep || patches == nullptr) return report;
  std::vector<const BicubicFit*> in_order;
  const std::vector<std::vector<BicubicFit>> fits = fit_patches(*brep, progress);
  for (const auto& face : fits) {
    for (const BicubicFit& fit : face) in_order.push_back(&fit);
  }
  Report fitted = Report::array();
  for (std::size_t k = 0; k < in_order.size(); ++k) {
    Report patch = patches->as_array().at(k);
    patch.set("bicubic", fit_report(*in_order[k]));
    fitted.push(std::move(patch));
  }
  Report result = report;
  result.set("patches", std::move(fitted));
  return result;
}

}  // namespace croquis::cli
