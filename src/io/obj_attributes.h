// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "croquis/geometry/poly_mesh.h"

#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace croquis {

/// One of OBJ's states (`g`, `o`, `usemtl`): the name in force becomes a label of every face and line that follows.
class ObjCategory {
 public:
  explicit ObjCategory(const char* name) : name_(name) {}

  void set(std::string_view label);
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

/// A table of OBJ's (`vt`, `vn`) and which of its entries each corner uses.
class ObjCornerTable {
 public:
  ObjCornerTable(const char* name, int least_width) : name_(name), width_(least_width) {}

  std::size_t size() const { return values_.size() / 3; }
  void add(const double (&values)[3], int given);

  /// @param entry index into the table, or no_index
  void corner_added(Index entry, std::size_t corners_before);

  /// Some corner uses an entry.
  bool used() const { return !entries_.empty(); }

  /// Appends the channel: on vertices where every corner uses the entry of its vertex' own number, else on corners.
  void finish(PolyMesh& mesh);

 private:
  bool follows_vertices(const PolyMesh& mesh) const;

  const char* name_;
  int width_;
  std::vector<double> values_;  // three per entry
  std::vector<Index> entries_;  // per corner, empty until one is used
};

}  // namespace croquis
