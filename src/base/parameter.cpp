// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/base/parameter.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "croquis/base/error.h"
#include "croquis/base/text.h"

namespace croquis {
namespace {

std::string range_text(const ParameterDescription& description) {
  const bool low = std::isfinite(description.minimum);
  const bool high = std::isfinite(description.maximum);
  if (low && high) return " from " + number_text(description.minimum) + " to " + number_text(description.maximum);
  if (low) return " of at least " + number_text(description.minimum);
  if (high) return " of at most " + number_text(description.maximum);
  return "";
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

Finding refusal(const ParameterDescription& description, const std::string& given) {
  return make_error(Category::Usage, "E_PARAMETER",
                    "'" + given + "' is no value for " + description.name + ": it takes " + accepted(description) + ".",
                    {{SubjectKind::Parameter, description.name, {}, {}, {}}});
}

bool in_range(const ParameterDescription& description, double value) {
  return std::isfinite(value) && value >= description.minimum && value <= description.maximum;
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

const ParameterDescription* find_parameter(std::span<const ParameterDescription> descriptions, std::string_view name) {
  const auto found = std::ranges::find(descriptions, name, &ParameterDescription::name);
  return found == descriptions.end() ? nullptr : &*found;
}

ParameterValues complete(const std::vector<ParameterDescription>& descriptions, ParameterValues values) {
  Findings findings;
  for (const auto& [name, value] : values) {
    const ParameterDescription* known = find_parameter(descriptions, name);
    if (known == nullptr) {
      findings.push_back(make_error(Category::Usage, "E_PARAMETER", "There is no parameter '" + name + "'.",
                                    {{SubjectKind::Parameter, name, {}, {}, {}}}));
    } else if (!acceptable(*known, value)) {
      findings.push_back(refusal(*known, to_text(value)));
    }
  }
  if (!findings.empty()) throw Error(std::move(findings));
  for (const ParameterDescription& description : descriptions) {
    values.try_emplace(description.name, description.default_value);
  }
  return values;
}

bool flag_of(const ParameterValues& values, const std::string& name) { return std::get<bool>(values.at(name)); }

std::int64_t integer_of(const ParameterValues& values, const std::string& name) {
  return std::get<std::int64_t>(values.at(name));
}

double number_of(const ParameterValues& values, const std::string& name) { return std::get<double>(values.at(name)); }

const std::string& text_of(const ParameterValues& values, const std::string& name) {
  const ParameterValue& value = values.at(name);
  const auto* parsed = std::get_if<ParsedText>(&value);
  return parsed == nullptr ? std::get<std::string>(value) : parsed->text();
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
  if (!acceptable(description, value)) throw Error(refusal(description, text));
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
