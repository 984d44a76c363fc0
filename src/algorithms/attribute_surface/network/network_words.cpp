// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/attribute_surface/network/network_words.h"

#include "croquis/base/text.h"

namespace croquis {

std::string quoted(const std::string& id) { return '"' + id + '"'; }

std::string rounded_text(double number) { return number_text(number, 4); }

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
