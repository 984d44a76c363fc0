// SPDX-License-Identifier: GPL-3.0-or-later
#include <set>

#include "croquis/geometry/curve_network.h"
#include "document/content_size.h"
#include "document/values/rational_bytes.h"
#include "document/values/value_row.h"
#include "document/values/vector_bytes.h"

namespace croquis {
namespace {

constexpr std::uint32_t network_layout = 1;

// The fewest bytes that an element takes: counts are checked with it.
constexpr std::size_t vertex_bytes = 3 * sizeof(double);
constexpr std::size_t least_curve_bytes = 2 * sizeof(std::uint64_t) + 2 * sizeof(Index) + 1;

void write_curve(const NetworkCurve& curve, ByteWriter& writer) {
  writer.text(curve.id);
  writer.number(curve.start);
  writer.number(curve.end);
  writer.flag(curve.straight);
  write_rationals(curve.pieces, writer);
}

void require_curve(const NetworkCurve& curve, const std::vector<Vec3>& vertices) {
  if (curve.start >= vertices.size() || curve.end >= vertices.size()) throw BadBytes("a curve's vertex is not there");
  if (curve.pieces.empty() || (curve.straight && curve.pieces.size() > 1)) throw BadBytes("a curve has no pieces");
  Vec3 end = vertices[curve.start];
  for (const RationalCubic& piece : curve.pieces) {
    if (piece.points[0] != end) throw BadBytes("a curve's piece begins elsewhere");
    end = piece.points[3];
  }
  if (end != vertices[curve.end]) throw BadBytes("a curve ends elsewhere");
}

NetworkCurve read_curve(ByteReader& reader, const std::vector<Vec3>& vertices) {
  NetworkCurve curve;
  curve.id = reader.text();
  curve.start = reader.number<Index>();
  curve.end = reader.number<Index>();
  curve.straight = reader.flag();
  curve.pieces = read_rationals(reader);
  require_curve(curve, vertices);
  return curve;
}

void hash_curve(const NetworkCurve& curve, ContentHasher& hasher) {
  hasher.add(curve.id);
  hasher.add(curve.start);
  hasher.add(curve.end);
  hasher.add(curve.straight);
  hash_rationals(curve.pieces, hasher);
}

/// Curves in space that meet at vertices.
struct CurveNetworkValue {
  using Content = CurveNetwork;
  static constexpr const char* name = "curve network";
  static constexpr std::uint64_t tag = 5;

  static void add_content(const CurveNetwork& network, ContentHasher& hasher) {
    hasher.add(network.vertices.size());
    for (const Vec3& vertex : network.vertices) hash_numbers(vertex, hasher);
    hasher.add(network.curves.size());
    for (const NetworkCurve& curve : network.curves) hash_curve(curve, hasher);
  }

  static std::size_t byte_size(const CurveNetwork& network) {
    std::size_t bytes = sizeof(CurveNetwork) + size_of(network.vertices) + size_of(network.curves);
    for (const NetworkCurve& curve : network.curves) bytes += curve.id.capacity() + size_of(curve.pieces);
    return bytes;
  }

  static void store(const CurveNetwork& network, ByteWriter& writer) {
    writer.number(network_layout);
    writer.count(network.vertices.size());
    for (const Vec3& vertex : network.vertices) write_numbers(vertex, writer);
    writer.count(network.curves.size());
    for (const NetworkCurve& curve : network.curves) write_curve(curve, writer);
  }

  static CurveNetwork load(ByteReader& reader) {
    read_layout(reader, network_layout);
    CurveNetwork network;
    network.vertices.resize(reader.count(vertex_bytes));
    for (Vec3& vertex : network.vertices) vertex = read_usable<Vec3>(reader);
    std::set<std::string> ids;
    for (std::size_t left = reader.count(least_curve_bytes); left > 0; --left) {
      network.curves.push_back(read_curve(reader, network.vertices));
      if (!ids.insert(network.curves.back().id).second) throw BadBytes("two curves have one name");
    }
    return network;
  }
};

}  // namespace

constinit const ValueTraits ValueTraits::CurveNetwork = value_row<CurveNetworkValue>();

}  // namespace croquis
