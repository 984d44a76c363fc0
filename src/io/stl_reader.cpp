// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>

#include "croquis/base/limits.h"
#include "io/channel_values.h"
#include "io/little_endian.h"
#include "io/mesh_formats.h"
#include "io/position_joiner.h"
#include "io/text.h"

namespace croquis {
namespace {

constexpr std::size_t header_size = 84;  // 80 bytes of anything, then the number of facets
constexpr std::size_t facet_size = 50;   // normal, 3 corners, 2 bytes of attribute
constexpr std::size_t looked_at_for_text = 512;

bool is_binary(std::string_view bytes) {
  if (bytes.size() >= header_size) {
    const std::size_t facets = load_little_endian<std::uint32_t>(bytes.data() + 80);
    if (bytes.size() == header_size + facet_size * facets) return true;
  }
  const std::string_view start = bytes.substr(0, looked_at_for_text);
  const std::size_t word = start.find_first_not_of(" \t\r\n");
  if (word == std::string_view::npos || lower_case(start.substr(word, 5)) != "solid") return true;
  return start.find('\0') != std::string_view::npos;
}

class BinaryStlReader {
 public:
  BinaryStlReader(std::string_view bytes, ReadContext& context) : bytes_(bytes), context_(context) {}

  PolyMesh read() {
    const std::size_t count = facet_count();
    mesh_.corners.reserve(3 * count);
    mesh_.face_offsets.reserve(count + 1);
    attributes_.reserve(count);
    for (std::size_t f = 0; f < count; ++f) read_facet(f);
    if (std::any_of(attributes_.begin(), attributes_.end(), [](std::uint16_t a) { return a != 0; })) {
      mesh_.channels.push_back(make_channel("attribute", Domain::Face, 1, std::move(attributes_)));
    }
    return std::move(mesh_);
  }

 private:
  std::size_t facet_count() {
    if (bytes_.size() < header_size) {
      context_.fail(lower_case(bytes_.substr(0, 5)) == "solid" ? "E_SYNTAX" : "E_TRUNCATED",
                    "this is neither a text STL nor long enough for a binary one", at_byte(bytes_.size()));
    }
    const std::size_t claimed = load_little_endian<std::uint32_t>(bytes_.data() + 80);
    const std::size_t held = (bytes_.size() - header_size) / facet_size;
    if (claimed > held) {
      context_.fail(
          "E_TRUNCATED",
          "the header claims " + std::to_string(claimed) + " facets, but the file holds only " + std::to_string(held),
          at_byte(bytes_.size()));
    }
    if (claimed < held) {
      context_.fail(
          "E_COUNT",
          "the header claims " + std::to_string(claimed) + " facets, but the file holds " + std::to_string(held),
          at_byte(80));
    }
    const std::size_t end = header_size + facet_size * claimed;
    if (end < bytes_.size()) {
      context_.warn("W_TRAILING", std::to_string(bytes_.size() - end) + " bytes after the last facet were passed over",
                    at_byte(end));
    }
    return claimed;
  }

  void read_facet(std::size_t facet) {
    const std::size_t byte = header_size + facet_size * facet;
    context_.tick(byte);
    const char* from = bytes_.data() + byte + 12;
    std::array<Index, 3> corners{};
    for (Index& corner : corners) {
      Vec3 point;
      for (double& x : point) {
        x = load_little_endian<float>(from);
        from += 4;
      }
      if (!are_usable_numbers(point)) context_.not_finite(mesh_.vertex_count(), at_byte(byte));
      corner = joiner_.add(point, mesh_.positions);
    }
    mesh_.add_face(corners);
    attributes_.push_back(load_little_endian<std::uint16_t>(from));
  }

  std::string_view bytes_;
  ReadContext& context_;
  PolyMesh mesh_;
  PositionJoiner joiner_;
  std::vector<std::uint16_t> attributes_;
};

class TextStlReader {
 public:
  TextStlReader(std::string_view bytes, ReadContext& context) : lines_(bytes), words_(""), context_(context) {}

  PolyMesh read() {
    for (std::string_view word = next(); !word.empty(); word = next()) {
      if (lower_case(word) != "solid") fail_expecting("solid", word);
      read_solid();
    }
    objects_.finish(mesh_);
    return std::move(mesh_);
  }

 private:
  // The next word of the file, whichever line it is on.
  std::string_view next() {
    std::string_view word = words_.next();
    TextLine line;
    while (word.empty() && lines_.next(line)) {
      words_ = WordReader(line.text);
      word = words_.next();
    }
    return word;
  }

  void expect(const char* keyword) {
    const std::string_view word = next();
    if (word != keyword && lower_case(word) != keyword) fail_expecting(keyword, word);
  }

  void fail_expecting(const std::string& keyword, std::string_view word) {
    const Place place = at_line(lines_.line_number());
    if (word.empty()) context_.fail("E_TRUNCATED", "the file ends where '" + keyword + "' must follow", place);
    context_.fail("E_SYNTAX", in_quotes(word) + " stands where '" + keyword + "' must follow", place);
  }

  double number() {
    const std::string_view word = next();
    double value = 0;
    if (word.empty() || !parse_number(word, value)) fail_expecting("a number", word);
    return value;
  }

  void read_solid() {
    const std::string_view name = words_.rest();
    name.empty() ? objects_.clear() : objects_.set(name);
    words_ = WordReader("");
    while (true) {
      const std::string_view word = next();
      const std::string keyword = lower_case(word);
      if (keyword == "endsolid") break;
      if (keyword != "facet") fail_expecting("facet' or 'endsolid", word);
      read_facet();
    }
    words_ = WordReader("");
  }

  void read_facet() {
    context_.tick(lines_.position());
    expect("normal");
    for (int k = 0; k < 3; ++k) number();
    expect("outer");
    expect("loop");
    corners_.clear();
    std::string_view word = next();
    for (; lower_case(word) == "vertex"; word = next()) {
      Vec3 point;
      for (double& x : point) x = number();
      if (!are_usable_numbers(point)) context_.not_finite(mesh_.vertex_count(), at_line(lines_.line_number()));
      corners_.push_back(joiner_.add(point, mesh_.positions));
    }
    if (lower_case(word) != "endloop") fail_expecting("vertex' or 'endloop", word);
    expect("endfacet");
    if (corners_.size() < 3) {
      context_.too_few_corners(mesh_.face_count(), corners_.size(), at_line(lines_.line_number()));
    }
    if (corners_.size() > 3) {
      context_.error("E_COUNT",
                     "facet " + std::to_string(mesh_.face_count()) + " has " + std::to_string(corners_.size()) +
                         " corners, and STL knows triangles only",
                     at_line(lines_.line_number()), face_subject(mesh_.face_count()));
    }
    objects_.face_added(mesh_.face_count());
    mesh_.add_face(corners_);
  }

  LineReader lines_;
  WordReader words_;
  ReadContext& context_;
  PolyMesh mesh_;
  PositionJoiner joiner_;
  CategoryState objects_{"object"};
  std::vector<Index> corners_;
};

}  // namespace

PolyMesh read_stl(std::string_view bytes, ReadContext& context) {
  return is_binary(bytes) ? BinaryStlReader(bytes, context).read() : TextStlReader(bytes, context).read();
}

}  // namespace croquis
