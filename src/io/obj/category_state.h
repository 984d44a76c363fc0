// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "croquis/geometry/poly_mesh.h"

namespace croquis {

/// A named state of a text format (OBJ's g, o and usemtl, STL's solid): the name in force becomes a label of every face
/// and line that follows.
class CategoryState {
 public:
  explicit CategoryState(const char* name) : name_(name) {}

  void set(std::string_view label);
  void clear() { current_ = -1; }
  void face_added(std::size_t faces_before) { note(face_values_, faces_before); }
  void line_added(std::size_t lines_before) { note(line_values_, lines_before); }

  /// Appends the channels, none where nothing was ever named.
  void finish(PolyMesh& mesh);

 private:
  void note(std::vector<std::int32_t>& values, std::size_t elements_before);

  const char* name_;
  std::int32_t current_ = -1;
  std::vector<std::string> labels_;
  std::unordered_map<std::string, std::int32_t> numbers_;
  std::vector<std::int32_t> face_values_;
  std::vector<std::int32_t> line_values_;
};

}  // namespace croquis
