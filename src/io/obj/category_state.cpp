// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/obj/category_state.h"

#include "io/channel_values.h"

namespace croquis {

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
