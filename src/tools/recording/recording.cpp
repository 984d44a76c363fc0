// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/tools/recording/recording.h"

#include <algorithm>
#include <utility>

#include "croquis/base/error.h"

namespace croquis::recorded {
namespace {

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
  FieldWriter writer;
  const StepKind& kind = step.kind();
  if (kind.verbs.size() == 1) writer.verb(kind.verbs.front());
  kind.write(step, writer);
  return writer.line();
}

}  // namespace croquis::recorded
