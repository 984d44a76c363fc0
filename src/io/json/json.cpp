// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/io/json.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "croquis/base/error.h"
#include "croquis/base/limits.h"

namespace croquis {
namespace {

using Json = nlohmann::ordered_json;

/// A place that is described by its line.
struct Fault {
  std::size_t byte = 0;  ///< number of bytes before it
  std::string what;
};

/// What nlohmann::json calls while it reads; builds the report without a tree of its own.
class ReportBuilder {
 public:
  bool null() { return add(Report()); }
  bool boolean(bool value) { return add(Report(value)); }
  bool number_integer(std::int64_t value) { return add(Report(value)); }
  bool number_unsigned(std::uint64_t value) {
    const bool fits = value <= static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max());
    return add(fits ? Report(static_cast<std::int64_t>(value)) : Report(static_cast<double>(value)));
  }
  bool number_float(double value, const std::string&) { return add(Report(value)); }
  bool string(std::string& value) { return add(Report(std::move(value))); }
  bool binary(std::vector<std::uint8_t>&) { return false; }

  bool start_object(std::size_t) { return open(true); }
  bool start_array(std::size_t) { return open(false); }
  bool key(std::string& name) {
    levels_.back().key = std::move(name);
    return true;
  }
  bool end_object() { return close(); }
  bool end_array() { return close(); }

  bool parse_error(std::size_t position, const std::string&, const nlohmann::detail::exception& exception) {
    std::string what = exception.what();
    // The reason stands behind the library's own name of the error, "[…] ", and the place, where it gives one.
    if (const std::size_t name = what.find("] "); what.starts_with('[') && name != std::string::npos)
      what.erase(0, name + 2);
    const std::size_t reason = what.find(": ");
    fault_ = {position, reason == std::string::npos ? what : what.substr(reason + 2)};
    return false;
  }

  bool too_deep() const { return too_deep_; }
  const Fault& fault() const { return fault_; }
  Report take() { return std::move(root_); }

 private:
  struct Level {
    bool is_object = false;
    std::string key;
    Report::Array elements;
    Report::Object members;
    std::unordered_map<std::string, std::size_t> places;  ///< of members by name; for lookups alone
  };

  bool open(bool is_object) {
    too_deep_ = levels_.size() == deepest_nesting;
    if (too_deep_) return false;
    levels_.emplace_back().is_object = is_object;
    return true;
  }

  bool close() {
    Level level = std::move(levels_.back());
    levels_.pop_back();
    return add(level.is_object ? Report::of_members(std::move(level.members)) : Report(std::move(level.elements)));
  }

  bool add(Report value) {
    if (levels_.empty()) {
      root_ = std::move(value);
      return true;
    }
    Level& level = levels_.back();
    if (!level.is_object) {
      level.elements.push_back(std::move(value));
      return true;
    }
    const auto [place, is_new] = level.places.try_emplace(level.key, level.members.size());
    if (is_new) {
      level.members.emplace_back(std::move(level.key), std::move(value));
    } else {
      level.members[place->second].second = std::move(value);
    }
    return true;
  }

  std::vector<Level> levels_;
  Report root_;
  Fault fault_;
  bool too_deep_ = false;
};

Error refused(const char* code, const std::string& message, const std::string& file, std::optional<std::int64_t> line) {
  return Error(make_error(Category::Malformed, code, message, {{SubjectKind::File, file, file, line, {}}}));
}

/// Control characters and what isn't ASCII don't belong into a message.
std::string printable(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c < 0x20 || c > 0x7e; }, '?');
  constexpr std::size_t longest = 160;
  return text.size() > longest ? text.substr(0, longest) + "..." : text;
}

/// JSON knows no infinity and no NaN; "not known" is null.
Json to_json(const Report& report) {
  struct Visitor {
    Json operator()(std::monostate) const { return nullptr; }
    Json operator()(bool value) const { return value; }
    Json operator()(std::int64_t value) const { return value; }
    Json operator()(double value) const { return std::isfinite(value) ? Json(value) : Json(nullptr); }
    Json operator()(const std::string& value) const { return value; }
    Json operator()(const Report::Array& array) const {
      Json json = Json::array();
      for (const Report& element : array) json.push_back(to_json(element));
      return json;
    }
    Json operator()(const Report::Object& object) const {
      Json json = Json::object();
      for (const auto& [key, value] : object) json[key] = to_json(value);
      return json;
    }
  };
  return std::visit(Visitor{}, report.value());
}

}  // namespace

Report read_json(std::string_view bytes, const std::string& file_name) {
  if (bytes.find_first_not_of(" \t\r\n") == std::string_view::npos) {
    throw refused("E_EMPTY", "The file '" + file_name + "' is empty.", file_name, {});
  }
  ReportBuilder builder;
  if (Json::sax_parse(bytes, &builder)) return builder.take();
  if (builder.too_deep()) {
    throw refused(
        "E_SYNTAX",
        "'" + file_name + "': lists and objects are nested deeper than " + std::to_string(deepest_nesting) + " levels.",
        file_name, {});
  }
  const std::string_view before = bytes.substr(0, std::min(builder.fault().byte, bytes.size()));
  const std::int64_t line = 1 + std::count(before.begin(), before.end(), '\n');
  throw refused("E_SYNTAX",
                "'" + file_name + "', line " + std::to_string(line) + ": " + printable(builder.fault().what) + ".",
                file_name, line);
}

std::string write_json(const Report& report, JsonLayout layout) {
  const bool indented = layout == JsonLayout::Indented;
  const std::string text = to_json(report).dump(indented ? 1 : -1, ' ', false, Json::error_handler_t::replace);
  return indented ? text + "\n" : text;
}

}  // namespace croquis
