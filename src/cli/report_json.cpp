// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/report_json.h"

#include "croquis/io/json.h"

namespace croquis::cli {
namespace {

Report to_report(const Subject& subject) {
  Report report;
  report.set("kind", to_string(subject.kind)).set("id", name_of(subject));
  if (subject.file) report.set("file", *subject.file);
  if (subject.line) report.set("line", *subject.line);
  if (!subject.at.empty()) report.set("at", Report::list(subject.at));
  return report;
}

Report to_report(const Finding& finding) {
  Report subjects = Report::array();
  for (const Subject& subject : finding.subjects) subjects.push(to_report(subject));
  Report report;
  report.set("code", finding.code).set("message", finding.message).set("subject", std::move(subjects));
  if (finding.fix) {
    Report fix;
    fix.set("stroke", finding.fix->stroke).set("group", finding.fix->group).set("text", finding.fix->text);
    report.set("fix", std::move(fix));
  }
  return report;
}

Report to_report(const Findings& findings) {
  Report report = Report::array();
  for (const Finding& finding : findings) report.push(to_report(finding));
  return report;
}

}  // namespace

std::string success_json(const RunFigures& figures, const CommandResult& result) {
  Report stages = Report::array();
  for (const StageTime& stage : figures.stages) {
    Report entry;
    stages.push(entry.set("name", stage.name).set("seconds", stage.seconds));
  }
  Report report;
  report.set("command", figures.command)
      .set("version", CROQUIS_VERSION)
      .set("input", figures.input)
      .set("output", figures.output)
      .set("seconds", figures.seconds)
      .set("stages", std::move(stages))
      .set("peak_memory_bytes", figures.peak_memory_bytes)
      .set("warnings", to_report(result.warnings));
  if (result.mesh) report.set("mesh", croquis::to_report(*result.mesh));
  if (result.details) report.set("details", *result.details);
  return write_json(report, JsonLayout::OneLine);
}

std::string failure_json(const std::string& command, const Findings& errors, const CommandResult& result) {
  Report report;
  report.set("command", command).set("error", to_report(errors.front())).set("errors", to_report(errors));
  if (!result.warnings.empty()) report.set("warnings", to_report(result.warnings));
  if (result.mesh) report.set("mesh", croquis::to_report(*result.mesh));
  return write_json(report, JsonLayout::OneLine);
}

}  // namespace croquis::cli
