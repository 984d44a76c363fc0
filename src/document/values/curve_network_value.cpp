// SPDX-License-Identifier: GPL-3.0-or-later
#include <set>

#include "croquis/geometry/curve_network.h"
#include "document/values/rational_members.h"

namespace croquis {

inline auto members(const NetworkCurve& curve) {
  return std::tie(curve.id, curve.start, curve.end, curve.straight, curve.pieces);
}
static_assert(lists_every_member<NetworkCurve>);

inline auto members(const CurveNetwork& network) { return std::tie(network.vertices, network.curves); }
static_assert(lists_every_member<CurveNetwork>);

inline void require_valid(const CurveNetwork& network) {
  std::set<std::string> ids;
  for (const NetworkCurve& curve : network.curves) {
    if (curve.start >= network.vertices.size() || curve.end >= network.vertices.size())
      throw BadBytes("a curve's vertex is not there");
    if (curve.pieces.empty() || (curve.straight && curve.pieces.size() > 1)) throw BadBytes("a curve has no pieces");
    Vec3 end = network.vertices[curve.start];
    for (const RationalCubic& piece : curve.pieces) {
      if (piece.points[0] != end) throw BadBytes("a curve's piece begins elsewhere");
      end = piece.points[3];
    }
    if (end != network.vertices[curve.end]) throw BadBytes("a curve ends elsewhere");
    if (!ids.insert(curve.id).second) throw BadBytes("two curves have one name");
  }
}

namespace {

/// Curves in space that meet at vertices.
struct CurveNetworkValue : ListedValue<CurveNetwork> {
  static constexpr const char* name = "curve network";
  static constexpr std::uint64_t tag = 5;
};

}  // namespace

constinit const ValueTraits ValueTraits::CurveNetwork = value_row<CurveNetworkValue>();

}  // namespace croquis
