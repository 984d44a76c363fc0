// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/runner.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <exception>
#include <new>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include <sys/resource.h>

#include "cli/command_line.h"
#include "cli/mesh_text.h"
#include "cli/progress_display.h"
#include "cli/run_limits.h"
#include "croquis/base/described.h"
#include "croquis/base/error.h"
#include "croquis/base/exit_code.h"
#include "croquis/io/file.h"
#include "croquis/io/json.h"

namespace croquis::cli {
namespace {

/// What the runner measured around a command.
struct RunFigures {
  std::string command;
  std::string input;
  std::string output;
  double seconds = 0;
  std::vector<StageTime> stages;
  std::int64_t peak_memory_bytes = 0;
};

Report to_report(const Subject& subject) {
  Report report = croquis::to_report(fields(named("kind", subject.kind), named("id", name_of(subject))));
  if (subject.file) report.set("file", *subject.file);
  if (subject.line) report.set("line", *subject.line);
  if (!subject.at.empty()) report.set("at", Report::list(subject.at));
  return report;
}

Report to_report(const Finding& finding) {
  Report subjects = Report::array();
  for (const Subject& subject : finding.subjects) subjects.push(to_report(subject));
  Report report = croquis::to_report(
      fields(named("code", finding.code), named("message", finding.message), named("subject", subjects)));
  if (const auto& fix = finding.fix)
    report.set("fix", croquis::to_report(
                          fields(named("stroke", fix->stroke), named("group", fix->group), named("text", fix->text))));
  return report;
}

Report to_report(const Findings& findings) {
  Report report = Report::array();
  for (const Finding& finding : findings) report.push(to_report(finding));
  return report;
}

/// The report of a command that succeeded: one line of JSON without a newline.
std::string success_json(const RunFigures& figures, const CommandResult& result) {
  Report report = croquis::to_report(
      fields(named("command", figures.command), named("version", CROQUIS_VERSION), named("input", figures.input),
             named("output", figures.output), named("seconds", figures.seconds), named("stages", figures.stages),
             named("peak_memory_bytes", figures.peak_memory_bytes), named("warnings", to_report(result.warnings))));
  if (result.mesh) report.set("mesh", croquis::to_report(*result.mesh));
  if (result.details) report.set("details", *result.details);
  return write_json(report, JsonLayout::OneLine);
}

/// The report of a command that failed, with whatever it had found out before.
std::string failure_json(const std::string& command, const Findings& errors, const CommandResult& result) {
  Report report = croquis::to_report(
      fields(named("command", command), named("error", to_report(errors.front())), named("errors", to_report(errors))));
  if (!result.warnings.empty()) report.set("warnings", to_report(result.warnings));
  if (result.mesh) report.set("mesh", croquis::to_report(*result.mesh));
  return write_json(report, JsonLayout::OneLine);
}

std::int64_t peak_memory_bytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::int64_t>(usage.ru_maxrss) * 1024;
}

Finding internal_finding(const std::string& reason) {
  return make_error(Category::Internal, "E_INTERNAL",
                    "Internal error (" + reason + "); please report it with the input.");
}

Finding memory_finding() {
  return make_error(Category::Limit, "E_MEMORY",
                    "There is not enough memory for this input; allow more with --max-memory or make it smaller.");
}

Finding stopped_finding(StopReason reason) {
  if (reason == StopReason::TimedOut) {
    return make_error(Category::Limit, "E_TIMEOUT", "The time of --timeout is over; nothing was written.");
  }
  return make_error(Category::Limit, "E_INTERRUPTED", "Interrupted; nothing was written.");
}

void print(std::FILE* stream, const std::string& text) {
  std::fwrite(text.data(), 1, text.size(), stream);
  std::fputc('\n', stream);
}

/// " at (12, 30), (14, 31)": a terminal has no mark that shows where a finding is.
std::string places_text(const Finding& finding) {
  constexpr std::size_t most_places = 4;
  std::vector<std::string> places;
  for (const Subject& subject : finding.subjects) {
    std::string place;
    for (const double coordinate : subject.at) place += (place.empty() ? "" : ", ") + number_text(coordinate);
    if (place.empty() || places.size() == most_places) continue;
    if (std::find(places.begin(), places.end(), place) == places.end()) places.push_back(std::move(place));
  }
  std::string text;
  for (const std::string& place : places) text += (text.empty() ? " at (" : ", (") + place + ")";
  return text;
}

const char* word_of(Severity severity) {
  if (severity == Severity::Error) return "error";
  return severity == Severity::Warning ? "warning" : "note";
}

void print_findings(const Findings& findings) {
  for (const Finding& finding : findings) {
    const char* word = word_of(finding.severity);
    std::fprintf(stderr, "%s: %s [%s%s]\n", word, finding.message.c_str(), finding.code.c_str(),
                 places_text(finding).c_str());
  }
}

/// Only the errors of a mixed list; a failure's warnings stay warnings.
Findings errors_of(const Findings& findings) {
  Findings errors;
  for (const Finding& finding : findings) {
    if (finding.severity == Severity::Error) errors.push_back(finding);
  }
  return errors.empty() ? findings : errors;
}

/// Files go to disk together, after everything else has succeeded; "-" goes to standard output.
void write_files(const CommandResult& result) {
  OutputTransaction transaction;
  for (const auto& [path, bytes] : result.files) {
    if (path != "-") transaction.add(path, bytes);
  }
  transaction.commit();
  const auto stream = result.files.find("-");
  if (stream == result.files.end()) return;
  const std::size_t written = std::fwrite(stream->second.data(), 1, stream->second.size(), stdout);
  if (written != stream->second.size() || std::fflush(stdout) != 0) {
    throw Error(make_error(Category::Io, "E_WRITE", "Standard output can't be written."));
  }
}

/// One run of one command: what it found, and the exit code it stands for.
struct Outcome {
  CommandResult result;
  Findings errors;
  int code = exit_done;
};

void fail(Outcome& outcome, Findings findings, int code) {
  outcome.errors = errors_of(findings);
  outcome.code = code;
  for (Finding& finding : findings) {
    if (finding.severity != Severity::Error) outcome.result.warnings.push_back(std::move(finding));
  }
}

int code_of(const Findings& findings) { return exit_code_of(errors_of(findings).front().category); }

Outcome execute(const Command& command, const Invocation& invocation, ProgressDisplay& display) {
  Outcome outcome;
  const RunLimits limits(invocation.timeout, invocation.memory_limit);
  Progress progress(display.sink(), limits.cancel_flag());
  try {
    command.run(invocation, outcome.result, progress);
    progress.check();
    write_files(outcome.result);
  } catch (const Cancelled&) {
    const StopReason reason = limits.reason();
    fail(outcome, {stopped_finding(reason)}, reason == StopReason::TimedOut ? exit_limit : exit_interrupted);
  } catch (const Error& error) {
    fail(outcome, error.findings(), code_of(error.findings()));
  } catch (const std::bad_alloc&) {
    fail(outcome, {memory_finding()}, exit_limit);
  } catch (const std::system_error& error) {
    // A thread that has no room for its stack.
    const bool no_room = error.code() == std::errc::resource_unavailable_try_again;
    fail(outcome, {no_room ? memory_finding() : internal_finding(error.what())}, no_room ? exit_limit : exit_internal);
  } catch (const std::exception& exception) {
    fail(outcome, {internal_finding(exception.what())}, exit_internal);
  }
  // Notes count too: what was only guessed is named for an input that is read strictly.
  if (outcome.code == exit_done && invocation.strict && !outcome.result.warnings.empty()) outcome.code = exit_warnings;
  return outcome;
}

/// For people: the files, once they are written, and the command's text.
std::string text_of(const Outcome& outcome) {
  std::string text;
  for (const auto& [path, bytes] : outcome.result.files) {
    if (path != "-" && outcome.errors.empty()) text += (text.empty() ? "Wrote " : ", ") + path;
  }
  if (!text.empty() && !outcome.result.text.empty()) text += '\n';
  return text + outcome.result.text;
}

void print_outcome(const Invocation& invocation, const RunFigures& figures, const Outcome& outcome) {
  const bool to_stdout = outcome.result.files.contains("-");
  if (!invocation.quiet) print_findings(outcome.result.warnings);
  print_findings(outcome.errors);
  const bool succeeded = outcome.errors.empty();
  const std::string text = text_of(outcome);
  if (!invocation.quiet && !text.empty() && (succeeded || outcome.result.mesh)) {
    print(invocation.json || to_stdout ? stderr : stdout, text);
  }
  if (!invocation.json) return;
  const std::string json =
      succeeded ? success_json(figures, outcome.result) : failure_json(figures.command, outcome.errors, outcome.result);
  print(to_stdout ? stderr : stdout, json);
}

int refuse(const std::vector<std::string>& arguments, const Findings& findings) {
  print_findings(findings);
  const bool json = std::find(arguments.begin(), arguments.end(), "--json") != arguments.end();
  if (json) print(stdout, failure_json(arguments.front(), findings, {}));
  return code_of(findings);
}

}  // namespace

int run(const std::vector<std::string>& arguments, const std::vector<Command>& commands) {
  ParsedLine line;
  try {
    line = parse_command_line(arguments, commands);
  } catch (const Error& error) {
    return refuse(arguments, error.findings());
  }
  if (line.command == nullptr) {
    print(stdout, line.text);
    return exit_done;
  }
  const auto began = std::chrono::steady_clock::now();
  ProgressDisplay display(line.invocation.progress, line.invocation.quiet);
  const Outcome outcome = execute(*line.command, line.invocation, display);
  RunFigures figures;
  figures.command = line.command->description.name;
  figures.input = line.invocation.input;
  figures.output = line.invocation.output;
  figures.stages = display.stages();
  figures.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  figures.peak_memory_bytes = peak_memory_bytes();
  print_outcome(line.invocation, figures, outcome);
  return outcome.code;
}

}  // namespace croquis::cli
