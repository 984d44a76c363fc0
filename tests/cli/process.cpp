// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/process.h"

#include <array>
#include <chrono>
#include <csignal>
#include <ctime>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <thread>

#include <fcntl.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "support/sanitizers.h"

namespace croquis::test {
namespace {

constexpr int kill_after_ms = 60'000 * slowness;

struct Pipe {
  std::array<int, 2> ends{};
  Pipe() {
    if (pipe(ends.data()) != 0) throw std::runtime_error("no pipe");
  }
};

[[noreturn]] void become_cli(const std::vector<std::string>& arguments, const ProcessOptions& options,
                             const std::array<Pipe, 3>& pipes) {
  for (int stream = 0; stream < 3; ++stream) {
    const Pipe& pipe = pipes[static_cast<std::size_t>(stream)];
    dup2(pipe.ends[stream == 0 ? 0 : 1], stream);
    close(pipe.ends[0]);
    close(pipe.ends[1]);
  }
  if (!options.folder.empty() && chdir(options.folder.c_str()) != 0) _exit(126);
  std::vector<std::string> words = {CROQUIS_CLI};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  execv(argv[0], argv.data());
  _exit(127);
}

/// Processor time of a program that runs; 0 where it can't be known.
double cpu_seconds_of(pid_t child) {
  clockid_t clock{};
  timespec time{};
  if (clock_getcpuclockid(child, &clock) != 0 || clock_gettime(clock, &time) != 0) return 0;
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// Reads what is there; false at the end of the stream.
bool drain(int descriptor, std::string& text) {
  std::array<char, 65536> buffer;
  const ssize_t count = read(descriptor, buffer.data(), buffer.size());
  if (count <= 0) return false;
  text.append(buffer.data(), static_cast<std::size_t>(count));
  return true;
}

/// @return the processor time until it was interrupted; 0 if it wasn't
double collect(pid_t child, int out, int err, const ProcessOptions& options, ProcessResult& result) {
  using Clock = std::chrono::steady_clock;
  const auto began = Clock::now();
  bool interrupted = options.interrupt_after_ms == 0 && options.interrupt_at.empty();
  double cpu_seconds = 0;
  std::array<pollfd, 2> streams = {{{out, POLLIN, 0}, {err, POLLIN, 0}}};
  std::array<std::string*, 2> texts = {&result.out, &result.err};
  int open = 2;
  while (open > 0) {
    poll(streams.data(), streams.size(), 5);
    for (std::size_t i = 0; i < 2; ++i) {
      if (streams[i].fd < 0 || streams[i].revents == 0) continue;
      if (!drain(streams[i].fd, *texts[i])) {
        streams[i].fd = -1;
        --open;
      }
    }
    const auto elapsed = std::chrono::duration_cast<std::chrono::milliseconds>(Clock::now() - began).count();
    const bool is_time = options.interrupt_at.empty() ? elapsed >= slowness * options.interrupt_after_ms
                                                      : result.err.find(options.interrupt_at) != std::string::npos;
    if (!interrupted && is_time) {
      cpu_seconds = cpu_seconds_of(child);
      kill(child, SIGINT);
      interrupted = true;
    }
    if (elapsed > kill_after_ms) kill(child, SIGKILL);
  }
  return cpu_seconds;
}

}  // namespace

ProcessResult run_cli(const std::vector<std::string>& arguments, const ProcessOptions& options) {
  std::array<Pipe, 3> pipes;
  const pid_t child = fork();
  if (child == 0) become_cli(arguments, options, pipes);
  close(pipes[0].ends[0]);
  close(pipes[1].ends[1]);
  close(pipes[2].ends[1]);
  std::thread feeder([&options, descriptor = pipes[0].ends[1]] {
    std::signal(SIGPIPE, SIG_IGN);
    std::size_t sent = 0;
    while (sent < options.standard_input.size()) {
      const ssize_t count =
          write(descriptor, options.standard_input.data() + sent, options.standard_input.size() - sent);
      if (count <= 0) break;
      sent += static_cast<std::size_t>(count);
    }
    close(descriptor);
  });
  ProcessResult result;
  const double interrupted_at = collect(child, pipes[1].ends[0], pipes[2].ends[0], options, result);
  feeder.join();
  close(pipes[1].ends[0]);
  close(pipes[2].ends[0]);
  int status = 0;
  rusage usage{};
  wait4(child, &status, 0, &usage);
  result.code = WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
  if (!is_sanitized) result.peak_kilobytes = usage.ru_maxrss;
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  };
  result.cpu_seconds = seconds(usage.ru_utime) + seconds(usage.ru_stime);
  if (interrupted_at > 0) result.cpu_seconds_interrupted = result.cpu_seconds - interrupted_at;
  return result;
}

std::string slurp(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

}  // namespace croquis::test
