// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/report_json.h"

#include <cmath>

#include <nlohmann/json.hpp>

namespace croquis::cli {
namespace {

using Json = nlohmann::ordered_json;

/// JSON knows no infinity and no NaN; "not known" is null.
Json finite(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json to_json(const Report& report) {
  struct Visitor {
    Json operator()(std::monostate) const { return nullptr; }
    Json operator()(bool value) const { return value; }
    Json operator()(std::int64_t value) const { return value; }
    Json operator()(double value) const { return finite(value); }
    Json operator()(const std::string& value) const { return value; }
    Json operator()(const Report::Array& array) const {
      Json json = Json::array();
      for (const Report& element : array) json.push_back(to_json(element));
      return json;
    }
    Json operator()(const Report::Object& object) const {
      Json json = Json::object();
      for (const auto& [key, value] : object) json[key] = to_json(value);
      return json;
    }
  };
  return std::visit(Visitor{}, report.value());
}

Json to_json(const Subject& subject) {
  Json json = {{"kind", to_string(subject.kind)}, {"id", subject.id}};
  if (subject.file) json["file"] = *subject.file;
  if (subject.line) json["line"] = *subject.line;
  if (!subject.at.empty()) json["at"] = subject.at;
  return json;
}

Json to_json(const Finding& finding) {
  Json subjects = Json::array();
  for (const Subject& subject : finding.subjects) subjects.push_back(to_json(subject));
  return {{"code", finding.code}, {"message", finding.message}, {"subject", std::move(subjects)}};
}

Json to_json(const Findings& findings) {
  Json json = Json::array();
  for (const Finding& finding : findings) json.push_back(to_json(finding));
  return json;
}

/// Names of files may hold bytes that are no UTF-8; they are replaced rather than refused.
std::string text_of(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

}  // namespace

std::string success_json(const RunFigures& figures, const CommandResult& result) {
  Json stages = Json::array();
  for (const StageTime& stage : figures.stages) stages.push_back({{"name", stage.name}, {"seconds", stage.seconds}});
  Json json = {{"command", figures.command},
               {"version", CROQUIS_VERSION},
               {"input", figures.input},
               {"output", figures.output},
               {"seconds", figures.seconds},
               {"stages", std::move(stages)},
               {"peak_memory_bytes", figures.peak_memory_bytes},
               {"warnings", to_json(result.warnings)}};
  if (result.mesh) json["mesh"] = to_json(to_report(*result.mesh));
  if (result.details) json["details"] = to_json(*result.details);
  return text_of(json);
}

std::string failure_json(const std::string& command, const Findings& errors, const CommandResult& result) {
  Json json = {{"command", command}, {"error", to_json(errors.front())}, {"errors", to_json(errors)}};
  if (!result.warnings.empty()) json["warnings"] = to_json(result.warnings);
  if (result.mesh) json["mesh"] = to_json(to_report(*result.mesh));
  return text_of(json);
}

}  // namespace croquis::cli
