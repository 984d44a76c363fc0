// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <concepts>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "croquis/base/parameter.h"

namespace croquis {

/// The parameters of settings, each with the member that it sets, listed by one function beside what they are for:
///
///     void list_parameters(Settings& settings, ParameterList& list) {
///       list.number("min-gap", settings.depth.minimum_gap, 0.01, 1, "× radius", "Least distance between parts.")
///           .titled("Gap between parts");
///     }
///
/// Descriptions and what presets give are made from it (parameters_of), and given values are read by it (settings_of):
/// nothing else names a parameter. Defaults are what the members hold.
class ParameterList {
 public:
  /// Sets the members that belong to a value. @throws Error (E_PARAMETER) for a text that can't be read
  using Set = std::function<void(const ParameterValue&)>;

  ParameterList& add(ParameterDescription description, Set set);

  ParameterList& flag(const std::string& name, bool& value, const std::string& sentence);
  ParameterList& number(const std::string& name, double& value, double minimum, double maximum,
                        const ParameterUnit& unit, const std::string& sentence);
  /// 0 leaves the value absent.
  ParameterList& number(const std::string& name, std::optional<double>& value, double maximum,
                        const ParameterUnit& unit, const std::string& sentence);
  /// People give degrees.
  ParameterList& angle(const std::string& name, double& radians, double minimum, double maximum,
                       const std::string& sentence);

  template <std::integral Integer>
  ParameterList& integer(const std::string& name, Integer& value, double minimum, double maximum,
                         const std::string& unit, const std::string& sentence) {
    return add(integer_parameter(name, static_cast<std::int64_t>(value), minimum, maximum, unit, sentence),
               [&value](const ParameterValue& given) { value = static_cast<Integer>(std::get<std::int64_t>(given)); });
  }

  /// @param words for the values 0, 1 … of an enumeration or a bool
  template <typename Enum>
  ParameterList& choice(const std::string& name, Enum& value, const std::vector<std::string>& words,
                        const std::string& sentence) {
    return choice_of(name, static_cast<std::size_t>(value), words, sentence,
                     [&value](std::size_t chosen) { value = static_cast<Enum>(chosen); });
  }
  /// The first word leaves the value absent.
  template <typename Enum>
  ParameterList& choice(const std::string& name, std::optional<Enum>& value, const std::vector<std::string>& words,
                        const std::string& sentence) {
    return choice_of(name, value ? 1 + static_cast<std::size_t>(*value) : 0, words, sentence,
                     [&value](std::size_t chosen) {
                       value = chosen > 0 ? std::optional(static_cast<Enum>(chosen - 1)) : std::nullopt;
                     });
  }
  /// A choice by the place of its word.
  ParameterList& choice_of(const std::string& name, std::size_t chosen, const std::vector<std::string>& words,
                           const std::string& sentence, std::function<void(std::size_t)> set);
  /// One of these numbers.
  ParameterList& choice_of_numbers(const std::string& name, std::size_t& value,
                                   std::initializer_list<std::size_t> numbers, const std::string& sentence);

  using Read = std::function<void(const std::string&)>;
  ParameterList& text(const std::string& name, const std::string& value, const std::string& sentence, Read read);
  /// A list separated by ';', empty by default.
  ParameterList& list(const std::string& name, const std::string& sentence, Read read);

  /// Words for windows for the parameter that was listed last, and for its choices or the two ends of its range.
  ParameterList& titled(const std::string& title, const std::vector<std::string>& choice_titles = {});
  ParameterList& at(ParameterPlace place);
  /// What windows show in place of the default.
  ParameterList& or_else(const std::string& default_title);
  /// The choice that was listed last gets "preset" as a further one: as the chosen preset has it.
  ParameterList& or_preset();
  /// The choice that was listed last sets the values of other parameters, too, unless they are given.
  ParameterList& sets_others();

  /// Sets the members by complete values (see croquis::complete), by what sets others first.
  /// @throws Error with the findings of all that can't be read
  void set(const ParameterValues& values) const;

  const std::vector<ParameterDescription>& descriptions() const { return descriptions_; }

  /// Calls back with each choice that sets others; the callback gives the descriptions after it was made.
  using After = std::function<std::vector<ParameterDescription>(std::size_t parameter, const ParameterValue& choice)>;
  std::vector<ParameterDescription> with_presets(const After& after) const;

  /// Sets the members of one parameter.
  void set(std::size_t parameter, const ParameterValue& value) const { sets_[parameter](value); }

 private:
  std::vector<ParameterDescription> descriptions_;
  std::vector<Set> sets_;
  std::vector<std::size_t> first_;  ///< places of those that set others
};

template <typename Settings>
using ListParameters = void (*)(Settings&, ParameterList&);

/// The descriptions of the parameters, with the values that go with presets.
template <typename Settings>
std::vector<ParameterDescription> parameters_of(ListParameters<Settings> list_parameters) {
  const auto listed = [list_parameters](Settings& settings) {
    ParameterList list;
    list_parameters(settings, list);
    return list;
  };
  Settings settings;
  return listed(settings).with_presets([&](std::size_t parameter, const ParameterValue& choice) {
    Settings chosen;
    listed(chosen).set(parameter, choice);
    return listed(chosen).descriptions();
  });
}

/// The settings that complete values stand for.
/// @throws Error (E_PARAMETER) with the findings of all that can't be read
template <typename Settings>
Settings settings_of(ListParameters<Settings> list_parameters, const ParameterValues& values) {
  Settings settings;
  ParameterList list;
  list_parameters(settings, list);
  list.set(values);
  return settings;
}

}  // namespace croquis
