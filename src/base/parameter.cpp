// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/base/parameter.h"

#include <algorithm>
#include <cctype>
#include <utility>

#include "croquis/base/error.h"
#include "croquis/base/limits.h"
#include "croquis/base/text.h"

namespace croquis {
namespace {

std::string range_text(const ParameterDescription& description) {
  const bool low = is_usable_number(description.minimum);
  const bool high = is_usable_number(description.maximum);
  if (low && high) return " from " + number_text(description.minimum) + " to " + number_text(description.maximum);
  const std::string limit = description.type == ParameterType::Number ? ", at most 1e30 in size" : "";
  if (low) return " of at least " + number_text(description.minimum) + limit;
  if (high) return " of at most " + number_text(description.maximum) + limit;
  return limit;
}

std::string accepted(const ParameterDescription& description) {
  switch (description.type) {
    case ParameterType::Flag: return "true or false";
    case ParameterType::Integer: return "a whole number" + range_text(description);
    case ParameterType::Number: return "a number" + range_text(description);
    case ParameterType::Text: return "a text";
    case ParameterType::File: return "a file name";
    case ParameterType::Choice: break;
  }
  std::string list = "one of ";
  for (std::size_t i = 0; i < description.choices.size(); ++i) {
    if (i > 0) list += i + 1 == description.choices.size() ? " or " : ", ";
    list += description.choices[i];
  }
  return list;
}

bool in_range(const ParameterDescription& description, double value) {
  return is_usable_number(value) && value >= description.minimum && value <= description.maximum;
}

bool acceptable(const ParameterDescription& description, const ParameterValue& value) {
  switch (description.type) {
    case ParameterType::Flag: return std::holds_alternative<bool>(value);
    case ParameterType::Integer:
      return std::holds_alternative<std::int64_t>(value) &&
             in_range(description, static_cast<double>(std::get<std::int64_t>(value)));
    case ParameterType::Number:
      return std::holds_alternative<double>(value) && in_range(description, std::get<double>(value));
    case ParameterType::Choice:
      return std::holds_alternative<std::string>(value) &&
             std::find(description.choices.begin(), description.choices.end(), std::get<std::string>(value)) !=
                 description.choices.end();
    case ParameterType::Text:
      return std::holds_alternative<std::string>(value) || std::holds_alternative<ParsedText>(value);
    case ParameterType::File: return std::holds_alternative<std::string>(value);
  }
  return false;
}

/// The text of a value, or null for one that is none.
const std::string* text_in(const ParameterValue& value) {
  const auto* parsed = std::get_if<ParsedText>(&value);
  return parsed == nullptr ? std::get_if<std::string>(&value) : &parsed->text();
}

}  // namespace

const char* to_string(ParameterType type) {
  switch (type) {
    case ParameterType::Flag: return "flag";
    case ParameterType::Integer: return "integer";
    case ParameterType::Number: return "number";
    case ParameterType::Choice: return "choice";
    case ParameterType::Text: return "text";
    case ParameterType::File: return "file";
  }
  return "text";
}

std::string title_of(const ParameterDescription& description) {
  if (!description.title.empty()) return description.title;
  std::string title = description.name;
  std::ranges::replace(title, '-', ' ');
  if (!title.empty()) title[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(title[0])));
  return title;
}

std::string title_with(const ParameterDescription& description, const ParameterValue& value) {
  const std::string title = title_of(description);
  if (description.type == ParameterType::Text || description.type == ParameterType::File) return title;
  if (!is_given(description, value)) return title;
  if (const auto* flag = std::get_if<bool>(&value)) return title + (*flag ? " on" : " off");
  if (description.type != ParameterType::Choice) return title + ' ' + to_text(value);
  const auto chosen = std::ranges::find(description.choices, to_text(value));
  const auto place = static_cast<std::size_t>(chosen - description.choices.begin());
  return title + ' ' + (place < description.choice_titles.size() ? description.choice_titles[place] : to_text(value));
}

ParameterDescription flag_parameter(const std::string& name, bool value, const std::string& sentence) {
  return {name, ParameterType::Flag, value, 0, 0, {}, "", sentence};
}

ParameterDescription integer_parameter(const std::string& name, std::int64_t value, double minimum, double maximum,
                                       const std::string& unit, const std::string& sentence) {
  return {name, ParameterType::Integer, value, minimum, maximum, {}, unit, sentence};
}

ParameterDescription number_parameter(const std::string& name, double value, double minimum, double maximum,
                                      const ParameterUnit& unit, const std::string& sentence) {
  ParameterDescription made{name, ParameterType::Number, value, minimum, maximum, {}, unit.words, sentence};
  made.length = unit.length;
  made.share = unit.share;
  return made;
}

ParameterDescription choice_parameter(const std::string& name, const std::vector<std::string>& choices,
                                      const std::string& sentence) {
  return {name, ParameterType::Choice, choices.front(), 0, 0, choices, "", sentence};
}

ParameterDescription text_parameter(const std::string& name, const std::string& value, const std::string& sentence) {
  return {name, ParameterType::Text, value, 0, 0, {}, "", sentence};
}

ParameterDescription file_parameter(const std::string& name, const std::string& sentence) {
  return {name, ParameterType::File, std::string(), 0, 0, {}, "", sentence};
}

ParameterDescription list_parameter(const std::string& name, const std::string& sentence) {
  return {name, ParameterType::Text, std::string(), 0, 0, {}, "", sentence, true};
}

Finding refused_value(const std::string& name, std::string_view value, const std::string& accepted) {
  return make_error(Category::Usage, "E_PARAMETER",
                    "'" + std::string(value) + "' is no value for " + name + ": it takes " + accepted + ".",
                    {{SubjectKind::Parameter, name, {}, {}, {}}});
}

const ParameterDescription* find_parameter(std::span<const ParameterDescription> descriptions, std::string_view name) {
  const auto found = std::ranges::find(descriptions, name, &ParameterDescription::name);
  return found == descriptions.end() ? nullptr : &*found;
}

bool is_given(const ParameterDescription& description, const ParameterValue& value) {
  const std::string* text = text_in(value);
  if (text == nullptr) return true;
  if (description.type == ParameterType::Choice) return *text != "preset" && !text->empty();
  const std::string* usual = text_in(description.default_value);
  return !text->empty() || (usual != nullptr && !usual->empty());
}

ParameterValues with_defaults(const std::vector<ParameterDescription>& descriptions, ParameterValues given) {
  std::erase_if(given, [&](const auto& entry) {
    const ParameterDescription* known = find_parameter(descriptions, entry.first);
    return known != nullptr && !is_given(*known, entry.second);
  });
  for (const ParameterDescription& description : descriptions) {
    if (description.presets.empty()) continue;
    const auto chosen = given.try_emplace(description.name, description.default_value).first;
    const auto* name = std::get_if<std::string>(&chosen->second);
    const auto preset = name == nullptr ? description.presets.end() : description.presets.find(*name);
    if (preset != description.presets.end()) given.insert(preset->second.begin(), preset->second.end());
  }
  for (const ParameterDescription& description : descriptions) {
    given.try_emplace(description.name, description.default_value);
  }
  return given;
}

ParameterValues complete(const std::vector<ParameterDescription>& descriptions, ParameterValues values) {
  Findings findings;
  for (const auto& [name, value] : values) {
    const ParameterDescription* known = find_parameter(descriptions, name);
    if (known == nullptr) {
      findings.push_back(make_error(Category::Usage, "E_PARAMETER", "There is no parameter '" + name + "'.",
                                    {{SubjectKind::Parameter, name, {}, {}, {}}}));
    } else if (!acceptable(*known, value)) {
      findings.push_back(refused_value(known->name, to_text(value), accepted(*known)));
    }
  }
  if (!findings.empty()) throw Error(std::move(findings));
  return with_defaults(descriptions, std::move(values));
}

bool flag_of(const ParameterValues& values, const std::string& name) { return std::get<bool>(values.at(name)); }

std::int64_t integer_of(const ParameterValues& values, const std::string& name) {
  return std::get<std::int64_t>(values.at(name));
}

double number_of(const ParameterValues& values, const std::string& name) { return std::get<double>(values.at(name)); }

const std::string& text_of(const ParameterValues& values, const std::string& name) {
  const ParameterValue& value = values.at(name);
  const std::string* text = text_in(value);
  return text == nullptr ? std::get<std::string>(value) : *text;
}

ParameterValue parse_parameter(const ParameterDescription& description, const std::string& text) {
  ParameterValue value = text;
  if (description.type == ParameterType::Flag && (text == "true" || text == "false")) {
    value = text == "true";
  } else if (description.type == ParameterType::Integer) {
    std::int64_t integer = 0;
    if (read_number(text, integer)) value = integer;
  } else if (description.type == ParameterType::Number) {
    double number = 0;
    if (read_number(text, number)) value = number;
  }
  if (!acceptable(description, value)) throw Error(refused_value(description.name, text, accepted(description)));
  return value;
}

std::string to_text(const ParameterValue& value) {
  if (const auto* flag = std::get_if<bool>(&value)) return *flag ? "true" : "false";
  if (const auto* integer = std::get_if<std::int64_t>(&value)) return std::to_string(*integer);
  if (const auto* number = std::get_if<double>(&value)) return number_text(*number);
  if (const auto* parsed = std::get_if<ParsedText>(&value)) return parsed->text();
  return std::get<std::string>(value);
}

}  // namespace croquis
