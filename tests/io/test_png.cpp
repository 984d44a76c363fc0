// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <png.h>

#include "croquis/base/error.h"
#include "croquis/io/png.h"

using namespace croquis;

namespace {

Picture gradient(int width, int height) {
  Picture picture{width, height, {}};
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      for (int value : {x * 7, y * 11, x + y, 255 - x}) picture.rgba.push_back(static_cast<std::uint8_t>(value));
    }
  }
  return picture;
}

Picture decode(const std::string& bytes) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  REQUIRE(png_image_begin_read_from_memory(&image, bytes.data(), bytes.size()));
  image.format = PNG_FORMAT_RGBA;
  Picture picture{static_cast<int>(image.width), static_cast<int>(image.height), {}};
  picture.rgba.resize(PNG_IMAGE_SIZE(image));
  REQUIRE(png_image_finish_read(&image, nullptr, picture.rgba.data(), 0, nullptr));
  return picture;
}

}  // namespace

TEST_CASE("a PNG holds the picture's pixels, top row first") {
  for (const auto& [width, height] : {std::pair{1, 1}, std::pair{3, 5}, std::pair{200, 17}}) {
    const Picture picture = gradient(width, height);
    const Picture back = decode(encode_png(picture));
    CHECK(back.width == width);
    CHECK(back.height == height);
    CHECK(back.rgba == picture.rgba);
  }
}

TEST_CASE("the same picture gives the same PNG bytes") {
  CHECK(encode_png(gradient(64, 48)) == encode_png(gradient(64, 48)));
}

TEST_CASE("a picture whose sizes contradict each other is refused") {
  Picture picture = gradient(4, 4);
  picture.rgba.pop_back();
  CHECK_THROWS_AS(encode_png(picture), Error);
  CHECK_THROWS_AS(encode_png(Picture{}), Error);
  CHECK_THROWS_AS(encode_png(Picture{-1, -1, {1, 2, 3, 4}}), Error);
}
