// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "croquis/geometry/poly_mesh.h"

/// Reading and making channels independently of the type that their file has.
namespace croquis {

/// Of vertices: corners that an earlier refinement has made, in OBJ's own tag `settled`.
inline constexpr const char* settled_corner_channel = "settled_corner";

/// The value number `i` of the flat data.
double value_of(const AttributeChannel& channel, std::size_t i);

bool is_floating(const AttributeChannel& channel);

/// A colour's component as 0..1, whatever its type.
double colour_of(const AttributeChannel& channel, std::size_t i);

/// All values are finite (integers always are).
bool all_finite(const AttributeChannel& channel);

/// The name of a face's or line's group, object or material: its label, else its number; empty for none (-1).
std::string label_of(const AttributeChannel& channel, std::size_t element);

/// The length fits the mesh, so that elements may be looked up.
bool fits(const AttributeChannel& channel, const PolyMesh& mesh);

/// The channel of that name, domain and one of two widths, if there is one that fits.
const AttributeChannel* usable_channel(const PolyMesh& mesh, const char* name, Domain domain, int width, int or_width);

template <typename T>
AttributeChannel make_channel(std::string name, Domain domain, int width, std::vector<T> values) {
  return {std::move(name), domain, width, std::move(values), {}};
}

/// Colours gathered as numbers: bytes when every file's value was an integer 0..255 and each element has one, else
/// numbers 0..1 with NaN for none.
AttributeChannel colour_channel(Domain domain, int width, std::vector<double> unit_values, bool bytes);

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
