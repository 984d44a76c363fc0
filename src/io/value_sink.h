// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <string>

#include "io/text.h"

namespace croquis {

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

}  // namespace croquis
