// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/geometry/attribute_network.h"
#include "document/content_size.h"
#include "document/values/value_row.h"
#include "document/values/vector_bytes.h"

namespace croquis {
namespace {

constexpr std::uint32_t attribute_network_layout = 1;

// The fewest bytes that an element takes: counts are checked with it.
constexpr std::size_t place_bytes = 3 * sizeof(double);
constexpr std::size_t least_node_bytes = sizeof(std::uint64_t) + place_bytes;
constexpr std::size_t least_attribute_curve_bytes = 2 * sizeof(std::uint64_t) + 2 * sizeof(Index) + 1;
constexpr std::size_t side_bytes = sizeof(Index) + 1;
constexpr std::size_t least_inner_bytes = sizeof(Index) + 2;
constexpr std::size_t least_attribute_face_bytes = 3 * sizeof(std::uint64_t) + sizeof(double) + 2;
constexpr std::size_t least_point_bytes = sizeof(std::uint64_t) + sizeof(Index) + place_bytes + 4;
constexpr std::size_t least_slope_bytes = 2 * sizeof(std::uint64_t) + 2 * sizeof(Index) + sizeof(double);

/// Writes and hashes take the same path through the elements: what is stored counts, and the other way round.
class ByteSink {
 public:
  explicit ByteSink(ByteWriter& writer) : writer_(writer) {}
  void text(const std::string& value) { writer_.text(value); }
  void count(std::size_t value) { writer_.count(value); }
  void index(Index value) { writer_.number(value); }
  void flag(bool value) { writer_.flag(value); }
  void kind(std::uint8_t value) { writer_.number(value); }
  void number(double value) { writer_.number(value); }

 private:
  ByteWriter& writer_;
};

class HashSink {
 public:
  explicit HashSink(ContentHasher& hasher) : hasher_(hasher) {}
  void text(const std::string& value) { hasher_.add(value); }
  void count(std::size_t value) { hasher_.add(value); }
  void index(Index value) { hasher_.add(value); }
  void flag(bool value) { hasher_.add(value); }
  void kind(std::uint8_t value) { hasher_.add(value); }
  void number(double value) { hasher_.add(value); }

 private:
  ContentHasher& hasher_;
};

template <class Sink>
void put_place(const Vec3& place, Sink& sink) {
  for (const double value : place) sink.number(value);
}

template <class Sink>
void put_number(const std::optional<double>& number, Sink& sink) {
  sink.flag(number.has_value());
  if (number) sink.number(*number);
}

template <class Enum, class Sink>
void put_kind(Enum kind, Sink& sink) {
  sink.kind(static_cast<std::uint8_t>(kind));
}

template <class Sink>
void put_curve(const AttributeCurve& curve, Sink& sink) {
  sink.text(curve.id);
  sink.index(curve.from);
  sink.index(curve.to);
  sink.count(curve.control.size());
  for (const Vec3& point : curve.control) put_place(point, sink);
  put_kind(curve.join, sink);
}

template <class Sink>
void put_face(const AttributeFace& face, Sink& sink) {
  sink.text(face.id);
  sink.count(face.loop.size());
  for (const AttributeSide& side : face.loop) {
    sink.index(side.curve);
    sink.flag(side.reversed);
  }
  put_kind(face.mode, sink);
  sink.number(face.fullness);
  put_kind(face.domain, sink);
  sink.count(face.inner.size());
  for (const InnerCurve& inner : face.inner) {
    sink.index(inner.curve);
    put_kind(inner.profile, sink);
    put_number(inner.radius, sink);
  }
}

template <class Sink>
void put_point(const PointAttribute& point, Sink& sink) {
  sink.text(point.id);
  sink.index(point.face);
  put_place(point.point, sink);
  sink.flag(point.fan.has_value());
  if (point.fan) {
    sink.count(point.fan->corner);
    sink.number(point.fan->a);
    sink.number(point.fan->b);
  }
  put_number(point.radius, sink);
  put_kind(point.profile, sink);
  sink.flag(point.normal.has_value());
  if (point.normal) put_place(*point.normal, sink);
}

template <class Sink>
void put_slope(const SlopeAttribute& slope, Sink& sink) {
  sink.index(slope.curve);
  sink.index(slope.face);
  sink.count(slope.at.size());
  for (const double at : slope.at) sink.number(at);
  sink.count(slope.normals.size());
  for (const Vec3& normal : slope.normals) put_place(normal, sink);
  sink.number(slope.magnitude);
}

template <class Sink>
void put_network(const AttributeNetwork& network, Sink& sink) {
  sink.text(network.name);
  sink.text(network.units);
  put_number(network.tolerance, sink);
  sink.count(network.nodes.size());
  for (const AttributeNode& node : network.nodes) {
    sink.text(node.id);
    put_place(node.point, sink);
  }
  sink.count(network.curves.size());
  for (const AttributeCurve& curve : network.curves) put_curve(curve, sink);
  sink.count(network.faces.size());
  for (const AttributeFace& face : network.faces) put_face(face, sink);
  sink.count(network.points.size());
  for (const PointAttribute& point : network.points) put_point(point, sink);
  sink.count(network.slopes.size());
  for (const SlopeAttribute& slope : network.slopes) put_slope(slope, sink);
}

template <class Enum>
Enum read_attribute_kind(ByteReader& reader, Enum last) {
  const auto number = reader.number<std::uint8_t>();
  if (number > static_cast<std::uint8_t>(last)) throw BadBytes("a join, mode, domain or profile is not known");
  return static_cast<Enum>(number);
}

std::optional<double> read_optional_number(ByteReader& reader) {
  if (!reader.flag()) return std::nullopt;
  return reader.number<double>();
}

AttributeCurve read_attribute_curve(ByteReader& reader) {
  AttributeCurve curve;
  curve.id = reader.text();
  curve.from = reader.number<Index>();
  curve.to = reader.number<Index>();
  curve.control.resize(reader.count(place_bytes));
  for (Vec3& point : curve.control) point = read_usable<Vec3>(reader);
  curve.join = read_attribute_kind(reader, CurveJoin::Smooth);
  return curve;
}

AttributeFace read_attribute_face(ByteReader& reader) {
  AttributeFace face;
  face.id = reader.text();
  face.loop.resize(reader.count(side_bytes));
  for (AttributeSide& side : face.loop) {
    side.curve = reader.number<Index>();
    side.reversed = reader.flag();
  }
  face.mode = read_attribute_kind(reader, AttributeMode::Paper);
  face.fullness = reader.number<double>();
  face.domain = read_attribute_kind(reader, AttributeDomain::Uniform);
  face.inner.resize(reader.count(least_inner_bytes));
  for (InnerCurve& inner : face.inner) {
    inner.curve = reader.number<Index>();
    inner.profile = read_attribute_kind(reader, InnerProfile::Sharp);
    inner.radius = read_optional_number(reader);
  }
  return face;
}

PointAttribute read_point_attribute(ByteReader& reader) {
  PointAttribute point;
  point.id = reader.text();
  point.face = reader.number<Index>();
  point.point = read_usable<Vec3>(reader);
  if (reader.flag()) {
    FanPlace fan;
    fan.corner = reader.number<std::uint64_t>();
    fan.a = reader.number<double>();
    fan.b = reader.number<double>();
    point.fan = fan;
  }
  point.radius = read_optional_number(reader);
  point.profile = read_attribute_kind(reader, PointProfile::Cone);
  if (reader.flag()) point.normal = read_usable<Vec3>(reader);
  return point;
}

SlopeAttribute read_slope_attribute(ByteReader& reader) {
  SlopeAttribute slope;
  slope.curve = reader.number<Index>();
  slope.face = reader.number<Index>();
  slope.at = reader.numbers<double>();
  slope.normals.resize(reader.count(place_bytes));
  for (Vec3& normal : slope.normals) normal = read_usable<Vec3>(reader);
  slope.magnitude = reader.number<double>();
  return slope;
}

/// Curves, points and slopes that surfaces are made from.
struct AttributeNetworkValue {
  using Content = AttributeNetwork;
  static constexpr const char* name = "attribute network";
  static constexpr std::uint64_t tag = 7;

  static void add_content(const AttributeNetwork& network, ContentHasher& hasher) {
    HashSink sink(hasher);
    put_network(network, sink);
  }

  static std::size_t byte_size(const AttributeNetwork& network) {
    std::size_t bytes = sizeof(AttributeNetwork) + network.name.capacity() + network.units.capacity() +
                        size_of(network.nodes) + size_of(network.curves) + size_of(network.faces) +
                        size_of(network.points) + size_of(network.slopes);
    for (const AttributeNode& node : network.nodes) bytes += node.id.capacity();
    for (const AttributeCurve& curve : network.curves) bytes += curve.id.capacity() + size_of(curve.control);
    for (const AttributeFace& face : network.faces)
      bytes += face.id.capacity() + size_of(face.loop) + size_of(face.inner);
    for (const PointAttribute& point : network.points) bytes += point.id.capacity();
    for (const SlopeAttribute& slope : network.slopes) bytes += size_of(slope.at) + size_of(slope.normals);
    return bytes;
  }

  static void store(const AttributeNetwork& network, ByteWriter& writer) {
    writer.number(attribute_network_layout);
    ByteSink sink(writer);
    put_network(network, sink);
  }

  static AttributeNetwork load(ByteReader& reader) {
    read_layout(reader, attribute_network_layout);
    AttributeNetwork network;
    network.name = reader.text();
    network.units = reader.text();
    network.tolerance = read_optional_number(reader);
    network.nodes.resize(reader.count(least_node_bytes));
    for (AttributeNode& node : network.nodes) {
      node.id = reader.text();
      node.point = read_usable<Vec3>(reader);
    }
    for (std::size_t left = reader.count(least_attribute_curve_bytes); left > 0; --left)
      network.curves.push_back(read_attribute_curve(reader));
    for (std::size_t left = reader.count(least_attribute_face_bytes); left > 0; --left)
      network.faces.push_back(read_attribute_face(reader));
    for (std::size_t left = reader.count(least_point_bytes); left > 0; --left)
      network.points.push_back(read_point_attribute(reader));
    for (std::size_t left = reader.count(least_slope_bytes); left > 0; --left)
      network.slopes.push_back(read_slope_attribute(reader));
    if (const Findings wrong = validate(network); !wrong.empty()) throw BadBytes(wrong.front().message);
    return network;
  }
};

}  // namespace

constinit const ValueTraits ValueTraits::AttributeNetwork = value_row<AttributeNetworkValue>();

}  // namespace croquis
