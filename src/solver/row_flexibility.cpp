// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/row_flexibility.h"

#include <algorithm>

namespace croquis {

using Eigen::VectorXd;

RowFlexibility::RowFlexibility(const ScaledProblem& problem, const KktSystem& system)
    : problem_(problem), system_(system), work_(VectorXd::Zero(system.size())) {}

/// Puts the row into the factors' order; returns where its entries are.
std::vector<int> RowFlexibility::start(Eigen::Index row) {
  std::vector<int> places;
  const auto& order = system_.factors().permutationP().indices();
  for (RowMatrix::InnerIterator entry(problem_.inequalities, row); entry; ++entry) {
    const int place = order.size() > 0 ? order[entry.col()] : static_cast<int>(entry.col());
    work_[place] += entry.value();
    places.push_back(place);
  }
  return places;
}

/// All places on the paths to the root, ascending. A column's parent is its first entry below the diagonal.
std::vector<int> RowFlexibility::reached(std::vector<int> start) const {
  const auto& lower = system_.factors().matrixL().nestedExpression();
  std::vector<int> places;
  std::vector<int> merged;
  for (const int first : start) {
    std::vector<int> path{first};
    for (int place = first;;) {
      const int begin = lower.outerIndexPtr()[place];
      if (begin == lower.outerIndexPtr()[place + 1]) break;
      place = lower.innerIndexPtr()[begin];
      // Where two paths meet they stay together.
      if (std::binary_search(places.begin(), places.end(), place)) break;
      path.push_back(place);
    }
    merged.clear();
    std::set_union(places.begin(), places.end(), path.begin(), path.end(), std::back_inserter(merged));
    places.swap(merged);
  }
  return places;
}

RowFlexibility::HalfSolution RowFlexibility::half_solve(Eigen::Index row) {
  HalfSolution half;
  half.places = reached(start(row));
  half.values.resize(static_cast<Eigen::Index>(half.places.size()));
  const auto& lower = system_.factors().matrixL().nestedExpression();
  Eigen::Index next = 0;
  for (const int place : half.places) {
    const double value = work_[place];
    half.values[next++] = value;
    work_[place] = 0;
    for (int k = lower.outerIndexPtr()[place]; k < lower.outerIndexPtr()[place + 1]; ++k)
      work_[lower.innerIndexPtr()[k]] -= lower.valuePtr()[k] * value;
  }
  return half;
}

VectorXd RowFlexibility::add(Eigen::Index row) {
  halves_.push_back(half_solve(row));
  const HalfSolution& last = halves_.back();
  const auto& pivots = system_.factors().vectorD();
  for (std::size_t i = 0; i < last.places.size(); ++i)
    work_[last.places[i]] = last.values[static_cast<Eigen::Index>(i)] / pivots[last.places[i]];

  VectorXd flexibility(static_cast<Eigen::Index>(halves_.size()));
  for (std::size_t h = 0; h < halves_.size(); ++h) {
    double product = 0;
    for (std::size_t i = 0; i < halves_[h].places.size(); ++i)
      product += work_[halves_[h].places[i]] * halves_[h].values[static_cast<Eigen::Index>(i)];
    flexibility[static_cast<Eigen::Index>(h)] = product;
  }
  for (const int place : last.places) work_[place] = 0;
  return flexibility;
}

}  // namespace croquis
