// SPDX-License-Identifier: GPL-3.0-or-later
#include <functional>
#include <memory>

#include <sqlite3.h>
#include <sys/resource.h>

#include <catch2/catch.hpp>

#include "croquis/base/error.h"
#include "croquis/document/value_bytes.h"
#include "croquis/io/file.h"
#include "croquis/io/project_file.h"
#include "fuzz/readers.h"
#include "io/random_project.h"
#include "io/scratch.h"
#include "support/meshes/mesh_shapes.h"
#include "support/sample_count.h"
#include "support/sanitizers.h"
#include "support/trial_operation.h"

using namespace croquis;
using namespace croquis::test;
namespace fs = std::filesystem;

namespace {

/// A mesh, a drawing and an operation on them.
Document small_document() {
  Random random(7);
  const Node mesh = source_node(std::make_shared<const PolyMesh>(cube()), "body");
  const Node drawing = source_node(std::make_shared<const Drawing>(random_drawing(random)), "lines");
  Node operation;
  operation.name = "solid";
  operation.operation = "inflate";
  operation.parameters = {{"flag", true}, {"count", std::int64_t{3}}, {"size", 0.5}, {"word", std::string("tablet")}};
  operation.inputs = {{"sketch", {2, "value"}}, {"with", {1, "value"}}};
  return Document().with(mesh).with(drawing).with(operation);
}

std::string saved(const Document& document) {
  const Scratch folder;
  Progress progress;
  save_project(folder / "a.croq", {document, {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n', 1}, {}}, progress);
  return read_file((folder / "a.croq").string());
}

ProjectFile read(const std::string& bytes) {
  Progress progress;
  return read_project(bytes, "fuzzed", progress);
}

/// The project with statements run on it as any SQLite tool would.
std::string edited(const Document& document, const std::string& sql) {
  const Scratch folder;
  const fs::path file = folder / "a.croq";
  write_bytes(file, saved(document));
  sqlite3* handle = nullptr;
  REQUIRE(sqlite3_open(file.c_str(), &handle) == SQLITE_OK);
  char* message = nullptr;
  const int code = sqlite3_exec(handle, sql.c_str(), nullptr, nullptr, &message);
  INFO(sql << ": " << (message == nullptr ? "" : message));
  CHECK(code == SQLITE_OK);
  sqlite3_free(message);
  sqlite3_close(handle);
  return read_file(file.string());
}

bool has_warning(const ProjectFile& project, const std::string& code, const std::string& word) {
  return std::any_of(project.warnings.begin(), project.warnings.end(), [&](const Finding& finding) {
    return finding.code == code && finding.message.find(word) != std::string::npos;
  });
}

std::string refusal(const std::string& bytes) {
  const Findings findings = findings_of([&] { read(bytes); });
  return findings.size() == 1 && findings[0].category == Category::Malformed ? findings[0].code : "";
}

std::string with_byte(std::string bytes, std::size_t at, char value) {
  bytes.at(at) = value;
  return bytes;
}

std::size_t peak_bytes() {
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::size_t>(usage.ru_maxrss) * 1024;
}

/// Refused with a sentence, or read; without a warning only when nothing is lost.
void check_damaged(const std::string& bytes, const Document& original) {
  CHECK(fuzzed_reader("croq").verdict_on(bytes).broken == "");
  try {
    const ProjectFile project = read(bytes);
    if (project.warnings.empty()) CHECK(difference(original, project.document) == "");
  } catch (const Error&) {
  }
}

}  // namespace

TEST_CASE("what isn't a project is refused by name") {
  CHECK(refusal("") == "E_EMPTY");
  CHECK(refusal("CROQ") == "E_PROJECT_FORMAT");
  CHECK(refusal(std::string(5000, '\0')) == "E_PROJECT_FORMAT");
  CHECK(refusal(edited(small_document(), "PRAGMA application_id=1")) == "E_PROJECT_FORMAT");
  Progress progress;
  const auto code = [&](const fs::path& path) { return findings_of([&] { load_project(path, progress); }).at(0).code; };
  const Scratch folder;
  CHECK(code(folder / "missing.croq") == "E_FILE_OPEN");
  CHECK(code(folder.path()) == "E_FILE_OPEN");
  CHECK(code("/dev/null") == "E_FILE_OPEN");
  write_bytes(folder / "text.croq", "just text");
  CHECK(code(folder / "text.croq") == "E_PROJECT_FORMAT");
}

TEST_CASE("bytes that change anywhere are refused, noticed or harmless") {
  Random random(8);
  const Document document = small_document();
  const std::string whole = saved(document);
  int noticed = 0;
  for (int i = 0; i < sample_count(2000, 50000); ++i) {
    std::string bytes = whole;
    for (std::uint32_t edits = 1 + random.below(3); edits > 0; --edits) {
      bytes[random.below(static_cast<std::uint32_t>(bytes.size()))] = static_cast<char>(random.below(256));
    }
    check_damaged(bytes, document);
    try {
      noticed += read(bytes).warnings.empty() ? 0 : 1;
    } catch (const Error&) {
      ++noticed;
    }
  }
  CHECK(noticed > 50);
}

TEST_CASE("a project cut off anywhere is refused or says what is lost") {
  const Document document = small_document();
  const std::string whole = saved(document);
  for (std::size_t length = 0; length < whole.size(); length += 499) {
    const std::string bytes = whole.substr(0, length);
    check_damaged(bytes, document);
    if (length < 4096) CHECK(refusal(bytes) != "");
  }
}

TEST_CASE("a value that has changed costs its node, and its users their input") {
  const std::string whole = saved(small_document());
  const std::string mesh = encode(*small_document().nodes()[0]->source);
  const std::size_t at = whole.find(mesh.substr(0, 60));
  REQUIRE(at != std::string::npos);
  const ProjectFile project = read(with_byte(whole, at + 40, 'x'));
  REQUIRE(project.document.nodes().size() == 2);
  CHECK(has_warning(project, "W_PROJECT_DAMAGED", "node 1 ('body') is left out"));
  CHECK(has_warning(project, "W_PROJECT_DAMAGED", "node 3 ('solid') has lost its input 'with'"));
  CHECK(project.document.find(3)->inputs == std::map<std::string, Link>{{"sketch", {2, "value"}}});
  CHECK(project.document.next_id() == 4);
}

TEST_CASE("missing and wrong parts are named one by one") {
  struct Case {
    const char* sql;
    const char* word;
    std::size_t nodes;
  };
  const std::vector<Case> cases = {
      {"DELETE FROM chunks", "a part of them is missing", 1},
      {"DELETE FROM blobs", "they are missing", 1},
      {"UPDATE blobs SET length=9000000000000000000", "a part of them is missing", 1},
      {"UPDATE chunks SET number=7", "a part of them is missing", 1},
      {"UPDATE chunks SET bytes=zeroblob(40000000)", "missing", 1},
      {"UPDATE sources SET kind='sculpture'", "doesn't know", 1},
      {"UPDATE sources SET kind='report'", "left out", 1},
      {"UPDATE parameters SET type='integer'", "parameter 'word'", 3},
      {"UPDATE parameters SET value=NULL WHERE name='flag'", "parameter 'flag'", 3},
      {"UPDATE parameters SET value=x'01' WHERE name='size'", "parameter 'size'", 3},
      {"UPDATE nodes SET visible=5 WHERE id=1", "node 1", 2},
      {"UPDATE nodes SET version=5000000000 WHERE id=1", "node 1", 2},
      {"UPDATE nodes SET id=0 WHERE id=1", "node 0", 2},
      {"UPDATE nodes SET name='x' WHERE id=1", "not those that were saved", 3},
      {"UPDATE parameters SET value=4 WHERE name='count'", "not those that were saved", 3},
      {"DELETE FROM nodes WHERE id=2", "not those that were saved", 2},
      {"DROP TABLE links", "links between steps", 3},
      {"DROP TABLE parameters", "its parameters", 3},
      {"DROP TABLE sources", "drawings and meshes", 1},
      {"DROP TABLE thumbnail", "thumbnail", 3},
  };
  for (const Case& damage : cases) {
    INFO(damage.sql);
    const ProjectFile project = read(edited(small_document(), damage.sql));
    std::string said;
    for (const Finding& finding : project.warnings) said += finding.message + "\n";
    INFO(said);
    CHECK(project.document.nodes().size() == damage.nodes);
    CHECK(has_warning(project, "W_PROJECT_DAMAGED", damage.word));
  }
  CHECK(refusal(edited(small_document(), "DROP TABLE nodes")) == "E_PROJECT_DAMAGED");
}

TEST_CASE("a newer schema is followed where it says so, with a word about what is left out") {
  const Document document = small_document();
  CHECK(refusal(edited(document, "PRAGMA user_version=6")) == "E_PROJECT_VERSION");
  CHECK(refusal(edited(document, "PRAGMA user_version=9; INSERT INTO meta VALUES('readable_since', '6')")) ==
        "E_PROJECT_VERSION");
  const ProjectFile project = read(edited(document,
                                          "PRAGMA user_version=6; INSERT INTO meta VALUES('readable_since', '1');"
                                          "ALTER TABLE nodes ADD COLUMN colour TEXT; CREATE TABLE layers(name);"));
  CHECK(difference(document, project.document) == "");
  CHECK(has_warning(project, "W_PROJECT_NEWER", "newer"));
  CHECK(has_warning(project, "W_IGNORED", "'layers'"));
}

TEST_CASE("nothing that a project brings along is run") {
  const Document document = small_document();
  const ProjectFile triggered = read(edited(document, "CREATE TRIGGER t AFTER INSERT ON nodes BEGIN SELECT 1; END"));
  CHECK(difference(document, triggered.document) == "");
  const std::string view =
      "CREATE TABLE n AS SELECT * FROM nodes; DROP TABLE nodes;"
      "CREATE VIEW nodes AS WITH RECURSIVE c(x) AS (SELECT 1 UNION ALL SELECT x+1 FROM c)"
      " SELECT x AS id, x AS position, 'n' AS name, '' AS operation, 1 AS version, 1 AS visible FROM c;";
  CHECK(refusal(edited(document, view)) == "E_PROJECT_DAMAGED");
  const std::string generated =
      "CREATE TABLE n AS SELECT * FROM nodes; DROP TABLE nodes;"
      "CREATE TABLE nodes(id, position, name AS (hex(zeroblob(30000000))), operation, version, visible);"
      "INSERT INTO nodes(id, position, operation, version, visible) SELECT id, position, operation, version, visible"
      " FROM n";
  CHECK(refusal(edited(document, generated)) == "E_PROJECT_DAMAGED");
  CHECK(refusal(edited(document, "CREATE VIRTUAL TABLE words USING fts5(x)")) == "E_PROJECT_DAMAGED");
}

TEST_CASE("claims and overlaps cost little memory") {
  const Document document = small_document();
  const std::string whole = saved(document);
  const std::size_t before = peak_bytes();
  read(edited(document, "UPDATE blobs SET length=4000000000"));
  read(edited(document,
              "WITH RECURSIVE c(x) AS (SELECT 10 UNION ALL SELECT x+1 FROM c WHERE x<20000)"
              "INSERT INTO nodes SELECT x, x, 'n', '', 1, 1 FROM c;"
              "INSERT INTO sources SELECT id, 'mesh', (SELECT hash FROM sources WHERE node=1) FROM nodes WHERE id>9"));
  if (!is_sanitized) CHECK(peak_bytes() - before < 100'000'000);
}

TEST_CASE("damage is described in people's words, with the earlier versions that are there") {
  const Document document = small_document();
  const std::string whole = saved(document);
  Random random(11);
  int named = 0;
  const auto check_words = [&](const Findings& findings) {
    for (const Finding& finding : findings) {
      INFO(finding.message);
      for (const char* word : {"sqlite", "table '", "syntax", "malformed", "database", "disk image", "PRAGMA", "Tree "})
        CHECK(finding.message.find(word) == std::string::npos);
      if (!finding.code.ends_with("PROJECT_DAMAGED")) continue;
      CHECK(finding.message.find("no earlier versions lie beside it") != std::string::npos);
      ++named;
    }
  };
  for (int i = 0; i < 400; ++i) {
    std::string bytes = whole;
    // The first half has the tables' own descriptions.
    for (int k = 0; k < 4; ++k)
      bytes[100 + random.below(static_cast<std::uint32_t>(bytes.size() - 100))] = static_cast<char>(random.below(256));
    if (i % 2 == 0) bytes.replace(bytes.find("CREATE"), 6, "CREA?E");
    try {
      check_words(read(bytes).warnings);
    } catch (const Error& error) {
      check_words(error.findings());
    }
  }
  CHECK(named > 200);
  const Scratch folder;
  write_bytes(folder / "a.croq", whole.substr(0, 5000));
  write_bytes(folder / "a.croq~1", whole);
  Progress progress;
  const Findings lost = findings_of([&] { load_project(folder / "a.croq", progress); });
  REQUIRE(lost.size() == 1);
  CHECK(lost.front().message.find("open an earlier version beside it: a.croq~1.") != std::string::npos);
}
