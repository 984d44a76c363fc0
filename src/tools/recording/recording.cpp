// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/tools/recording/recording.h"

#include <algorithm>

#include "croquis/base/error.h"
#include "croquis/tools/recording/vocabulary.h"

namespace croquis::recorded {
namespace {

bool has_verb(const StepKind& kind, const std::string& verb) {
  return std::find(kind.verbs.begin(), kind.verbs.end(), verb) != kind.verbs.end();
}

Finding finding_of(const Mistake& mistake, const std::string& file, std::int64_t line) {
  return make_error(Category::Malformed, "E_REPLAY",
                    "Line " + std::to_string(line) + " of the recording can't be replayed: " + mistake.sentence + '.',
                    {{SubjectKind::Line, std::to_string(line), file, line, {}}});
}

Step read_line(std::string_view line, const Vocabulary& vocabulary) {
  Fields fields(line, vocabulary);
  Step step = vocabulary.kind_of(fields).read(fields);
  fields.refuse_unknown();
  return step;
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
  std::string verb;
  fields.required("do", verb);
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

std::vector<Line> parse(std::string_view text, const std::string& name, const Vocabulary& vocabulary) {
  std::vector<Line> lines;
  Findings findings;
  std::int64_t number = 0;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    ++number;
    const std::size_t first = line.find_first_not_of(" \t\r");
    if (first == std::string_view::npos || line[first] == '#') continue;
    try {
      lines.push_back({read_line(line, vocabulary), number});
    } catch (const Mistake& mistake) {
      findings.push_back(finding_of(mistake, name, number));
    }
  }
  if (!findings.empty()) throw Error(std::move(findings));
  return lines;
}

std::string to_line(const Step& step) {
  Fields fields;
  const StepKind& kind = step.kind();
  std::string verb = kind.verbs.front();
  if (kind.verbs.size() == 1) fields.required("do", verb);
  kind.write(step, fields);
  return fields.line();
}

}  // namespace croquis::recorded
