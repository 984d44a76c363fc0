// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <sstream>
#include <utility>
#include <vector>

#include "cli/command.h"
#include "cli/commands/project_run.h"
#include "cli/contact_sheet.h"
#include "cli/files.h"
#include "cli/mesh_text.h"
#include "cli/solid_faults.h"
#include "croquis/base/described.h"
#include "croquis/base/error.h"
#include "croquis/io/project_file.h"
#include "croquis/render/offscreen_context.h"
#include "croquis/render/picture.h"

namespace croquis::cli {
namespace {

// ---- Values for one run

struct Setting {
  std::string node;
  std::string parameter;
  std::string value;
};

Error refused(const char* code, std::string message, const std::string& subject, SubjectKind kind) {
  return Error(make_error(Category::Usage, code, std::move(message), {{kind, subject, {}, {}, {}}}));
}

/// Names may hold dots, parameters don't.
bool parse(const std::string& text, Setting& setting) {
  const auto equals = text.find('=');
  if (equals == std::string::npos) return false;
  const auto dot = text.rfind('.', equals);
  if (dot == std::string::npos || dot == 0 || dot + 1 == equals) return false;
  setting = {text.substr(0, dot), text.substr(dot + 1, equals - dot - 1), text.substr(equals + 1)};
  return true;
}

std::vector<Setting> split(const std::string& settings) {
  std::vector<Setting> list;
  std::istringstream stream(settings);
  for (std::string piece; std::getline(stream, piece, ';');) {
    Setting setting;
    if (parse(piece, setting)) {
      list.push_back(std::move(setting));
    } else if (list.empty()) {
      throw refused("E_USAGE", "'" + piece + "' is no setting: write NODE.PARAMETER=VALUE.", "set",
                    SubjectKind::Parameter);
    } else {
      list.back().value += ";" + piece;
    }
  }
  return list;
}

const Node& find_node(const Document& document, const std::string& wanted) {
  const Node* found = nullptr;
  for (const auto& node : document.nodes()) {
    if (std::to_string(node->id) == wanted) return *node;
    if (node->name != wanted) continue;
    if (found != nullptr) {
      throw refused("E_USAGE", "Several nodes are called '" + wanted + "'; name the one you mean by its id.", wanted,
                    SubjectKind::Node);
    }
    found = node.get();
  }
  if (found != nullptr) return *found;
  std::string names;
  for (const auto& node : document.nodes()) {
    names += (names.empty() ? "" : ", ") + std::to_string(node->id) + " ('" + node->name + "')";
  }
  throw refused("E_USAGE",
                "There is no node '" + wanted + "' in the project; there are " + (names.empty() ? "none" : names) + ".",
                wanted, SubjectKind::Node);
}

const ParameterDescription& find_described(const Document& document, const Setting& setting, const Registry& registry) {
  const OperationDescription* operation = registry.description(find_node(document, setting.node).operation);
  const ParameterDescription* found =
      operation == nullptr ? nullptr : find_parameter(operation->parameters, setting.parameter);
  if (found != nullptr) return *found;
  throw refused("E_PARAMETER",
                "Node '" + setting.node + "' has no parameter '" + setting.parameter +
                    "'; croquis-cli operations lists them all.",
                setting.parameter, SubjectKind::Parameter);
}

Document with_setting(const Document& document, const Setting& setting, const Registry& registry) {
  const ParameterDescription& described = find_described(document, setting, registry);
  Node node = find_node(document, setting.node);
  node.parameters[setting.parameter] = parse_parameter(described, setting.value);
  return document.with(std::move(node));
}

/// The document with other parameters.
/// @param settings NODE.PARAMETER=VALUE, several separated by ';'. NODE is a node's id or its name. A piece that isn't
///        of that form belongs to the value before it, which may be a list of its own.
/// @throws Error (E_USAGE, E_PARAMETER; Category::Usage) with a finding for each setting that can't be
Document with_settings(const Document& document, const std::string& settings, const Registry& registry) {
  Document edited = document;
  Findings findings;
  for (const Setting& setting : split(settings)) {
    try {
      edited = with_setting(edited, setting, registry);
    } catch (const Error& error) {
      findings.insert(findings.end(), error.findings().begin(), error.findings().end());
    }
  }
  if (!findings.empty()) throw Error(std::move(findings));
  return edited;
}

ProjectFile read_input_project(const Invocation& invocation, Progress& progress) {
  if (invocation.input == "-") return read_project(read_input(invocation), "standard input", progress);
  return load_project(invocation.input, progress);
}

// ---- One parameter with several values

constexpr int most_values = 100;
constexpr render::PictureSize tile_size = {240, 180};

Error no_sweep(const std::string& message) { return refused("E_USAGE", message, "sweep", SubjectKind::Parameter); }

/// The settings of NODE.PARAMETER=FROM:TO:COUNT, one for each value.
/// @throws Error (E_USAGE, E_PARAMETER; Category::Usage)
std::vector<Setting> swept(const std::string& text, const Document& document, const Registry& registry) {
  Setting setting;
  std::vector<std::string> parts;
  if (parse(text, setting)) {
    std::istringstream stream(setting.value);
    for (std::string part; std::getline(stream, part, ':');) parts.push_back(part);
  }
  if (parts.size() != 3) throw no_sweep("'" + text + "' is no sweep: write NODE.PARAMETER=FROM:TO:COUNT.");
  const ParameterDescription& described = find_described(document, setting, registry);
  const bool whole = described.type == ParameterType::Integer;
  if (!whole && described.type != ParameterType::Number)
    throw no_sweep("'" + setting.parameter +
                   "' isn't a number, so it has no values between two others; set it with --set.");
  const auto number = [&](const std::string& part) {
    const ParameterValue value = parse_parameter(described, part);
    return whole ? static_cast<double>(std::get<std::int64_t>(value)) : std::get<double>(value);
  };
  const double from = number(parts[0]), to = number(parts[1]);
  const auto counting = integer_parameter("COUNT", 1, 1, most_values, "", "");
  const std::int64_t count = std::get<std::int64_t>(parse_parameter(counting, parts[2]));
  if (whole && static_cast<double>(count) > std::abs(to - from) + 1)
    throw no_sweep("'" + setting.parameter + "' takes whole numbers, and from " + parts[0] + " to " + parts[1] +
                   " there are fewer than " + parts[2] + " of them; give a smaller COUNT.");
  std::vector<Setting> settings;
  for (std::int64_t i = 0; i < count; ++i) {
    const double share = count == 1 ? 0 : static_cast<double>(i) / static_cast<double>(count - 1);
    const double value = i + 1 == count && count > 1 ? to : from + (to - from) * share;
    setting.value = whole ? to_text(static_cast<std::int64_t>(std::llround(value))) : to_text(value);
    settings.push_back(setting);
  }
  return settings;
}

/// What one value of the parameter gave, and what is said of it.
struct SweptValue {
  render::MeshItemPtr item;  ///< null where there is nothing to show
  Report report;
  Findings findings;
};

SweptValue evaluate_with(const Setting& setting, const Document& plain, const Registry& registry, Evaluator& evaluator,
                         Progress& progress) {
  const Document document = with_setting(plain, setting, registry);
  const std::vector<const Node*> wanted = results_of(document, registry);
  ProjectRun run(registry, document, evaluator);
  CommandResult result;
  SweptValue swept;
  Report errors = Report::array();
  std::size_t faces = 0;
  try {
    for (const Node* node : wanted) {
      Progress step = progress.step(title_of(*node), 1.0 / static_cast<double>(wanted.size()));
      run.evaluate(*node, step);
    }
    run.finish(result);
    const PolyMesh mesh = joined(run.meshes());
    swept.item = render::make_mesh_item(mesh, {});
    faces = mesh.face_count();
    swept.findings = std::move(result.warnings);
  } catch (const Error& error) {
    swept.findings = error.findings();
    for (Finding& finding : swept.findings) {
      if (finding.severity == Severity::Error) errors.push(finding.code);
      finding.message = "With " + setting.parameter + " = " + setting.value + ": " + finding.message;
    }
  }
  swept.report =
      to_report(fields(named("value", std::strtod(setting.value.c_str(), nullptr)),
                       named("failed", swept.item == nullptr), named("faces", faces), named("errors", errors)));
  return swept;
}

/// By one camera for all: what grows is seen to grow.
std::vector<SheetTile> tiles_of(const std::vector<SweptValue>& values, const std::vector<render::MeshItemPtr>& items,
                                render::Renderer& renderer, Progress& progress) {
  const auto direction = render::view_direction(render::NamedView::Perspective);
  const render::Camera camera = render::frame(render::points_of(items), direction, tile_size.aspect());
  std::vector<SheetTile> tiles;
  for (const SweptValue& value : values) {
    progress.check();
    SheetTile tile{number_text(std::get<double>(value.report.at("value").value())), {}};
    if (value.item) tile.rgba = render::render_picture(renderer, {value.item}, camera, {}, tile_size).rgba;
    tiles.push_back(std::move(tile));
    progress.report(static_cast<double>(tiles.size()) / static_cast<double>(values.size()));
  }
  return tiles;
}

void run_sweep(const Document& document, const Registry& registry, const Invocation& invocation, CommandResult& result,
               Progress& progress) {
  const std::vector<Setting> settings = swept(text_of(invocation.parameters, "sweep"), document, registry);
  const render::OffscreenContext context;  // without one nothing is computed in vain
  render::Renderer renderer;
  Evaluator evaluator(registry);
  std::vector<SweptValue> values;
  std::vector<render::MeshItemPtr> items;
  Findings findings;
  Report reports = Report::array();
  Progress evaluating = progress.step("evaluate", 0.8);
  for (const Setting& setting : settings) {
    Progress step = evaluating.step(setting.value, 1.0 / static_cast<double>(settings.size()));
    values.push_back(evaluate_with(setting, document, registry, evaluator, step));
    if (values.back().item) items.push_back(values.back().item);
    reports.push(values.back().report);
    for (const Finding& finding : values.back().findings) {
      const auto is_same = [&](const Finding& other) { return other.message == finding.message; };
      if (std::ranges::none_of(findings, is_same)) findings.push_back(finding);
    }
  }
  if (items.empty()) throw Error(std::move(findings));
  for (Finding& finding : findings) finding.severity = std::min(finding.severity, Severity::Warning);
  result.warnings.insert(result.warnings.end(), findings.begin(), findings.end());
  Progress drawing = progress.step("draw", 0.1);
  const std::vector<SheetTile> tiles = tiles_of(values, items, renderer, drawing);
  stage_file(invocation.output, encode_png(contact_sheet(tiles, tile_size.width, tile_size.height)), result);
  result.details =
      to_report(fields(named("parameter", settings.front().node + "." + settings.front().parameter),
                       named("columns", sheet_columns(static_cast<int>(tiles.size()))), named("values", reports)));
  result.text = std::to_string(items.size()) + " of " + std::to_string(values.size()) + " values gave a mesh.";
  progress.report(1);
}

void run_project(const Registry& registry, const Invocation& invocation, CommandResult& result, Progress& progress) {
  const bool sweeps = !text_of(invocation.parameters, "sweep").empty();
  if (sweeps) require_png_output(invocation);
  const auto format = sweeps ? MeshFormat() : output_mesh_format(invocation.output, invocation.output_format);
  Progress reading = progress.step("read", 0.05);
  ProjectFile project = read_input_project(invocation, reading);
  result.warnings = std::move(project.warnings);
  const std::string settings = text_of(invocation.parameters, "set");
  const Document document = with_settings(project.document, settings, registry);
  if (sweeps) return run_sweep(document, registry, invocation, result, progress);

  Progress evaluating = progress.step("evaluate", 0.85);
  const std::vector<const Node*> wanted = results_of(document, registry);
  Evaluator evaluator(registry);
  ProjectRun project_run(registry, document, evaluator);
  for (const Node* node : wanted) {
    Progress step = evaluating.step(title_of(*node), 1.0 / static_cast<double>(wanted.size()));
    project_run.evaluate(*node, step);
  }
  project_run.finish(result);
  MeshUnion united = project_run.united();
  result.warnings.insert(result.warnings.end(), united.warnings.begin(), united.warnings.end());

  Progress writing = progress.step("write", 0.1);
  stage_mesh(invocation.output, united.mesh, {}, format, result, writing);
  const PolyMesh written = as_written(united.mesh, format, {});
  if (project_run.promises_solid()) {
    judge_solid(invocation.output, written, result, writing);
  } else {
    result.mesh = inspect(written, true, writing);
    warn_of_faults(invocation.output, format == MeshFormat::Stl, result);
  }
  result.text = mesh_text(*result.mesh);
  progress.report(1);
}

}  // namespace

Command run_command(const Registry& registry) {
  return {{.name = "run",
           .sentence = "Evaluates a project and writes its visible meshes that no other visible mesh is made of.",
           .input_word = "FILE.croq",
           .output = OutputNeed::Required,
           .parameters = {list_parameter("set",
                                         "NODE.PARAMETER=VALUE: another value, for this run; NODE is a name or an id."),
                          text_parameter("sweep", "",
                                         "NODE.PARAMETER=FROM:TO:COUNT: a picture (PNG) of the results with so many "
                                         "values of a number, evenly spaced.")},
           .examples = {"croquis-cli run project.croq -o solid.obj",
                        "croquis-cli run project.croq -o solid.obj --set inflate.min-gap=0.5",
                        "croquis-cli run project.croq -o sheet.png --sweep inflate.min-gap=0.1:0.9:9"}},
          [&registry](const Invocation& invocation, CommandResult& result, Progress& progress) {
            run_project(registry, invocation, result, progress);
          }};
}

}  // namespace croquis::cli
