// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/operators/part_roles.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <Eigen/Geometry>

namespace croquis {
namespace {

struct PartShape {
  Eigen::AlignedBox2d box;
  double area = 0;     ///< of what its lines surround, times a factor that is the same for all
  double stretch = 1;  ///< how many times as long as wide
  PartRole role = PartRole::None;
  std::map<std::size_t, Vec2> joints;  ///< with other parts, and where

  Vec2 middle() const { return box.center(); }
};

/// From how its lines are spread about their middle: they needn't be closed.
PartShape shape_of(const Drawing& drawing, const InflatedObject& object) {
  PartShape shape;
  double length = 0;
  Vec2 sum = Vec2::Zero();
  Eigen::Matrix2d squares = Eigen::Matrix2d::Zero();
  for (const Stroke& stroke : drawing.strokes) {
    if (std::ranges::count(object.strokes, stroke.id) == 0) continue;
    for (std::size_t i = 0; i < stroke.samples.size(); ++i) {
      const Vec2& at = stroke.samples[i].position;
      shape.box.extend(at);
      if (i == 0) continue;
      const Vec2& before = stroke.samples[i - 1].position;
      const double part = (at - before).norm();
      const Vec2 middle = (at + before) / 2;
      length += part;
      sum += part * middle;
      squares += part * middle * middle.transpose();
    }
  }
  if (length == 0) return shape;
  const Vec2 middle = sum / length;
  const Eigen::Matrix2d spread = squares / length - middle * middle.transpose();
  const double mean = spread.trace() / 2;
  const double gap = std::sqrt(std::max(0.0, mean * mean - spread.determinant()));
  shape.area = std::sqrt(std::max(0.0, spread.determinant()));
  shape.stretch = std::sqrt((mean + gap) / std::max(mean - gap, 1e-12 * mean));
  return shape;
}

std::vector<PartShape> shapes_of(const Drawing& drawing, const InflateResult& inflated) {
  std::vector<PartShape> shapes;
  std::map<std::string, std::size_t> place;
  for (const InflatedObject& object : inflated.objects) {
    place[object.name] = shapes.size();
    shapes.push_back(shape_of(drawing, object));
  }
  const auto join = [&](const std::string& a, const std::string& b, const Vec2& at) {
    if (!place.contains(a) || !place.contains(b)) return;
    shapes[place[a]].joints[place[b]] = at;
    shapes[place[b]].joints[place[a]] = at;
  };
  for (const SuggestedJoint& pair : inflated.suggested) join(pair.a, pair.b, pair.at);
  for (const silhouette::SolidAttachment& pair : inflated.attached) join(pair.a, pair.b, pair.at);
  return shapes;
}

/// The largest of the parts that something grows out of.
PartShape* find_body(std::vector<PartShape>& shapes) {
  PartShape* body = nullptr;
  for (PartShape& shape : shapes) {
    if (!shape.joints.empty() && (body == nullptr || shape.area > body->area)) body = &shape;
  }
  return body;
}

/// The largest compact part at the body that reaches past it, and not downwards.
PartShape* find_head(std::vector<PartShape>& shapes, const PartShape& body) {
  PartShape* head = nullptr;
  for (const auto& [place, at] : body.joints) {
    PartShape& shape = shapes[place];
    const bool reaches_out = !body.box.contains(shape.middle()) || shape.middle().y() > body.middle().y();
    const bool hangs = shape.box.max().y() < body.middle().y();
    if (shape.stretch > 2.2 || !reaches_out || hangs || shape.area < 0.04 * body.area) continue;
    if (head == nullptr || shape.area > head->area) head = &shape;
  }
  return head;
}

/// What else grows out of the body, by where it goes.
void name_limbs(std::vector<PartShape>& shapes, const PartShape& body, const PartShape* head) {
  const bool upright = body.box.sizes().y() > 0.9 * body.box.sizes().x();
  std::vector<PartShape*> others;
  for (const auto& [place, at] : body.joints) {
    PartShape& shape = shapes[place];
    if (shape.role != PartRole::None || shape.area > 0.4 * body.area) continue;
    const bool reaches_below = shape.box.min().y() < body.box.min().y() - 0.05 * body.box.sizes().y();
    if (reaches_below && shape.middle().y() < body.middle().y())
      shape.role = PartRole::Leg;
    else if (shape.stretch >= 1.8)
      others.push_back(&shape);
  }
  if (upright && others.size() == 2) {
    for (PartShape* arm : others) arm->role = PartRole::Arm;
  } else if (others.size() == 1 && head != nullptr) {
    const double towards_head = head->middle().x() - body.middle().x();
    const bool is_behind = towards_head * (others[0]->middle().x() - body.middle().x()) < 0;
    if (is_behind && !upright) others[0]->role = PartRole::Tail;
  }
}

/// Ears grow out of a head's upper half, noses and beaks sideways; eyes lie within it.
void name_face(std::vector<PartShape>& shapes, const PartShape& head) {
  for (const auto& [place, at] : head.joints) {
    PartShape& shape = shapes[place];
    if (shape.role != PartRole::None || shape.area > 0.6 * head.area) continue;
    const bool beside = shape.middle().x() < head.box.min().x() || shape.middle().x() > head.box.max().x();
    const bool grows_up = at.y() > head.middle().y() && (!beside || shape.middle().y() > head.box.max().y());
    if (grows_up && !head.box.contains(shape.box)) shape.role = PartRole::Ear;
  }
  for (PartShape& shape : shapes) {
    const bool is_small = shape.area < 0.08 * head.area && shape.stretch < 2;
    if (shape.role == PartRole::None && is_small && head.box.contains(shape.box)) shape.role = PartRole::Eye;
  }
}

}  // namespace

std::vector<PartPlace> part_roles(const Drawing& drawing, const InflateResult& inflated) {
  std::vector<PartShape> shapes = shapes_of(drawing, inflated);
  if (PartShape* body = find_body(shapes); body != nullptr) {
    body->role = PartRole::Body;
    PartShape* head = find_head(shapes, *body);
    if (head != nullptr) head->role = PartRole::Head;
    name_limbs(shapes, *body, head);
    if (head != nullptr) name_face(shapes, *head);
  }
  std::vector<PartPlace> places;
  for (const PartShape& shape : shapes) places.push_back({shape.role, shape.middle()});
  return places;
}

}  // namespace croquis
