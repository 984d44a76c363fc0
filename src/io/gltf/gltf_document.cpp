// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/gltf/gltf_document.h"

#include <algorithm>
#include <cmath>

#include "croquis/io/json.h"

namespace croquis {
namespace {

/// Indices and byte counts fit four bytes in any file that is read.
constexpr double largest_whole = 4294967295.0;

template <typename T>
const T* gltf_value(const Report* report) {
  return report == nullptr ? nullptr : std::get_if<T>(&report->value());
}

const Report* member_of(const Report& object, const char* member) {
  return gltf_value<Report::Object>(&object) == nullptr ? nullptr : object.find(member);
}

std::optional<double> number_of(const Report& report) {
  if (const auto* whole = gltf_value<std::int64_t>(&report)) return static_cast<double>(*whole);
  if (const auto* number = gltf_value<double>(&report)) return *number;
  return std::nullopt;
}

std::optional<std::size_t> whole_of(const Report& report) {
  const std::optional<double> number = number_of(report);
  if (!number || *number < 0 || *number > largest_whole || std::floor(*number) != *number) return std::nullopt;
  return static_cast<std::size_t>(*number);
}

}  // namespace

std::string gltf_element(const char* kind, std::size_t index) {
  return std::string(kind) + " " + std::to_string(index);
}

GltfDocument::GltfDocument(std::string_view json, ReadContext& context)
    : context_(context),
      root_(read_json(json.substr(0, json.find_last_not_of(std::string_view(" \0", 2)) + 1), context.file_name())) {
  if (gltf_value<Report::Object>(&root_) == nullptr) fail("E_SYNTAX", "the model's description is no object");
  const Report* asset = member_of(root_, "asset");
  const std::string version = asset == nullptr ? "" : text(*asset, "version");
  if (!version.starts_with("2.")) fail("E_SYNTAX", "the model's description names no version 2 of glTF");
}

void GltfDocument::fail(const char* code, const std::string& message) const { context_.fail(code, message, {}); }

std::size_t GltfDocument::count(const char* list) const {
  const auto* elements = gltf_value<Report::Array>(member_of(root_, list));
  return elements == nullptr ? 0 : elements->size();
}

const Report& GltfDocument::element(const char* list, std::size_t index, const std::string& user) const {
  const auto* elements = gltf_value<Report::Array>(member_of(root_, list));
  const std::size_t held = elements == nullptr ? 0 : elements->size();
  if (index >= held) {
    fail("E_INDEX",
         user + " uses entry " + std::to_string(index) + " of '" + list + "', which has " + std::to_string(held));
  }
  const Report& found = (*elements)[index];
  if (gltf_value<Report::Object>(&found) == nullptr) {
    fail("E_SYNTAX", "entry " + std::to_string(index) + " of '" + list + "' is no object");
  }
  return found;
}

std::optional<std::size_t> GltfDocument::index(const Report& object, const char* member,
                                               const std::string& owner) const {
  const Report* value = member_of(object, member);
  if (value == nullptr) return std::nullopt;
  const std::optional<std::size_t> whole = whole_of(*value);
  if (!whole) fail("E_SYNTAX", "'" + std::string(member) + "' of " + owner + " is no whole number from 0");
  return whole;
}

std::size_t GltfDocument::index_or(const Report& object, const char* member, std::size_t otherwise,
                                   const std::string& owner) const {
  return index(object, member, owner).value_or(otherwise);
}

std::optional<std::vector<double>> GltfDocument::numbers(const Report& object, const char* member, std::size_t count,
                                                         const std::string& owner) const {
  const Report* value = member_of(object, member);
  if (value == nullptr) return std::nullopt;
  const auto* list = gltf_value<Report::Array>(value);
  std::vector<double> result;
  for (std::size_t i = 0; list != nullptr && list->size() == count && i < count; ++i) {
    if (const std::optional<double> number = number_of((*list)[i])) result.push_back(*number);
  }
  if (result.size() != count) {
    fail("E_SYNTAX",
         "'" + std::string(member) + "' of " + owner + " is no list of " + std::to_string(count) + " numbers");
  }
  return result;
}

std::vector<std::size_t> GltfDocument::indices(const Report& object, const char* member,
                                               const std::string& owner) const {
  const Report* value = member_of(object, member);
  if (value == nullptr) return {};
  std::vector<std::size_t> result;
  const auto* list = gltf_value<Report::Array>(value);
  const auto refuse = [&] {
    fail("E_SYNTAX", "'" + std::string(member) + "' of " + owner + " is no list of whole numbers from 0");
  };
  if (list == nullptr) refuse();
  for (const Report& entry : *list) {
    const std::optional<std::size_t> whole = whole_of(entry);
    if (!whole) refuse();
    result.push_back(*whole);
  }
  return result;
}

std::string GltfDocument::text(const Report& object, const char* member) {
  const auto* value = gltf_value<std::string>(member_of(object, member));
  return value == nullptr ? std::string() : *value;
}

}  // namespace croquis
