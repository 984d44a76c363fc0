// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/commands/alternatives.h"

#include <filesystem>
#include <utility>

#include "cli/files.h"
#include "cli/solid_faults.h"
#include "croquis/base/described.h"
#include "croquis/base/error.h"
#include "croquis/base/text.h"
#include "croquis/operators/drawing_readings.h"

namespace croquis::cli {
namespace {

constexpr const char* alternatives_name = "alternatives";
constexpr std::size_t most_readings = 99;

/// The solid of a reading as its file holds it; none where it is no solid.
std::optional<PolyMesh> solid_of(const FirstReading& first, const Drawing& drawing, const std::string& path,
                                 const Invocation& invocation, Progress& progress) {
  const OperationDescription& description = first.operation.describe();
  Values inputs = first.inputs;
  inputs[description.inputs.front().name] = std::make_shared<const Drawing>(drawing);
  Progress silent = progress.silent();
  Context context{silent};
  context.threads = static_cast<int>(invocation.threads);
  try {
    const OperationResult computed = croquis::run(first.operation, inputs, first.parameters, context);
    PolyMesh mesh = computed.outputs.at(description.outputs.front().name).get<PolyMesh>();
    const MeshFormat format = output_mesh_format(path, invocation.output_format);
    if (solid_faults(inspect(as_written(mesh, format, {}), true, silent), path).empty()) return mesh;
  } catch (const Error&) {  // then that is no reading
  }
  return std::nullopt;
}

/// What a stroke has to say for a reading.
struct Said {
  std::string stroke, key, value;
};

std::vector<Said> said_in(const Drawing& drawing, const Drawing& reading) {
  std::vector<Said> all;
  for (std::size_t s = 0; s < drawing.strokes.size(); ++s) {
    const auto& before = drawing.strokes[s].data;
    for (const auto& [key, value] : reading.strokes[s].data) {
      const auto known = before.find(key);
      if (known == before.end() || known->second != value) all.push_back({drawing.strokes[s].id, key, value});
    }
  }
  return all;
}

Report row_of(const std::string& file, const Drawing& drawing, const silhouette::DrawingReading& reading) {
  Report says = Report::array();
  for (const auto& [stroke, key, value] : said_in(drawing, reading.drawing)) {
    says.push(to_report(fields(named("stroke", stroke), named("key", key), named("value", value))));
  }
  return to_report(fields(named("file", file), named("cost", reading.cost),
                          named("differs", Report::list(reading.differs)), named("says", says)));
}

}  // namespace

bool has_readings(const OperationDescription& description) { return description.id == "inflate"; }

ParameterDescription alternatives_option() {
  return text_parameter(
      alternatives_name, "",
      "Write so many readings of the drawing, 1 to 99, as OUT-1, OUT-2 and so on: the best one, then "
      "others in which strokes have other kinds, hidden ends are joined in other ways, or other parts "
      "lie in front.");
}

std::optional<std::size_t> asked_readings(const OperationDescription& description, const Invocation& invocation) {
  if (!has_readings(description)) return std::nullopt;
  const std::string& text = text_of(invocation.parameters, alternatives_name);
  if (text.empty()) return std::nullopt;
  std::size_t count = 0;
  if (!read_number(text, count) || count < 1 || count > most_readings) {
    throw Error(refused_value(alternatives_name, text, "a count of readings, 1 to " + std::to_string(most_readings)));
  }
  if (invocation.output.empty() || invocation.output == "-") {
    throw Error(make_error(Category::Usage, "E_USAGE",
                           "--alternatives writes several files: name the first part of their names with -o."));
  }
  return count;
}

std::string numbered_path(const std::string& path, std::size_t number) {
  std::filesystem::path numbered(path);
  numbered.replace_filename(numbered.stem().string() + "-" + std::to_string(number) + numbered.extension().string());
  return numbered.string();
}

void stage_alternatives(const FirstReading& first, std::size_t count, const Invocation& invocation,
                        CommandResult& result, Progress& progress) {
  const Drawing& drawing = first.inputs.at(first.operation.describe().inputs.front().name).get<Drawing>();
  silhouette::DrawingReadings readings = readings_of(drawing, first.parameters);
  Progress looking = progress.step("other readings", 1);
  Report rows = Report::array();
  rows.push(row_of(numbered_path(invocation.output, 1), drawing, {drawing, 0, {}}));
  std::size_t found = 1;
  readings.next(looking);  // the first one again
  while (found < count) {
    const std::optional<silhouette::DrawingReading> reading = readings.next(looking);
    if (!reading) break;
    const std::string path = numbered_path(invocation.output, found + 1);
    const std::optional<PolyMesh> mesh = solid_of(first, reading->drawing, path, invocation, looking);
    if (!mesh) continue;
    ++found;
    rows.push(row_of(path, drawing, *reading));
    stage_mesh(path, *mesh, {}, output_mesh_format(path, invocation.output_format), result, looking);
  }
  if (result.details) result.details->set(alternatives_name, std::move(rows));
  if (found < count) {
    Finding fewer = make_warning(Category::Geometry, "W_ALTERNATIVES",
                                 "The drawing has no more than " + counted(found, "reading", "readings") + " of " +
                                     std::to_string(count) + " that were asked for",
                                 {{SubjectKind::Parameter, alternatives_name, {}, {}, {}}});
    fewer.severity = Severity::Info;
    result.warnings.push_back(std::move(fewer));
  }
}

}  // namespace croquis::cli
