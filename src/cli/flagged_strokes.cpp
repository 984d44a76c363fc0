// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/flagged_strokes.h"

#include <set>
#include <string>
#include <utility>
#include <variant>

namespace croquis::cli {

void flag_strokes(const Findings& findings, Report& details) {
  constexpr const char* list = "strokes";
  const Report* strokes = details.find(list);
  const auto* uses = strokes != nullptr ? std::get_if<Report::Object>(&strokes->value()) : nullptr;
  if (uses == nullptr) return;
  std::set<std::string> named;
  for (const Finding& finding : findings) {
    for (const Subject& subject : finding.subjects) {
      if (subject.kind == SubjectKind::Stroke) named.insert(subject.id);
    }
  }
  Report::Object flagged = *uses;
  for (auto& [id, use] : flagged) {
    if (named.contains(id)) use = "flagged";
  }
  details.set(list, Report::of_members(std::move(flagged)));
}

}  // namespace croquis::cli
