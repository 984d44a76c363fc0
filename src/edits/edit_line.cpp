// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/edits/edit_line.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "croquis/base/error.h"
#include "croquis/base/index_list.h"
#include "croquis/base/text.h"

namespace croquis {
namespace {

/// What is wrong with a line, as the end of a sentence.
struct Mistake {
  std::string what;
};

std::string kinds_of(const EditDescription& description) {
  std::string list;
  for (const ComponentKind kind : description.kinds) {
    list += (list.empty() ? "" : " or ") + std::string(plural(kind)) + "=";
  }
  return list;
}

EditTarget parse_target(const EditDescription& description, ComponentKind kind, std::string_view value) {
  if (std::find(description.kinds.begin(), description.kinds.end(), kind) == description.kinds.end()) {
    throw Mistake{"it works on " + kinds_of(description)};
  }
  EditTarget target{kind, value == "all", {}};
  if (target.all) return target;
  for (const std::string_view word : text_parts(value, ",")) {
    if (!append_indices(word, target.elements)) {
      throw Mistake{"'" + std::string(word) + "' is no number of an element, counted from 0, such as 0,3-5"};
    }
  }
  if (target.elements.empty()) throw Mistake{"'" + std::string(plural(kind)) + "=' names no element"};
  return target;
}

void parse_word(const EditDescription& description, std::string_view word, std::optional<EditTarget>& target,
                ParameterValues& parameters) {
  const std::size_t sign = word.find('=');
  if (sign == std::string_view::npos) throw Mistake{"'" + std::string(word) + "' is not written as name=value"};
  const std::string_view name = word.substr(0, sign);
  const std::string_view value = word.substr(sign + 1);
  if (const auto kind = kind_of_plural(name)) {
    if (target) throw Mistake{"its elements are given twice"};
    target = parse_target(description, *kind, value);
    return;
  }
  const ParameterDescription* known = find_parameter(description.parameters, name);
  if (known == nullptr) {
    std::string names;
    for (const ParameterDescription& parameter : description.parameters) names += ", " + parameter.name + "=";
    throw Mistake{"there is no '" + std::string(name) + "': it takes " + kinds_of(description) + names};
  }
  if (!parameters.emplace(known->name, parse_parameter(*known, std::string(value))).second) {
    throw Mistake{"'" + known->name + "' is given twice"};
  }
}

EditLine parse_line(std::string_view text) {
  const std::vector<std::string_view> words = text_parts(text, " \t\r");
  EditLine line;
  line.edit = std::string(words.front());
  const Edit* edit = find_edit(line.edit);
  if (edit == nullptr) {
    std::string ids;
    for (const Edit& known : all_edits()) ids += (ids.empty() ? "" : ", ") + known.description.id;
    throw Mistake{"there is no edit '" + line.edit + "', but " + ids};
  }
  const EditDescription& description = edit->description;
  std::optional<EditTarget> target;
  for (std::size_t i = 1; i < words.size(); ++i) parse_word(description, words[i], target, line.parameters);
  if (!target) throw Mistake{"say with " + kinds_of(description) + " what is to be edited"};
  line.target = std::move(*target);
  return line;
}

Finding refused_line(std::string_view text, const std::string& what) {
  return make_error(Category::Usage, "E_EDIT", "'" + std::string(text) + "': " + what + ".",
                    {{SubjectKind::Parameter, std::string(text), {}, {}, {}}});
}

/// "not a number." becomes a part of a sentence.
std::string without_stop(std::string text) {
  if (text.ends_with('.')) text.pop_back();
  return text;
}

}  // namespace

std::vector<EditLine> parse_edit_lines(std::string_view text) {
  std::vector<EditLine> lines;
  Findings findings;
  for (std::string_view line : text_parts(text, ";\n")) {
    const std::size_t begin = line.find_first_not_of(" \t\r");
    if (begin == std::string_view::npos || line[begin] == '#') continue;
    line = line.substr(begin, line.find_last_not_of(" \t\r") + 1 - begin);
    try {
      lines.push_back(parse_line(line));
    } catch (const Mistake& mistake) {
      findings.push_back(refused_line(line, mistake.what));
    } catch (const Error& error) {
      findings.push_back(refused_line(line, without_stop(error.findings().front().message)));
    }
  }
  if (!findings.empty()) throw Error(std::move(findings));
  return lines;
}

std::string to_text(const EditLine& line) {
  std::string text = line.edit + ' ' + std::string(plural(line.target.kind)) + '=';
  text += line.target.all ? "all" : index_list_text(line.target.elements, ',');
  for (const auto& [name, value] : line.parameters) text += ' ' + name + '=' + to_text(value);
  return text;
}

std::string to_text(const std::vector<EditLine>& lines) {
  std::string text;
  for (const EditLine& line : lines) text += (text.empty() ? "" : "; ") + to_text(line);
  return text;
}

std::string counted_elements(ComponentKind kind, std::size_t count) {
  return std::to_string(count) + ' ' + (count == 1 ? singular(kind) : plural(kind));
}

std::string label_of(const EditLine& line, const std::string& whole) {
  const Edit* edit = find_edit(line.edit);
  const std::string title = edit == nullptr ? line.edit : edit->description.title;
  Elements elements = line.target.elements;
  std::sort(elements.begin(), elements.end());
  elements.erase(std::unique(elements.begin(), elements.end()), elements.end());
  return title + ' ' + (line.target.all ? whole : counted_elements(line.target.kind, elements.size()));
}

}  // namespace croquis
