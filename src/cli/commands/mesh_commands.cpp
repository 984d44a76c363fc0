// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/commands/mesh_commands.h"

#include <string>
#include <utility>

#include "cli/files.h"
#include "cli/mesh_text.h"
#include "cli/solid_faults.h"
#include "croquis/base/error.h"

namespace croquis::cli {

CommandDescription InfoCommand::describe() const {
  CommandDescription description;
  description.name = "info";
  description.sentence = "Tells what a mesh file holds: counts, topology, area, volume, bounds.";
  description.parameters = {
      {"self-intersections", ParameterType::Flag, false, 0, 0, {}, "", "Count pairs of faces that intersect as well."}};
  description.examples = {"croquis-cli info model.obj", "croquis-cli info --json --self-intersections scan.ply"};
  return description;
}

void InfoCommand::run(const Invocation& invocation, CommandResult& result, Progress& progress) const {
  Progress reading = progress.step("read", 0.4);
  const PolyMesh mesh = read_input_mesh(invocation, false, result, reading);
  Progress inspecting = progress.step("inspect", 0.6);
  result.mesh = inspect(mesh, flag_of(invocation.parameters, "self-intersections"), inspecting);
  result.text = mesh_text(*result.mesh);
  progress.report(1);
}

CommandDescription CheckCommand::describe() const {
  CommandDescription description;
  description.name = "check";
  description.sentence = "Succeeds only if a mesh is closed, manifold, oriented and free of self-intersections.";
  description.examples = {"croquis-cli check model.obj"};
  description.parameters = {{"self-intersections",
                             ParameterType::Flag,
                             true,
                             0,
                             0,
                             {},
                             "",
                             "Always counted here; accepted so that info and check take the same options."}};
  return description;
}

void CheckCommand::run(const Invocation& invocation, CommandResult& result, Progress& progress) const {
  Progress reading = progress.step("read", 0.3);
  const PolyMesh mesh = read_input_mesh(invocation, true, result, reading);
  Progress inspecting = progress.step("inspect", 0.7);
  result.mesh = inspect(mesh, true, inspecting);
  Findings found = solid_faults(*result.mesh, invocation.input);
  if (!found.empty()) throw Error(std::move(found));
  result.text = invocation.input + ": closed, manifold, oriented, free of self-intersections.";
  progress.report(1);
}

CommandDescription ConvertCommand::describe() const {
  CommandDescription description;
  description.name = "convert";
  description.sentence = "Converts a mesh between OBJ, PLY, STL, OFF and GLB.";
  description.output = OutputNeed::Required;
  description.parameters = {{"precision",
                             ParameterType::Integer,
                             std::int64_t{0},
                             0,
                             17,
                             {},
                             "significant digits",
                             "Digits of numbers in text formats; 0 writes them so that they read back exactly."},
                            {"ascii", ParameterType::Flag, false, 0, 0, {}, "", "Write PLY and STL as text."}};
  description.examples = {"croquis-cli convert model.obj -o model.stl",
                          "croquis-cli convert model.obj -o - --output-format ply > model.ply"};
  return description;
}

void ConvertCommand::run(const Invocation& invocation, CommandResult& result, Progress& progress) const {
  const MeshFormat format = output_mesh_format(invocation.output, invocation.output_format);
  Progress reading = progress.step("read", 0.6);
  const PolyMesh mesh = read_input_mesh(invocation, false, result, reading);
  MeshWriteOptions options;
  options.precision = static_cast<int>(integer_of(invocation.parameters, "precision"));
  options.ascii = flag_of(invocation.parameters, "ascii");
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

}  // namespace croquis::cli
