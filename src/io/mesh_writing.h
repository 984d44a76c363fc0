// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <string>
#include <vector>

#include "croquis/base/progress.h"
#include "croquis/geometry/poly_mesh.h"
#include "croquis/io/mesh_file.h"
#include "io/text.h"

/// What the writers of meshes share.
namespace croquis {

/// Called for every element written; looks now and then whether to stop.
class WriteTick {
 public:
  explicit WriteTick(const Progress& progress) : progress_(progress) {}

  /// @throws Cancelled
  void operator()() {
    if (++count_ % (std::size_t{1} << 16) == 0) progress_.check();
  }

 private:
  const Progress& progress_;
  std::size_t count_ = 0;
};

/// Appends the values of a format's rows as text or as little-endian bytes.
class ValueSink {
 public:
  ValueSink(bool ascii, int precision) : ascii_(ascii), precision_(precision) {}

  template <typename T>
  void put(T value) {
    if (ascii_) {
      if (row_begun_) text_ += ' ';
      row_begun_ = true;
      append_number(text_, value, precision_);
      return;
    }
    auto bytes = std::bit_cast<std::array<char, sizeof(T)>>(value);
    if constexpr (std::endian::native == std::endian::big) std::reverse(bytes.begin(), bytes.end());
    text_.append(bytes.data(), bytes.size());
  }

  void end_row() {
    if (ascii_) text_ += '\n';
    row_begun_ = false;
  }

  std::string& text() { return text_; }

 private:
  bool ascii_;
  int precision_;
  bool row_begun_ = false;
  std::string text_;
};

/// Each coordinate rounded to the nearest 32-bit float, infinite when it is too large.
Vec3 as_floats(const Vec3& point);

/// Floats hold every position exactly.
bool positions_are_floats(const PolyMesh& mesh);

/// The positions as 32-bit floats.
/// @throws Error (E_OUT_OF_RANGE) when one is too large for them
std::vector<Vec3> positions_as_floats(const PolyMesh& mesh, MeshFormat format);

/// Gathers what a format can't hold, for the one warning that goes with the written file.
class FormatLoss {
 public:
  explicit FormatLoss(std::string format) : format_(std::move(format)) {}

  void note(std::string what) { parts_.push_back(std::move(what)); }
  void note_channel(const AttributeChannel& channel);

  /// Every channel of the mesh that is not among those written.
  void note_others(const PolyMesh& mesh, const std::vector<const AttributeChannel*>& written);

  /// That polygons are cut into triangles, if some are.
  void note_polygons(const PolyMesh& mesh);

  /// All tags, if there are any.
  void note_tags(const MeshTags& tags);

  /// That tags go into named sets, if some do.
  void note_sets(const MeshTags& tags);

  /// Nothing, or one W_FORMAT_LOSS.
  Findings warnings() const;

 private:
  std::string format_;
  std::vector<std::string> parts_;
};

}  // namespace croquis
