// SPDX-License-Identifier: GPL-3.0-or-later
#include <csignal>

#include <sys/wait.h>
#include <unistd.h>

#include <catch2/catch.hpp>

#include "croquis/io/file.h"
#include "croquis/io/project_file.h"
#include "croquis/io/project_lock.h"
#include "croquis/io/recovery.h"
#include "io/random_project.h"
#include "io/scratch.h"

using namespace croquis;
using namespace croquis::test;
namespace fs = std::filesystem;

namespace {

std::vector<std::string> names_in(const fs::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace

TEST_CASE("a project that is open is locked for others, by whatever name, until it is closed") {
  const Scratch folder;
  write_bytes(folder / "a.croq", "");
  fs::create_symlink(folder / "a.croq", folder / "link.croq");
  {
    const auto own = ProjectLock::take(folder / "state", folder / "a.croq");
    REQUIRE(own);
    CHECK(!ProjectLock::take(folder / "state", folder / "a.croq"));
    CHECK(!ProjectLock::take(folder / "state", folder / "link.croq"));
    CHECK(!ProjectLock::take(folder / "state", folder / "state" / ".." / "a.croq"));
    CHECK(ProjectLock::take(folder / "state", folder / "b.croq"));
    CHECK(find_recoverable(folder / "state").empty());
  }
  CHECK(ProjectLock::take(folder / "state", folder / "a.croq"));
  CHECK(fs::is_empty(folder / "state"));
}

TEST_CASE("another process' lock is seen while it lives, and blocks nobody once it is killed") {
  const Scratch folder;
  const pid_t child = ::fork();
  if (child == 0) {
    const auto lock = ProjectLock::take(folder / "state", folder / "a.croq");
    write_bytes(folder / "ready", lock ? "locked" : "");
    ::pause();
  }
  while (!fs::exists(folder / "ready")) ::usleep(1000);
  CHECK(!ProjectLock::take(folder / "state", folder / "a.croq"));
  ::kill(child, SIGKILL);
  ::waitpid(child, nullptr, 0);
  CHECK(!fs::is_empty(folder / "state"));
  const auto own = ProjectLock::take(folder / "state", folder / "a.croq");
  CHECK(own);
  // Sweeping up what dead processes left keeps the locks of the living.
  const WorkingCopy copy = WorkingCopy::create(folder / "state");
  CHECK(!ProjectLock::take(folder / "state", folder / "a.croq"));
}

TEST_CASE("projects and their backups are known by name") {
  for (const char* name : {"a.croq", "/b/A.CROQ", "a.croq~1", "a.croq~3", "a.croq~damaged", "a.croq~damaged-2"}) {
    INFO(name);
    CHECK(is_project_name(name));
  }
  for (const char* name : {"a.obj", "a.croq.svg", "croq", "a.croq~", "a.croq~x", "a.obj~1", "a~1.obj"}) {
    INFO(name);
    CHECK(!is_project_name(name));
  }
  CHECK(project_of_backup("/b/a.croq~2") == fs::path("/b/a.croq"));
  CHECK(project_of_backup("a.croq~damaged-2") == fs::path("a.croq"));
  CHECK(!project_of_backup("/b/a.croq"));
}

TEST_CASE("the backups of a project are listed, the newest first, and a damaged one is put aside without losing any") {
  const Scratch folder;
  const fs::path project = folder / "a.croq";
  CHECK(project_backups(project).empty());
  Progress progress;
  Random random(11);
  for (int version = 0; version < 5; ++version) save_project(project, {random_document(random, 3), {}, {}}, progress);
  fs::create_symlink(project, folder / "link.croq");
  for (const char* name : {"a.croq", "link.croq"}) {
    const auto backups = project_backups(folder / name);
    REQUIRE(backups.size() == 3);
    for (std::size_t number = 1; number <= 3; ++number) {
      CHECK(backups[number - 1].filename() == "a.croq~" + std::to_string(number));
    }
  }
  const std::string damaged = "damaged";
  write_bytes(project, damaged);
  const fs::path aside = put_damaged_project_aside(folder / "link.croq");
  CHECK(aside.filename() == "a.croq~damaged");
  CHECK(!fs::exists(project));
  save_project(project, {random_document(random, 3), {}, {}}, progress);
  CHECK(project_backups(project).size() == 3);
  CHECK(read_file(aside.string()) == damaged);
  write_bytes(project, damaged);
  CHECK(put_damaged_project_aside(project).filename() == "a.croq~damaged-2");
  CHECK(names_in(folder.path()) == std::vector<std::string>{"a.croq~1", "a.croq~2", "a.croq~3", "a.croq~damaged",
                                                            "a.croq~damaged-2", "link.croq"});
}
