// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cstdlib>
#include <new>
#include <vector>

#include <sys/mman.h>

#include "algorithms/subdivision/refinement/refine.h"
#include "croquis/base/parallel.h"
#include "croquis/subdivision/half_edges.h"

namespace croquis::subdivision {
namespace {

constexpr std::size_t small_page = 4096;

/// Faces, and rows of weights, from which a further thread is worth starting.
constexpr std::size_t least_faces = 4096;
constexpr std::size_t least_rows = 8192;

/// Points of faces whose corners all have their own lie behind one another; the others go through the new numbers.
class FacePoints {
 public:
  FacePoints(const HalfEdges& old, const Refinement& made, const FaceMask& mask, const Vec3* from, Vec3* to)
      : old_(old), made_(made), mask_(mask), from_(from), to_(to) {}

  void compute(std::size_t begin, std::size_t end) const {
    const auto& gaps = made_.rules.gap_faces;
    auto gap = std::lower_bound(gaps.begin(), gaps.end(), begin);
    for (std::size_t face = begin; face < end;) {
      const std::size_t run_end = gap != gaps.end() && *gap < end ? *gap : end;
      compute_run(face, run_end);
      if (run_end == end) return;
      compute_gap_face(*gap++);
      face = run_end + 1;
    }
  }

 private:
  void compute_run(std::size_t begin, std::size_t end) const {
    if (begin == end) return;
    Vec3* result = to_ + made_.level.topology.corner_vertex[old_.face_offsets[begin]];
    for (std::size_t face = begin; face < end; ++face) {
      const auto corners = old_.face(face);
      mask_.apply(from_, corners, result);
      result += corners.size();
    }
  }

  void compute_gap_face(std::size_t face) const {
    const auto corners = old_.face(face);
    std::vector<Vec3> result(corners.size());
    mask_.apply(from_, corners, result.data());
    const Index* points = made_.level.topology.corner_vertex.data() + old_.face_offsets[face];
    for (std::size_t i = 0; i < corners.size(); ++i) {
      if (points[i] < made_.origins.own_corners.kept_count()) to_[points[i]] = result[i];
    }
  }

  const HalfEdges& old_;
  const Refinement& made_;
  const FaceMask& mask_;
  const Vec3* from_;
  Vec3* to_;
};

Vec3 weighted_sum(const WeightRows& rows, std::size_t row, const Vec3* points) {
  Vec3 sum = Vec3::Zero();
  for (Index i = rows.offsets[row]; i < rows.offsets[row + 1]; ++i) sum += rows.weights[i] * points[rows.columns[i]];
  return sum;
}

using Entries = std::vector<Eigen::Triplet<double>>;

void add(std::size_t row, Index column, double weight, Entries& entries) {
  entries.emplace_back(static_cast<int>(row), static_cast<int>(column), weight);
}

void add_row(const WeightRows& rows, std::size_t which, std::size_t row, Entries& entries) {
  for (Index i = rows.offsets[which]; i < rows.offsets[which + 1]; ++i) {
    add(row, rows.columns[i], rows.weights[i], entries);
  }
}

/// How much of the plain rule each own point keeps, by point.
std::vector<double> plain_shares(const Refinement& made) {
  std::vector<double> shares(made.origins.own_corners.kept_count(), 1);
  for (std::size_t i = 0; i < made.rules.adjusted_corner.size(); ++i) {
    shares[made.origins.own_corners.rank(made.rules.adjusted_corner[i])] = made.rules.plain_share[i];
  }
  return shares;
}

void add_plain_rows(const HalfEdges& old, const Refinement& made, const FaceMask& mask, Entries& entries) {
  const std::vector<double> shares = plain_shares(made);
  for (std::size_t face = 0; face < old.face_count(); ++face) {
    const auto corners = old.face(face);
    const std::size_t n = corners.size();
    const std::vector<double> row = mask.row(n);
    for (std::size_t i = 0; i < n; ++i) {
      const Index point = made.level.topology.corner_vertex[old.face_offsets[face] + i];
      if (point >= shares.size() || shares[point] == 0) continue;
      for (std::size_t j = 0; j < n; ++j) add(point, corners[(i + j) % n], shares[point] * row[j], entries);
    }
  }
}

template <typename... Arrays>
std::size_t array_bytes(const Arrays&... arrays) {
  return (... + (arrays.capacity() * sizeof(arrays[0])));
}

std::size_t rows_bytes(const WeightRows& rows) { return array_bytes(rows.offsets, rows.columns, rows.weights); }

}  // namespace

CornerFaces::CornerFaces(const HalfEdges& mesh) : offsets_(mesh.face_offsets.data()) {
  face_.resize(mesh.corner_count());
  for (Index face = 0; face < mesh.face_count(); ++face) {
    std::fill(face_.begin() + mesh.face_offsets[face], face_.begin() + mesh.face_offsets[face + std::size_t{1}], face);
  }
}

void request_large_pages(void* block, std::size_t bytes) {
  if (bytes < large_page || std::align(small_page, large_page, block, bytes) == nullptr) return;
  madvise(block, bytes, MADV_HUGEPAGE);
}

void* allocate_block(std::size_t bytes) {
  void* block = nullptr;
  if (bytes < large_page) {
    block = std::malloc(bytes);
  } else if (posix_memalign(&block, large_page, bytes) == 0) {
    request_large_pages(block, bytes);
  }
  if (block == nullptr && bytes > 0) throw std::bad_alloc();
  return block;
}

void free_block(void* block) { std::free(block); }

void compute_positions(const HalfEdges& old, const Refinement& made, const FaceMask& mask, const Vec3* old_points,
                       Vec3* points, int threads) {
  const FacePoints faces(old, made, mask, old_points, points);
  for_each_part(old.face_count(), even_grain(old.face_count(), threads, least_faces), threads,
                [&](std::size_t begin, std::size_t end) { faces.compute(begin, end); });

  const PointRules& rules = made.rules;
  const auto& number_of_corner = made.level.topology.corner_vertex;
  for_each_part(rules.adjusted.size(), even_grain(rules.adjusted.size(), threads, least_rows), threads,
                [&](std::size_t begin, std::size_t end) {
                  for (std::size_t row = begin; row < end; ++row) {
                    Vec3& point = points[number_of_corner[rules.adjusted_corner[row]]];
                    point = rules.plain_share[row] * point + weighted_sum(rules.adjusted, row, old_points);
                  }
                });
  Vec3* listed = points + made.origins.own_corners.kept_count();
  for_each_part(rules.listed.size(), even_grain(rules.listed.size(), threads, least_rows), threads,
                [&](std::size_t begin, std::size_t end) {
                  for (std::size_t row = begin; row < end; ++row)
                    listed[row] = weighted_sum(rules.listed, row, old_points);
                });
}

Eigen::SparseMatrix<double, Eigen::RowMajor> level_weights(const HalfEdges& old, const Refinement& made,
                                                           const FaceMask& mask) {
  Entries entries;
  add_plain_rows(old, made, mask, entries);
  const PointRules& rules = made.rules;
  for (std::size_t i = 0; i < rules.adjusted.size(); ++i) {
    add_row(rules.adjusted, i, made.origins.own_corners.rank(rules.adjusted_corner[i]), entries);
  }
  const std::size_t own = made.origins.own_corners.kept_count();
  for (std::size_t i = 0; i < rules.listed.size(); ++i) add_row(rules.listed, i, own + i, entries);
  Eigen::SparseMatrix<double, Eigen::RowMajor> matrix(static_cast<Eigen::Index>(made.level.topology.vertex_count()),
                                                      static_cast<Eigen::Index>(old.vertex_count()));
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

std::size_t bytes_of(const Level& level) {
  const HalfEdges& mesh = level.topology;
  return sizeof(Level) +
         array_bytes(mesh.face_offsets, mesh.corner_vertex, mesh.twin, mesh.corner_edge, mesh.edge_corner,
                     mesh.vertex_corner) +
         array_bytes(level.sharp, level.boundary, level.pins, level.settled, level.valence_two);
}

std::size_t bytes_of(const Refinement& refinement) {
  const PointRules& rules = refinement.rules;
  const LevelOrigins& origins = refinement.origins;
  return bytes_of(refinement.level) + sizeof(Refinement) - sizeof(Level) +
         array_bytes(rules.gap_faces, rules.adjusted_corner, rules.plain_share) + rows_bytes(rules.adjusted) +
         rows_bytes(rules.listed) +
         array_bytes(origins.own_corners.left_out(), origins.listed, origins.plain_vertices.left_out(),
                     origins.listed_faces);
}

}  // namespace croquis::subdivision
