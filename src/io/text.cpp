// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/text.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace croquis {
namespace {

constexpr std::size_t longest_quote = 40;

// The text is a number whose magnitude the type can't hold: its exponent decides which of the two ends.
template <typename Float>
Float out_of_range_value(std::string_view word) {
  long double wide = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), wide);
  if (error == std::errc()) return static_cast<Float>(wide);
  const std::size_t exponent = word.find_first_of("eE");
  const bool tiny = exponent != std::string_view::npos && word.substr(exponent).find('-') != std::string_view::npos;
  const Float magnitude = tiny ? Float(0) : std::numeric_limits<Float>::infinity();
  return word.front() == '-' ? -magnitude : magnitude;
}

template <typename Float>
bool parse_float(std::string_view word, Float& value) {
  if (!word.empty() && word.front() == '+') {
    word.remove_prefix(1);
    if (!word.empty() && word.front() == '-') return false;
  }
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error == std::errc::result_out_of_range && end == word.data() + word.size()) {
    value = out_of_range_value<Float>(word);
    return true;
  }
  if (error == std::errc() && end == word.data() + word.size()) return true;
  // Microsoft's old runtime wrote 1.#QNAN, -1.#IND and 1.#INF.
  if (word.find(".#") == std::string_view::npos || word.size() > 12) return false;
  value = std::numeric_limits<Float>::quiet_NaN();
  return true;
}

template <typename Float>
void append_float(std::string& text, Float value, int precision) {
  char buffer[64];
  const auto result = precision > 0 ? std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::general,
                                                    std::min(precision, 17))
                                    : std::to_chars(buffer, buffer + sizeof buffer, value);
  text.append(buffer, result.ptr);
}

}  // namespace

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

std::string lower_case(std::string_view text) {
  std::string lower(text);
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return lower;
}

std::string in_quotes(std::string_view text) {
  std::string result = "'";
  for (const char c : text.substr(0, longest_quote)) {
    const auto byte = static_cast<unsigned char>(c);
    result += byte < 0x20 || byte >= 0x7f ? '?' : c;
  }
  if (text.size() > longest_quote) result += "...";
  return result += '\'';
}

void append_xml_attribute(std::string& text, std::string_view name, std::string_view value) {
  text.append(" ").append(name).append("=\"");
  for (const char c : value) {
    switch (c) {
      case '&': text += "&amp;"; break;
      case '<': text += "&lt;"; break;
      case '>': text += "&gt;"; break;
      case '"': text += "&quot;"; break;
      default: text += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
    }
  }
  text += '"';
}

LineReader::LineReader(std::string_view bytes, std::size_t position, std::int64_t first_line)
    : bytes_(bytes), position_(position), number_(first_line - 1) {
  end_ = bytes.find('\n', position) == std::string_view::npos ? '\r' : '\n';
}

bool LineReader::next(TextLine& line) {
  if (position_ >= bytes_.size()) return false;
  const char* begin = bytes_.data() + position_;
  const std::size_t left = bytes_.size() - position_;
  const auto* end = static_cast<const char*>(std::memchr(begin, end_, left));
  std::size_t length = end == nullptr ? left : static_cast<std::size_t>(end - begin);
  position_ += end == nullptr ? length : length + 1;
  if (length > 0 && begin[length - 1] == '\r') --length;
  line = {{begin, length}, ++number_};
  return true;
}

std::string_view WordReader::next() {
  while (at_ != end_ && is_blank(*at_)) ++at_;
  if (at_ != end_ && *at_ == '#') at_ = end_;
  const char* begin = at_;
  while (at_ != end_ && !is_blank(*at_)) ++at_;
  return {begin, static_cast<std::size_t>(at_ - begin)};
}

bool parse_number(std::string_view word, double& value) { return parse_float(word, value); }
bool parse_number(std::string_view word, float& value) { return parse_float(word, value); }

void append_number(std::string& text, double value, int precision) { append_float(text, value, precision); }
void append_number(std::string& text, float value, int precision) { append_float(text, value, precision); }

}  // namespace croquis
