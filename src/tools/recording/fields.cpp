// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/tools/recording/fields.h"

#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <variant>

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

template <typename Vector>
Vector as_vector(const FieldJson& value, const std::string& name, const char* expected) {
  const std::vector<double> numbers = number_list(value, name);
  if (numbers.size() != Vector::SizeAtCompileTime) throw Mistake{quoted(name) + " must be " + expected};
  return Eigen::Map<const Vector>(numbers.data());
}

template <typename Vector>
FieldJson json_of(const Vector& numbers) {
  return std::vector<double>(numbers.begin(), numbers.end());
}

}  // namespace

struct FieldState {
  bool reads = false;
  FieldJson object = FieldJson::object();
  std::set<std::string> known;

  const FieldJson* find(const std::string& name) {
    known.insert(name);
    const auto found = object.find(name);
    return found == object.end() ? nullptr : &*found;
  }

  /// Reads a value as `take` understands the field, or writes it.
  template <typename T, typename Take>
  void take_or_put(const std::string& name, T& value, const Take& take) {
    if (!reads) {
      object[name] = value;
      return;
    }
    const FieldJson* found = find(name);
    if (found == nullptr) throw Mistake{quoted(name) + " is missing"};
    value = take(*found);
  }

  template <typename Vector>
  void take_or_put_vector(const std::string& name, Vector& value, const char* expected) {
    FieldJson numbers = json_of(value);
    take_or_put(name, numbers, [](const FieldJson& field) { return field; });
    if (reads) value = as_vector<Vector>(numbers, name, expected);
  }
};

Fields::Fields(std::string_view line, const Vocabulary& vocabulary)
    : state_(std::make_unique<FieldState>()), vocabulary_(&vocabulary) {
  state_->reads = true;
  state_->object = FieldJson::parse(line, nullptr, false);
  if (!state_->object.is_object()) throw Mistake{"it is no JSON object"};
}

Fields::Fields() : state_(std::make_unique<FieldState>()) {}

Fields::~Fields() = default;

bool reads(const FieldState& state) { return state.reads; }

bool Fields::has(const std::string& name) { return state_->find(name) != nullptr; }

void exchange(FieldState& state, const std::string& name, std::string& value) {
  state.take_or_put(name, value, [&](const FieldJson& field) {
    if (!field.is_string()) throw Mistake{quoted(name) + " must be a text"};
    return field.get<std::string>();
  });
}

void exchange(FieldState& state, const std::string& name, std::string& value, const Words& words) {
  exchange(state, name, value);
  if (!state.reads || std::ranges::find(words, value) != words.end()) return;
  std::string list;
  for (const std::string& word : words) list += (list.empty() ? "" : ", ") + word;
  throw Mistake{quoted(name) + " must be one of " + list};
}

void exchange(FieldState& state, const std::string& name, bool& value) {
  state.take_or_put(name, value, [&](const FieldJson& field) {
    if (!field.is_boolean()) throw Mistake{quoted(name) + " must be true or false"};
    return field.get<bool>();
  });
}

void exchange(FieldState& state, const std::string& name, double& value) {
  state.take_or_put(name, value, [&](const FieldJson& field) {
    if (!is_usable(field)) throw Mistake{quoted(name) + " must be a finite number"};
    return field.get<double>();
  });
}

void exchange(FieldState& state, const std::string& name, double& value, const OrInfinite&) {
  FieldJson number = std::isinf(value) ? FieldJson("inf") : FieldJson(value);
  state.take_or_put(name, number, [&](const FieldJson& field) {
    if (field == "inf") return FieldJson(std::numeric_limits<double>::infinity());
    if (!is_usable(field) || field.get<double>() < 0)
      throw Mistake{quoted(name) + " must be a number of at least 0, or \"inf\""};
    return field;
  });
  if (state.reads) value = number.get<double>();
}

void exchange(FieldState& state, const std::string& name, std::int64_t& value) {
  state.take_or_put(name, value, [&](const FieldJson& field) {
    if (!field.is_number_integer() || field.get<double>() < 0 || field.get<double>() > 1e15)
      throw Mistake{quoted(name) + " must be a whole number of at least 0"};
    return field.get<std::int64_t>();
  });
}

void exchange(FieldState& state, const std::string& name, std::size_t& value) {
  auto number = static_cast<std::int64_t>(value);
  exchange(state, name, number);
  value = static_cast<std::size_t>(number);
}

void exchange(FieldState& state, const std::string& name, int& value) {
  std::int64_t number = value;
  exchange(state, name, number);
  value = static_cast<int>(number);
}

void exchange(FieldState& state, const std::string& name, Index& value) {
  state.take_or_put(name, value, [&](const FieldJson& field) { return as_index(field, name); });
}

void exchange(FieldState& state, const std::string& name, std::vector<Index>& value) {
  state.take_or_put(name, value, [&](const FieldJson& field) {
    if (!field.is_array()) throw Mistake{quoted(name) + " must be a list of whole numbers"};
    std::vector<Index> values;
    for (const FieldJson& element : field) values.push_back(as_index(element, name));
    return values;
  });
}

void exchange(FieldState& state, const std::string& name, std::vector<std::string>& value) {
  state.take_or_put(name, value, [&](const FieldJson& field) {
    const bool named = field.is_array() && !field.empty() &&
                       std::ranges::all_of(field, [](const FieldJson& element) { return element.is_string(); });
    if (!named) throw Mistake{quoted(name) + " must be a list of names"};
    return field.get<std::vector<std::string>>();
  });
}

void exchange(FieldState& state, const std::string& name, std::vector<std::vector<double>>& value) {
  state.take_or_put(name, value, [&](const FieldJson& field) {
    if (!field.is_array() || field.empty()) throw Mistake{quoted(name) + " must be a list of at least one list"};
    std::vector<std::vector<double>> lists;
    for (const FieldJson& list : field) lists.push_back(number_list(list, name));
    return lists;
  });
}

template <typename Vector>
void exchange_places(FieldState& state, const std::string& name, std::vector<Vector>& value, const char* numbers) {
  std::vector<std::vector<double>> places;
  for (const Vector& place : value) places.emplace_back(place.begin(), place.end());
  exchange(state, name, places);
  value.clear();
  for (const std::vector<double>& place : places) {
    if (place.size() != Vector::SizeAtCompileTime)
      throw Mistake{quoted(name) + " must be a list of places of " + numbers + " numbers"};
    value.emplace_back(Eigen::Map<const Vector>(place.data()));
  }
}

void exchange(FieldState& state, const std::string& name, std::vector<Vec2>& value) {
  exchange_places(state, name, value, "two");
}

void exchange(FieldState& state, const std::string& name, std::vector<Vec3>& value) {
  exchange_places(state, name, value, "three");
}

void exchange(FieldState& state, const std::string& name, Vec2& value) {
  state.take_or_put_vector(name, value, "a pair of numbers");
}

void exchange(FieldState& state, const std::string& name, Vec3& value) {
  state.take_or_put_vector(name, value, "three numbers");
}

void exchange(FieldState& state, const std::string& name, ParameterValue& value) {
  FieldJson json = std::visit([](const auto& held) { return FieldJson(held); }, value);
  state.take_or_put(name, json, [](const FieldJson& field) { return field; });
  if (!state.reads) return;
  if (json.is_boolean()) {
    value = json.get<bool>();
  } else if (json.is_number_integer()) {
    value = json.get<std::int64_t>();
  } else if (json.is_number()) {
    value = json.get<double>();
  } else if (json.is_string()) {
    value = json.get<std::string>();
  } else {
    throw Mistake{quoted(name) + " must be true, false, a number or a text"};
  }
}

void Fields::place(const std::string& name, Vec2& sketch, ModelPlace& model) {
  if (const FieldJson* field = reads() ? state_->find(name) : nullptr)
    model = field->is_array() && field->size() == 3 ? ModelPlace(Vec3::Zero()) : std::nullopt;
  if (model) {
    exchange(*state_, name, *model);
  } else {
    exchange(*state_, name, sketch);
  }
}

void Fields::modifiers(std::vector<std::string>& modifiers) {
  if (reads() ? !has("modifiers") : modifiers.empty()) return;
  state_->take_or_put("modifiers", modifiers, [](const FieldJson& field) {
    if (!field.is_array()) throw Mistake{"\"modifiers\" must be a list of names"};
    const bool known = std::ranges::all_of(field, [](const FieldJson& key) {
      return key.is_string() && std::ranges::find(modifier_keys, key.get<std::string>()) != modifier_keys.end();
    });
    if (!known) throw Mistake{"\"modifiers\" may hold shift, ctrl, alt and super"};
    return field.get<std::vector<std::string>>();
  });
}

void Fields::refuse_unknown() const {
  for (const auto& [name, value] : state_->object.items()) {
    if (!state_->known.contains(name)) throw Mistake{quoted(name) + " means nothing here"};
  }
}

std::string Fields::line() const { return state_->object.dump(-1, ' ', false, FieldJson::error_handler_t::replace); }

}  // namespace croquis::recorded
