// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/text_mutation.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string_view>
#include <vector>

#include "croquis/base/text.h"

namespace croquis::test {
namespace {

/// A part of a text.
struct Span {
  std::size_t begin = 0, end = 0;

  std::string of(const std::string& text) const { return text.substr(begin, end - begin); }
};

using Spans = std::vector<Span>;

bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

Spans numbers_of(const std::string& text) {
  Spans numbers;
  for (std::size_t at = 0; at < text.size();) {
    double value = 0;
    const bool begins = is_digit(text[at]) || ((text[at] == '-' || text[at] == '.') && at + 1 < text.size() &&
                                               (is_digit(text[at + 1]) || text[at + 1] == '.'));
    const char* from = text.data() + at;
    const char* end = begins ? std::from_chars(from, text.data() + text.size(), value).ptr : from;
    if (end == from) {
      ++at;
      continue;
    }
    const std::size_t length = static_cast<std::size_t>(end - from);
    numbers.push_back({at, at + length});
    at += length;
  }
  return numbers;
}

Spans lines_of(const std::string& text) {
  Spans lines;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size() - 1) + 1;
    lines.push_back({begin, end});
    begin = end;
  }
  return lines;
}

/// Members and elements at every level, without the commas between them.
Spans json_elements(const std::string& text) {
  Spans elements;
  std::vector<std::size_t> begins;
  bool quoted = false;
  for (std::size_t at = 0; at < text.size(); ++at) {
    const char c = text[at];
    if (c == '"' && (at == 0 || text[at - 1] != '\\')) quoted = !quoted;
    if (quoted) continue;
    const bool ends = c == ',' || c == ']' || c == '}';
    if (ends && !begins.empty()) {
      if (begins.back() < at) elements.push_back({begins.back(), at});
      c == ',' ? void(begins.back() = at + 1) : begins.pop_back();
    }
    if (c == '[' || c == '{') begins.push_back(at + 1);
  }
  return elements;
}

/// Elements with their contents, the outermost left out.
Spans xml_elements(const std::string& text) {
  Spans elements;
  std::vector<std::size_t> open;
  for (std::size_t at = text.find('<'); at != std::string::npos; at = text.find('<', at + 1)) {
    const std::size_t end = text.find('>', at);
    if (end == std::string::npos) break;
    const bool closes = text.compare(at, 2, "</") == 0;
    const bool alone = text[end - 1] == '/';
    if (text[at + 1] == '?' || text[at + 1] == '!') continue;
    if (!closes && !alone) open.push_back(at);
    if (alone && !open.empty()) elements.push_back({at, end + 1});
    if (closes && open.size() > 1) elements.push_back({open.back(), end + 1});
    if (closes && !open.empty()) open.pop_back();
  }
  return elements;
}

/// ` name="value"`.
Spans xml_attributes(const std::string& text) {
  Spans attributes;
  for (std::size_t sign = text.find("=\""); sign != std::string::npos; sign = text.find("=\"", sign + 1)) {
    const std::size_t begin = text.find_last_of(" \n\t", sign), end = text.find('"', sign + 2);
    if (begin != std::string::npos && end != std::string::npos) attributes.push_back({begin, end + 1});
  }
  return attributes;
}

Spans elements_of(const std::string& text, TextSyntax syntax, Random& random) {
  if (syntax == TextSyntax::Lines) return lines_of(text);
  if (syntax == TextSyntax::Json) return json_elements(text);
  return random.below(4) == 0 ? xml_attributes(text) : xml_elements(text);
}

/// What stands between quotes, or between blanks.
Spans words_of(const std::string& text, TextSyntax syntax) {
  const std::string_view separators = syntax == TextSyntax::Lines ? " \n=," : "\"";
  Spans words;
  for (const std::string_view word : text_parts(text, separators)) {
    const auto begin = static_cast<std::size_t>(word.data() - text.data());
    const bool quoted = begin > 0 && text[begin - 1] == '"';
    if (syntax == TextSyntax::Lines || (quoted && word.size() < 40)) words.push_back({begin, begin + word.size()});
  }
  return words;
}

const Span& one_of(const Spans& spans, Random& random) {
  return spans[random.below(static_cast<std::uint32_t>(spans.size()))];
}

void change_element(std::string& text, TextSyntax syntax, Random& random) {
  const Spans elements = elements_of(text, syntax, random);
  if (elements.empty()) return;
  Span element = one_of(elements, random);
  const std::string old = element.of(text);
  const std::string comma = syntax == TextSyntax::Json ? "," : "";
  const std::uint32_t kind = random.below(3);
  if (kind == 0) {
    const bool followed = element.end < text.size() && text[element.end] == ',';
    if (syntax == TextSyntax::Json && followed) ++element.end;
    if (syntax == TextSyntax::Json && !followed && element.begin > 0 && text[element.begin - 1] == ',') --element.begin;
    text.erase(element.begin, element.end - element.begin);
  } else if (kind == 1) {
    text.insert(element.end, comma + old);
  } else {
    Span other = one_of(elements, random);
    if (other.begin < element.begin) std::swap(other, element);
    if (other.begin < element.end) return;  // the same one, or one within the other
    const std::string first = element.of(text), second = other.of(text);
    text.replace(other.begin, second.size(), first);
    text.replace(element.begin, first.size(), second);
  }
}

/// Nearby, at a distance from rounding to the number's own size; whole numbers stay whole most of the time.
std::string moved_number(const std::string& old, Random& random) {
  double value = 0;
  std::from_chars(old.data(), old.data() + old.size(), value);
  const bool whole = old.find('.') == std::string::npos;
  if (random.below(8) < (whole ? 7 : 1)) return number_text(std::round(value) + (random.below(2) == 0 ? 1 : -1));
  const double size = std::pow(10, -static_cast<double>(random.below(16)));
  return number_text(value + size * random.between(-1, 1) * (value == 0 ? 1 : value));
}

void change_number(std::string& text, Random& random) {
  const Spans numbers = numbers_of(text);
  if (numbers.empty()) return;
  const Span number = one_of(numbers, random);
  const std::uint32_t kind = random.below(6);
  const std::string instead = kind == 0  ? number_text(extreme_number(random))
                              : kind < 3 ? one_of(numbers, random).of(text)
                                         : moved_number(number.of(text), random);
  text.replace(number.begin, number.end - number.begin, instead);
}

void change_word(std::string& text, TextSyntax syntax, Random& random) {
  const Spans words = words_of(text, syntax);
  if (words.empty()) return;
  const Span word = one_of(words, random);
  const std::string instead = one_of(words, random).of(text);
  text.replace(word.begin, word.end - word.begin, instead);
}

void cut(std::string& text, Random& random) {
  if (text.empty()) return;
  const std::size_t at = random.below(static_cast<std::uint32_t>(text.size()));
  random.below(4) == 0 ? text.erase(at) : text.erase(at, 1 + random.below(12));
}

/// All numbers with a point, as if the model had another unit.
void scale(std::string& text, Random& random) {
  const double factor = std::pow(10, std::round(random.between(-32, 32)));
  const Spans numbers = numbers_of(text);
  for (auto number = numbers.rbegin(); number != numbers.rend(); ++number) {
    const std::string old = number->of(text);
    double value = 0;
    std::from_chars(old.data(), old.data() + old.size(), value);
    if (old.find('.') != std::string::npos) text.replace(number->begin, old.size(), number_text(value * factor));
  }
}

}  // namespace

double extreme_number(Random& random) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  constexpr std::array numbers = {0.0,          -0.0,         1.0,
                                  -1.0,         0.5,          1e-5,
                                  1e-12,        1e-30,        1e-160,
                                  5e-324,       1e3,          1e7,
                                  1e12,         1e16,         1e20,
                                  1e30,         -1e30,        1.0000001e30,
                                  1e31,         1e75,         1e100,
                                  1e154,        1e308,        -1e308,
                                  4294967295.0, 2147483648.0, 9223372036854775808.0,
                                  infinity,     -infinity,    std::numeric_limits<double>::quiet_NaN()};
  return numbers[random.below(static_cast<std::uint32_t>(numbers.size()))];
}

std::string mutated_text(std::string text, TextSyntax syntax, Random& random) {
  for (std::uint32_t changes = 1 + random.below(3); changes > 0; --changes) {
    const std::uint32_t kind = random.below(40);
    if (kind < 22) {
      change_number(text, random);
    } else if (kind < 34) {
      change_element(text, syntax, random);
    } else if (kind < 38) {
      change_word(text, syntax, random);
    } else if (kind < 39) {
      cut(text, random);
    } else {
      scale(text, random);
    }
  }
  return text;
}

}  // namespace croquis::test
