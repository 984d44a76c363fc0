// SPDX-License-Identifier: GPL-3.0-or-later
// croquis-mutate SYSTEM FIRST COUNT [FOLDER]   runs the commands of croquis-cli on COUNT mutated inputs
// croquis-mutate SYSTEM FILE…                  runs all commands of the system on these files, as they are
//
// Inputs are numbered: the same number gives the same input, and a run goes on where another one ended. A child process
// runs them one by one, so that one that crashes or hangs is named, kept in FOLDER, and the rest goes on. The exit
// status is 1 when something was found.
#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <memory>
#include <new>
#include <string>
#include <utility>
#include <vector>

#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include "cli/command_line.h"
#include "croquis/base/error.h"
#include "croquis/base/text.h"
#include "croquis/io/mesh_file.h"
#include "croquis/operators/all_operations.h"
#include "fuzz/mutation_inputs.h"
#include "support/sanitizers.h"

namespace croquis::test {
namespace {

using Commands = std::vector<cli::Command>;

constexpr int most_seconds = 20 * slowness;      // of processor time, for one input
constexpr rlim_t most_memory = rlim_t{4} << 30;  // of address space, where sanitizers leave it alone
constexpr std::size_t most_faces = 2'000'000;    // of a small input's result

bool is_nan(double number) { return std::isnan(number); }
bool is_not_finite(double number) { return !std::isfinite(number); }

/// The first wrong number of a report, by its path; empty when there is none.
std::string wrong_in(const Report& report, const std::string& path, bool (*is_wrong)(double)) {
  if (const auto* number = std::get_if<double>(&report.value())) return is_wrong(*number) ? path : "";
  std::string found;
  if (const auto* list = std::get_if<Report::Array>(&report.value())) {
    for (std::size_t i = 0; i < list->size() && found.empty(); ++i)
      found = wrong_in((*list)[i], path + '[' + std::to_string(i) + ']', is_wrong);
  } else if (const auto* members = std::get_if<Report::Object>(&report.value())) {
    for (std::size_t i = 0; i < members->size() && found.empty(); ++i)
      found = wrong_in((*members)[i].second, path + '.' + (*members)[i].first, is_wrong);
  }
  return found;
}

std::string fault_in(const Findings& findings) {
  for (const Finding& finding : findings) {
    if (finding.code.empty() || finding.message.empty()) return "a finding without a code or a sentence";
    if (finding.category == Category::Internal) return finding.code + ": " + finding.message;
    for (const Subject& subject : finding.subjects) {
      for (const double coordinate : subject.at) {
        if (!std::isfinite(coordinate)) return finding.code + " is at a place that is not finite";
      }
    }
  }
  return "";
}

/// A mesh that was written must read back, and be something. @param points_alone what was given may have no more
std::string fault_in_file(const std::string& path, const std::string& bytes, bool points_alone) {
  if (bytes.empty()) return path + " is empty";
  const std::string extension = std::filesystem::path(path).extension().string();
  if (extension != ".obj" && extension != ".ply" && extension != ".stl" && extension != ".off") return "";
  Progress progress;
  try {
    const MeshFormat format = extension == ".obj"   ? MeshFormat::Obj
                              : extension == ".ply" ? MeshFormat::Ply
                              : extension == ".stl" ? MeshFormat::Stl
                                                    : MeshFormat::Off;
    const PolyMesh mesh = read_mesh({bytes, format, path, false}, progress).mesh;
    if (mesh.face_count() > most_faces) return path + " has " + counted(mesh.face_count(), "face", "faces");
    const bool has_shape = mesh.face_count() + mesh.line_count() > 0 || points_alone || !path.starts_with("o.");
    return has_shape ? "" : path + " has nothing in it";
  } catch (const Error& error) {
    return path + " can't be read back: " + error.what();
  }
}

std::string fault_in(const cli::CommandResult& result, bool points_alone) {
  std::string fault = fault_in(result.warnings);
  // In details what there is nothing of may be infinite, as the least gap of what lies alone.
  if (fault.empty() && result.details) fault = wrong_in(*result.details, "details", is_nan);
  if (fault.empty() && result.mesh) fault = wrong_in(to_report(*result.mesh), "mesh", is_not_finite);
  for (auto file = result.files.begin(); file != result.files.end() && fault.empty(); ++file)
    fault = fault_in_file(file->first, file->second, points_alone);
  return fault;
}

/// What is wrong with how a command took its input; empty when nothing is.
std::string fault_of(const Arguments& arguments, const Commands& commands) {
  try {
    const cli::ParsedLine line = cli::parse_command_line(arguments, commands);
    if (line.command == nullptr) return "";
    cli::CommandResult result;
    Progress progress;
    line.command->run(line.invocation, result, progress);
    std::puts("  done");
    return fault_in(result, arguments.front() == "convert");
  } catch (const Error& error) {
    if (!error.findings().empty()) std::printf("  %s\n", error.findings().front().code.c_str());
    return has_errors(error.findings()) ? fault_in(error.findings()) : "a failure without an error";
  } catch (const std::bad_alloc&) {
    return "not enough memory";
  } catch (const std::exception& exception) {
    return std::string("an exception: ") + exception.what();
  }
}

std::string text_of(const Arguments& arguments) {
  std::string text;
  for (const std::string& argument : arguments) text += ' ' + argument;
  return text;
}

/// Ends the process when one input takes too much processor time.
void start_watch() {
  itimerval limit{};
  limit.it_value.tv_sec = most_seconds;
  setitimer(ITIMER_PROF, &limit, nullptr);
}

/// Where a child process is and what it found, so that its parent knows when it is gone.
struct Shared {
  std::atomic<std::uint64_t> next, found;
};

Shared& shared_counts() {
  void* page = mmap(nullptr, sizeof(Shared), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (page == MAP_FAILED) std::abort();
  return *new (page) Shared{};
}

/// Inputs from `shared.next` on, in this process.
void run_inputs(const MutationSystem& system, Shared& shared, std::uint64_t end, const std::filesystem::path& folder) {
  const Registry registry = all_operations();
  const Commands commands = cli::all_commands(registry);
  for (; shared.next < end; ++shared.next) {
    const MutatedInput input = write_mutated_input(system, shared.next, folder);
    std::printf("%s %llu:%s\n", system.name.c_str(), static_cast<unsigned long long>(shared.next.load()),
                text_of(input.arguments).c_str());
    std::fflush(stdout);
    start_watch();
    const std::string fault = fault_of(input.arguments, commands);
    if (fault.empty()) {
      std::filesystem::remove(input.file);
      continue;
    }
    ++shared.found;
    std::printf("FOUND %s\n", fault.c_str());
  }
  std::fflush(stdout);
}

/// @return how many faults were found, those included that ended a process
std::uint64_t run_numbers(const MutationSystem& system, std::uint64_t first, std::uint64_t count,
                          const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  Shared& shared = shared_counts();
  for (shared.next = first; shared.next < first + count; ++shared.next) {
    std::fflush(stdout);  // or the child prints once more what still waits to be printed
    const pid_t child = fork();
    if (child == 0) {
      const rlimit memory{most_memory, most_memory};
      if (!is_sanitized) setrlimit(RLIMIT_AS, &memory);
      run_inputs(system, shared, first + count, folder);
      std::_Exit(EXIT_SUCCESS);
    }
    int status = 0;
    waitpid(child, &status, 0);
    // A command that ends the process in the middle is a fault too, whatever status it gives.
    if (WIFEXITED(status) && WEXITSTATUS(status) == EXIT_SUCCESS && shared.next >= first + count) break;
    const bool slow = WIFSIGNALED(status) && WTERMSIG(status) == SIGPROF;
    std::printf("FOUND %s\n", slow ? "it takes too long" : "the program ended");
    ++shared.found;
  }
  const std::uint64_t found = shared.found;
  std::printf("%s: %llu inputs from %llu on, %llu findings\n", system.name.c_str(),
              static_cast<unsigned long long>(count), static_cast<unsigned long long>(first),
              static_cast<unsigned long long>(found));
  return found;
}

std::uint64_t run_files(const MutationSystem& system, const Arguments& files) {
  const Registry registry = all_operations();
  const Commands commands = cli::all_commands(registry);
  std::uint64_t found = 0;
  for (const std::string& file : files) {
    for (const Arguments& arguments : commands_on(system, file)) {
      std::printf("%s:%s\n", system.name.c_str(), text_of(arguments).c_str());
      std::fflush(stdout);
      start_watch();
      const std::string fault = fault_of(arguments, commands);
      if (fault.empty()) continue;
      ++found;
      std::printf("FOUND %s\n", fault.c_str());
    }
  }
  return found;
}

std::uint64_t run_mutations(const Arguments& arguments) {
  for (const MutationSystem& system : mutation_systems()) {
    if (arguments.size() < 2 || system.name != arguments[0]) continue;
    std::uint64_t first = 0, count = 0;
    const bool numbered = arguments.size() >= 3 && read_number(arguments[1], first) && read_number(arguments[2], count);
    if (!numbered) return run_files(system, {arguments.begin() + 1, arguments.end()});
    return run_numbers(system, first, count, arguments.size() > 3 ? arguments[3] : "mutate-findings");
  }
  std::fprintf(stderr, "usage: croquis-mutate SYSTEM FIRST COUNT [FOLDER], or croquis-mutate SYSTEM FILE…\nsystems:");
  for (const MutationSystem& system : mutation_systems()) std::fprintf(stderr, " %s", system.name.c_str());
  std::fputc('\n', stderr);
  return 2;
}

}  // namespace
}  // namespace croquis::test

int main(int argc, char** argv) {
  return croquis::test::run_mutations({argv + 1, argv + argc}) == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
