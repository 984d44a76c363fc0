// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/channel_values.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace croquis {
namespace {

constexpr double largest_byte = 255;

}  // namespace

double value_of(const AttributeChannel& channel, std::size_t i) {
  return std::visit([i](const auto& values) { return static_cast<double>(values[i]); }, channel.data);
}

bool is_floating(const AttributeChannel& channel) {
  return std::holds_alternative<std::vector<float>>(channel.data) ||
         std::holds_alternative<std::vector<double>>(channel.data);
}

double colour_of(const AttributeChannel& channel, std::size_t i) {
  return is_floating(channel) ? value_of(channel, i) : value_of(channel, i) / largest_byte;
}

bool all_finite(const AttributeChannel& channel) {
  return std::visit(
      [](const auto& values) {
        return std::all_of(values.begin(), values.end(),
                           [](auto value) { return std::isfinite(static_cast<double>(value)); });
      },
      channel.data);
}

std::string label_of(const AttributeChannel& channel, std::size_t element) {
  const double value = value_of(channel, element);
  if (!(value >= 0)) return {};
  const auto index = static_cast<std::size_t>(std::min(value, 1e15));
  return index < channel.labels.size() ? channel.labels[index] : std::to_string(index);
}

bool fits(const AttributeChannel& channel, const PolyMesh& mesh) {
  return channel.width > 0 &&
         channel.size() == mesh.element_count(channel.domain) * static_cast<std::size_t>(channel.width);
}

const AttributeChannel* usable_channel(const PolyMesh& mesh, const char* name, Domain domain, int width, int or_width) {
  const AttributeChannel* channel = mesh.channel(name, domain);
  if (channel == nullptr || !fits(*channel, mesh)) return nullptr;
  return channel->width == width || channel->width == or_width ? channel : nullptr;
}

AttributeChannel colour_channel(Domain domain, int width, std::vector<double> unit_values, bool bytes) {
  if (!bytes) return make_channel("color", domain, width, std::move(unit_values));
  std::vector<std::uint8_t> values(unit_values.size());
  std::transform(unit_values.begin(), unit_values.end(), values.begin(),
                 [](double value) { return static_cast<std::uint8_t>(std::lround(value * largest_byte)); });
  return make_channel("color", domain, width, std::move(values));
}

void CategoryState::set(std::string_view label) {
  const auto [entry, is_new] = numbers_.try_emplace(std::string(label), static_cast<std::int32_t>(labels_.size()));
  if (is_new) labels_.emplace_back(label);
  current_ = entry->second;
}

void CategoryState::note(std::vector<std::int32_t>& values, std::size_t elements_before) {
  if (labels_.empty()) return;
  values.resize(elements_before, -1);
  values.push_back(current_);
}

void CategoryState::finish(PolyMesh& mesh) {
  for (const auto& [domain, values] : {std::pair{Domain::Face, &face_values_}, {Domain::Line, &line_values_}}) {
    if (values->empty()) continue;
    AttributeChannel channel = make_channel(name_, domain, 1, std::move(*values));
    channel.labels = labels_;
    mesh.channels.push_back(std::move(channel));
  }
}

}  // namespace croquis
