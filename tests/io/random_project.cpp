// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/random_project.h"

#include <array>
#include <bit>
#include <cmath>
#include <limits>

#include <Eigen/Geometry>

#include "croquis/document/backdrop.h"
#include "croquis/document/content_hash.h"
#include "support/meshes/mesh_shapes.h"

namespace croquis::test {
namespace {

double random_number(Random& random) {
  static constexpr std::array<double, 8> special = {0.0,
                                                    -0.0,
                                                    std::numeric_limits<double>::infinity(),
                                                    -std::numeric_limits<double>::infinity(),
                                                    std::numeric_limits<double>::quiet_NaN(),
                                                    std::numeric_limits<double>::denorm_min(),
                                                    0.1,
                                                    1e300};
  const std::uint32_t kind = random.below(16);
  if (kind < special.size()) return special[kind];
  return kind < 12 ? random.between(-10, 10) : std::bit_cast<double>(random.bits());
}

std::map<std::string, std::string> random_texts(Random& random) {
  std::map<std::string, std::string> texts;
  for (std::uint32_t i = random.below(3); i > 0; --i) texts[random_text(random)] = random_text(random);
  return texts;
}

Stroke random_stroke(Random& random) {
  Stroke stroke;
  stroke.id = random_text(random);
  stroke.closed = random.below(2) == 0;
  stroke.object = random_text(random);
  stroke.data = random_texts(random);
  if (random.below(2) == 0) stroke.line = static_cast<std::int64_t>(random.bits());
  for (std::uint32_t i = 1 + random.below(30); i > 0; --i) {
    StrokeSample sample;
    for (double* value : {&sample.position.x(), &sample.position.y(), &sample.pressure, &sample.tilt.x(),
                          &sample.tilt.y(), &sample.time}) {
      *value = random_number(random);
    }
    stroke.samples.push_back(sample);
  }
  return stroke;
}

template <typename T>
std::vector<T> random_values(Random& random, std::size_t count) {
  std::vector<T> values(count);
  for (T& value : values) {
    if constexpr (std::is_same_v<T, double>) {
      value = random_number(random);
    } else {
      value = static_cast<T>(random.below(1000));
    }
  }
  return values;
}

AttributeChannel random_channel(Random& random, const PolyMesh& mesh) {
  AttributeChannel channel;
  channel.name = random_text(random);
  channel.domain = static_cast<Domain>(random.below(5));
  channel.width = static_cast<int>(1 + random.below(4));
  const std::size_t count = mesh.element_count(channel.domain) * static_cast<std::size_t>(channel.width);
  switch (random.below(8)) {
    case 0: channel.data = random_values<std::int8_t>(random, count); break;
    case 1: channel.data = random_values<std::uint8_t>(random, count); break;
    case 2: channel.data = random_values<std::int16_t>(random, count); break;
    case 3: channel.data = random_values<std::uint16_t>(random, count); break;
    case 4: channel.data = random_values<std::int32_t>(random, count); break;
    case 5: channel.data = random_values<std::uint32_t>(random, count); break;
    case 6: channel.data = random_values<float>(random, count); break;
    default: channel.data = random_values<double>(random, count);
  }
  for (std::uint32_t i = random.below(3); i > 0; --i) channel.labels.push_back(random_text(random));
  return channel;
}

Report random_tree(Random& random, int depth) {
  switch (random.below(depth > 4 ? 5 : 7)) {
    case 0: return {};
    case 1: return random.below(2) == 0;
    case 2: return static_cast<std::int64_t>(random.bits());
    case 3: return random_number(random);
    case 4: return random_text(random);
    case 5: {
      Report list = Report::array();
      for (std::uint32_t i = random.below(4); i > 0; --i) list.push(random_tree(random, depth + 1));
      return list;
    }
    default: {
      Report object = Report::object();
      for (std::uint32_t i = random.below(4); i > 0; --i)
        object.set(random_text(random), random_tree(random, depth + 1));
      return object;
    }
  }
}

PictureFile random_picture(Random& random) {
  return {"bytes" + random_text(random), static_cast<int>(1 + random.below(5000)),
          static_cast<int>(1 + random.below(5000)), random_text(random)};
}

Value random_value(Random& random) {
  switch (random.below(9)) {
    case 0: return std::make_shared<const PolyMesh>(random_mesh(random));
    case 5: return std::make_shared<const Brep>(random_brep(random));
    case 6: return std::make_shared<const AttributeNetwork>(random_attribute_network(random));
    case 1: return std::make_shared<const Camera>(random_camera(random));
    case 2: return std::make_shared<const PerspectiveDrawing>(random_perspective_drawing(random));
    case 3: return std::make_shared<const CurveNetwork>(random_network(random));
    case 4: return std::make_shared<const Drawing>(random_drawing(random));
    case 7: return std::make_shared<const PictureFile>(random_picture(random));
    default: return std::make_shared<const Report>(random_report(random));
  }
}

// Of vertices that may or may not be there.
MeshTags random_tags(Random& random) {
  const auto edge = [&] {
    const Index a = random.below(30);
    return std::array<Index, 2>{a, random.below(30)};
  };
  MeshTags tags;
  for (std::uint32_t i = random.below(6); i > 0; --i) tags.creases.push_back({edge(), random_number(random)});
  for (std::uint32_t i = random.below(4); i > 0; --i) tags.pins.push_back(random.below(30));
  for (std::uint32_t i = random.below(3); i > 0; --i) {
    CreaseSet set{random_text(random), random_number(random), {}, {}};
    for (std::uint32_t k = random.below(4); k > 0; --k) set.edges.push_back(edge());
    for (std::uint32_t k = random.below(4); k > 0; --k) set.pins.push_back(random.below(30));
    tags.sets.push_back(std::move(set));
  }
  return tags;
}

ParameterValue random_parameter(Random& random) {
  switch (random.below(4)) {
    case 0: return random.below(2) == 0;
    case 1: return static_cast<std::int64_t>(random.bits());
    case 2: return random_number(random);
    default: return random_text(random);
  }
}

Node random_node(Random& random, const Document& document) {
  Node node;
  node.name = random_text(random);
  node.visible = random.below(2) == 0;
  node.version = static_cast<int>(random.below(5)) - 1;
  if (random.below(4) == 0) {
    for (double& number : node.transform.linear.reshaped()) number = random.between(-10, 10);
    for (double& coordinate : node.transform.offset) coordinate = random.between(-10, 10);
  }
  node.enabled = random.below(4) != 0;
  if (random.below(4) == 0) {
    for (double& number : node.placement.position) number = random.between(-10, 10);
    for (double& number : node.placement.rotation) number = random.between(-360, 360);
    for (double& number : node.placement.scale) number = random.between(0.1, 10);
  }
  if (random.below(4) == 0) node.group = random_text(random);
  if (document.nodes().empty() || random.below(2) == 0) {
    node.source = random_value(random);
    if (random.below(4) == 0) {
      node.backdrop = std::make_shared<const Backdrop>(
          Backdrop{std::make_shared<const PictureFile>(random_picture(random)),
                   Vec2(random.between(-10, 10), random.between(-10, 10)), random.between(0.1, 10),
                   random.between(0, 1), random.below(2) == 0});
    }
    return node;
  }
  node.operation = "operation-" + std::to_string(random.below(3));
  for (std::uint32_t i = random.below(6); i > 0; --i) node.parameters[random_text(random)] = random_parameter(random);
  for (std::uint32_t i = random.below(3); i > 0; --i) {
    const auto& nodes = document.nodes();
    node.inputs[random_text(random)] = {nodes[random.below(static_cast<std::uint32_t>(nodes.size()))]->id,
                                        random_text(random)};
  }
  return node;
}

}  // namespace

std::string random_text(Random& random) {
  std::string text(random.below(random.below(20) == 0 ? 300 : 8), '\0');
  const bool plain = random.below(2) == 0;
  for (char& c : text) c = static_cast<char>(plain ? 'a' + random.below(26) : random.below(256));
  return text;
}

PolyMesh random_mesh(Random& random) {
  PolyMesh mesh = random.below(2) == 0 ? random_soup(random.bits(), random.below(20)) : grid(1 + random.below(4), 3);
  for (Vec3& position : mesh.positions) {
    if (random.below(4) == 0) position.x() = random_number(random);
  }
  if (mesh.vertex_count() > 1 && random.below(2) == 0) mesh.add_line(std::array<Index, 2>{0, 1});
  for (std::uint32_t i = random.below(4); i > 0; --i) mesh.channels.push_back(random_channel(random, mesh));
  if (random.below(2) == 0) mesh.tags = random_tags(random);
  return mesh;
}

Drawing random_drawing(Random& random) {
  Drawing drawing;
  drawing.file = random_text(random);
  if (random.below(3) == 0)
    drawing.plane = {Vec3(random_number(random) > 0 ? 1 : -2, 0.5, 3), Vec3(0, 0.6, 0.8), Vec3(-1, 0, 0)};
  for (std::uint32_t i = random.below(5); i > 0; --i) drawing.strokes.push_back(random_stroke(random));
  for (std::uint32_t i = random.below(3); i > 0; --i) drawing.object_data[random_text(random)] = random_texts(random);
  return drawing;
}

Report random_report(Random& random) { return random_tree(random, 0); }

Camera random_camera(Random& random) {
  Camera camera;
  camera.focal_length = random.between(1, 5000);
  camera.principal_point = {random.between(-900, 900), random.between(-900, 900)};
  camera.eye = {random.between(-9, 9), random.between(-9, 9), random.between(-9, 9)};
  camera.rotation = Eigen::AngleAxisd(random.between(-3, 3), Vec3(2, 3, 6) / 7).toRotationMatrix();
  camera.image_size = {random.between(0, 2000), random.between(0, 2000)};
  if (random.below(2) == 0) camera.image_origin = {random.between(-900, 900), random.between(-900, 900)};
  return camera;
}

PerspectiveDrawing random_perspective_drawing(Random& random) {
  PerspectiveDrawing drawing;
  drawing.file = random_text(random);
  drawing.origin = {random.between(-9, 9), random.between(-9, 9)};
  drawing.image_size = {random.between(1, 2000), random.between(1, 2000)};
  if (random.below(2) == 0) drawing.known_point = KnownPoint{drawing.origin, Vec3(1, random.unit(), 3)};
  if (random.below(2) == 0) drawing.known_lengths = {{random_text(random), random.between(0.1, 9)}};
  if (random.below(2) == 0) drawing.field_of_view = random.between(0.1, 3);
  if (random.below(2) == 0) drawing.principal_point = Vec2(random.unit(), 7);
  if (random.below(2) == 0) drawing.shells = 1 + static_cast<int>(random.below(5));
  drawing.unit = random_text(random);
  for (std::uint32_t i = 0, count = random.below(6); i < count; ++i) {
    PerspectiveStroke stroke;
    stroke.id = std::to_string(i) + random_text(random);
    stroke.role = static_cast<StrokeRole>(random.below(2));
    stroke.group = static_cast<StrokeGroup>(random.below(7));
    stroke.colour = random_text(random);
    stroke.straight = random.below(2) == 0;
    for (std::uint32_t k = stroke.straight ? 1 : 1 + random.below(3); k > 0; --k) {
      PictureCubic piece;
      for (Vec2& point : piece) point = {random_number(random), random_number(random)};
      if (!stroke.pieces.empty()) piece[0] = stroke.end();
      stroke.pieces.push_back(piece);
    }
    stroke.from = random_text(random);
    stroke.to = random_text(random);
    stroke.link = random.below(2) == 0;
    stroke.start_lock = static_cast<EndLock>(random.below(3));
    stroke.end_lock = static_cast<EndLock>(random.below(3));
    stroke.hidden = random.below(2) == 0;
    stroke.weight = random.between(0.1, 3);
    if (random.below(2) == 0) stroke.line = static_cast<std::int64_t>(random.bits());
    drawing.strokes.push_back(std::move(stroke));
  }
  return drawing;
}

CurveNetwork random_network(Random& random) {
  const auto point = [&] { return Vec3(random.between(-9, 9), random.between(-9, 9), random.between(-9, 9)); };
  CurveNetwork network;
  for (std::uint32_t i = 1 + random.below(5); i > 0; --i) network.vertices.push_back(point());
  const auto vertex = [&] { return random.below(static_cast<std::uint32_t>(network.vertices.size())); };
  for (std::uint32_t i = 0, count = random.below(6); i < count; ++i) {
    NetworkCurve curve{std::to_string(i) + random_text(random), vertex(), vertex(), {}, random.below(2) == 0};
    Vec3 start = network.vertices[curve.start];
    for (std::uint32_t k = curve.straight ? 1 : 1 + random.below(3); k > 0; --k) {
      RationalCubic piece{{start, point(), point(), k == 1 ? network.vertices[curve.end] : point()}};
      for (double& weight : piece.weights) weight = random.between(0.1, 3);
      start = piece.points[3];
      curve.pieces.push_back(piece);
    }
    network.curves.push_back(std::move(curve));
  }
  return network;
}

namespace {

Vec3 random_point(Random& random) { return {random.between(-9, 9), random.between(-9, 9), random.between(-9, 9)}; }

RationalCubic random_cubic(Random& random) {
  RationalCubic cubic;
  for (Vec3& point : cubic.points) point = random_point(random);
  for (double& weight : cubic.weights) weight = random.between(0.1, 3);
  return cubic;
}

}  // namespace

Brep random_brep(Random& random) {
  Brep brep;
  const Index pillows = random.below(3);
  for (Index k = 0; k < pillows; ++k) {  // each two faces of two sides
    for (int i = 0; i < 2; ++i) brep.vertices.push_back({random_point(random), random.below(9)});
    for (const Index e : {2 * k, 2 * k + 1}) {
      const Index h = 4 * k + e % 2;
      brep.edges.push_back({random_text(random),
                            random.below(9),
                            2 * k,
                            2 * k + 1,
                            {random_cubic(random), random_cubic(random)},
                            {random_cubic(random)},
                            random.below(2) == 0,
                            {h, h + 2},
                            random.below(2) == 0,
                            {random_point(random), random_point(random)}});
    }
    brep.half_edges.push_back({2 * k, false, 2 * k, 4 * k + 3});
    brep.half_edges.push_back({2 * k + 1, false, 2 * k + 1, 4 * k + 2});
    brep.half_edges.push_back({2 * k, true, 2 * k + 1, 4 * k + 1});
    brep.half_edges.push_back({2 * k + 1, true, 2 * k, 4 * k});
    for (const Index f : {2 * k, 2 * k + 1}) {
      brep.loops.push_back({f, 4 * k + f % 2});
      BrepFace face{
          k, random.below(9), {f}, random.below(2) == 0, random_point(random), Vec3(2, 3, 6) / 7, random.unit(), {}};
      if (!face.planar) face.patches.resize(2);
      for (GregoryPatch& patch : face.patches) {
        for (Vec3& point : patch.boundary) point = random_point(random);
        for (Vec3& point : patch.inner) point = random_point(random);
      }
      brep.faces.push_back(std::move(face));
    }
    brep.shells.push_back({{2 * k, 2 * k + 1}, true, random.below(2) == 0});
  }
  return brep;
}

AttributeNetwork random_attribute_network(Random& random) {
  const auto maybe = [&](double value) { return random.below(2) == 0 ? std::optional(value) : std::nullopt; };
  AttributeNetwork network;
  network.name = random_text(random);
  network.units = random_text(random);
  network.tolerance = maybe(1e-4);
  const Index nodes = 2 + random.below(4), curves = 2 + random.below(5), faces = 1 + random.below(3);
  for (Index i = 0; i < nodes; ++i) network.nodes.push_back({"n" + std::to_string(i), random_point(random)});
  for (Index i = 0; i < curves; ++i) {
    AttributeCurve curve{"c" + std::to_string(i), random.below(nodes), random.below(nodes), {}, CurveJoin::Smooth};
    if (random.below(2) == 0) curve.join = CurveJoin::Crease;
    if (random.below(3) == 0) curve.from = curve.to = no_index;
    const std::uint32_t least = curve.from == no_index ? 2 : 0;
    std::uint32_t points = least + random.below(6);
    for (points += points == 1 ? 1 : 0; points > 0; --points) curve.control.push_back(random_point(random));
    network.curves.push_back(std::move(curve));
  }
  for (Index i = 0; i < faces; ++i) {
    AttributeFace face{"f" + std::to_string(i),
                       {},
                       static_cast<AttributeMode>(random.below(3)),
                       random.between(-1, 2),
                       static_cast<AttributeDomain>(random.below(2)),
                       {}};
    for (Index c = 0; c < curves; ++c) {
      if (c < 2 || random.below(2) == 0) face.loop.push_back({c, random.below(2) == 0});
    }
    if (random.below(2) == 0)
      face.inner.push_back({random.below(curves), static_cast<InnerProfile>(random.below(2)), maybe(0.5)});
    network.faces.push_back(std::move(face));
  }
  for (std::uint32_t i = random.below(3); i > 0; --i) {
    PointAttribute point{"p" + std::to_string(i),
                         random.below(faces),
                         random_point(random),
                         {},
                         maybe(0.3),
                         static_cast<PointProfile>(random.below(2)),
                         {}};
    if (random.below(2) == 0) point.fan = FanPlace{random.below(2), random.unit(), random.unit()};
    if (random.below(2) == 0) point.normal = random_point(random);
    network.points.push_back(std::move(point));
  }
  if (random.below(2) == 0)
    network.slopes.push_back({random.below(curves),
                              random.below(2) == 0 ? no_index : random.below(faces),
                              {0, random.unit()},
                              {random_point(random), random_point(random)},
                              random.unit()});
  return network;
}

Document random_document(Random& random, std::uint32_t nodes) {
  Document document;
  for (std::uint32_t i = 0; i < nodes; ++i) {
    Node node = random_node(random, document);
    // Some share their contents with another.
    for (const auto& other : document.nodes()) {
      if (node.source && other->source && random.below(8) == 0) node.source = other->source;
    }
    document = document.with(std::move(node));
    if (random.below(6) == 0)
      document =
          document.without(document.nodes()[random.below(static_cast<std::uint32_t>(document.nodes().size()))]->id);
  }
  return document;
}

std::string difference(const Document& a, const Document& b) {
  if (a.next_id() != b.next_id()) return "next ids differ";
  if (a.nodes().size() != b.nodes().size()) return "one has more nodes";
  for (std::size_t i = 0; i < a.nodes().size(); ++i) {
    const Node &one = *a.nodes()[i], &other = *b.nodes()[i];
    const std::string name = "node " + std::to_string(one.id) + ": ";
    if (one.name != other.name) return name + "names differ";
    if (one.placement != other.placement || one.group != other.group) return name + "its place or group differs";
    // Every other field counts in the hash (tests/document/test_content_hash.cpp).
    if (content_hash(Document().with(one)) != content_hash(Document().with(other))) return name + "contents differ";
  }
  return "";
}

}  // namespace croquis::test
