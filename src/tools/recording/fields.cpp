// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/tools/recording/fields.h"

#include <algorithm>
#include <array>
#include <limits>
#include <set>

#include <nlohmann/json.hpp>

#include "croquis/base/limits.h"

namespace croquis::recorded {
namespace {

using FieldJson = nlohmann::ordered_json;

constexpr std::array<const char*, 4> modifier_keys{"shift", "ctrl", "alt", "super"};

std::string quoted(const std::string& name) { return '"' + name + '"'; }

bool is_usable(const FieldJson& value) { return value.is_number() && is_usable_number(value.get<double>()); }

std::vector<double> number_list(const FieldJson& value, const std::string& name) {
  if (!value.is_array()) throw Mistake{quoted(name) + " must be a list of numbers"};
  std::vector<double> numbers;
  for (const FieldJson& number : value) {
    if (!is_usable(number)) throw Mistake{quoted(name) + " may hold finite numbers only"};
    numbers.push_back(number.get<double>());
  }
  return numbers;
}

Index as_index(const FieldJson& value, const std::string& name) {
  if (!value.is_number_integer() || value.get<double>() < 0 || value.get<double>() >= no_index)
    throw Mistake{quoted(name) + " must hold whole numbers of at least 0"};
  return value.get<Index>();
}

}  // namespace

struct Fields::State {
  FieldJson object;
  std::set<std::string> known;

  const FieldJson* find(const std::string& name) {
    known.insert(name);
    const auto found = object.find(name);
    return found == object.end() ? nullptr : &*found;
  }

  const FieldJson& get(const std::string& name) {
    const FieldJson* found = find(name);
    if (found == nullptr) throw Mistake{quoted(name) + " is missing"};
    return *found;
  }
};

Fields::Fields(std::string_view line, const Vocabulary& vocabulary)
    : state_(std::make_unique<State>()), vocabulary_(vocabulary) {
  state_->object = FieldJson::parse(line, nullptr, false);
  if (!state_->object.is_object()) throw Mistake{"it is no JSON object"};
}

Fields::~Fields() = default;

bool Fields::has(const std::string& name) { return state_->find(name) != nullptr; }

std::string Fields::text(const std::string& name) {
  const FieldJson& value = state_->get(name);
  if (!value.is_string()) throw Mistake{quoted(name) + " must be a text"};
  return value.get<std::string>();
}

std::string Fields::text(const std::string& name, const std::string& otherwise) {
  return has(name) ? text(name) : otherwise;
}

std::string Fields::one_of(const std::string& name, const std::vector<std::string>& choices) {
  std::string value = text(name);
  if (std::find(choices.begin(), choices.end(), value) != choices.end()) return value;
  std::string list;
  for (const std::string& choice : choices) list += (list.empty() ? "" : ", ") + choice;
  throw Mistake{quoted(name) + " must be one of " + list};
}

bool Fields::flag(const std::string& name) {
  const FieldJson& value = state_->get(name);
  if (!value.is_boolean()) throw Mistake{quoted(name) + " must be true or false"};
  return value.get<bool>();
}

double Fields::number(const std::string& name) {
  const FieldJson& value = state_->get(name);
  if (!is_usable(value)) throw Mistake{quoted(name) + " must be a finite number"};
  return value.get<double>();
}

double Fields::number_or_infinite(const std::string& name) {
  const FieldJson& value = state_->get(name);
  if (value.is_string() && value.get<std::string>() == "inf") return std::numeric_limits<double>::infinity();
  if (!is_usable(value) || value.get<double>() < 0)
    throw Mistake{quoted(name) + " must be a number of at least 0, or \"inf\""};
  return value.get<double>();
}

std::int64_t Fields::count(const std::string& name) {
  const FieldJson& value = state_->get(name);
  if (!value.is_number_integer() || value.get<double>() < 0 || value.get<double>() > 1e15)
    throw Mistake{quoted(name) + " must be a whole number of at least 0"};
  return value.get<std::int64_t>();
}

Index Fields::index(const std::string& name) { return as_index(state_->get(name), name); }

std::vector<Index> Fields::indices(const std::string& name) {
  const FieldJson& list = state_->get(name);
  if (!list.is_array()) throw Mistake{quoted(name) + " must be a list of whole numbers"};
  std::vector<Index> values;
  for (const FieldJson& value : list) values.push_back(as_index(value, name));
  return values;
}

std::vector<std::string> Fields::names(const std::string& name) {
  const FieldJson& list = state_->get(name);
  std::vector<std::string> values;
  if (list.is_array() && std::all_of(list.begin(), list.end(), [](const auto& value) { return value.is_string(); }))
    values = list.get<std::vector<std::string>>();
  if (values.empty()) throw Mistake{quoted(name) + " must be a list of names"};
  return values;
}

std::vector<std::vector<double>> Fields::number_lists(const std::string& name) {
  const FieldJson& lists = state_->get(name);
  if (!lists.is_array() || lists.empty()) throw Mistake{quoted(name) + " must be a list of at least one list"};
  std::vector<std::vector<double>> values;
  for (const FieldJson& list : lists) values.push_back(number_list(list, name));
  return values;
}

ParameterValue Fields::value(const std::string& name) {
  const FieldJson& value = state_->get(name);
  if (value.is_boolean()) return value.get<bool>();
  if (value.is_number_integer()) return value.get<std::int64_t>();
  if (value.is_number()) return value.get<double>();
  if (value.is_string()) return value.get<std::string>();
  throw Mistake{quoted(name) + " must be true, false, a number or a text"};
}

Vec2 Fields::pair(const std::string& name) {
  const std::vector<double> numbers = number_list(state_->get(name), name);
  if (numbers.size() != 2) throw Mistake{quoted(name) + " must be a pair of numbers"};
  return {numbers[0], numbers[1]};
}

Vec3 Fields::triple(const std::string& name) {
  const std::vector<double> numbers = number_list(state_->get(name), name);
  if (numbers.size() != 3) throw Mistake{quoted(name) + " must be three numbers"};
  return {numbers[0], numbers[1], numbers[2]};
}

ModelPlace Fields::model_place(const std::string& name) { return has(name) ? ModelPlace(triple(name)) : std::nullopt; }

void Fields::place(const std::string& name, Vec2& sketch, ModelPlace& model) {
  const FieldJson& value = state_->get(name);
  if (value.is_array() && value.size() == 3) {
    model = triple(name);
  } else {
    sketch = pair(name);
  }
}

std::vector<std::string> Fields::modifiers() {
  if (!has("modifiers")) return {};
  const FieldJson& list = state_->get("modifiers");
  if (!list.is_array()) throw Mistake{"\"modifiers\" must be a list of names"};
  const auto is_key = [](const FieldJson& value) {
    return value.is_string() &&
           std::find(modifier_keys.begin(), modifier_keys.end(), value.get<std::string>()) != modifier_keys.end();
  };
  if (!std::all_of(list.begin(), list.end(), is_key))
    throw Mistake{"\"modifiers\" may hold shift, ctrl, alt and super"};
  return list.get<std::vector<std::string>>();
}

void Fields::refuse_unknown() const {
  for (const auto& [name, value] : state_->object.items()) {
    if (!state_->known.contains(name)) throw Mistake{quoted(name) + " means nothing here"};
  }
}

}  // namespace croquis::recorded
