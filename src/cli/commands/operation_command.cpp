// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cctype>
#include <cmath>
#include <numeric>
#include <optional>
#include <set>
#include <utility>
#include <variant>

#include "cli/command.h"
#include "cli/commands/alternatives.h"
#include "cli/commands/follow_ups.h"
#include "cli/files.h"
#include "cli/mesh_text.h"
#include "cli/report_table.h"
#include "cli/solid_faults.h"
#include "cli/solid_files.h"
#include "croquis/base/error.h"
#include "croquis/geometry/self_intersection.h"
#include "croquis/hole_filling/surface_view.h"
#include "croquis/io/attribute_network_file.h"
#include "croquis/io/camera_file.h"
#include "croquis/io/curve_network_file.h"
#include "croquis/io/json.h"
#include "croquis/io/svg_writer.h"
#include "step/step_file.h"

namespace croquis::cli {
namespace {

/// The report output that becomes `details`.
constexpr const char* details_output = "details";

/// Of raw inputs: what isn't finite is dropped instead of refused.
constexpr const char* drop_option = "drop-bad";

/// The parameter of operations that check their result as it will be stored, and its value for 32-bit numbers.
constexpr const char* precision_parameter = "precision";
constexpr const char* single_precision = "single";

/// The parameter of operations that refuse what would take more memory: --max-memory is a limit for them, too.
constexpr const char* memory_parameter = "memory-limit";

/// The parameter of operations that take near vertices for one, × the diagonal.
constexpr const char* weld_parameter = "weld";

/// The key in the details for self-intersections that the input didn't have.
constexpr const char* added_key = "added_self_intersections";

/// The flag of operations that mark the faces they make: only PLY files can hold the marks.
constexpr const char* marks_parameter = "patch-ids";

std::string upper_case(std::string word) {
  std::transform(word.begin(), word.end(), word.begin(), [](unsigned char c) { return std::toupper(c); });
  return word;
}

/// The outputs that get an option of their own: all but the first one, which is -o, and the report of the run.
std::vector<PortDescription> extra_outputs(const OperationDescription& description) {
  std::vector<PortDescription> extra;
  std::copy_if(description.outputs.begin() + 1, description.outputs.end(), std::back_inserter(extra),
               [](const PortDescription& port) { return port.name != details_output && has_files(port.type); });
  return extra;
}

/// The inputs that get an option of their own.
std::vector<PortDescription> extra_inputs(const OperationDescription& description) {
  std::vector<PortDescription> extra;
  std::copy_if(description.inputs.begin() + 1, description.inputs.end(), std::back_inserter(extra),
               [](const PortDescription& port) { return port.type == ValueType::Report; });
  return extra;
}

std::string text_option(const Invocation& invocation, const std::string& name) {
  return text_of(invocation.parameters, name);
}

/// A file with faults only in its faces could be read: only the result is missing.
Error without_result(const Error& error) {
  Findings findings = error.findings();
  const bool faces_alone = std::all_of(findings.begin(), findings.end(),
                                       [](const Finding& finding) { return finding.code == "E_FACE_DEGENERATE"; });
  if (!faces_alone) return error;
  for (Finding& finding : findings) finding.category = Category::Geometry;
  return Error(std::move(findings));
}

Value read_value(const PortDescription& port, const Invocation& invocation, CommandResult& result, Progress& progress) {
  if (port.type == ValueType::Drawing) {
    return std::make_shared<const Drawing>(read_input_drawing(invocation, result, progress));
  }
  if (port.type == ValueType::PerspectiveDrawing) {
    return std::make_shared<const PerspectiveDrawing>(read_input_perspective(invocation, result, progress));
  }
  if (port.type == ValueType::AttributeNetwork) {
    return std::make_shared<const AttributeNetwork>(read_input_network(invocation, result));
  }
  if (port.is_raw) {
    const bool drop = flag_of(invocation.parameters, drop_option);
    return std::make_shared<const PolyMesh>(drop ? read_finite_mesh(invocation, result, progress)
                                                 : read_input_mesh(invocation, true, result, progress));
  }
  try {
    return std::make_shared<const PolyMesh>(read_input_mesh(invocation, true, result, progress));
  } catch (const Error& error) {
    throw without_result(error);
  }
}

Values read_values(const OperationDescription& description, const Invocation& invocation, CommandResult& result,
                   Progress& progress) {
  Values values;
  const PortDescription& main_input = description.inputs.front();
  values[main_input.name] = read_value(main_input, invocation, result, progress);
  for (const PortDescription& port : extra_inputs(description)) {
    const std::string path = text_option(invocation, port.name);
    if (!path.empty()) values[port.name] = std::make_shared<const Report>(read_report(path));
  }
  return values;
}

/// How many vanishing points of a camera aren't at infinity: 1, 2 or 3.
int finite_vanishing_points(const Camera& camera) {
  constexpr double parallel = 1e-9;  // of an axis and the picture, radians
  int count = 0;
  for (int axis = 0; axis < 3; ++axis) count += std::abs(camera.rotation(2, axis)) > parallel ? 1 : 0;
  return count;
}

/// One output to its file.
struct Destination {
  std::string path;
  std::string format;              ///< asked for, where the path has no known extension
  const Camera* camera = nullptr;  ///< that was found with it, in a world whose z axis points up
};

/// The camera among the outputs of an operation, or null.
const Camera* camera_among(const Values& outputs) {
  for (const auto& [port, value] : outputs) {
    if (const auto camera = value.as<Camera>()) return camera.get();
  }
  return nullptr;
}

void stage_value(const PortDescription& port, const Value& value, const Destination& destination, CommandResult& result,
                 Progress& progress) {
  if (const auto drawing = value.as<Drawing>()) {
    stage_file(destination.path, write_svg_drawing(*drawing), result);
  } else if (const auto mesh = value.as<PolyMesh>()) {
    const MeshFormat format = output_mesh_format(destination.path, destination.format);
    MeshWriteOptions options;
    if (destination.camera != nullptr) options.camera = *destination.camera;
    options.z_up = destination.camera != nullptr;
    stage_mesh(destination.path, *mesh, options, format, result, progress);
    if (port.is_solid) judge_solid(destination.path, as_written(*mesh, format, {}), result, progress);
  } else if (const auto network = value.as<CurveNetwork>()) {
    stage_file(destination.path, write_curve_network_obj(*network), result);
  } else if (const auto attributes = value.as<AttributeNetwork>()) {
    stage_file(destination.path, write_attribute_network(*attributes), result);
  } else if (const auto camera = value.as<Camera>()) {
    stage_file(destination.path, write_camera_json({*camera, finite_vanishing_points(*camera)}), result);
  } else {
    stage_file(destination.path, write_json(value.get<Report>()), result);
  }
}

/// Volatile: GCC 12 may drop the rounding to 32 bits and back.
bool is_single(double coordinate) {
  const volatile float rounded = static_cast<float>(coordinate);
  return static_cast<double>(rounded) == coordinate;
}

bool is_single(const PolyMesh& mesh) {
  return std::all_of(mesh.positions.begin(), mesh.positions.end(), [](const Vec3& position) {
    return std::all_of(position.begin(), position.end(), [](double coordinate) { return is_single(coordinate); });
  });
}

/// STL and GLB have 32-bit numbers alone. PLY has both: a scan that came in 32 bits stays so.
bool stores_single(MeshFormat format, const Value& input) {
  if (format == MeshFormat::Stl || format == MeshFormat::Glb) return true;
  const auto mesh = input.as<PolyMesh>();
  return format == MeshFormat::Ply && mesh != nullptr && is_single(*mesh);
}

/// What operations can't know by themselves: how their result will be stored.
void settle_by_format(MeshFormat format, const Value& input, ParameterValues& values) {
  const auto precision = values.find(precision_parameter);
  if (precision != values.end() && stores_single(format, input)) precision->second = single_precision;
  const auto marks = values.find(marks_parameter);
  if (marks != values.end() && format != MeshFormat::Ply) marks->second = false;
}

/// What operations may predict to need: no more than the process gets.
void settle_by_memory(std::int64_t limit, ParameterValues& values) {
  const auto known = values.find(memory_parameter);
  if (known == values.end() || limit <= 0) return;
  constexpr double mebibyte = 1024 * 1024;
  double& wanted = std::get<double>(known->second);
  const double most = static_cast<double>(limit) / mebibyte;
  if (wanted == 0 || wanted > most) wanted = most;
}

/// Options that name files are the command's, all others the operation's.
ParameterValues operation_parameters(const OperationDescription& description, const Invocation& invocation,
                                     const Values& inputs) {
  ParameterValues values;
  for (const ParameterDescription& parameter : description.parameters) {
    values[parameter.name] = invocation.parameters.at(parameter.name);
  }
  settle_by_memory(invocation.memory_limit, values);
  const bool is_mesh = description.outputs.front().type == ValueType::Mesh && !writes_step(description, invocation);
  if (invocation.output.empty() || !is_mesh) return values;
  const MeshFormat format = output_mesh_format(invocation.output, invocation.output_format);
  settle_by_format(format, inputs.at(description.inputs.front().name), values);
  return values;
}

/// Whether nothing is to be written, only listed.
bool only_lists(const OperationDescription& description, const Invocation& invocation) {
  return !description.list_flag.empty() && flag_of(invocation.parameters, description.list_flag);
}

/// Whether there are questions, which need no file to be written.
bool asks(const OperationDescription& description, const Invocation& invocation) {
  return std::ranges::any_of(description.inputs, [&](const PortDescription& port) {
    return port.asks && !text_option(invocation, port.name).empty();
  });
}

/// Files and formats are settled before the work begins, so that a wrong name costs nothing.
void check_files(const OperationDescription& description, const std::vector<FollowUp>& follow_ups,
                 const Invocation& invocation) {
  const auto inputs = extra_inputs(description);
  const auto streams = std::count_if(inputs.begin(), inputs.end(), [&](const PortDescription& port) {
    return text_option(invocation, port.name) == "-";
  });
  if (streams + (invocation.input == "-" ? 1 : 0) > 1) {
    throw Error(make_error(Category::Usage, "E_USAGE", "Only one input can come from standard input."));
  }
  bool any = !invocation.output.empty();
  if (any && description.outputs.front().type == ValueType::Mesh && !writes_step(description, invocation)) {
    output_mesh_format(invocation.output, invocation.output_format);
  }
  for (const PortDescription& port : extra_outputs(description)) {
    const std::string path = text_option(invocation, port.name);
    if (path.empty()) continue;
    any = true;
    if (port.type == ValueType::Mesh) output_mesh_format(path, "");
  }
  for (const FollowUp& follow_up : follow_ups) {
    const std::string path = text_option(invocation, follow_up.option());
    any = any || !path.empty();
    if (!path.empty() && follow_up.output().type == ValueType::Mesh) output_mesh_format(path, "");
  }
  if (!any && !only_lists(description, invocation) && !asks(description, invocation)) {
    throw Error(make_error(Category::Usage, "E_USAGE", "Nothing to write: name an output with -o; see --help."));
  }
}

/// The figures of a mesh as hole filling sees it, where vertices at one place count as one; the details get the pairs
/// that intersect in which faces take part that the input doesn't have.
MeshReport inspect_joined(const PolyMesh& mesh, const Invocation& invocation, Report& details, Progress& progress) {
  const double tolerance = number_of(invocation.parameters, weld_parameter);
  const auto joined = hole_filling::joined(mesh, hole_filling::view_surface(mesh, progress, tolerance));
  const auto new_faces = static_cast<std::size_t>(details.at("new_faces").as_integer());
  const auto first = std::ranges::lower_bound(joined.face, static_cast<Index>(mesh.face_count() - new_faces));
  std::vector<Index> added(static_cast<std::size_t>(joined.face.end() - first));
  std::iota(added.begin(), added.end(), static_cast<Index>(first - joined.face.begin()));
  details.set(added_key, find_intersections_of(joined.mesh, added, progress, {.max_pairs = 0}).count);
  MeshReport figures = inspect(joined.mesh, true, progress);
  figures.faces = mesh.face_count();
  return figures;
}

/// The figures of what the main output's file holds; without a format, beside STEP files, of the mesh as computed.
MeshReport report_of_file(const PortDescription& port, const PolyMesh& mesh, std::optional<MeshFormat> format,
                          const Invocation& invocation, Report* details, Progress& progress) {
  PolyMesh other;
  const PolyMesh* counted = &mesh;
  if (format && !keeps_positions(mesh, *format, {})) counted = &(other = as_written(mesh, *format, {}));
  return port.joins_seams ? inspect_joined(*counted, invocation, *details, progress)
                          : inspect(*counted, true, progress);
}

/// A mesh without faces is no valid result; what was found on the way says why. That may be a limit.
void require_faces(const PortDescription& port, const Value& value, const Findings& warnings) {
  const auto mesh = value.as<PolyMesh>();
  if (mesh == nullptr || mesh->face_count() > 0) return;
  const bool limited =
      std::any_of(warnings.begin(), warnings.end(), [](const Finding& f) { return f.category == Category::Limit; });
  Findings findings{make_error(limited ? Category::Limit : Category::Geometry, "E_NO_FACES",
                               "The " + port.name + " has no faces, so it isn't written: see the other findings.")};
  findings.insert(findings.end(), warnings.begin(), warnings.end());
  throw Error(std::move(findings));
}

/// What an operation was given and made.
struct Computed {
  const Values& inputs;
  const Values& outputs;
  const Camera* camera = nullptr;  ///< that the input was drawn from, if one was found
};

/// Every output that has a file, and the figures of the main one.
void stage_outputs(const OperationDescription& description, const Invocation& invocation, const Computed& computed,
                   CommandResult& result, Progress& progress) {
  const PortDescription& main_output = description.outputs.front();
  if (!invocation.output.empty()) {
    const Value& value = computed.outputs.at(main_output.name);
    require_faces(main_output, value, result.warnings);
    const bool is_step = writes_step(description, invocation);
    if (is_step) {
      stage_step(invocation, computed.inputs, computed.outputs, result, progress);
    } else {
      stage_value(main_output, value, {invocation.output, invocation.output_format, computed.camera}, result, progress);
    }
    if (const auto mesh = value.as<PolyMesh>(); mesh != nullptr && !result.mesh) {
      std::optional<MeshFormat> format;
      if (!is_step) format = output_mesh_format(invocation.output, invocation.output_format);
      Report* details = result.details ? &*result.details : nullptr;
      result.mesh = report_of_file(main_output, *mesh, format, invocation, details, progress);
      warn_of_faults(invocation.output, main_output.is_closed || format == MeshFormat::Stl, result);
    }
  }
  for (const PortDescription& port : extra_outputs(description)) {
    const std::string path = text_option(invocation, port.name);
    if (path.empty()) continue;
    Value value = computed.outputs.at(port.name);
    if (const auto report = value.as<Report>()) {
      value = std::make_shared<const Report>(with_fits(*report, computed.outputs, progress));
    }
    stage_value(port, value, {path, "", computed.camera}, result, progress);
  }
}

/// What goes on from outputs that have no file format, where it is asked for.
void stage_follow_ups(const std::vector<FollowUp>& follow_ups, const Invocation& invocation, const Computed& computed,
                      CommandResult& result, Progress& progress) {
  for (const FollowUp& follow_up : follow_ups) {
    const std::string path = text_option(invocation, follow_up.option());
    if (path.empty()) continue;
    const OperationResult made = run(follow_up, computed.outputs, invocation, progress);
    const Value& value = made.outputs.at(follow_up.output().name);
    Findings warnings = result.warnings;
    warnings.insert(warnings.end(), made.warnings.begin(), made.warnings.end());
    require_faces(follow_up.output(), value, warnings);
    result.warnings = std::move(warnings);
    stage_value(follow_up.output(), value, {path, "", computed.camera}, result, progress);
  }
}

std::string summary(const CommandResult& result) {
  std::string text;
  const Report* sentence = result.details ? result.details->find("summary") : nullptr;
  if (sentence != nullptr) text += sentence->as_string();
  const Report* added = result.details ? result.details->find(added_key) : nullptr;
  if (result.mesh) {
    const auto count = added == nullptr ? std::nullopt : std::optional(static_cast<std::size_t>(added->as_integer()));
    text += (text.empty() ? "" : "\n") + mesh_text(*result.mesh, count);
  }
  return text;
}

/// An example where the program writes STEP files, else the reason why it doesn't.
void add_step(const std::string& call, CommandDescription& description) {
  const std::string why = why_no_step();
  if (why.empty()) {
    description.examples.push_back(call + " -o solid.step");
  } else {
    description.sentence += " No STEP files: " + why;
  }
}

/// How the help calls an operation's first input.
std::string input_word(const PortDescription& port) {
  if (port.type == ValueType::Drawing) return "SKETCH.svg";
  if (port.type == ValueType::PerspectiveDrawing) return "DRAWING.svg";
  return upper_case(port.name) + (port.type == ValueType::AttributeNetwork ? ".json" : "");
}

std::string example_input(ValueType type) {
  if (type == ValueType::Drawing) return "sketch.svg";
  if (type == ValueType::PerspectiveDrawing) return "drawing.svg";
  return type == ValueType::AttributeNetwork ? "network.json" : "model.obj";
}

/// Operations don't hear what was found while their inputs were read, but the report has both: strokes that any finding
/// names are flagged in the list `strokes` of the details, where there is one.
void flag_strokes(const Findings& findings, Report& details) {
  constexpr const char* list = "strokes";
  const Report* strokes = details.find(list);
  const auto* uses = strokes != nullptr ? std::get_if<Report::Object>(&strokes->value()) : nullptr;
  if (uses == nullptr) return;
  std::set<std::string> named;
  for (const Finding& finding : findings) {
    for (const Subject& subject : finding.subjects) {
      if (subject.kind == SubjectKind::Stroke) named.insert(subject.id);
    }
  }
  Report::Object flagged = *uses;
  for (auto& [id, use] : flagged) {
    if (named.contains(id)) use = "flagged";
  }
  details.set(list, Report::of_members(std::move(flagged)));
}

CommandDescription describe_command(const OperationDescription& operation, const std::vector<FollowUp>& follow_ups) {
  CommandDescription description;
  description.name = operation.id;
  description.sentence = operation.sentence;
  const ValueType input = operation.inputs.front().type;
  description.input_word = input_word(operation.inputs.front());
  const auto extra = extra_outputs(operation);
  const bool may_list = !operation.list_flag.empty();
  const bool may_ask = std::ranges::any_of(operation.inputs, &PortDescription::asks);
  description.output = extra.empty() && !may_list && !may_ask ? OutputNeed::Required : OutputNeed::Optional;
  description.parameters = operation.parameters;
  if (operation.inputs.front().is_raw)
    description.parameters.push_back(flag_parameter(
        drop_option, false,
        "Drop vertices with coordinates that are not finite, and the faces that use them, instead of refusing."));
  for (const PortDescription& port : extra_inputs(operation)) {
    description.parameters.push_back(file_parameter(port.name, "Read from a JSON file: " + port.sentence));
  }
  for (const PortDescription& port : extra) {
    description.parameters.push_back(file_parameter(port.name, "Write to FILE: " + port.sentence));
  }
  for (const FollowUp& follow_up : follow_ups) {
    const auto options = options_of(follow_up);
    description.parameters.insert(description.parameters.end(), options.begin(), options.end());
  }
  if (has_readings(operation)) description.parameters.push_back(alternatives_option());
  const std::string call = "croquis-cli " + operation.id + ' ' + example_input(input);
  const std::string options = operation.example.empty() ? "" : " " + operation.example;
  description.examples = {call + options + " -o solid.obj"};
  if (has_exact_solid(operation)) add_step(call + options, description);
  if (may_list) description.examples.push_back(call + " --" + operation.list_flag);
  for (const PortDescription& port : extra_inputs(operation)) {
    description.examples.push_back(call + " --" + port.name + " " + port.name + ".json -o solid.obj");
  }
  return description;
}

void run_operation(const Operation& operation, const std::vector<FollowUp>& follow_ups, const Invocation& typed,
                   CommandResult& result, Progress& progress) {
  const OperationDescription& description = operation.describe();
  const std::optional<std::size_t> asked = asked_readings(description, typed);
  Invocation invocation = typed;
  if (asked) invocation.output = numbered_path(typed.output, 1);
  check_files(description, follow_ups, invocation);
  Progress reading = progress.step("read", 0.05);
  const Values inputs = read_values(description, invocation, result, reading);

  Progress computing = progress.step(description.id, asked ? 0.3 : 0.85);
  Context context{computing};
  context.threads = static_cast<int>(invocation.threads);
  const ParameterValues parameters = operation_parameters(description, invocation, inputs);
  OperationResult computed = croquis::run(operation, inputs, parameters, context);
  result.warnings.insert(result.warnings.end(), computed.warnings.begin(), computed.warnings.end());

  const auto details = computed.outputs.find(details_output);
  if (details != computed.outputs.end()) {
    result.details = details->second.get<Report>();
    flag_strokes(result.warnings, *result.details);
  }
  if (only_lists(description, invocation)) {
    result.text = list_text(*result.details);
  } else {
    Progress writing = progress.step("write", 0.1);
    const Computed all{inputs, computed.outputs, camera_among(computed.outputs)};
    stage_outputs(description, invocation, all, result, writing);
    stage_follow_ups(follow_ups, invocation, all, result, writing);
    if (asked) {
      Progress others = progress.step("alternatives", 0.55);
      stage_alternatives({operation, inputs, parameters}, *asked, typed, result, others);
    }
    result.text = result.files.empty() && asks(description, invocation) ? list_text(*result.details) : summary(result);
  }
  progress.report(1);
}

}  // namespace

Command operation_command(const Operation& operation, const Registry& registry) {
  const OperationDescription& description = operation.describe();
  const std::vector<FollowUp> follow_ups = follow_ups_of(description, registry);
  return {describe_command(description, follow_ups),
          [&operation, follow_ups](const Invocation& invocation, CommandResult& result, Progress& progress) {
            run_operation(operation, follow_ups, invocation, result, progress);
          }};
}

}  // namespace croquis::cli
