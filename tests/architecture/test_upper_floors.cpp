// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <string>

#include <catch2/catch.hpp>

#include "architecture/source_tree.h"

namespace croquis::test {
namespace {

const std::filesystem::path root = CROQUIS_SOURCE_DIR;
constexpr std::size_t most_files = 40;
constexpr int longest_function = 60;
constexpr int longest_class = 250;
constexpr std::size_t most_functions = 30;

/// The tool that a file of the studio belongs to: "mesh" for src/app/tools/mesh/…; empty for none.
std::string app_tool_of(const std::string& path) {
  const std::string folder = "src/app/tools/";
  if (!path.starts_with(folder)) return {};
  const auto end = path.find('/', folder.size());
  return end == std::string::npos ? std::string() : path.substr(folder.size(), end - folder.size());
}

TEST_CASE("tools of the studio don't include each other, and nothing else includes one") {
  const std::set<std::string> lists{"src/app/tools/all_tools.cpp"};
  std::size_t tools_seen = 0;
  for (const SourceFile& file : read_sources(root)) {
    if (file.module != "app" || lists.contains(file.path)) continue;
    const std::string own = app_tool_of(file.path);
    tools_seen += !own.empty();
    for (const std::string& include : file.own_includes) {
      const std::string other = app_tool_of(include);
      INFO(file.path << " includes " << include);
      CHECK((other.empty() || other == own));
    }
  }
  CHECK(tools_seen > 10);
}

TEST_CASE("the window's own folders and the workspace know no operation") {
  const std::set<std::string> lists{"src/app/studio/studio.cpp"};
  for (const SourceFile& file : read_sources(root)) {
    const bool own = (file.module == "app" && app_tool_of(file.path).empty()) || file.module == "workspace";
    if (!own || lists.contains(file.path)) continue;
    for (const std::string& include : file.own_includes) {
      INFO(file.path << " includes " << include);
      CHECK_FALSE(include.starts_with("include/croquis/operators/"));
      CHECK_FALSE(include.starts_with("src/operators/"));
    }
  }
}

TEST_CASE("no folder has more than 40 files") {
  for (const char* part : {"include", "src", "tests"}) {
    for (const auto& entry : std::filesystem::recursive_directory_iterator(root / part)) {
      if (!entry.is_directory()) continue;
      const auto files = std::filesystem::directory_iterator(entry);
      const auto count = std::count_if(begin(files), end(files), [](const auto& inner) {
        return inner.path().extension() == ".cpp" || inner.path().extension() == ".h";
      });
      INFO(entry.path());
      CHECK(static_cast<std::size_t>(count) <= most_files);
    }
  }
}

struct LongFunction {
  std::string head;
  int lines = 0;
};

/// The longest function at the level of namespaces: its head begins and its brace ends in the first column.
LongFunction longest_in(const std::filesystem::path& path) {
  static const std::regex no_function(R"(^(namespace|struct|class|enum|union|using|template|extern|#|//|\}|\)).*)");
  LongFunction longest;
  std::ifstream stream(path);
  std::string head;
  int lines = 0;
  bool inside = false;
  for (std::string line; std::getline(stream, line);) {
    if (!inside) {
      const bool begins = !line.empty() && std::isalpha(static_cast<unsigned char>(line[0])) != 0;
      if (begins && !std::regex_match(line, no_function)) {
        head = line;
        lines = 0;
      }
      if (head.empty()) continue;
      ++lines;
      if (line.ends_with(';') || line.ends_with('}')) head.clear();
      inside = !head.empty() && line.ends_with('{');
      continue;
    }
    ++lines;
    if (line.empty() || line[0] != '}') continue;
    if (line == "}" && lines > longest.lines) longest = {head, lines};
    inside = false;
    head.clear();
  }
  return longest;
}

TEST_CASE("no function is longer than 60 lines") {
  LongFunction longest_of_all;
  for (const SourceFile& file : read_sources(root)) {
    const LongFunction longest = longest_in(root / file.path);
    INFO(file.path << ": " << longest.head);
    CHECK(longest.lines <= longest_function);
    if (longest.lines > longest_of_all.lines) longest_of_all = longest;
  }
  // A reader that finds none would be of no use.
  CHECK(longest_of_all.lines > 30);
}

struct ClassSize {
  int lines = 0;                    ///< of its body and of its members' definitions
  std::set<std::string> functions;  ///< as the body declares them
};

/// The lines of a file from the one that `begins` accepts to the brace that closes it in the first column.
template <typename Begins, typename Inside>
void each_block(const std::filesystem::path& path, const Begins& begins, const Inside& inside) {
  std::ifstream stream(path);
  bool open = false;
  for (std::string line; std::getline(stream, line);) {
    if (!open && (line.empty() || line[0] == ' ' || !begins(line))) continue;
    inside(line);
    open = open ? line[0] != '}' : !line.ends_with('}');
  }
}

/// Bodies of classes at the level of namespaces. Those of one source are known by its path, too.
void add_bodies(const SourceFile& file, std::map<std::string, ClassSize>& classes) {
  static const std::regex head(R"(^(?:class|struct) (\w+)[^;]*\{$)");
  static const std::regex function(R"(^  (?! )(?:[\w:<>,&*\[\] ]+ [&*]?)?(?:~?\w+|operator\S+)\(.*)");
  static const std::regex no_function(R"(^  (?:return|using|friend|static_assert)\b.*)");
  ClassSize* size = nullptr;
  const auto begins = [&](const std::string& line) {
    std::smatch name;
    if (!std::regex_match(line, name, head)) return false;
    size = &classes[file.path.ends_with(".cpp") ? file.path + name.str(1) : name.str(1)];
    return true;
  };
  each_block(root / file.path, begins, [&](const std::string& line) {
    ++size->lines;
    if (std::regex_match(line, function) && !std::regex_match(line, no_function)) size->functions.insert(line);
  });
}

void add_definitions(const SourceFile& file, std::map<std::string, ClassSize>& classes) {
  static const std::regex head(R"(^(?:[\w:<>,&*\[\] ]*[ &*])?(\w+)::(?:~?\w+|operator\S+)\(.*)");
  ClassSize* size = nullptr;
  const auto begins = [&](const std::string& line) {
    std::smatch name;
    if (line.ends_with(';') || !std::regex_match(line, name, head)) return false;
    auto known = classes.find(file.path + name.str(1));
    if (known == classes.end()) known = classes.find(name.str(1));
    size = known == classes.end() ? nullptr : &known->second;
    return size != nullptr;
  };
  each_block(root / file.path, begins, [&](const std::string&) { ++size->lines; });
}

TEST_CASE("no class has more than 30 functions or 250 lines") {
  std::map<std::string, ClassSize> classes;
  for (const SourceFile& file : read_sources(root)) add_bodies(file, classes);
  for (const SourceFile& file : read_sources(root)) add_definitions(file, classes);
  int longest = 0;
  for (const auto& [name, size] : classes) {
    INFO(name);
    CHECK(size.lines <= longest_class);
    CHECK(size.functions.size() <= most_functions);
    longest = std::max(longest, size.lines);
  }
  // A reader that finds none would be of no use.
  CHECK(longest > longest_class / 2);
}

}  // namespace
}  // namespace croquis::test
