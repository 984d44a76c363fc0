// SPDX-License-Identifier: GPL-3.0-or-later
// Documents that people keep under names, in project files and after a crash.
#include <unistd.h>

#include <catch2/catch.hpp>

#include "croquis/document/value_bytes.h"
#include "croquis/io/file.h"
#include "croquis/io/project_file.h"
#include "croquis/io/recovery.h"
#include "io/random_project.h"
#include "io/scratch.h"
#include "support/meshes/mesh_shapes.h"
#include "support/trial_operation.h"

using namespace croquis;
using namespace croquis::test;

namespace {

std::vector<std::uint8_t> png(std::uint8_t content) { return {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n', content}; }

void check_same(const std::vector<Version>& wanted, const std::vector<Version>& read) {
  REQUIRE(read.size() == wanted.size());
  for (std::size_t i = 0; i < read.size(); ++i) {
    CHECK(read[i].name == wanted[i].name);
    CHECK(difference(wanted[i].document, read[i].document) == "");
    CHECK(read[i].picture_png == wanted[i].picture_png);
  }
}

/// Some share nodes with the document, some don't.
std::vector<Version> versions_of(const Document& document, Random& random) {
  Node renamed = *document.nodes().front();
  renamed.name = "other";
  return {{"Short legs", document, png(1)},
          {"긴 다리 \"2\"", document.with(renamed), {}},
          {"", random_document(random, 5), png(3)},
          {"empty", Document(), {}}};
}

Document torus_document() { return Document().with(source_node(std::make_shared<const PolyMesh>(torus(40, 30)))); }

std::string saved(const Scratch& folder, const ProjectFile& project) {
  Progress progress;
  save_project(folder / "a.croq", project, progress);
  return read_file((folder / "a.croq").string());
}

}  // namespace

TEST_CASE("versions are in the project's file, and projects without them are what they were") {
  Random random(3);
  const Scratch folder;
  ProjectFile project{torus_document(), {}, {}};
  const std::string plain = saved(folder, project);
  CHECK(plain.find("versions") == std::string::npos);
  project.kept.versions = versions_of(project.document, random);
  const std::string bytes = saved(folder, project);
  CHECK(saved(folder, project) == bytes);
  // The torus is there once, for document and versions.
  CHECK(bytes.size() < plain.size() + plain.size() / 2 + 100'000);
  CHECK(static_cast<int>(bytes[63]) == 5);
  CHECK(bytes.find("readable_since1") != std::string::npos);
  Progress progress;
  const ProjectFile loaded = load_project(folder / "a.croq", progress);
  CHECK(loaded.warnings.empty());
  CHECK(difference(project.document, loaded.document) == "");
  CHECK(loaded.kept.past.empty());
  check_same(project.kept.versions, loaded.kept.versions);
}

TEST_CASE("of versions whose nodes can't be read each is named, and the others are kept") {
  const Scratch folder;
  Node lost = source_node(std::make_shared<const PolyMesh>(grid(30, 20)), "lost");
  ProjectFile project{torus_document(), {}, {}};
  project.kept.versions = {{"whole", project.document, png(1)}, {"broken", Document().with(lost), png(2)}};
  std::string bytes = saved(folder, project);
  const auto at = bytes.find(encode(*lost.source).substr(100, 60));
  REQUIRE(at != std::string::npos);
  bytes[at + 20] = static_cast<char>(bytes[at + 20] ^ 1);
  Progress progress;
  const ProjectFile read = read_project(bytes, "a.croq", progress);
  CHECK(difference(project.document, read.document) == "");
  check_same({project.kept.versions[0]}, read.kept.versions);
  REQUIRE(!read.warnings.empty());
  CHECK(read.warnings[0].code == "W_PROJECT_DAMAGED");
  CHECK(read.warnings[0].message.find("'broken'") != std::string::npos);
}

TEST_CASE("versions survive a crash as they were last: added, renamed and deleted") {
  Random random(4);
  const Scratch folder;
  const Document document = torus_document();
  std::vector<Version> versions = versions_of(document, random);
  std::vector<Version> last = {versions[2], versions[0]};
  last[0].name = "renamed";
  REQUIRE(in_child([&] {
            WorkingCopy copy = WorkingCopy::create(folder.path());
            copy.commit(document, "", {}, {{}, {{"Draw", document}}, {}});
            for (std::size_t count = 1; count <= versions.size(); ++count) {
              const auto end = versions.begin() + static_cast<std::ptrdiff_t>(count);
              copy.commit(document, "", {}, {{}, {{"Draw", document}}, {versions.begin(), end}});
            }
            copy.commit(document, "", {}, {{}, {}, last});
            ::_exit(0);
            return 0;
          }) == 0);
  const auto found = find_recoverable(folder.path());
  REQUIRE(found.size() == 1);
  Progress progress;
  const ProjectFile work = recover(found[0].file, progress);
  CHECK(work.warnings.empty());
  CHECK(work.kept.past.empty());
  check_same(last, work.kept.versions);
}
