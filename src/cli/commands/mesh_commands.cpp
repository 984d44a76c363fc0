// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>
#include <utility>

#include "cli/command.h"
#include "cli/files.h"
#include "cli/mesh_text.h"
#include "cli/solid_faults.h"
#include "croquis/base/error.h"
#include "croquis/base/parameter_list.h"

namespace croquis::cli {
namespace {

void run_info(const Invocation& invocation, CommandResult& result, Progress& progress) {
  Progress reading = progress.step("read", 0.4);
  const PolyMesh mesh = read_input_mesh(invocation, false, result, reading);
  Progress inspecting = progress.step("inspect", 0.6);
  result.mesh = inspect(mesh, flag_of(invocation.parameters, "self-intersections"), inspecting);
  result.text = mesh_text(*result.mesh);
  progress.report(1);
}

void run_check(const Invocation& invocation, CommandResult& result, Progress& progress) {
  Progress reading = progress.step("read", 0.3);
  const PolyMesh mesh = read_input_mesh(invocation, true, result, reading);
  Progress inspecting = progress.step("inspect", 0.7);
  result.mesh = inspect(mesh, true, inspecting);
  Findings found = solid_faults(*result.mesh, invocation.input);
  if (!found.empty()) throw Error(std::move(found));
  result.text = invocation.input + ": closed, manifold, oriented, free of self-intersections.";
  progress.report(1);
}

void list_convert_parameters(MeshWriteOptions& options, ParameterList& list) {
  list.integer("precision", options.precision, 0, 17, "significant digits",
               "Digits of numbers in text formats; 0 writes them so that they read back exactly.");
  list.flag("ascii", options.ascii, "Write PLY and STL as text.");
}

void run_convert(const Invocation& invocation, CommandResult& result, Progress& progress) {
  const MeshFormat format = output_mesh_format(invocation.output, invocation.output_format);
  Progress reading = progress.step("read", 0.6);
  const PolyMesh mesh = read_input_mesh(invocation, false, result, reading);
  const auto options = settings_of(list_convert_parameters, invocation.parameters);
  Progress writing = progress.step("write", 0.4);
  stage_mesh(invocation.output, mesh, options, format, result, writing);
  const bool for_printing = format == MeshFormat::Stl && mesh.face_count() > 0;
  if (invocation.json || for_printing) {  // counting a large mesh takes longer than converting it
    Progress inspecting;
    result.mesh = inspect(as_written(mesh, format, options), false, inspecting);
    warn_of_faults(invocation.output, for_printing, result);
  }
  progress.report(1);
}

}  // namespace

Command info_command() {
  return {{.name = "info",
           .sentence = "Shows what a mesh file holds: counts, topology, area, volume, bounds.",
           .parameters = {flag_parameter("self-intersections", false, "Count pairs of faces that intersect as well.")},
           .examples = {"croquis-cli info model.obj", "croquis-cli info --json --self-intersections scan.ply"}},
          run_info};
}

Command check_command() {
  return {
      {.name = "check",
       .sentence = "Succeeds only if a mesh is closed, manifold, oriented and free of self-intersections.",
       .parameters = {flag_parameter("self-intersections", true,
                                     "Always counted here; accepted so that info and check take the same options.")},
       .examples = {"croquis-cli check model.obj"}},
      run_check};
}

Command convert_command() {
  return {{.name = "convert",
           .sentence = "Converts a mesh between OBJ, PLY, STL, OFF and GLB.",
           .output = OutputNeed::Required,
           .parameters = parameters_of(list_convert_parameters),
           .examples = {"croquis-cli convert model.obj -o model.stl",
                        "croquis-cli convert model.obj -o - --output-format ply > model.ply"}},
          run_convert};
}

}  // namespace croquis::cli
