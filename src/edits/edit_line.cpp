// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/edits/edit_line.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "croquis/base/error.h"
#include "croquis/base/index_list.h"

namespace croquis {
namespace {

constexpr std::array<std::pair<std::string_view, ComponentKind>, 3> kind_words{
    {{"vertices", ComponentKind::Vertex}, {"edges", ComponentKind::Edge}, {"faces", ComponentKind::Face}}};

std::string_view word_of(ComponentKind kind) {
  return std::find_if(kind_words.begin(), kind_words.end(), [&](const auto& word) { return word.second == kind; })
      ->first;
}

/// The parts of a text between separators, without empty ones.
std::vector<std::string_view> parts_of(std::string_view text, std::string_view separators) {
  std::vector<std::string_view> parts;
  for (std::size_t at = text.find_first_not_of(separators); at != std::string_view::npos;) {
    const std::size_t end = std::min(text.find_first_of(separators, at), text.size());
    parts.push_back(text.substr(at, end - at));
    at = text.find_first_not_of(separators, end);
  }
  return parts;
}

/// What is wrong with a line, as the end of a sentence.
struct Mistake {
  std::string what;
};

std::string kinds_of(const EditDescription& description) {
  std::string list;
  for (const ComponentKind kind : description.kinds) {
    list += (list.empty() ? "" : " or ") + std::string(word_of(kind)) + "=";
  }
  return list;
}

EditTarget parse_target(const EditDescription& description, ComponentKind kind, std::string_view value) {
  if (std::find(description.kinds.begin(), description.kinds.end(), kind) == description.kinds.end()) {
    throw Mistake{"it works on " + kinds_of(description)};
  }
  EditTarget target{kind, value == "all", {}};
  if (target.all) return target;
  for (const std::string_view word : parts_of(value, ",")) {
    if (!append_indices(word, target.elements)) {
      throw Mistake{"'" + std::string(word) + "' is no number of an element, counted from 0, such as 0,3-5"};
    }
  }
  if (target.elements.empty()) throw Mistake{"'" + std::string(word_of(kind)) + "=' names no element"};
  return target;
}

void parse_word(const EditDescription& description, std::string_view word, std::optional<EditTarget>& target,
                ParameterValues& parameters) {
  const std::size_t sign = word.find('=');
  if (sign == std::string_view::npos) throw Mistake{"'" + std::string(word) + "' is not written as name=value"};
  const std::string_view name = word.substr(0, sign);
  const std::string_view value = word.substr(sign + 1);
  for (const auto& [text, kind] : kind_words) {
    if (name != text) continue;
    if (target) throw Mistake{"its elements are given twice"};
    target = parse_target(description, kind, value);
    return;
  }
  const auto known = std::find_if(description.parameters.begin(), description.parameters.end(),
                                  [&](const ParameterDescription& parameter) { return parameter.name == name; });
  if (known == description.parameters.end()) {
    std::string names;
    for (const ParameterDescription& parameter : description.parameters) names += ", " + parameter.name + "=";
    throw Mistake{"there is no '" + std::string(name) + "': it takes " + kinds_of(description) + names};
  }
  if (!parameters.emplace(known->name, parse_parameter(*known, std::string(value))).second) {
    throw Mistake{"'" + known->name + "' is given twice"};
  }
}

EditLine parse_line(std::string_view text, const EditRegistry& registry) {
  const std::vector<std::string_view> words = parts_of(text, " \t\r");
  EditLine line;
  line.edit = std::string(words.front());
  const Edit* edit = registry.find(line.edit);
  if (edit == nullptr) {
    std::string ids;
    for (const auto& known : registry.edits()) ids += (ids.empty() ? "" : ", ") + known->describe().id;
    throw Mistake{"there is no edit '" + line.edit + "', but " + ids};
  }
  const EditDescription description = edit->describe();
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

std::vector<EditLine> parse_edit_lines(std::string_view text, const EditRegistry& registry) {
  std::vector<EditLine> lines;
  Findings findings;
  for (std::string_view line : parts_of(text, ";\n")) {
    const std::size_t begin = line.find_first_not_of(" \t\r");
    if (begin == std::string_view::npos || line[begin] == '#') continue;
    line = line.substr(begin, line.find_last_not_of(" \t\r") + 1 - begin);
    try {
      lines.push_back(parse_line(line, registry));
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
  std::string text = line.edit + ' ' + std::string(word_of(line.target.kind)) + '=';
  text += line.target.all ? "all" : index_list_text(line.target.elements, ',');
  for (const auto& [name, value] : line.parameters) text += ' ' + name + '=' + to_text(value);
  return text;
}

}  // namespace croquis
