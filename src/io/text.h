// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <charconv>
#include <cstdint>
#include <string>
#include <string_view>
#include <type_traits>

/// What the text formats share: lines, words and numbers, without copies.
namespace croquis {

inline bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f' || c == '\r'; }

std::string_view trimmed(std::string_view text);
std::string lower_case(std::string_view text);

/// A piece of a file as it may stand in a message: shortened, control characters replaced.
std::string in_quotes(std::string_view text);

/// Appends ` name="value"`; characters that XML can't hold become spaces.
void append_xml_attribute(std::string& text, std::string_view name, std::string_view value);

struct TextLine {
  std::string_view text;    ///< without its end
  std::int64_t number = 0;  ///< 1-based
};

/// Walks over lines that end with \n, \r\n or, in files without any \n, with \r.
class LineReader {
 public:
  /// @param first_line number of the line at `position`
  explicit LineReader(std::string_view bytes, std::size_t position = 0, std::int64_t first_line = 1);

  bool next(TextLine& line);
  std::size_t position() const { return position_; }    ///< of the first byte after the last line
  std::int64_t line_number() const { return number_; }  ///< of the last line given

 private:
  std::string_view bytes_;
  std::size_t position_;
  std::int64_t number_;
  char end_;
};

/// The words of one line. A word that begins with '#' ends it.
class WordReader {
 public:
  explicit WordReader(std::string_view text) : at_(text.data()), end_(text.data() + text.size()) {}

  /// An empty word means that there are no more.
  std::string_view next();
  std::string_view rest() const { return trimmed({at_, static_cast<std::size_t>(end_ - at_)}); }

 private:
  const char* at_;
  const char* end_;
};

/// All of the word is a number; "nan" and "inf" count, too large ones become infinite.
bool parse_number(std::string_view word, double& value);
bool parse_number(std::string_view word, float& value);

/// All of the word is an integer that fits; a leading + is allowed.
template <typename Integer>
requires std::is_integral_v<Integer>
bool parse_number(std::string_view word, Integer& value) {
  if (!word.empty() && word.front() == '+') word.remove_prefix(1);
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  return error == std::errc() && end == word.data() + word.size();
}

/// @param precision significant digits, 0 for the shortest text that reads back as the same value
void append_number(std::string& text, double value, int precision = 0);
void append_number(std::string& text, float value, int precision = 0);

template <typename Integer>
requires std::is_integral_v<Integer>
void append_number(std::string& text, Integer value, int = 0) {
  char buffer[24];
  text.append(buffer, std::to_chars(buffer, buffer + sizeof buffer, value).ptr);
}

}  // namespace croquis
