// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/geometry/attribute_network.h"
#include "document/values/member_bytes.h"

namespace croquis {

inline auto members(const AttributeNode& node) { return std::tie(node.id, node.point); }
static_assert(lists_every_member<AttributeNode>);

inline auto members(const AttributeCurve& curve) {
  return std::tie(curve.id, curve.from, curve.to, curve.control, curve.join);
}
static_assert(lists_every_member<AttributeCurve>);

inline auto members(const AttributeSide& side) { return std::tie(side.curve, side.reversed); }
static_assert(lists_every_member<AttributeSide>);

inline auto members(const InnerCurve& inner) {
  const auto& [curve, profile, radius] = inner;
  return std::tie(curve, profile, radius);
}

inline auto members(const AttributeFace& face) {
  return std::tie(face.id, face.loop, face.mode, face.fullness, face.domain, face.inner);
}
static_assert(lists_every_member<AttributeFace>);

inline auto members(const FanPlace& fan) { return std::tie(fan.corner, fan.a, fan.b); }
static_assert(lists_every_member<FanPlace>);

inline auto members(const PointAttribute& attribute) {
  const auto& [id, face, point, fan, radius, profile, normal] = attribute;
  return std::tie(id, face, point, fan, radius, profile, normal);
}

inline auto members(const SlopeAttribute& slope) {
  return std::tie(slope.curve, slope.face, slope.at, slope.normals, slope.magnitude);
}
static_assert(lists_every_member<SlopeAttribute>);

inline auto members(const AttributeNetwork& network) {
  const auto& [name, units, tolerance, nodes, curves, faces, points, slopes] = network;
  return std::tie(name, units, tolerance, nodes, curves, faces, points, slopes);
}

constexpr CurveJoin last_of(CurveJoin) { return CurveJoin::Smooth; }
constexpr AttributeMode last_of(AttributeMode) { return AttributeMode::Paper; }
constexpr AttributeDomain last_of(AttributeDomain) { return AttributeDomain::Uniform; }
constexpr PointProfile last_of(PointProfile) { return PointProfile::Cone; }
constexpr InnerProfile last_of(InnerProfile) { return InnerProfile::Sharp; }

inline void require_valid(const AttributeNetwork& network) {
  if (const Findings wrong = validate(network); !wrong.empty()) throw BadBytes(wrong.front().message);
}

namespace {

/// Curves, points and slopes that surfaces are made from.
struct AttributeNetworkValue : ListedValue<AttributeNetwork> {
  static constexpr const char* name = "attribute network";
  static constexpr std::uint64_t tag = 7;
};

}  // namespace

constinit const ValueTraits ValueTraits::AttributeNetwork = value_row<AttributeNetworkValue>();

}  // namespace croquis
