// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/io/png.h"

#include <png.h>

#include "croquis/base/error.h"

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

}  // namespace

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
