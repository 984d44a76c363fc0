// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>

#include <catch2/catch.hpp>

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

/// A number as PNG files hold it.
std::string four_bytes(std::uint32_t number) {
  std::string bytes;
  for (int shift = 24; shift >= 0; shift -= 8) bytes.push_back(static_cast<char>(number >> shift & 0xFFU));
  return bytes;
}

/// The checksum of a chunk (PNG specification, annex D).
std::uint32_t checksum(const std::string& bytes) {
  std::uint32_t sum = ~0U;
  for (const char byte : bytes) {
    sum ^= static_cast<unsigned char>(byte);
    for (int bit = 0; bit < 8; ++bit) sum = sum >> 1 ^ ((sum & 1U) != 0 ? 0xEDB88320U : 0U);
  }
  return ~sum;
}

std::string chunk(const std::string& name, const std::string& data) {
  return four_bytes(static_cast<std::uint32_t>(data.size())) + name + data + four_bytes(checksum(name + data));
}

constexpr std::size_t after_header = 8 + 25;  // bytes: signature and the header's chunk

/// A PNG file that says how its pixels lie.
std::string with_orientation(std::string png, int orientation, bool highest_first) {
  using namespace std::string_literals;
  const auto code = static_cast<char>(orientation);
  const std::string exif = highest_first ? "MM\0*\0\0\0\x08\0\1\x01\x12\0\3\0\0\0\1\0"s + code + "\0\0\0\0\0\0"s
                                         : "II*\0\x08\0\0\0\1\0\x12\x01\3\0\1\0\0\0"s + code + "\0\0\0\0\0\0\0"s;
  return png.insert(after_header, chunk("eXIf", exif));
}

std::string refusal_of(const std::string& bytes) {
  try {
    decode_png(bytes, "photo.png");
  } catch (const Error& error) {
    CHECK(error.findings().front().message.find("photo.png") != std::string::npos);
    return error.findings().front().code;
  }
  return "";
}

}  // namespace

TEST_CASE("a PNG holds the picture's pixels, top row first") {
  for (const auto& [width, height] : {std::pair{1, 1}, std::pair{3, 5}, std::pair{200, 17}}) {
    const Picture picture = gradient(width, height);
    const Picture back = decode_png(encode_png(picture), "");
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

TEST_CASE("a PNG file that says how its pixels lie is read upright") {
  // A letter F, and as which corner of it each orientation stores first (Exif 2.32, 4.6.4).
  const std::vector<std::vector<int>> letter{{1, 1, 1}, {1, 0, 0}, {1, 1, 0}, {1, 0, 0}};
  const auto shown = [&](int x, int y) { return letter[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)]; };
  // Where a stored row and column are found in the letter.
  using Place = std::array<int, 2>;
  const std::array<Place (*)(int, int), 8> places{[](int row, int column) {
                                                    return Place{column, row};
                                                  },
                                                  [](int row, int column) {
                                                    return Place{2 - column, row};
                                                  },
                                                  [](int row, int column) {
                                                    return Place{2 - column, 3 - row};
                                                  },
                                                  [](int row, int column) {
                                                    return Place{column, 3 - row};
                                                  },
                                                  [](int row, int column) {
                                                    return Place{row, column};
                                                  },
                                                  [](int row, int column) {
                                                    return Place{2 - row, column};
                                                  },
                                                  [](int row, int column) {
                                                    return Place{2 - row, 3 - column};
                                                  },
                                                  [](int row, int column) {
                                                    return Place{row, 3 - column};
                                                  }};
  for (int orientation = 1; orientation <= 8; ++orientation) {
    const bool lies = orientation > 4;
    Picture stored{lies ? 4 : 3, lies ? 3 : 4, {}};
    for (int row = 0; row < stored.height; ++row) {
      for (int column = 0; column < stored.width; ++column) {
        const auto [x, y] = places[static_cast<std::size_t>(orientation - 1)](row, column);
        const auto level = static_cast<std::uint8_t>(255 * shown(x, y));
        stored.rgba.insert(stored.rgba.end(), {level, level, level, 255});
      }
    }
    for (const bool highest_first : {false, true}) {
      INFO("orientation " << orientation);
      const std::string bytes = with_orientation(encode_png(stored), orientation, highest_first);
      CHECK(png_orientation(bytes) == orientation);
      const Picture picture = decode_png(bytes, "photo.png");
      REQUIRE(picture.width == 3);
      REQUIRE(picture.height == 4);
      for (int y = 0; y < 4; ++y) {
        for (int x = 0; x < 3; ++x) CHECK(picture.rgba[static_cast<std::size_t>(4 * (3 * y + x))] == 255 * shown(x, y));
      }
    }
  }
  CHECK(png_orientation(with_orientation(encode_png(gradient(2, 2)), 9, true)) == 1);
}

TEST_CASE("damaged PNG files are refused, and those that are too large") {
  const std::string bytes = with_orientation(encode_png(gradient(40, 30)), 6, true);
  REQUIRE(refusal_of(bytes).empty());
  CHECK(refusal_of("") == "E_PICTURE_FILE");
  for (std::size_t size = 1; size + 20 < bytes.size(); size += 7)
    CHECK(refusal_of(bytes.substr(0, size)) == "E_PICTURE_FILE");
  for (std::size_t place = 0; place < bytes.size(); place += 3) {
    std::string damaged = bytes;
    damaged[place] = static_cast<char>(damaged[place] ^ 0x55);
    const std::string code = refusal_of(damaged);
    CHECK((code.empty() || code == "E_PICTURE_FILE" || code == "E_LIMIT"));
    png_orientation(damaged);
  }
  std::string large =
      bytes.substr(0, 8) + chunk("IHDR", four_bytes(20000) + four_bytes(20000) + std::string("\x08\6\0\0\0", 5));
  CHECK(refusal_of(large + bytes.substr(after_header)) == "E_LIMIT");
}
