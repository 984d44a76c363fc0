// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/attribute_surface/network/network_words.h"

#include <array>
#include <charconv>

namespace croquis {

std::string quoted(const std::string& id) { return '"' + id + '"'; }

std::string rounded_text(double number) {
  std::array<char, 32> text{};
  const auto written = std::to_chars(text.data(), text.data() + text.size(), number, std::chars_format::general, 4);
  return {text.data(), written.ptr};
}

std::string length_text(const AttributeNetwork& network, double length) {
  return rounded_text(length) + (network.units.empty() ? "" : " " + network.units);
}

Subject subject_of(SubjectKind kind, const std::string& id) {
  Subject subject;
  subject.kind = kind;
  subject.id = id;
  return subject;
}

}  // namespace croquis
