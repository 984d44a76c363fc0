// SPDX-License-Identifier: GPL-3.0-or-later
#include <filesystem>
#include <fstream>
#include <functional>
#include <set>

#include <unistd.h>

#include <catch2/catch.hpp>

#include "croquis/base/error.h"
#include "croquis/io/file.h"

using namespace croquis;
namespace fs = std::filesystem;

namespace {

// A folder of its own for each case, gone at its end.
class Folder {
 public:
  Folder() {
    std::string pattern = (fs::temp_directory_path() / "croquis-file-XXXXXX").string();
    REQUIRE(::mkdtemp(pattern.data()) != nullptr);
    path_ = pattern;
  }
  ~Folder() { fs::remove_all(path_); }

  std::string operator/(const std::string& name) const { return (path_ / name).string(); }

  std::set<std::string> names() const {
    std::set<std::string> names;
    for (const auto& entry : fs::directory_iterator(path_)) names.insert(entry.path().filename().string());
    return names;
  }

 private:
  fs::path path_;
};

void put(const std::string& path, const std::string& bytes) { std::ofstream(path, std::ios::binary) << bytes; }

Finding failure_of(const std::function<void()>& action) {
  try {
    action();
  } catch (const Error& error) {
    return error.findings().front();
  }
  FAIL("nothing was thrown");
  return {};
}

}  // namespace

TEST_CASE("a file is read byte for byte") {
  const Folder folder;
  const std::string bytes("a\0\r\n\xff text", 10);
  put(folder / "x", bytes);
  CHECK(read_file(folder / "x") == bytes);
  put(folder / "empty", "");
  CHECK(read_file(folder / "empty").empty());
  CHECK(read_file("/dev/null").empty());
}

TEST_CASE("a file that can't be opened counts as unreadable input and names its path") {
  const Folder folder;
  put(folder / "plain", "1");
  for (const auto& [path, words] : {std::pair{folder / "missing", "no such file"}, std::pair{folder / ".", "a folder"},
                                    std::pair{folder / "plain/below", "not a folder"}}) {
    const Finding finding = failure_of([&] { read_file(path); });
    CHECK(finding.code == "E_FILE_OPEN");
    CHECK(finding.category == Category::Malformed);
    CHECK_THAT(finding.message, Catch::Contains(path) && Catch::Contains(words));
  }
}

TEST_CASE("files appear at commit and not before") {
  const Folder folder;
  OutputTransaction outputs;
  outputs.add(folder / "a", "one");
  outputs.add(folder / "b", std::string(100000, 'x'));
  CHECK(folder.names().empty());
  outputs.commit();
  CHECK(folder.names() == std::set<std::string>{"a", "b"});
  CHECK(read_file(folder / "a") == "one");
  CHECK(read_file(folder / "b") == std::string(100000, 'x'));
}

TEST_CASE("a transaction without commit leaves nothing behind") {
  const Folder folder;
  { OutputTransaction().add(folder / "a", "one"); }
  CHECK(folder.names().empty());
}

TEST_CASE("an existing file is replaced and keeps its permissions") {
  const Folder folder;
  put(folder / "a", "old");
  fs::permissions(folder / "a", fs::perms(0640));
  OutputTransaction outputs;
  outputs.add(folder / "a", "new");
  outputs.commit();
  CHECK(read_file(folder / "a") == "new");
  CHECK((fs::status(folder / "a").permissions() & fs::perms::mask) == fs::perms(0640));
  CHECK(folder.names() == std::set<std::string>{"a"});
}

TEST_CASE("when one output can't be written, none is and existing files stay") {
  const Folder folder;
  put(folder / "existing", "old");
  put(folder / "plain", "1");
  fs::create_directory(folder / "folder");
  for (const std::string bad : {"missing/x", "plain/x", "folder"}) {
    OutputTransaction outputs;
    outputs.add(folder / "existing", "new");
    outputs.add(folder / "fresh", "new");
    outputs.add(folder / bad, "bad");
    const Finding finding = failure_of([&] { outputs.commit(); });
    CHECK(finding.code == "E_WRITE");
    CHECK(finding.category == Category::Io);
    CHECK_THAT(finding.message, Catch::Contains(folder / bad));
    CHECK(read_file(folder / "existing") == "old");
    CHECK(folder.names() == std::set<std::string>{"existing", "folder", "plain"});
  }
}

TEST_CASE("a full device is reported and brings the old files back") {
  const Folder folder;
  put(folder / "existing", "old");
  OutputTransaction outputs;
  outputs.add(folder / "existing", "new");
  outputs.add(folder / "fresh", "new");
  outputs.add("/dev/full", "bytes");
  CHECK_THAT(failure_of([&] { outputs.commit(); }).message, Catch::Contains("/dev/full") && Catch::Contains("full"));
  CHECK(read_file(folder / "existing") == "old");
  CHECK(folder.names() == std::set<std::string>{"existing"});
}

TEST_CASE("a symbolic link stays a link and its file is replaced") {
  const Folder folder;
  put(folder / "real", "old");
  fs::create_symlink("real", folder / "link");
  OutputTransaction outputs;
  outputs.add(folder / "link", "new");
  outputs.add("/dev/null", "anything");
  outputs.commit();
  CHECK(fs::is_symlink(folder / "link"));
  CHECK(read_file(folder / "real") == "new");
}

TEST_CASE("one path can't be two outputs") {
  OutputTransaction outputs;
  outputs.add("same", "1");
  CHECK(failure_of([&] { outputs.add("same", "2"); }).code == "E_WRITE");
}
