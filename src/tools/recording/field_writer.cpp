// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/tools/recording/field_writer.h"

#include <cmath>
#include <variant>

#include <nlohmann/json.hpp>

namespace croquis::recorded {

struct FieldWriter::State {
  nlohmann::ordered_json object = nlohmann::ordered_json::object();
};

FieldWriter::FieldWriter() : state_(std::make_unique<State>()) {}
FieldWriter::~FieldWriter() = default;

void FieldWriter::text(const std::string& name, const std::string& value) { state_->object[name] = value; }
void FieldWriter::flag(const std::string& name, bool value) { state_->object[name] = value; }
void FieldWriter::number(const std::string& name, double value) { state_->object[name] = value; }
void FieldWriter::count(const std::string& name, std::int64_t value) { state_->object[name] = value; }

void FieldWriter::number_or_infinite(const std::string& name, double value) {
  if (std::isinf(value)) {
    text(name, "inf");
  } else {
    number(name, value);
  }
}

void FieldWriter::indices(const std::string& name, const std::vector<Index>& values) { state_->object[name] = values; }

void FieldWriter::names(const std::string& name, const std::vector<std::string>& values) {
  state_->object[name] = values;
}

void FieldWriter::number_lists(const std::string& name, const std::vector<std::vector<double>>& values) {
  state_->object[name] = values;
}

void FieldWriter::value(const std::string& name, const ParameterValue& value) {
  std::visit([&](const auto& held) { state_->object[name] = held; }, value);
}

void FieldWriter::pair(const std::string& name, const Vec2& value) { state_->object[name] = {value.x(), value.y()}; }

void FieldWriter::triple(const std::string& name, const Vec3& value) {
  state_->object[name] = {value.x(), value.y(), value.z()};
}

void FieldWriter::place(const std::string& name, const Vec2& sketch, const ModelPlace& model) {
  if (model) {
    triple(name, *model);
  } else {
    pair(name, sketch);
  }
}

void FieldWriter::modifiers(const std::vector<std::string>& modifiers) {
  if (!modifiers.empty()) names("modifiers", modifiers);
}

std::string FieldWriter::line() const {
  return state_->object.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

}  // namespace croquis::recorded
