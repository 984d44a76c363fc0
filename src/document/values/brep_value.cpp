// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "croquis/base/limits.h"
#include "croquis/geometry/brep.h"
#include "document/content_size.h"
#include "document/values/rational_bytes.h"
#include "document/values/value_row.h"
#include "document/values/vector_bytes.h"

namespace croquis {
namespace {

constexpr std::uint32_t brep_layout = 1;
constexpr double largest_normal_error = 1e-9;  // of stored unit normals

// The fewest bytes that an element takes: counts are checked with it.
constexpr std::size_t brep_vertex_bytes = 3 * sizeof(double) + sizeof(Index);
constexpr std::size_t least_brep_edge_bytes = 3 * sizeof(std::uint64_t) + 5 * sizeof(Index) + 6 * sizeof(double) + 2;
constexpr std::size_t brep_half_edge_bytes = 3 * sizeof(Index) + 1;
constexpr std::size_t brep_loop_bytes = 2 * sizeof(Index);
constexpr std::size_t patch_bytes = 60 * sizeof(double);
constexpr std::size_t least_brep_face_bytes = 2 * sizeof(std::uint64_t) + 2 * sizeof(Index) + 7 * sizeof(double) + 1;
constexpr std::size_t least_brep_shell_bytes = sizeof(std::uint64_t) + 2;

void write_brep_edge(const BrepEdge& edge, ByteWriter& writer) {
  writer.text(edge.id);
  writer.number(edge.curve);
  writer.number(edge.start);
  writer.number(edge.end);
  write_rationals(edge.pieces, writer);
  write_rationals(edge.fitted, writer);
  writer.flag(edge.straight);
  for (const Index half_edge : edge.half_edges) writer.number(half_edge);
  writer.flag(edge.smooth);
  for (const Vec3& across : edge.across) write_numbers(across, writer);
}

BrepEdge read_brep_edge(ByteReader& reader) {
  BrepEdge edge;
  edge.id = reader.text();
  edge.curve = reader.number<Index>();
  edge.start = reader.number<Index>();
  edge.end = reader.number<Index>();
  edge.pieces = read_rationals(reader);
  edge.fitted = read_rationals(reader);
  edge.straight = reader.flag();
  for (Index& half_edge : edge.half_edges) half_edge = reader.number<Index>();
  edge.smooth = reader.flag();
  for (Vec3& across : edge.across) across = read_usable<Vec3>(reader);
  return edge;
}

void write_brep_face(const BrepFace& face, ByteWriter& writer) {
  writer.number(face.shell);
  writer.number(face.outline);
  writer.numbers(face.loops);
  writer.flag(face.planar);
  write_numbers(face.origin, writer);
  write_numbers(face.normal, writer);
  writer.number(face.flatness);
  writer.count(face.patches.size());
  for (const GregoryPatch& patch : face.patches) {
    for (const Vec3& point : patch.boundary) write_numbers(point, writer);
    for (const Vec3& point : patch.inner) write_numbers(point, writer);
  }
}

BrepFace read_brep_face(ByteReader& reader) {
  BrepFace face;
  face.shell = reader.number<Index>();
  face.outline = reader.number<Index>();
  face.loops = reader.numbers<Index>();
  face.planar = reader.flag();
  face.origin = read_usable<Vec3>(reader);
  face.normal = read_usable<Vec3>(reader);
  if (face.planar && std::abs(face.normal.norm() - 1) > largest_normal_error)
    throw BadBytes("a face's normal is not of length 1");
  face.flatness = reader.number<double>();
  if (!(face.flatness >= 0 && is_usable_number(face.flatness))) throw BadBytes("a face's flatness is not a distance");
  face.patches.resize(reader.count(patch_bytes));
  for (GregoryPatch& patch : face.patches) {
    for (Vec3& point : patch.boundary) point = read_usable<Vec3>(reader);
    for (Vec3& point : patch.inner) point = read_usable<Vec3>(reader);
  }
  return face;
}

void hash_brep_edge(const BrepEdge& edge, ContentHasher& hasher) {
  hasher.add(edge.id);
  hasher.add(edge.curve);
  hasher.add(edge.start);
  hasher.add(edge.end);
  hash_rationals(edge.pieces, hasher);
  hash_rationals(edge.fitted, hasher);
  hasher.add(edge.straight);
  for (const Index half_edge : edge.half_edges) hasher.add(half_edge);
  hasher.add(edge.smooth);
  for (const Vec3& across : edge.across) hash_numbers(across, hasher);
}

void hash_brep_face(const BrepFace& face, ContentHasher& hasher) {
  hasher.add(face.shell);
  hasher.add(face.outline);
  hasher.add(std::span<const std::uint32_t>(face.loops));
  hasher.add(face.planar);
  hash_numbers(face.origin, hasher);
  hash_numbers(face.normal, hasher);
  hasher.add(face.flatness);
  hasher.add(face.patches.size());
  for (const GregoryPatch& patch : face.patches) {
    for (const Vec3& point : patch.boundary) hash_numbers(point, hasher);
    for (const Vec3& point : patch.inner) hash_numbers(point, hasher);
  }
}

/// What bounds a solid: faces with exact curves and patches.
struct BrepValue {
  using Content = Brep;
  static constexpr const char* name = "B-rep";
  static constexpr std::uint64_t tag = 6;

  static void add_content(const Brep& brep, ContentHasher& hasher) {
    hasher.add(brep.vertices.size());
    for (const BrepVertex& vertex : brep.vertices) {
      hash_numbers(vertex.point, hasher);
      hasher.add(vertex.network_vertex);
    }
    hasher.add(brep.edges.size());
    for (const BrepEdge& edge : brep.edges) hash_brep_edge(edge, hasher);
    hasher.add(brep.half_edges.size());
    for (const BrepHalfEdge& half : brep.half_edges) {
      hasher.add(half.edge);
      hasher.add(half.reversed);
      hasher.add(half.loop);
      hasher.add(half.next);
    }
    hasher.add(brep.loops.size());
    for (const BrepLoop& loop : brep.loops) {
      hasher.add(loop.face);
      hasher.add(loop.first);
    }
    hasher.add(brep.faces.size());
    for (const BrepFace& face : brep.faces) hash_brep_face(face, hasher);
    hasher.add(brep.shells.size());
    for (const BrepShell& shell : brep.shells) {
      hasher.add(std::span<const std::uint32_t>(shell.faces));
      hasher.add(shell.closed);
      hasher.add(shell.is_void);
    }
  }

  static std::size_t byte_size(const Brep& brep) {
    std::size_t bytes = sizeof(Brep) + size_of(brep.vertices) + size_of(brep.edges) + size_of(brep.half_edges) +
                        size_of(brep.loops) + size_of(brep.faces) + size_of(brep.shells);
    for (const BrepEdge& edge : brep.edges) bytes += edge.id.capacity() + size_of(edge.pieces) + size_of(edge.fitted);
    for (const BrepFace& face : brep.faces) bytes += size_of(face.loops) + size_of(face.patches);
    for (const BrepShell& shell : brep.shells) bytes += size_of(shell.faces);
    return bytes;
  }

  static void store(const Brep& brep, ByteWriter& writer) {
    writer.number(brep_layout);
    writer.count(brep.vertices.size());
    for (const BrepVertex& vertex : brep.vertices) {
      write_numbers(vertex.point, writer);
      writer.number(vertex.network_vertex);
    }
    writer.count(brep.edges.size());
    for (const BrepEdge& edge : brep.edges) write_brep_edge(edge, writer);
    writer.count(brep.half_edges.size());
    for (const BrepHalfEdge& half : brep.half_edges) {
      writer.number(half.edge);
      writer.flag(half.reversed);
      writer.number(half.loop);
      writer.number(half.next);
    }
    writer.count(brep.loops.size());
    for (const BrepLoop& loop : brep.loops) {
      writer.number(loop.face);
      writer.number(loop.first);
    }
    writer.count(brep.faces.size());
    for (const BrepFace& face : brep.faces) write_brep_face(face, writer);
    writer.count(brep.shells.size());
    for (const BrepShell& shell : brep.shells) {
      writer.numbers(shell.faces);
      writer.flag(shell.closed);
      writer.flag(shell.is_void);
    }
  }

  static Brep load(ByteReader& reader) {
    read_layout(reader, brep_layout);
    Brep brep;
    brep.vertices.resize(reader.count(brep_vertex_bytes));
    for (BrepVertex& vertex : brep.vertices) {
      vertex.point = read_usable<Vec3>(reader);
      vertex.network_vertex = reader.number<Index>();
    }
    for (std::size_t left = reader.count(least_brep_edge_bytes); left > 0; --left)
      brep.edges.push_back(read_brep_edge(reader));
    brep.half_edges.resize(reader.count(brep_half_edge_bytes));
    for (BrepHalfEdge& half : brep.half_edges) {
      half.edge = reader.number<Index>();
      half.reversed = reader.flag();
      half.loop = reader.number<Index>();
      half.next = reader.number<Index>();
    }
    brep.loops.resize(reader.count(brep_loop_bytes));
    for (BrepLoop& loop : brep.loops) {
      loop.face = reader.number<Index>();
      loop.first = reader.number<Index>();
    }
    for (std::size_t left = reader.count(least_brep_face_bytes); left > 0; --left)
      brep.faces.push_back(read_brep_face(reader));
    for (std::size_t left = reader.count(least_brep_shell_bytes); left > 0; --left) {
      BrepShell shell;
      shell.faces = reader.numbers<Index>();
      shell.closed = reader.flag();
      shell.is_void = reader.flag();
      brep.shells.push_back(std::move(shell));
    }
    if (const Findings wrong = validate(brep); !wrong.empty()) throw BadBytes(wrong.front().message);
    return brep;
  }
};

}  // namespace

constinit const ValueTraits ValueTraits::Brep = value_row<BrepValue>();

}  // namespace croquis
