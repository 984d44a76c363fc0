// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/base/parameter_list.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "croquis/base/error.h"

namespace croquis {
namespace {

/// Without what rounding adds to numbers that people wrote.
double degrees_of(double radians) {
  constexpr double parts = 1e9;  // of a degree
  return std::round(radians * 180 / std::numbers::pi * parts) / parts;
}

}  // namespace

ParameterList& ParameterList::add(ParameterDescription description, Set set) {
  descriptions_.push_back(std::move(description));
  sets_.push_back(std::move(set));
  return *this;
}

ParameterList& ParameterList::flag(const std::string& name, bool& value, const std::string& sentence) {
  return add(flag_parameter(name, value, sentence),
             [&value](const ParameterValue& given) { value = std::get<bool>(given); });
}

ParameterList& ParameterList::number(const std::string& name, double& value, double minimum, double maximum,
                                     const ParameterUnit& unit, const std::string& sentence) {
  return add(number_parameter(name, value, minimum, maximum, unit, sentence),
             [&value](const ParameterValue& given) { value = std::get<double>(given); });
}

ParameterList& ParameterList::number(const std::string& name, std::optional<double>& value, double maximum,
                                     const ParameterUnit& unit, const std::string& sentence) {
  return add(number_parameter(name, value.value_or(0), 0, maximum, unit, sentence),
             [&value](const ParameterValue& given) {
               const double number = std::get<double>(given);
               value = number > 0 ? std::optional(number) : std::nullopt;
             });
}

ParameterList& ParameterList::angle(const std::string& name, double& radians, double minimum, double maximum,
                                    const std::string& sentence) {
  return add(number_parameter(name, degrees_of(radians), minimum, maximum, "degrees", sentence),
             [&radians](const ParameterValue& given) { radians = std::get<double>(given) * std::numbers::pi / 180; });
}

ParameterList& ParameterList::choice_of(const std::string& name, std::size_t chosen,
                                        const std::vector<std::string>& words, const std::string& sentence,
                                        std::function<void(std::size_t)> set) {
  ParameterDescription description = choice_parameter(name, words, sentence);
  description.default_value = words[chosen];
  return add(std::move(description), [words, set = std::move(set)](const ParameterValue& given) {
    set(static_cast<std::size_t>(std::ranges::find(words, std::get<std::string>(given)) - words.begin()));
  });
}

ParameterList& ParameterList::choice_of_numbers(const std::string& name, std::size_t& value,
                                                std::initializer_list<std::size_t> numbers,
                                                const std::string& sentence) {
  const std::vector<std::size_t> values = numbers;
  std::vector<std::string> words;
  for (const std::size_t number : values) words.push_back(std::to_string(number));
  const auto chosen = static_cast<std::size_t>(std::ranges::find(values, value) - values.begin());
  return choice_of(name, chosen, words, sentence, [&value, values](std::size_t place) { value = values[place]; });
}

ParameterList& ParameterList::text(const std::string& name, const std::string& value, const std::string& sentence,
                                   Read read) {
  return add(text_parameter(name, value, sentence),
             [read = std::move(read)](const ParameterValue& given) { read(to_text(given)); });
}

ParameterList& ParameterList::list(const std::string& name, const std::string& sentence, Read read) {
  text(name, "", sentence, std::move(read));
  descriptions_.back().repeatable = true;
  return *this;
}

ParameterList& ParameterList::titled(const std::string& title, const std::vector<std::string>& choice_titles) {
  descriptions_.back().title = title;
  descriptions_.back().choice_titles = choice_titles;
  return *this;
}

ParameterList& ParameterList::at(ParameterPlace place) {
  descriptions_.back().place = place;
  return *this;
}

ParameterList& ParameterList::or_else(const std::string& default_title) {
  descriptions_.back().default_title = default_title;
  return *this;
}

ParameterList& ParameterList::or_preset() {
  descriptions_.back().choices.emplace_back("preset");
  return *this;
}

ParameterList& ParameterList::sets_others() {
  first_.push_back(descriptions_.size() - 1);
  return *this;
}

void ParameterList::set(const ParameterValues& values) const {
  for (const std::size_t parameter : first_) set(parameter, values.at(descriptions_[parameter].name));
  Findings findings;
  for (std::size_t parameter = 0; parameter < sets_.size(); ++parameter) {
    if (std::ranges::find(first_, parameter) != first_.end()) continue;
    try {
      set(parameter, values.at(descriptions_[parameter].name));
    } catch (const Error& error) {
      findings.insert(findings.end(), error.findings().begin(), error.findings().end());
    }
  }
  if (!findings.empty()) throw Error(std::move(findings));
}

std::vector<ParameterDescription> ParameterList::with_presets(const After& after) const {
  std::vector<ParameterDescription> described = descriptions_;
  for (const std::size_t parameter : first_) {
    for (const std::string& choice : descriptions_[parameter].choices) {
      for (const ParameterDescription& other : after(parameter, choice)) {
        const ParameterDescription& usual = *find_parameter(descriptions_, other.name);
        if (other.name == descriptions_[parameter].name || other.default_value == usual.default_value) continue;
        described[parameter].presets[choice].emplace(other.name, other.default_value);
      }
    }
  }
  return described;
}

}  // namespace croquis
