// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/tools/recording/vocabulary.h"

#include <algorithm>

#include "croquis/base/error.h"

namespace croquis::recorded {
namespace {

bool has_verb(const StepKind& kind, const std::string& verb) {
  return std::find(kind.verbs.begin(), kind.verbs.end(), verb) != kind.verbs.end();
}

}  // namespace

void Vocabulary::add(const StepKind& kind) {
  for (const StepKind* known : kinds_) {
    for (const std::string& verb : kind.verbs) {
      if (known->mark != kind.mark || !has_verb(*known, verb)) continue;
      throw Error(make_error(Category::Internal, "E_INTERNAL", "Two recorded steps are called '" + verb + "'."));
    }
  }
  kinds_.push_back(&kind);
}

void Vocabulary::add(const Vocabulary& other) {
  for (const StepKind* kind : other.kinds_) add(*kind);
  counts_.insert(counts_.end(), other.counts_.begin(), other.counts_.end());
  ranges_.insert(ranges_.end(), other.ranges_.begin(), other.ranges_.end());
}

const StepKind& Vocabulary::kind_of(Fields& fields) const {
  const std::string verb = fields.verb();
  const StepKind* unmarked = nullptr;
  std::string marks;
  for (const StepKind* kind : kinds_) {
    if (!has_verb(*kind, verb)) continue;
    if (kind->mark.empty()) {
      unmarked = kind;
    } else if (fields.has(kind->mark)) {
      return *kind;
    } else {
      marks += (marks.empty() ? "\"" : " or \"") + kind->mark + '"';
    }
  }
  if (unmarked != nullptr) return *unmarked;
  throw Mistake{marks.empty() ? "there is no step \"" + verb + '"' : marks + " is missing"};
}

}  // namespace croquis::recorded
