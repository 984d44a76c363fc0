// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/geometry/picture_file.h"
#include "document/values/value_row.h"

namespace croquis {
namespace {

constexpr std::uint32_t picture_layout = 1;

std::int32_t read_side(ByteReader& reader) {
  const auto pixels = reader.number<std::int32_t>();
  if (pixels < 1) throw BadBytes("a picture has no pixels");
  return pixels;
}

/// A picture's file, which has no place in space.
struct PictureFileValue {
  using Content = PictureFile;
  static constexpr const char* name = "picture";
  static constexpr std::uint64_t tag = 8;

  static void add_content(const PictureFile& picture, ContentHasher& hasher) {
    hasher.add(picture.file);
    hasher.add(picture.width);
    hasher.add(picture.height);
    hasher.add(picture.bytes);
  }

  static std::size_t byte_size(const PictureFile& picture) {
    return sizeof(PictureFile) + picture.bytes.capacity() + picture.file.capacity();
  }

  static void store(const PictureFile& picture, ByteWriter& writer) {
    writer.number(picture_layout);
    writer.text(picture.file);
    writer.number(static_cast<std::int32_t>(picture.width));
    writer.number(static_cast<std::int32_t>(picture.height));
    writer.text(picture.bytes);
  }

  static PictureFile load(ByteReader& reader) {
    read_layout(reader, picture_layout);
    PictureFile picture;
    picture.file = reader.text();
    picture.width = read_side(reader);
    picture.height = read_side(reader);
    picture.bytes = reader.text();
    if (picture.bytes.empty()) throw BadBytes("a picture has no bytes");
    return picture;
  }
};

}  // namespace

constinit const ValueTraits ValueTraits::PictureFile = value_row<PictureFileValue>();

}  // namespace croquis
