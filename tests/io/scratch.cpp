// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/scratch.h"

#include <fstream>

#include <sys/wait.h>
#include <unistd.h>

#include "croquis/base/error.h"

namespace croquis::test {

namespace fs = std::filesystem;

void write_bytes(const fs::path& path, const std::string& bytes) {
  std::ofstream stream(path, std::ios::binary | std::ios::trunc);
  stream << bytes;
}

Findings findings_of(const std::function<void()>& call) {
  try {
    call();
  } catch (const Error& error) {
    return error.findings();
  }
  return {};
}

int in_child(const std::function<int()>& body) {
  const pid_t child = ::fork();
  if (child == 0) {
    int code = 99;
    try {
      code = body();
    } catch (...) {
    }
    ::_exit(code);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
}

}  // namespace croquis::test
