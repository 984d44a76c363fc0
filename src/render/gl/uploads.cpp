// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/gl/uploads.h"

#include <algorithm>

namespace croquis::render {
namespace {

/// However small the budget, a drawing sends as much: or it would take for ever.
constexpr std::size_t least_budget = 4096;

}  // namespace

void Uploads::begin_drawing(std::size_t budget) {
  left_ = budget == 0 ? std::numeric_limits<std::size_t>::max() : std::max(budget, least_budget);
  pending_ = false;
}

std::size_t Uploads::grant(std::size_t wanted, bool at_once) {
  const std::size_t granted = at_once ? wanted : std::min(wanted, left_);
  left_ -= std::min(left_, granted);
  if (granted < wanted) pending_ = true;
  return granted;
}

void Uploads::count(std::size_t bytes) {
  total_.bytes += bytes;
  ++total_.transfers;
}

SlicedBuffer::SlicedBuffer(std::size_t size) : buffer_(make_buffer()), size_(size) {
  glBindBuffer(GL_ARRAY_BUFFER, buffer_.name());
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(size), nullptr, GL_STATIC_DRAW);
}

void SlicedBuffer::send(std::span<const std::byte> bytes, bool at_once, Uploads& uploads) {
  const std::size_t now = uploads.grant(size_ - sent_, at_once);
  if (now == 0) return;
  glBindBuffer(GL_ARRAY_BUFFER, buffer_.name());
  glBufferSubData(GL_ARRAY_BUFFER, static_cast<GLintptr>(sent_), static_cast<GLsizeiptr>(now), bytes.data() + sent_);
  uploads.count(now);
  sent_ += now;
}

}  // namespace croquis::render
