// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <string_view>
#include <vector>

#include "croquis/base/limits.h"
#include "io/channel_values.h"
#include "io/mesh_formats.h"
#include "io/text.h"

namespace croquis {
namespace {

constexpr std::size_t least_vertex_bytes = 6;  // "0 0 0" and what ends it
constexpr std::size_t least_face_bytes = 2;

constexpr double no_colour = std::numeric_limits<double>::quiet_NaN();

/// Colours of OFF's vertices or faces, of which some may have none; what type they are is known at the end.
class ColourGathering {
 public:
  /// @param words three or four numbers. @return false when one is no number
  bool add(std::size_t element, std::span<const std::string_view> words) {
    values_.resize(4 * element, no_colour);
    for (const std::string_view word : words) {
      double value = 0;
      if (!parse_number(word, value)) return false;
      whole_ = whole_ && word.find_first_of(".eEnN") == std::string_view::npos;
      values_.push_back(value);
    }
    // No alpha is known to be opaque only at the end, when the scale is; infinity stands for it until then.
    if (words.size() == 3) values_.push_back(std::numeric_limits<double>::infinity());
    width_ = std::max(width_, words.size());
    ++count_;
    return true;
  }

  /// Appends the channel: bytes when every element has integers 0..255, else numbers 0..1 with NaN for none.
  void finish(PolyMesh& mesh, Domain domain) {
    if (count_ == 0) return;
    const std::size_t elements = mesh.element_count(domain);
    values_.resize(4 * elements, no_colour);
    const double full = whole_ ? 255 : 1;
    bool bytes = whole_ && count_ == elements;
    std::vector<double> scaled;
    scaled.reserve(elements * width_);
    for (std::size_t e = 0; e < elements; ++e) {
      for (std::size_t k = 0; k < width_; ++k) {
        const double value = std::isinf(values_[4 * e + k]) ? full : values_[4 * e + k];
        bytes = bytes && value >= 0 && value <= full;
        scaled.push_back(value / full);
      }
    }
    mesh.channels.push_back(colour_channel(domain, static_cast<int>(width_), std::move(scaled), bytes));
  }

 private:
  std::vector<double> values_;  // four per element, up to the last that has a colour
  std::size_t width_ = 3;
  std::size_t count_ = 0;
  bool whole_ = true;  // no value was written with a point or an exponent
};

class OffReader {
 public:
  OffReader(std::string_view bytes, ReadContext& context) : bytes_(bytes), lines_(bytes), context_(context) {}

  PolyMesh read() {
    read_header();
    for (std::size_t v = 0; v < vertex_count_; ++v) read_vertex(v);
    for (std::size_t f = 0; f < face_count_; ++f) read_face(f);
    if (next_row()) {
      context_.error("E_COUNT", "the file holds more than its header announces", at_line(line_));
    }
    if (context_.has_errors()) return {};
    add_channels();
    return std::move(mesh_);
  }

 private:
  // The next line with words on it.
  bool next_row() {
    TextLine line;
    while (lines_.next(line)) {
      context_.tick(lines_.position());
      words_.clear();
      WordReader reader(line.text);
      for (std::string_view word = reader.next(); !word.empty(); word = reader.next()) words_.push_back(word);
      line_ = line.number;
      if (!words_.empty()) return true;
    }
    return false;
  }

  void require_row(const char* what, std::size_t read, std::size_t claimed) {
    if (next_row()) return;
    context_.fail("E_TRUNCATED",
                  "the file ends after " + std::to_string(read) + " of " + std::to_string(claimed) + " " + what,
                  at_line(lines_.line_number()));
  }

  void read_header() {
    if (!next_row()) context_.fail("E_EMPTY", "the file holds nothing but comments", at_line(1));
    read_kind(words_[0]);
    if (words_.size() > 1 && lower_case(words_[1]) == "binary") {
      context_.fail("E_SYNTAX", "binary OFF is not read; save it as text", at_line(line_));
    }
    if (words_.size() > 1) return read_counts(1);
    if (!next_row()) context_.fail("E_TRUNCATED", "the file ends before its counts", at_line(line_));
    read_counts(0);
  }

  void read_kind(std::string_view word) {
    const std::string_view whole = word;
    const auto take = [&word](std::string_view prefix) {
      const bool found = word.starts_with(prefix);
      if (found) word.remove_prefix(prefix.size());
      return found;
    };
    has_uv_ = take("ST");
    take("C");
    has_normals_ = take("N");
    if (word == "OFF") return;
    if (word == "4OFF" || word == "nOFF" || word == "4nOFF") {
      context_.fail("E_SYNTAX", in_quotes(whole) + " has points of another dimension than three", at_line(line_));
    }
    context_.fail("E_SYNTAX", "an OFF file begins with OFF, COFF, NOFF or the like, not with " + in_quotes(whole),
                  at_line(line_));
  }

  void read_counts(std::size_t first_word) {
    const std::size_t given = words_.size() - first_word;
    if (given < 2 || given > 3 || !parse_number(words_[first_word], vertex_count_) ||
        !parse_number(words_[first_word + 1], face_count_)) {
      context_.fail("E_COUNT", "the numbers of vertices, faces and edges must stand here", at_line(line_));
    }
    const std::size_t left = bytes_.size() - lines_.position() + 1;  // the last line needs no end
    const std::size_t vertices = left / least_vertex_bytes;
    const std::size_t faces = left / least_face_bytes;
    if (vertex_count_ <= vertices && face_count_ <= faces) return;
    context_.fail("E_TRUNCATED",
                  "the header claims " + std::to_string(vertex_count_) + " vertices and " +
                      std::to_string(face_count_) + " faces, more than the rest of the file can hold",
                  at_line(line_));
  }

  void read_vertex(std::size_t vertex) {
    require_row("vertices", vertex, vertex_count_);
    const std::size_t fixed = 3U + (has_normals_ ? 3U : 0U) + (has_uv_ ? 2U : 0U);
    const std::size_t colours = words_.size() - std::min(fixed, words_.size());
    mesh_.positions.emplace_back(Vec3::Zero());  // even after an error, to keep the numbering
    if (words_.size() < fixed || (colours != 0 && colours != 3 && colours != 4)) {
      return context_.error("E_COUNT",
                            "vertex " + std::to_string(vertex) + " has " + std::to_string(words_.size()) +
                                " values, not " + std::to_string(fixed) + " and a colour of 3 or 4",
                            at_line(line_), vertex_subject(vertex));
    }
    std::array<double, 3> values{};
    if (!read_numbers(0, values)) return;
    mesh_.positions.back() = Vec3(values[0], values[1], values[2]);
    if (!are_usable_numbers(mesh_.positions.back())) context_.not_finite(vertex, at_line(line_));
    if (has_normals_ && read_numbers(3, values)) normals_.insert(normals_.end(), values.begin(), values.end());
    const std::span<const std::string_view> colour(words_.data() + (has_normals_ ? 6 : 3), colours);
    if (colours > 0 && !vertex_colours_.add(vertex, colour)) {
      context_.error("E_SYNTAX", "the colour of vertex " + std::to_string(vertex) + " is not made of numbers",
                     at_line(line_), vertex_subject(vertex));
    }
    std::array<double, 2> uv{};
    if (has_uv_ && read_numbers(words_.size() - 2, uv)) uvs_.insert(uvs_.end(), uv.begin(), uv.end());
  }

  bool read_numbers(std::size_t first, std::span<double> values) {
    for (std::size_t k = 0; k < values.size(); ++k) {
      if (parse_number(words_[first + k], values[k])) continue;
      context_.error("E_SYNTAX", in_quotes(words_[first + k]) + " is not a number", at_line(line_));
      return false;
    }
    return true;
  }

  void read_face(std::size_t face) {
    require_row("faces", face, face_count_);
    std::size_t count = 0;
    if (!parse_number(words_[0], count) || count >= words_.size()) {
      return context_.error("E_COUNT",
                            "face " + std::to_string(face) + " claims " + in_quotes(words_[0]) +
                                " corners, but its line has " + std::to_string(words_.size() - 1) +
                                " values after that",
                            at_line(line_), face_subject(face));
    }
    if (count < 3) context_.too_few_corners(face, count, at_line(line_));
    for (std::size_t i = 1; i <= count; ++i) {
      std::int64_t index = 0;
      if (!parse_number(words_[i], index)) {
        context_.error("E_SYNTAX", in_quotes(words_[i]) + " is not the index of a vertex", at_line(line_),
                       face_subject(face));
      } else if (index < 0 || index >= static_cast<std::int64_t>(vertex_count_)) {
        context_.bad_index(face, index, vertex_count_, at_line(line_));
      }
      mesh_.corners.push_back(static_cast<Index>(index));
    }
    mesh_.face_offsets.push_back(static_cast<Index>(mesh_.corners.size()));
    read_face_colour(face, count + 1);
  }

  void read_face_colour(std::size_t face, std::size_t first_word) {
    const std::size_t given = words_.size() - first_word;
    if (given == 1 && !met_colour_map_) {
      met_colour_map_ = true;
      context_.warn("W_IGNORED", "indices into a colour map were passed over, the file has no map", at_line(line_));
    }
    if (given <= 1) return;
    const std::span<const std::string_view> colour(words_.data() + first_word, given);
    if (given > 4 || given < 3 || !face_colours_.add(face, colour)) {
      context_.error("E_COUNT", "what follows the corners of face " + std::to_string(face) + " is no colour",
                     at_line(line_), face_subject(face));
    }
  }

  void add_channels() {
    if (!normals_.empty()) mesh_.channels.push_back(make_channel("normal", Domain::Vertex, 3, std::move(normals_)));
    vertex_colours_.finish(mesh_, Domain::Vertex);
    if (!uvs_.empty()) mesh_.channels.push_back(make_channel("uv", Domain::Vertex, 2, std::move(uvs_)));
    face_colours_.finish(mesh_, Domain::Face);
  }

  std::string_view bytes_;
  LineReader lines_;
  ReadContext& context_;
  PolyMesh mesh_;
  std::vector<std::string_view> words_;  // of the row under way
  std::int64_t line_ = 0;
  bool has_normals_ = false, has_uv_ = false;
  std::size_t vertex_count_ = 0, face_count_ = 0;
  std::vector<double> normals_, uvs_;
  ColourGathering vertex_colours_, face_colours_;
  bool met_colour_map_ = false;
};

}  // namespace

PolyMesh read_off(std::string_view bytes, ReadContext& context) { return OffReader(bytes, context).read(); }

}  // namespace croquis
