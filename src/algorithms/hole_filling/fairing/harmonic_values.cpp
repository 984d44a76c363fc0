// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/hole_filling/fairing/harmonic_values.h"

#include <algorithm>
#include <array>
#include <utility>

namespace croquis::hole_filling {
namespace {

constexpr std::size_t most_solver_rounds = 10000;  // a patch of a million vertices takes about 3000

double dot(double a, double b) { return a * b; }
double dot(const Vec3& a, const Vec3& b) { return a.dot(b); }

template <typename Value>
double dot(const std::vector<Value>& a, const std::vector<Value>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += dot(a[i], b[i]);
  return sum;
}

}  // namespace

PatchGraph::PatchGraph(const HolePatch& patch, Index vertices_given) {
  for (const auto& t : patch.triangles) {
    for (const Index v : t) {
      if (v < vertices_given) rim_.push_back(v);
    }
  }
  std::sort(rim_.begin(), rim_.end());
  rim_.erase(std::unique(rim_.begin(), rim_.end()), rim_.end());
  const std::size_t count = patch.points.size();
  const auto number = [&](Index v) {
    if (v >= vertices_given) return v - vertices_given;
    return static_cast<Index>(count) + static_cast<Index>(std::lower_bound(rim_.begin(), rim_.end(), v) - rim_.begin());
  };
  std::vector<std::array<Index, 3>> triangles;
  for (const auto& [a, b, c] : patch.triangles) triangles.push_back({number(a), number(b), number(c)});
  first_.assign(count + 1, 0);
  for (const auto& t : triangles) {
    for (const Index v : t) {
      if (v < count) first_[v + 1] += 2;
    }
  }
  for (std::size_t v = 0; v < count; ++v) first_[v + 1] += first_[v];
  neighbours_.resize(first_.back());
  std::vector<Index> end(first_.begin(), first_.end() - 1);
  for (const auto& t : triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      if (t[i] >= count) continue;
      neighbours_[end[t[i]]++] = t[(i + 1) % 3];
      neighbours_[end[t[i]]++] = t[(i + 2) % 3];
    }
  }
}

/// The Laplacian of the new vertices.
template <typename Value>
void PatchGraph::apply(const std::vector<Value>& values, std::vector<Value>& result) const {
  const auto count = static_cast<Index>(values.size());
  for (Index v = 0; v < count; ++v) {
    Value sum = static_cast<double>(first_[v + 1] - first_[v]) * values[v];
    for (Index i = first_[v]; i < first_[v + 1]; ++i) {
      if (neighbours_[i] < count) sum -= values[neighbours_[i]];
    }
    result[v] = sum;
  }
}

/// Solves for the differences from one of the known values: where all are equal, nothing is rounded.
template <typename Value>
std::vector<Value> PatchGraph::solve(std::span<const Value> known, double accuracy) const {
  const auto count = static_cast<Index>(first_.size() - 1);
  if (known.empty() || count == 0) return {};
  const Value base = known.front(), zero = base - base;
  std::vector<Value> values(count, zero), rest(count, zero), applied(count, zero);
  for (Index v = 0; v < count; ++v) {
    for (Index i = first_[v]; i < first_[v + 1]; ++i) {
      if (neighbours_[i] >= count) rest[v] += known[neighbours_[i] - count] - base;
    }
  }
  std::vector<Value> way = rest;
  double left = dot(rest, rest);
  const double enough = accuracy * accuracy * left;
  for (std::size_t round = 0; round < most_solver_rounds && left > enough; ++round) {
    apply(way, applied);
    const double step = left / dot(way, applied);
    for (Index v = 0; v < count; ++v) {
      values[v] += step * way[v];
      rest[v] -= step * applied[v];
    }
    const double before = std::exchange(left, dot(rest, rest));
    for (Index v = 0; v < count; ++v) way[v] = rest[v] + left / before * way[v];
  }
  for (Value& value : values) value += base;
  return values;
}

std::vector<double> PatchGraph::harmonic(std::span<const double> known, double accuracy) const {
  return solve(known, accuracy);
}
std::vector<Vec3> PatchGraph::harmonic(std::span<const Vec3> known, double accuracy) const {
  return solve(known, accuracy);
}

}  // namespace croquis::hole_filling
