// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/hole_filling/editable_triangles.h"

#include <numeric>

namespace croquis::hole_filling {

EditableTriangles::EditableTriangles(std::span<const std::array<Index, 3>> triangles, std::size_t vertex_count)
    : out_(vertex_count, none), is_gone_(vertex_count, false) {
  from_.reserve(6 * triangles.size());
  for (const auto& t : triangles) from_.insert(from_.end(), t.begin(), t.end());
  moved_to_.assign(from_.size(), none);
  find_twins(vertex_count);
}

/// Sides in the order of where they begin. Of each vertex those that end there, each behind one that begins there, find
/// their twins by where those lead.
void EditableTriangles::find_twins(std::size_t vertex_count) {
  // Shifted by one, so that placing the sides turns beginnings into ends.
  std::vector<Index> ends(vertex_count + 1, 0);
  for (const Index v : from_) ++ends[v + std::size_t{1}];
  std::partial_sum(ends.begin(), ends.end(), ends.begin());
  std::vector<Side> sorted(from_.size());
  for (Side s = 0; s < from_.size(); ++s) sorted[ends[from_[s]]++] = s;
  twin_.reserve(2 * from_.size());
  twin_.assign(from_.size(), none);
  std::vector<Side> leading_to(vertex_count, none);
  for (std::size_t v = 0; v < vertex_count; ++v) {
    const std::size_t begin = v == 0 ? 0 : ends[v - 1];
    const std::span<const Side> sides(sorted.data() + begin, ends[v] - begin);
    for (const Side s : sides) {
      has_doubled_sides_ |= leading_to[to(s)] != none;
      leading_to[to(s)] = s;
    }
    for (const Side s : sides) twin_[previous(s)] = leading_to[apex(s)];
    for (const Side s : sides) leading_to[to(s)] = none;
    if (!sides.empty()) out_[v] = sides.back();
  }
}

bool EditableTriangles::is_manifold(std::size_t open_vertices) const {
  if (has_doubled_sides_) return false;
  std::vector<Index> sizes(out_.size(), 0);
  for (const Index v : from_) ++sizes[v];
  for (Index v = static_cast<Index>(open_vertices); v < out_.size(); ++v) {
    if (!is_closed_fan(v, sizes[v])) return false;
  }
  return true;
}

bool EditableTriangles::is_closed_fan(Index v, Index size) const {
  Side s = out_[v];
  for (Index i = 0; i < size; ++i) {
    s = twin_[previous(s)];
    if (s == none) return false;
    if (s == out_[v]) return i + 1 == size;
  }
  return size == 0;
}

void EditableTriangles::join(Side a, Side b) {
  twin_[a] = b;
  if (b != none) twin_[b] = a;
}

void EditableTriangles::set(Side s, Index from) {
  from_[s] = from;
  out_[from] = s;
}

EditableTriangles::Side EditableTriangles::add_triangle(Index a, Index b, Index c) {
  const Side first = count();
  from_.resize(from_.size() + 3);
  twin_.resize(twin_.size() + 3, none);
  moved_to_.resize(from_.size(), none);
  set(first, a);
  set(first + 1, b);
  set(first + 2, c);
  return first;
}

/// What moves later from the same place is an edge that wasn't there at first.
void EditableTriangles::remember_move(Side from, Side to) {
  if (moved_to_[from] == none) moved_to_[from] = to;
}

void EditableTriangles::split(Side s) {
  const Side t = twin_[s];
  const Index b = to(s), c = apex(s), d = apex(t);
  const auto middle = static_cast<Index>(out_.size());
  out_.push_back(none);
  is_gone_.push_back(false);
  const Side left = add_triangle(middle, b, c), right = add_triangle(b, middle, d);
  join(left + 1, twin_[next(s)]);
  join(right + 2, twin_[previous(t)]);
  remember_move(next(s), left + 1);
  remember_move(previous(t), right + 2);
  join(left, right);
  join(left + 2, next(s));
  join(right + 1, previous(t));
  from_[next(s)] = middle;
  from_[t] = middle;
}

void EditableTriangles::collapse(Side s) {
  const Side t = twin_[s];
  const Index gone = from(s), kept = to(s);
  Side out = s;
  do {
    const Side following = twin_[previous(out)];
    from_[out] = kept;
    out = following;
  } while (out != s);
  for (const Side side : {s, t}) {  // the other two sides of each triangle fall into one edge
    const Side a = twin_[next(side)], b = twin_[previous(side)];
    for (const Side end : {a, b}) {
      if (end != none) out_[from_[end]] = end;
    }
    join(b != none ? b : a, b != none ? a : b);
  }
  for (const Side side : {s, next(s), previous(s), t, next(t), previous(t)}) from_[side] = none;
  is_gone_[gone] = true;
}

void EditableTriangles::flip(Side s) {
  const Side t = twin_[s];
  const Index a = from(s), b = to(s), c = apex(s), d = apex(t);
  const Side ca = twin_[previous(s)], ad = twin_[next(t)], db = twin_[previous(t)], bc = twin_[next(s)];
  set(s, d), set(next(s), c), set(previous(s), a);
  set(t, c), set(next(t), d), set(previous(t), b);
  join(next(s), ca), join(previous(s), ad);
  join(next(t), db), join(previous(t), bc);
}

std::vector<std::array<Index, 3>> EditableTriangles::triangles() const {
  std::vector<std::array<Index, 3>> result;
  for (Side s = 0; s < from_.size(); s += 3) {
    if (from_[s] != none) result.push_back({from_[s], from_[s + 1], from_[s + 2]});
  }
  return result;
}

}  // namespace croquis::hole_filling
