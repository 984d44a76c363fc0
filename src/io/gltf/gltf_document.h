// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "croquis/base/report.h"
#include "io/read_context.h"

namespace croquis {

/// What glTF calls one of its elements in sentences: accessor 3.
std::string gltf_element(const char* kind, std::size_t index);

/// Reads members of glTF's JSON and reports what is wrong with them.
class GltfDocument {
 public:
  /// @throws Error E_SYNTAX when it isn't JSON, no object, or of another version than 2
  GltfDocument(std::string_view json, ReadContext& context);

  ReadContext& context() const { return context_; }
  const Report& root() const { return root_; }

  /// How many elements a list of the root has; 0 when there is none.
  std::size_t count(const char* list) const;

  /// An object. @throws Error E_INDEX when there is no such element, E_SYNTAX when it is something else
  const Report& element(const char* list, std::size_t index, const std::string& user) const;

  /// A whole number that isn't negative. @throws Error E_SYNTAX when it is something else
  std::optional<std::size_t> index(const Report& object, const char* member, const std::string& owner) const;
  std::size_t index_or(const Report& object, const char* member, std::size_t otherwise, const std::string& owner) const;

  /// The numbers of a list, as many as asked for; nothing when the member is missing. @throws Error E_SYNTAX
  std::optional<std::vector<double>> numbers(const Report& object, const char* member, std::size_t count,
                                             const std::string& owner) const;

  /// Whole numbers that aren't negative, as many as there are. @throws Error E_SYNTAX
  std::vector<std::size_t> indices(const Report& object, const char* member, const std::string& owner) const;

  /// Empty when it is missing or no text.
  static std::string text(const Report& object, const char* member);

  [[noreturn]] void fail(const char* code, const std::string& message) const;

 private:
  ReadContext& context_;
  Report root_;
};

}  // namespace croquis
