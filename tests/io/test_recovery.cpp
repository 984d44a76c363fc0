// SPDX-License-Identifier: GPL-3.0-or-later
#include <csignal>
#include <cstdlib>

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <catch2/catch.hpp>

#include "croquis/base/error.h"
#include "croquis/document/backdrop.h"
#include "croquis/io/recovery.h"
#include "io/random_project.h"
#include "io/scratch.h"
#include "support/meshes/mesh_shapes.h"
#include "support/sample_count.h"

using namespace croquis;
using namespace croquis::test;
namespace fs = std::filesystem;

namespace {

const std::vector<std::uint8_t> picture = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n', 42};

ProjectFile recovered(const fs::path& file) {
  Progress progress;
  return recover(file, progress);
}

/// A document whose content follows from one number: some nodes stay, one changes, some come and go.
Document numbered(std::int64_t number) {
  static const auto heavy = std::make_shared<const PolyMesh>(grid(60, 60));
  static const Node fixed = [] {
    Node node;
    node.name = "heavy";
    node.source = heavy;
    return node;
  }();
  Document document = Document().with(fixed);
  Node drawing;
  drawing.name = "drawing";
  Drawing strokes;
  for (std::int64_t i = 0; i <= number % 7; ++i) {
    Stroke stroke;
    stroke.id = "stroke-" + std::to_string(number) + "-" + std::to_string(i);
    stroke.samples.resize(static_cast<std::size_t>(100 + number % 50));
    strokes.strokes.push_back(stroke);
  }
  drawing.source = std::make_shared<const Drawing>(std::move(strokes));
  document = document.with(drawing);
  Node operation;
  operation.operation = "inflate";
  operation.parameters["number"] = number;
  operation.inputs["sketch"] = {2, "value"};
  document = document.with(operation);
  if (number % 3 == 0) document = document.with(operation).without(1);
  return document;
}

std::int64_t number_of(const Document& document) {
  return std::get<std::int64_t>(document.find(3)->parameters.at("number"));
}

/// Commits in a process that then dies without closing.
void leave_behind(const fs::path& folder, const Document& document, const std::string& project_path) {
  REQUIRE(in_child([&] {
            WorkingCopy copy = WorkingCopy::create(folder);
            copy.commit(document, project_path, picture);
            ::_exit(0);
            return 0;
          }) == 0);
}

}  // namespace

TEST_CASE("the work of a process that died is found and recovered, then discarded") {
  const Scratch folder;
  leave_behind(folder / "state", numbered(5), "/home/a.croq");
  const auto found = find_recoverable(folder / "state");
  REQUIRE(found.size() == 1);
  CHECK(found[0].project_path == "/home/a.croq");
  CHECK(found[0].thumbnail_png == picture);
  CHECK(found[0].time.size() == 20);
  CHECK(found[0].time.ends_with("Z"));
  const ProjectFile work = recovered(found[0].file);
  CHECK(difference(numbered(5), work.document) == "");
  CHECK(work.warnings.empty());
  discard(found[0].file);
  CHECK(find_recoverable(folder / "state").empty());
  CHECK(fs::is_empty(folder / "state"));
}

TEST_CASE("work of living processes is not offered, neither of this one nor of others") {
  const Scratch folder;
  WorkingCopy own = WorkingCopy::create(folder.path());
  own.commit(numbered(1), "");
  CHECK(find_recoverable(folder.path()).empty());
  const pid_t child = ::fork();
  if (child == 0) {
    WorkingCopy other = WorkingCopy::create(folder.path());
    other.commit(numbered(2), "");
    write_bytes(folder / "ready", "");
    ::pause();
  }
  while (!fs::exists(folder / "ready")) ::usleep(1000);
  CHECK(find_recoverable(folder.path()).empty());
  ::kill(child, SIGKILL);
  ::waitpid(child, nullptr, 0);
  const auto found = find_recoverable(folder.path());
  REQUIRE(found.size() == 1);
  CHECK(number_of(recovered(found[0].file).document) == 2);
  CHECK(found[0].file != own.file());
}

TEST_CASE("closing cleanly leaves nothing; going without a word leaves the work") {
  const Scratch folder;
  {
    WorkingCopy copy = WorkingCopy::create(folder.path());
    copy.commit(numbered(1), "");
    copy.close_cleanly();
    copy.close_cleanly();
  }
  CHECK(fs::is_empty(folder.path()));
  {
    WorkingCopy copy = WorkingCopy::create(folder.path());
    copy.commit(numbered(1), "");
  }
  CHECK(find_recoverable(folder.path()).size() == 1);
}

TEST_CASE("a copy that never committed is nothing to recover and is swept away") {
  const Scratch folder;
  CHECK(in_child([&] {
          WorkingCopy copy = WorkingCopy::create(folder.path());
          ::_exit(0);
          return 0;
        }) == 0);
  write_bytes(folder / "99999-0.work", "");
  CHECK(find_recoverable(folder.path()).empty());
  leave_behind(folder.path(), numbered(3), "");
  WorkingCopy copy = WorkingCopy::create(folder.path());
  CHECK(find_recoverable(folder.path()).size() == 1);
  const auto names = folder.names();
  CHECK(std::count_if(names.begin(), names.end(), [](const auto& name) { return name.ends_with(".work"); }) == 2);
}

TEST_CASE("a working copy follows any series of edits") {
  const Scratch folder;
  Random random(4);
  for (int series = 0; series < sample_count(10, 200); ++series) {
    WorkingCopy copy = WorkingCopy::create(folder.path());
    Document document;
    std::vector<Document> history;
    for (int edit = 0; edit < 15; ++edit) {
      history.push_back(document);
      if (random.below(4) == 0) {
        document = history[random.below(static_cast<std::uint32_t>(history.size()))];
      } else if (!document.nodes().empty() && random.below(3) == 0) {
        Node changed = *document.nodes()[random.below(static_cast<std::uint32_t>(document.nodes().size()))];
        changed.name += "!";
        document = document.with(std::move(changed));
      } else {
        const Document more = random_document(random, 3);
        for (const auto& node : more.nodes()) {
          Node added = *node;
          added.id = random.below(3) == 0 ? 1 + random.below(10) : 0;
          document = document.with(std::move(added));
        }
        if (random.below(2) == 0 && !document.nodes().empty())
          document = document.without(document.nodes().front()->id);
      }
      copy.commit(document, "p");
      if (random.below(3) != 0) continue;
      const ProjectFile work = recovered(copy.file());
      CHECK(difference(document, work.document) == "");
      CHECK(work.warnings.empty());
    }
    copy.close_cleanly();
  }
}

TEST_CASE("a commit writes what has changed, not the meshes that stay") {
  const Scratch folder;
  WorkingCopy copy = WorkingCopy::create(folder.path());
  Node heavy;
  heavy.source = std::make_shared<const PolyMesh>(grid(500, 500));  // 11 MB
  Node light;
  light.operation = "fill";
  Document document = Document().with(heavy).with(light);
  copy.commit(document, "");
  const auto written = [&] {
    std::uintmax_t bytes = 0;
    for (const char* ending : {"", "-wal"}) {
      std::error_code error;
      const auto size = fs::file_size(copy.file().string() + ending, error);
      bytes += error ? 0 : size;
    }
    return bytes;
  };
  const std::uintmax_t before = written();
  rusage usage_before{};
  ::getrusage(RUSAGE_SELF, &usage_before);
  for (std::int64_t i = 0; i < 50; ++i) {
    light.id = 2;
    light.parameters["i"] = i;
    document = document.with(light);
    copy.commit(document, "");
  }
  rusage usage_after{};
  ::getrusage(RUSAGE_SELF, &usage_after);
  CHECK(before > 11'000'000);
  CHECK(written() <= before);  // the log is used again from its beginning
  CHECK((usage_after.ru_oublock - usage_before.ru_oublock) * 512 < 20'000'000);
}

TEST_CASE("a commit that fails keeps the last one, and the next one makes up for it") {
  const Scratch folder;
  CHECK(in_child([&] {
          std::signal(SIGXFSZ, SIG_IGN);
          WorkingCopy copy = WorkingCopy::create(folder.path());
          copy.commit(numbered(1), "");
          Node heavy;
          heavy.source = std::make_shared<const PolyMesh>(grid(300, 300));
          const Document larger = numbered(2).with(heavy);
          rlimit limits{};
          ::getrlimit(RLIMIT_FSIZE, &limits);
          const rlim_t usual = limits.rlim_cur;
          limits.rlim_cur = 500'000;
          ::setrlimit(RLIMIT_FSIZE, &limits);
          const Findings findings = findings_of([&] { copy.commit(larger, ""); });
          if (findings.size() != 1 || findings[0].code != "E_WRITE") return 1;
          if (!difference(numbered(1), recovered(copy.file()).document).empty()) return 2;
          limits.rlim_cur = usual;
          ::setrlimit(RLIMIT_FSIZE, &limits);
          copy.commit(larger, "");
          return difference(larger, recovered(copy.file()).document).empty() ? 0 : 3;
        }) == 0);
}

TEST_CASE("a state folder that can't be made is refused; one that isn't there has no work") {
  const Scratch folder;
  write_bytes(folder / "file", "");
  const Findings findings = findings_of([&] { WorkingCopy::create(folder / "file/state"); });
  REQUIRE(findings.size() == 1);
  CHECK(findings[0].code == "E_WRITE");
  CHECK(find_recoverable(folder / "missing").empty());
  CHECK(findings_of([&] { recovered(folder / "missing.work"); }).at(0).code == "E_FILE_OPEN");
}

TEST_CASE("remains that can't be read are listed and can be discarded") {
  const Scratch folder;
  write_bytes(folder / "12345-0.work", std::string(5000, 'x'));
  const auto found = find_recoverable(folder.path());
  REQUIRE(found.size() == 1);
  CHECK(found[0].time.empty());
  CHECK(findings_of([&] { recovered(found[0].file); }).at(0).code == "E_PROJECT_DAMAGED");
  discard(found[0].file);
  CHECK(fs::is_empty(folder.path()));
}

namespace {

/// Edits, commits and saves for ever; tells after each commit and save how far it is.
[[noreturn]] void edit_for_ever(const fs::path& folder, std::int64_t first, int reports) {
  WorkingCopy copy = WorkingCopy::create(folder / "state");
  for (std::int64_t number = first;; ++number) {
    const Document document = numbered(number);
    copy.commit(document, (folder / "a.croq").string(), picture);
    if (::write(reports, &number, sizeof number) != sizeof number) ::_exit(1);
    if (number % 3 != 0) continue;
    Progress progress;
    save_project(folder / "a.croq", {document, picture, {}}, progress);
  }
}

/// The last number that the process told before it was killed.
std::int64_t kill_after(const fs::path& folder, std::int64_t first, unsigned microseconds) {
  int ends[2];
  REQUIRE(::pipe(ends) == 0);
  const pid_t child = ::fork();
  if (child == 0) {
    ::close(ends[0]);
    edit_for_ever(folder, first, ends[1]);
  }
  ::close(ends[1]);
  std::int64_t last = first - 1;
  std::int64_t told = 0;
  // The clock starts at the first commit, so that a slow machine has something to lose, too.
  if (::read(ends[0], &told, sizeof told) == sizeof told) last = told;
  ::usleep(microseconds);
  ::kill(child, SIGKILL);
  while (::read(ends[0], &told, sizeof told) == sizeof told) last = told;
  ::close(ends[0]);
  ::waitpid(child, nullptr, 0);
  return last;
}

/// The numbers of the saved project and its backups, newest first; every one of them opens without a warning.
std::vector<std::int64_t> saved_numbers(const fs::path& folder) {
  std::vector<std::int64_t> numbers;
  for (const char* ending : {"", "~1", "~2", "~3"}) {
    const fs::path file = (folder / "a.croq").string() + ending;
    if (!fs::exists(file)) continue;
    Progress progress;
    const ProjectFile project = load_project(file, progress);
    CHECK(project.warnings.empty());
    numbers.push_back(number_of(project.document));
    CHECK(difference(numbered(numbers.back()), project.document) == "");
  }
  return numbers;
}

}  // namespace

TEST_CASE("a process killed at any moment loses one edit at most, and no saved version") {
  const Scratch folder;
  Random random(5);
  std::int64_t last = 0;
  std::size_t versions = 0;
  for (int kill = 0; kill < sample_count(5, 100); ++kill) {
    const std::int64_t first = last + 1;
    last = kill_after(folder.path(), first, random.below(60'000));
    const auto found = find_recoverable(folder / "state");
    REQUIRE(found.size() == 1);
    const ProjectFile work = recovered(found[0].file);
    CHECK(work.warnings.empty());
    const std::int64_t number = number_of(work.document);
    // It may have died after the commit and before it could tell.
    CHECK((number == last || number == last + 1));
    CHECK(difference(numbered(number), work.document) == "");
    last = number;
    discard(found[0].file);

    const auto numbers = saved_numbers(folder.path());
    // The oldest makes room before the save that was under way is done.
    CHECK(numbers.size() + 1 >= versions);
    versions = std::max(versions, numbers.size());
    CHECK(std::is_sorted(numbers.rbegin(), numbers.rend()));
    // Every third edit is saved before the next one is told.
    const std::int64_t saved = (last - 1) / 3 * 3;
    if (saved >= first) {
      REQUIRE(!numbers.empty());
      CHECK(numbers.front() >= saved);
    }
  }
  CHECK(versions > 1);
}

TEST_CASE("a picture behind a drawing survives a crash, and changing its opacity doesn't write it again") {
  const Scratch folder;
  Node node;
  node.source = std::make_shared<const Drawing>();
  const auto picture_file =
      std::make_shared<const PictureFile>(PictureFile{std::string(1'000'000, 'p'), 40, 30, "scan.png"});
  const auto behind = [&](double opacity) {
    node.backdrop = std::make_shared<const Backdrop>(Backdrop{picture_file, Vec2(1, 2), 2, opacity, true});
    return Document().with(node);
  };
  REQUIRE(in_child([&] {
            WorkingCopy copy = WorkingCopy::create(folder / "state");
            for (int i = 1; i <= 20; ++i) copy.commit(behind(i / 20.0), "", picture);
            ::_exit(0);
            return 0;
          }) == 0);
  const auto found = find_recoverable(folder / "state");
  REQUIRE(found.size() == 1);
  std::uintmax_t written = 0;
  for (const auto& file : fs::directory_iterator(folder / "state")) written += file.file_size();
  CHECK(written < 3'000'000);
  CHECK(difference(recovered(found[0].file).document, behind(1)) == "");
}

TEST_CASE("the steps that undo leads back to survive a crash, each state of a node written once") {
  const Scratch folder;
  std::vector<PastDocument> past;
  for (std::int64_t number = 1; number <= 12; ++number) {
    Document document = numbered(number);
    Node node = *document.find(2);
    node.enabled = number % 2 == 0;
    if (number % 4 == 0) node.transform.offset = Vec3(1, 2, static_cast<double>(number));
    past.push_back({"Step " + std::to_string(number), document.with(node)});
  }
  const KeptWork kept{{{3, {std::make_shared<const PolyMesh>(cube()), {}}}}, past};
  REQUIRE(in_child([&] {
            WorkingCopy copy = WorkingCopy::create(folder / "state");
            for (std::size_t count = 0; count <= past.size(); ++count) {
              KeptWork so_far{kept.results, {past.begin(), past.begin() + static_cast<std::ptrdiff_t>(count)}};
              copy.commit(numbered(static_cast<std::int64_t>(count)), "", picture, so_far);
            }
            // The oldest are forgotten, as they are where their number is bounded.
            copy.commit(numbered(20), "", picture, {kept.results, {past.begin() + 4, past.end()}});
            ::_exit(0);
            return 0;
          }) == 0);
  const auto found = find_recoverable(folder / "state");
  REQUIRE(found.size() == 1);
  const fs::path log = found[0].file.string() + "-wal";
  CHECK(fs::file_size(found[0].file) + (fs::exists(log) ? fs::file_size(log) : 0) < 8'000'000);
  const ProjectFile work = recovered(found[0].file);
  CHECK(work.warnings.empty());
  CHECK(difference(numbered(20), work.document) == "");
  REQUIRE(work.kept.results.size() == 1);
  REQUIRE(work.kept.past.size() == past.size() - 4);
  for (std::size_t i = 0; i < work.kept.past.size(); ++i) {
    CHECK(work.kept.past[i].label == past[i + 4].label);
    CHECK(difference(past[i + 4].document, work.kept.past[i].document) == "");
  }
}
