// SPDX-License-Identifier: GPL-3.0-or-later
#include <limits>

#include "io/svg/svg_shapes.h"
#include "io/text.h"

namespace croquis {
namespace {

bool is_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

}  // namespace

void SvgScanner::skip_blanks() {
  while (position_ < text_.size() && is_space(text_[position_])) ++position_;
}

void SvgScanner::skip_separators() {
  skip_blanks();
  if (peek() != ',') return;
  ++position_;
  skip_blanks();
}

std::size_t SvgScanner::skip_digits(std::size_t from) const {
  while (from < text_.size() && is_digit(text_[from])) ++from;
  return from;
}

std::size_t SvgScanner::end_of_number() const {
  std::size_t at = position_;
  if (at < text_.size() && (text_[at] == '+' || text_[at] == '-')) ++at;
  const std::size_t whole = skip_digits(at);
  std::size_t end = whole;
  std::size_t digits = whole - at;
  if (whole < text_.size() && text_[whole] == '.') {
    end = skip_digits(whole + 1);
    digits += end - whole - 1;
  }
  if (digits == 0) return position_;
  if (end < text_.size() && (text_[end] == 'e' || text_[end] == 'E')) {
    std::size_t exponent = end + 1;
    if (exponent < text_.size() && (text_[exponent] == '+' || text_[exponent] == '-')) ++exponent;
    const std::size_t last = skip_digits(exponent);
    if (last > exponent) end = last;  // else the e begins a unit
  }
  return end;
}

std::optional<double> SvgScanner::number_word() {
  std::size_t at = position_;
  if (at < text_.size() && (text_[at] == '+' || text_[at] == '-')) ++at;
  for (const std::string_view name : {"infinity", "inf", "nan"}) {
    if (lower_case(text_.substr(at, name.size())) != name) continue;
    position_ = at + name.size();
    return std::numeric_limits<double>::quiet_NaN();
  }
  return std::nullopt;
}

std::optional<double> SvgScanner::number() {
  const std::size_t end = end_of_number();
  if (end == position_) return number_word();
  const std::string_view number = text_.substr(position_, end - position_);
  position_ = end;
  double value = 0;
  parse_number(number, value);
  return value;
}

std::optional<bool> SvgScanner::flag() {
  if (peek() != '0' && peek() != '1') return std::nullopt;
  return take() == '1';
}

std::string_view SvgScanner::word() {
  const std::size_t begin = position_;
  while (position_ < text_.size() && is_letter(text_[position_])) ++position_;
  return text_.substr(begin, position_ - begin);
}

}  // namespace croquis
