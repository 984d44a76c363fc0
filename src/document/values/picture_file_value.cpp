// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/geometry/picture_file.h"
#include "document/values/member_bytes.h"

namespace croquis {

inline auto members(const PictureFile& picture) {
  return std::tie(picture.file, picture.width, picture.height, picture.bytes);
}
static_assert(lists_every_member<PictureFile>);

inline void require_valid(const PictureFile& picture) {
  if (picture.width < 1 || picture.height < 1) throw BadBytes("a picture has no pixels");
  if (picture.bytes.empty()) throw BadBytes("a picture has no bytes");
}

namespace {

/// A picture's file, which has no place in space.
struct PictureFileValue : ListedValue<PictureFile> {
  static constexpr const char* name = "picture";
  static constexpr std::uint64_t tag = 8;
};

}  // namespace

constinit const ValueTraits ValueTraits::PictureFile = value_row<PictureFileValue>();

}  // namespace croquis
