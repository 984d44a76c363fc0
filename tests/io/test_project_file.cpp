// SPDX-License-Identifier: GPL-3.0-or-later
#include <atomic>
#include <bit>
#include <csignal>
#include <limits>

#include <sched.h>
#include <sys/mount.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <catch2/catch.hpp>

#include "croquis/base/error.h"
#include "croquis/document/backdrop.h"
#include "croquis/document/byte_stream.h"
#include "croquis/document/value_bytes.h"
#include "croquis/io/file.h"
#include "croquis/io/project_file.h"
#include "io/random_project.h"
#include "io/scratch.h"
#include "support/meshes/mesh_shapes.h"
#include "support/sample_count.h"
#include "support/trial_operation.h"

using namespace croquis;
using namespace croquis::test;
namespace fs = std::filesystem;

namespace {

void save(const fs::path& path, const Document& document, std::vector<std::uint8_t> thumbnail = {}) {
  Progress progress;
  save_project(path, {document, std::move(thumbnail), {}}, progress);
}

ProjectFile load(const fs::path& path) {
  Progress progress;
  return load_project(path, progress);
}

std::vector<std::uint8_t> png(std::uint8_t content) { return {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n', content}; }

Document one_node(const std::string& name) {
  return Document().with(source_node(std::make_shared<const PolyMesh>(cube()), name));
}

Document big_document() {
  return one_node("small").with(source_node(std::make_shared<const PolyMesh>(grid(200, 200))));
}

std::string name_in(const fs::path& path) { return load(path).document.nodes().at(0)->name; }

// What must be true of a folder after a save that failed.
void check_untouched(const Scratch& folder, const std::string& bytes) {
  CHECK(folder.names() == std::set<std::string>{"a.croq"});
  CHECK(read_file((folder / "a.croq").string()) == bytes);
}

}  // namespace

TEST_CASE("what is saved is loaded again, bit by bit") {
  Random random(1);
  const Scratch folder;
  for (int i = 0; i < sample_count(60, 1000); ++i) {
    const Document document = random_document(random, random.below(12));
    const auto thumbnail = random.below(2) == 0 ? png(7) : std::vector<std::uint8_t>();
    save(folder / "a.croq", document, thumbnail);
    const ProjectFile loaded = load(folder / "a.croq");
    CHECK(difference(document, loaded.document) == "");
    CHECK(loaded.thumbnail_png == thumbnail);
    CHECK(loaded.warnings.empty());
  }
}

TEST_CASE("a text that a program wrote is saved as text") {
  const Scratch folder;
  Node node;
  node.operation = "fill";
  node.parameters["holes"] = ParsedText("3: flat", 3);
  save(folder / "a.croq", Document().with(node));
  CHECK(load(folder / "a.croq").document.nodes().at(0)->parameters.at("holes") ==
        ParameterValue(std::string("3: flat")));
}

// Every number here is exact in binary; the file was saved when the schema was made and stays as it is.
TEST_CASE("a project of schema 1 still loads as it was saved") {
  Drawing drawing;
  drawing.file = "bear.svg";
  drawing.object_data["head"] = {{"weight-distance", "2"}};
  Stroke stroke;
  stroke.id = "ear";
  stroke.closed = true;
  stroke.object = "head";
  stroke.data["kind"] = "hidden";
  stroke.line = 12;
  stroke.samples = {{{1.5, -2}, 0.25, {0.5, -0.5}, 0}, {{3, 4}, 1, {0, 0}, 0.125}};
  drawing.strokes = {stroke};
  const Node sketch = source_node(std::make_shared<const Drawing>(drawing), "sketch");
  PolyMesh mesh = cube();
  mesh.channels.push_back({"group", Domain::Face, 1, std::vector<std::int32_t>{0, 0, 1, 1, -1, -1}, {"a", "b"}});
  Node body = source_node(std::make_shared<const PolyMesh>(mesh), "몸");
  body.visible = false;
  Node solid;
  solid.name = "solid";
  solid.operation = "inflate";
  solid.parameters = {{"preset", std::string("tablet")}, {"min-gap", 0.25}, {"swap", std::int64_t{-1}}, {"all", true}};
  solid.inputs["sketch"] = {1, "value"};
  const Report figures = Report().set("count", 3).set("list", Report(Report::Array{0.5, "x"}));
  const Node report = source_node(std::make_shared<const Report>(figures), "report");
  const Document expected = Document().with(sketch).with(body).with(solid).with(report).with({}).without(5);
  const ProjectFile loaded = load(fs::path(CROQUIS_FUZZ_FOLDER) / "corpus/croq/schema-1.croq");
  CHECK(difference(expected, loaded.document) == "");
  CHECK(loaded.thumbnail_png == png(1));
  CHECK(loaded.warnings.empty());
}

TEST_CASE("the same project gives the same bytes, also once it was loaded") {
  Random random(2);
  const Scratch folder;
  for (int i = 0; i < 10; ++i) {
    const Document document = random_document(random, 8);
    save(folder / "a.croq", document);
    save(folder / "b.croq", document);
    save(folder / "c.croq", load(folder / "b.croq").document);
    const std::string bytes = read_file((folder / "a.croq").string());
    CHECK(read_file((folder / "b.croq").string()) == bytes);
    CHECK(read_file((folder / "c.croq").string()) == bytes);
  }
}

TEST_CASE("only meshes with tags need a layout that older versions don't know") {
  PolyMesh mesh = cube();
  const auto bytes_of = [](const PolyMesh& m) { return encode(std::make_shared<const PolyMesh>(m)); };
  const std::string plain = bytes_of(mesh);
  mesh.tags = {{{{0, 1}, infinite_sharpness}, {{3, 2}, 0.1}}, {7, 7}, {{"rim", 0.1, {{2, 3}}, {7}}}};
  const std::string tagged = bytes_of(mesh);
  CHECK(plain[0] == 1);
  CHECK(tagged[0] == 2);
  CHECK(tagged.substr(4, plain.size() - 4) == plain.substr(4));
  CHECK(decode(ValueType::Mesh, tagged).get<PolyMesh>().tags == mesh.tags);
  CHECK(decode(ValueType::Mesh, plain).get<PolyMesh>().tags.empty());
  for (const char layout : {'\0', '\3', '\1'}) {
    std::string other = tagged;
    other[0] = layout;
    CHECK_THROWS_AS(decode(ValueType::Mesh, other), BadBytes);
  }
  std::string report = encode(std::make_shared<const Report>(Report(1)));
  report[0] = 2;
  CHECK_THROWS_AS(decode(ValueType::Report, report), BadBytes);
  for (std::size_t length = plain.size(); length < tagged.size(); ++length) {
    CHECK_THROWS_AS(decode(ValueType::Mesh, tagged.substr(0, length)), BadBytes);
  }
}

TEST_CASE("only drawings on another plane need a layout that older versions don't know") {
  Drawing drawing;
  drawing.file = "cat.svg";
  const auto bytes_of = [](const Drawing& d) { return encode(std::make_shared<const Drawing>(d)); };
  const std::string plain = bytes_of(drawing);
  drawing.plane = {Vec3(1, 2, 3), Vec3(0, 0.6, 0.8), Vec3(1, 0, 0)};
  const std::string placed = bytes_of(drawing);
  CHECK(plain[0] == 1);
  CHECK(placed[0] == 2);
  CHECK(placed.substr(4, plain.size() - 4) == plain.substr(4));
  CHECK(placed.size() == plain.size() + 72);
  CHECK(decode(ValueType::Drawing, placed).get<Drawing>().plane == drawing.plane);
  drawing.plane.v = Vec3(0, 1, 0);
  CHECK_THROWS_AS(decode(ValueType::Drawing, bytes_of(drawing)), BadBytes);
}

TEST_CASE("only projects with transforms or nodes that are off need the second schema, which the first can follow") {
  const Scratch folder;
  const auto schema = [&] {
    const std::string bytes = read_file((folder / "a.croq").string());
    return static_cast<int>(bytes[63]);  // the last byte of user_version
  };
  Node node = *one_node("cube").nodes()[0];
  save(folder / "a.croq", Document().with(node));
  const std::string plain = read_file((folder / "a.croq").string());
  CHECK(schema() == 1);
  CHECK(plain.find("transforms") == std::string::npos);
  CHECK(plain.find("readable_since") == std::string::npos);

  node.transform.linear(0, 2) = -2.5;
  node.transform.offset = Vec3(0.1, -0.0, 1e30);
  Node off = node;
  off.id = 0;
  off.transform = {};
  off.enabled = false;
  const Document document = Document().with(node).with(off);
  save(folder / "a.croq", document);
  CHECK(schema() == 2);
  CHECK(read_file((folder / "a.croq").string()).find("readable_since1") != std::string::npos);
  const ProjectFile loaded = load(folder / "a.croq");
  CHECK(loaded.warnings.empty());
  CHECK(difference(document, loaded.document) == "");

  node.transform = {};
  save(folder / "a.croq", Document().with(node));
  CHECK(read_file((folder / "a.croq").string()) == plain);
}

TEST_CASE("a project in memory reads like one on disk") {
  const Scratch folder;
  save(folder / "a.croq", big_document(), png(1));
  const std::string bytes = read_file((folder / "a.croq").string());
  Progress progress;
  const ProjectFile read = read_project(bytes, "a.croq", progress);
  CHECK(difference(read.document, big_document()) == "");
  CHECK(read.thumbnail_png == png(1));
}

TEST_CASE("nodes that share a value share it in the file and after loading") {
  const auto mesh = std::make_shared<const PolyMesh>(grid(100, 100));
  Document document;
  for (int i = 0; i < 20; ++i) document = document.with(source_node(mesh));
  const Scratch folder;
  save(folder / "a.croq", document);
  CHECK(fs::file_size(folder / "a.croq") < 1'000'000);
  const Document loaded = load(folder / "a.croq").document;
  const auto first = loaded.nodes()[0]->source->as<PolyMesh>();
  for (const auto& node : loaded.nodes()) CHECK(node->source->as<PolyMesh>() == first);
}

TEST_CASE("a value larger than one chunk survives") {
  PolyMesh mesh;
  mesh.positions.assign(3'500'000, Vec3(1, 2, 3));  // 84 MB
  mesh.positions.back() = Vec3(4, 5, 6);
  const Document document = Document().with(source_node(std::make_shared<const PolyMesh>(std::move(mesh))));
  const Scratch folder;
  save(folder / "a.croq", document);
  CHECK(difference(document, load(folder / "a.croq").document) == "");
}

TEST_CASE("three earlier versions are kept, the newest as number 1") {
  const Scratch folder;
  for (int i = 1; i <= 6; ++i) save(folder / "a.croq", one_node("version " + std::to_string(i)));
  CHECK(folder.names() == std::set<std::string>{"a.croq", "a.croq~1", "a.croq~2", "a.croq~3"});
  CHECK(name_in(folder / "a.croq") == "version 6");
  CHECK(name_in(folder / "a.croq~1") == "version 5");
  CHECK(name_in(folder / "a.croq~2") == "version 4");
  CHECK(name_in(folder / "a.croq~3") == "version 3");
}

TEST_CASE("a gap among the backups is filled before one is dropped") {
  const Scratch folder;
  for (int i = 1; i <= 4; ++i) save(folder / "a.croq", one_node("version " + std::to_string(i)));
  fs::remove(folder / "a.croq~1");
  save(folder / "a.croq", one_node("version 5"));
  CHECK(name_in(folder / "a.croq~1") == "version 4");
  CHECK(name_in(folder / "a.croq~2") == "version 2");
  CHECK(name_in(folder / "a.croq~3") == "version 1");
}

TEST_CASE("saving through a symbolic link replaces what it leads to, and keeps permissions") {
  const Scratch folder;
  save(folder / "real.croq", one_node("old"));
  fs::permissions(folder / "real.croq", fs::perms::owner_read | fs::perms::owner_write);
  fs::create_symlink("real.croq", folder / "link.croq");
  save(folder / "link.croq", one_node("new"));
  CHECK(fs::is_symlink(folder / "link.croq"));
  CHECK(name_in(folder / "real.croq") == "new");
  CHECK(name_in(folder / "real.croq~1") == "old");
  CHECK(fs::status(folder / "real.croq").permissions() == (fs::perms::owner_read | fs::perms::owner_write));
}

TEST_CASE("what a save that was killed left is swept away by the next one") {
  const Scratch folder;
  write_bytes(folder / ".a.croq.12345-0.saving", "half a project");
  write_bytes(folder / ".b.croq.12345-0.saving", "somebody else's");
  save(folder / "a.croq", one_node("whole"));
  CHECK(folder.names() == std::set<std::string>{"a.croq", ".b.croq.12345-0.saving"});
}

TEST_CASE("a folder that doesn't exist, a folder in its place and a device are refused") {
  const Scratch folder;
  for (const fs::path& path : {folder / "missing/a.croq", folder.path(), fs::path("/dev/null")}) {
    const Findings findings = findings_of([&] { save(path, one_node("x")); });
    REQUIRE(findings.size() == 1);
    CHECK(findings[0].code == "E_WRITE");
    CHECK(findings[0].category == Category::Io);
    CHECK(findings[0].message.find(path.string()) != std::string::npos);
  }
  CHECK(folder.names().empty());
}

TEST_CASE("a read-only folder or file is refused and left alone") {
  const Scratch folder;
  save(folder / "a.croq", one_node("old"));
  const std::string bytes = read_file((folder / "a.croq").string());
  const auto refused = [&] {
    // Root may write anywhere, nobody may not.
    if (::geteuid() == 0 && (::setgid(65534) != 0 || ::setuid(65534) != 0)) return 98;
    const Findings findings = findings_of([&] { save(folder / "a.croq", one_node("new")); });
    return findings.size() == 1 && findings[0].code == "E_WRITE" ? 0 : 1;
  };
  fs::permissions(folder.path(), fs::perms(0555));
  CHECK(in_child(refused) == 0);
  fs::permissions(folder.path(), fs::perms(0777));
  fs::permissions(folder / "a.croq", fs::perms(0444));
  CHECK(in_child(refused) == 0);
  check_untouched(folder, bytes);
}

TEST_CASE("a limit on the size of files leaves the old project as it was") {
  const Scratch folder;
  save(folder / "a.croq", one_node("old"));
  const std::string bytes = read_file((folder / "a.croq").string());
  for (const rlim_t limit : std::initializer_list<rlim_t>{0, 4096, 40'000, 100'000, 400'000}) {
    CHECK(in_child([&] {
            std::signal(SIGXFSZ, SIG_IGN);
            const rlimit limits{limit, limit};
            ::setrlimit(RLIMIT_FSIZE, &limits);
            const Findings findings = findings_of([&] { save(folder / "a.croq", big_document()); });
            return findings.size() == 1 && findings[0].code == "E_WRITE" ? 0 : 1;
          }) == 0);
    check_untouched(folder, bytes);
  }
}

TEST_CASE("a full disk leaves the old project as it was and says so") {
  const Scratch folder;
  const int code = in_child([&] {
    // A file system of 256 KB that only this process sees. Where that isn't allowed, the limit above stands for it.
    if (::unshare(::geteuid() == 0 ? CLONE_NEWNS : CLONE_NEWUSER | CLONE_NEWNS) != 0) return 97;
    ::mount(nullptr, "/", nullptr, MS_REC | MS_PRIVATE, nullptr);
    if (::mount("tmpfs", folder.path().c_str(), "tmpfs", 0, "size=256k") != 0) return 97;
    save(folder / "a.croq", one_node("old"));
    const std::string bytes = read_file((folder / "a.croq").string());
    const Findings findings = findings_of([&] { save(folder / "a.croq", big_document()); });
    if (findings.size() != 1 || findings[0].code != "E_WRITE") return 1;
    if (findings[0].message.find("the disk is full") == std::string::npos) return 2;
    if (folder.names() != std::set<std::string>{"a.croq"}) return 3;
    return read_file((folder / "a.croq").string()) == bytes ? 0 : 4;
  });
  if (code == 97) WARN("no file system could be mounted");
  if (code != 97) CHECK(code == 0);
}

TEST_CASE("a cancelled save changes nothing and a cancelled load gives nothing") {
  const Scratch folder;
  save(folder / "a.croq", one_node("old"));
  const std::string bytes = read_file((folder / "a.croq").string());
  std::atomic<bool> cancel = true;
  Progress progress({}, &cancel);
  CHECK_THROWS_AS(save_project(folder / "a.croq", {big_document(), {}, {}}, progress), Cancelled);
  check_untouched(folder, bytes);
  CHECK_THROWS_AS(load_project(folder / "a.croq", progress), Cancelled);
}

TEST_CASE("progress of saving and loading never goes back and comes to its end") {
  const Scratch folder;
  std::vector<double> fractions;
  Progress progress([&](double fraction, const std::string&) { fractions.push_back(fraction); });
  Random random(3);
  save_project(folder / "a.croq", {random_document(random, 20), {}, {}}, progress);
  REQUIRE(fractions.size() > 5);
  CHECK(std::is_sorted(fractions.begin(), fractions.end()));
  CHECK(fractions.back() == 1);
  fractions.clear();
  Progress loading([&](double fraction, const std::string&) { fractions.push_back(fraction); });
  load_project(folder / "a.croq", loading);
  CHECK(std::is_sorted(fractions.begin(), fractions.end()));
  CHECK(fractions.back() == 1);
}

TEST_CASE("the id of a removed last node is not given again") {
  Document document = one_node("a").with({});
  document = document.without(2);
  const Scratch folder;
  save(folder / "a.croq", document);
  CHECK(load(folder / "a.croq").document.next_id() == 3);
}

TEST_CASE("names that SQLite would take for addresses are names") {
  const Scratch folder;
  for (const char* name : {"a?mode=memory.croq", "%41.croq", "file:x.croq", "a#b.croq", "\xea\xb0\x80 \xff.croq"}) {
    save(folder / name, one_node(name));
    CHECK(name_in(folder / name) == name);
  }
  CHECK(folder.names().size() == 5);
}

namespace {

std::shared_ptr<const Backdrop> photo_behind(std::shared_ptr<const PictureFile> picture, double opacity) {
  return std::make_shared<const Backdrop>(Backdrop{std::move(picture), Vec2(3.5, -2), 0.25, opacity, false});
}

std::shared_ptr<const PictureFile> photo(std::size_t bytes) {
  return std::make_shared<const PictureFile>(PictureFile{std::string(bytes, 'p'), 6000, 4000, "/home/photo.jpg"});
}

Node drawing_node() { return source_node(std::make_shared<const Drawing>(), "drawing"); }

}  // namespace

TEST_CASE("a picture behind drawings is stored once, byte by byte, in a table of its own that others can leave out") {
  const Scratch folder;
  Node node = drawing_node();
  node.backdrop = photo_behind(photo(2'000'000), 0.5);
  Node other = drawing_node();
  other.backdrop = photo_behind(node.backdrop->picture, 0.25);
  const Document document = Document().with(node).with(other);
  save(folder / "a.croq", document);
  CHECK(fs::file_size(folder / "a.croq") < 2'200'000);
  const std::string bytes = read_file((folder / "a.croq").string());
  CHECK(static_cast<int>(bytes[63]) == 3);
  CHECK(bytes.find("readable_since1") != std::string::npos);
  CHECK(bytes.find("transforms") == std::string::npos);
  const ProjectFile loaded = load(folder / "a.croq");
  CHECK(loaded.warnings.empty());
  CHECK(difference(document, loaded.document) == "");
  CHECK(loaded.document.nodes()[0]->backdrop->picture == loaded.document.nodes()[1]->backdrop->picture);

  node.backdrop = nullptr;
  node.enabled = false;
  save(folder / "a.croq", Document().with(node));
  CHECK(fs::file_size(folder / "a.croq") < 100'000);
  CHECK(static_cast<int>(read_file((folder / "a.croq").string())[63]) == 2);
}

TEST_CASE("where objects stand and their groups lie in a table of their own; an impossible place is reported") {
  const Scratch folder;
  Node node = drawing_node();
  node.placement = {{1, 2, 3}, {10, 20, 30}, {1, 2, 0.5}};
  node.group = "wheels";
  const Document document = Document().with(node);
  save(folder / "a.croq", document);
  std::string bytes = read_file((folder / "a.croq").string());
  CHECK(static_cast<int>(bytes[63]) == 4);
  CHECK(bytes.find("readable_since1") != std::string::npos);
  const ProjectFile loaded = load(folder / "a.croq");
  CHECK(loaded.warnings.empty());
  CHECK(difference(document, loaded.document) == "");

  const auto half = little_endian(0.5);
  const auto at = bytes.find(std::string(half.begin(), half.end()) + "wheels");
  REQUIRE(at != std::string::npos);
  const auto none = little_endian(-0.5);
  std::copy(none.begin(), none.end(), bytes.begin() + static_cast<std::ptrdiff_t>(at));
  Progress progress;
  const ProjectFile read = read_project(bytes, "a.croq", progress);
  REQUIRE(read.document.nodes().size() == 1);
  CHECK(read.document.nodes()[0]->placement == Placement());
  REQUIRE(!read.warnings.empty());
  CHECK(read.warnings[0].message.find("has lost its place") != std::string::npos);
}

TEST_CASE("a drawing whose picture can't be read is kept, and the finding names it") {
  const Scratch folder;
  Node node = drawing_node();
  node.backdrop = photo_behind(photo(300'000), 0.5);
  save(folder / "a.croq", Document().with(node));
  std::string bytes = read_file((folder / "a.croq").string());
  const auto at = bytes.find(std::string(200, 'p'));
  REQUIRE(at != std::string::npos);
  bytes[at + 50] = 'q';
  Progress progress;
  const ProjectFile read = read_project(bytes, "a.croq", progress);
  REQUIRE(read.document.nodes().size() == 1);
  CHECK(read.document.nodes()[0]->backdrop == nullptr);
  REQUIRE(!read.warnings.empty());
  CHECK(read.warnings[0].code == "W_PROJECT_DAMAGED");
  CHECK(read.warnings[0].message.find("lost the picture behind it") != std::string::npos);
}

TEST_CASE("what steps gave last is kept in a table of its own, which projects without it don't have") {
  const Scratch folder;
  const Document document = one_node("cube");
  const NodeId id = document.nodes()[0]->id;
  save(folder / "a.croq", document);
  const std::string plain = read_file((folder / "a.croq").string());
  CHECK(plain.find("kept_results") == std::string::npos);

  ProjectFile project{document, {}, {}};
  project.kept.results[id] = {std::make_shared<const PolyMesh>(torus(5, 4)), std::make_shared<const PolyMesh>(cube())};
  project.kept.results[7] = {std::make_shared<const PolyMesh>(grid(3, 2)), {}};
  project.kept.past = {{"Draw", document}};
  Progress progress;
  save_project(folder / "a.croq", project, progress);
  const std::string bytes = read_file((folder / "a.croq").string());
  CHECK(static_cast<int>(bytes[63]) == 4);
  CHECK(bytes.find("readable_since1") != std::string::npos);
  const ProjectFile loaded = load(folder / "a.croq");
  CHECK(loaded.warnings.empty());
  CHECK(difference(document, loaded.document) == "");
  CHECK(loaded.kept.past.empty());
  REQUIRE(loaded.kept.results.size() == 2);
  for (const auto& [node, kept] : project.kept.results) {
    const KeptResult& read = loaded.kept.results.at(node);
    CHECK(encode(read.result) == encode(kept.result));
    CHECK(read.edited.has_content() == kept.edited.has_content());
    if (kept.edited.has_content()) CHECK(encode(read.edited) == encode(kept.edited));
  }
  // The cube's bytes are there once, and a change of them is told.
  const auto at = bytes.find(encode(project.kept.results.at(7).result).substr(40, 60));
  REQUIRE(at != std::string::npos);
  std::string spoilt = bytes;
  spoilt[at + 5] = static_cast<char>(spoilt[at + 5] ^ 0x11);
  const ProjectFile rest = read_project(spoilt, "a.croq", progress);
  CHECK(rest.kept.results.size() == 1);
  REQUIRE(!rest.warnings.empty());
  CHECK(rest.warnings[0].code == "W_PROJECT_DAMAGED");

  save(folder / "a.croq", document);
  CHECK(read_file((folder / "a.croq").string()) == plain);
}
