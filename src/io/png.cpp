// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/io/png.h"

#include <algorithm>
#include <array>
#include <utility>

#include <png.h>

#include "croquis/base/error.h"
#include "croquis/base/limits.h"

namespace croquis {
namespace {

[[noreturn]] void fail(const std::string& reason) {
  throw Error(make_error(Category::Internal, "E_PICTURE", "The picture can't be encoded as PNG: " + reason + "."));
}

void check_size(const Picture& picture) {
  if (picture.width <= 0 || picture.height <= 0) fail("it has no pixels");
  const auto pixels = static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height);
  if (picture.rgba.size() != 4 * pixels) fail("its data does not match its width and height");
}

[[noreturn]] void refuse_png(const std::string& file, Category category, const char* code, const std::string& reason) {
  throw Error(make_error(category, code, "The picture \"" + file + "\" " + reason,
                         {{SubjectKind::File, file, std::nullopt, std::nullopt, {}}}));
}

/// A number of some bytes, the highest first or last; 0 beyond the end.
std::uint32_t number_at(std::string_view bytes, std::size_t place, std::size_t size, bool highest_first = true) {
  if (place > bytes.size() || size > bytes.size() - place) return 0;
  std::uint32_t number = 0;
  for (std::size_t i = 0; i < size; ++i)
    number = number << 8 | static_cast<unsigned char>(bytes[place + (highest_first ? i : size - 1 - i)]);
  return number;
}

/// The tag "orientation" of Exif data, 1..8; 1 where it isn't given. https://www.w3.org/TR/png-3/ (11.3.4.3), Exif 2.32
/// (4.6.4)
int exif_orientation(std::string_view exif) {
  constexpr std::uint32_t orientation = 0x0112;
  constexpr std::size_t entry_size = 12;
  const bool highest_first = exif.starts_with("MM");
  const std::size_t table = number_at(exif, 4, 4, highest_first);
  const std::size_t count = number_at(exif, table, 2, highest_first);
  for (std::size_t entry = table + 2; entry < table + 2 + count * entry_size; entry += entry_size) {
    if (number_at(exif, entry, 2, highest_first) != orientation) continue;
    const std::uint32_t value = number_at(exif, entry + 8, 2, highest_first);
    return value >= 1 && value <= 8 ? static_cast<int>(value) : 1;
  }
  return 1;
}

/// The picture as people see it that a file stores in that orientation.
Picture upright(Picture stored, int orientation) {
  if (orientation == 1) return stored;
  const bool transposes = orientation >= 5;
  const bool flips_x = orientation == 2 || orientation == 3 || orientation == 7 || orientation == 8;
  const bool flips_y = orientation == 3 || orientation == 4 || orientation == 6 || orientation == 7;
  Picture picture = stored;
  if (transposes) std::swap(picture.width, picture.height);
  auto to = picture.rgba.begin();
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      const int column = transposes ? y : x, row = transposes ? x : y;
      const auto from_x = static_cast<std::size_t>(flips_x ? stored.width - 1 - column : column);
      const auto from_y = static_cast<std::size_t>(flips_y ? stored.height - 1 - row : row);
      const std::size_t from = 4 * (from_y * static_cast<std::size_t>(stored.width) + from_x);
      to = std::copy_n(stored.rgba.begin() + static_cast<std::ptrdiff_t>(from), 4, to);
    }
  }
  return picture;
}

}  // namespace

int png_orientation(std::string_view bytes) {
  constexpr std::size_t signature = 8, around_data = 12;  // bytes: length, name and checksum of each chunk
  for (std::size_t chunk = signature; chunk + around_data <= bytes.size();) {
    const std::size_t size = number_at(bytes, chunk, 4);
    if (bytes.substr(chunk + 4, 4) == "eXIf") return exif_orientation(bytes.substr(chunk + 8, size));
    chunk += size + around_data;
  }
  return 1;
}

Picture decode_png(std::string_view bytes, const std::string& file_name) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  const auto refuse_damaged = [&] {
    const std::string reason = image.message;
    png_image_free(&image);
    refuse_png(file_name, Category::Malformed, "E_PICTURE_FILE", "can't be read: " + reason + "; save it again as PNG");
  };
  if (png_image_begin_read_from_memory(&image, bytes.data(), bytes.size()) == 0) refuse_damaged();
  if (static_cast<std::size_t>(image.width) * image.height > most_picture_pixels) {
    png_image_free(&image);
    refuse_png(file_name, Category::Limit, "E_LIMIT", "has more than 100 million pixels: scale it down");
  }
  image.format = PNG_FORMAT_RGBA;
  Picture picture{static_cast<int>(image.width), static_cast<int>(image.height), {}};
  picture.rgba.resize(PNG_IMAGE_SIZE(image));
  if (png_image_finish_read(&image, nullptr, picture.rgba.data(), 0, nullptr) == 0) refuse_damaged();
  return upright(std::move(picture), png_orientation(bytes));
}

std::string encode_png(const Picture& picture) {
  check_size(picture);
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(picture.width);
  image.height = static_cast<png_uint_32>(picture.height);
  image.format = PNG_FORMAT_RGBA;
  // The upper bound costs memory for a moment; asking for the exact size would compress twice.
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(image);
  std::string bytes(size, '\0');
  if (png_image_write_to_memory(&image, bytes.data(), &size, 0, picture.rgba.data(), 0, nullptr) == 0) {
    const std::string reason = image.message;
    png_image_free(&image);
    fail(reason);
  }
  bytes.resize(size);
  bytes.shrink_to_fit();
  return bytes;
}

}  // namespace croquis
