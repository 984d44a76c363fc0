// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/child_process.h"

#include <cerrno>

#include <fcntl.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace croquis::bench {
namespace {

double in_ms(const timeval& time) {
  return 1e3 * static_cast<double>(time.tv_sec) + 1e-3 * static_cast<double>(time.tv_usec);
}

}  // namespace

std::optional<ChildUse> use_of(const std::vector<std::string>& command) {
  std::vector<char*> arguments;
  for (const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
  pid_t child = 0;
  const int failure = posix_spawnp(&child, arguments[0], &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (failure != 0) return std::nullopt;
  int status = 0;
  rusage usage{};
  while (wait4(child, &status, 0, &usage) < 0) {
    if (errno != EINTR) return std::nullopt;
  }
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) return std::nullopt;
  return ChildUse{in_ms(usage.ru_utime) + in_ms(usage.ru_stime), static_cast<double>(usage.ru_maxrss) / 1024};
}

std::optional<double> cpu_ms_of(const std::vector<std::string>& command) {
  const auto use = use_of(command);
  return use ? std::optional(use->cpu_ms) : std::nullopt;
}

bool is_installed(const std::string& program) {
  return cpu_ms_of({"sh", "-c", "command -v \"$1\"", "sh", program}).has_value();
}

}  // namespace croquis::bench
