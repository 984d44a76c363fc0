// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/gltf/glb_nodes.h"

#include <algorithm>

#include <Eigen/Geometry>

namespace croquis {
namespace {

Eigen::Matrix4d transform_of_node(const GltfDocument& document, const Report& node, const std::string& name) {
  if (const auto matrix = document.numbers(node, "matrix", 16, name)) {
    return Eigen::Map<const Eigen::Matrix4d>(matrix->data());  // column by column, as Eigen's
  }
  Eigen::Affine3d transform = Eigen::Affine3d::Identity();
  if (const auto move = document.numbers(node, "translation", 3, name)) {
    transform.translate(Eigen::Vector3d((*move)[0], (*move)[1], (*move)[2]));
  }
  if (const auto turn = document.numbers(node, "rotation", 4, name)) {
    const Eigen::Quaterniond rotation((*turn)[3], (*turn)[0], (*turn)[1], (*turn)[2]);
    if (rotation.norm() > 0) transform.rotate(rotation.normalized());
  }
  if (const auto scale = document.numbers(node, "scale", 3, name)) {
    transform.scale(Eigen::Vector3d((*scale)[0], (*scale)[1], (*scale)[2]));
  }
  return transform.matrix();
}

class NodeWalk {
 public:
  explicit NodeWalk(const GltfDocument& document)
      : document_(document), is_child_(document.count("nodes"), false), reached_(is_child_.size(), false) {}

  std::vector<GlbInstance> walk() {
    for (std::size_t n = 0; n < is_child_.size(); ++n) note_children(n);
    for (std::size_t n = 0; n < is_child_.size(); ++n) {
      if (!is_child_[n]) walk_from(n);
    }
    const auto missed = std::find(reached_.begin(), reached_.end(), false);
    if (missed != reached_.end()) {
      const auto node = static_cast<std::size_t>(missed - reached_.begin());
      document_.fail("E_SYNTAX", gltf_element("node", node) + " is its own descendant");
    }
    return std::move(instances_);
  }

 private:
  std::vector<std::size_t> children_of(std::size_t node) const {
    const std::string name = gltf_element("node", node);
    return document_.indices(document_.element("nodes", node, name), "children", name);
  }

  void note_children(std::size_t node) {
    for (const std::size_t child : children_of(node)) {
      document_.element("nodes", child, gltf_element("node", node));
      if (is_child_[child]) document_.fail("E_SYNTAX", gltf_element("node", child) + " has two parents");
      is_child_[child] = true;
    }
  }

  void walk_from(std::size_t root) {
    std::vector<GlbInstance> waiting{{root, 0, Eigen::Matrix4d::Identity()}};
    while (!waiting.empty()) {
      GlbInstance here = waiting.back();
      waiting.pop_back();
      reached_[here.node] = true;
      const std::string name = gltf_element("node", here.node);
      const Report& node = document_.element("nodes", here.node, name);
      here.transform = here.transform * transform_of_node(document_, node, name);
      if (const auto mesh = document_.index(node, "mesh", name)) {
        here.mesh = *mesh;
        instances_.push_back(here);
      }
      const std::vector<std::size_t> children = children_of(here.node);
      for (auto child = children.rbegin(); child != children.rend(); ++child) {
        waiting.push_back({*child, 0, here.transform});
      }
    }
  }

  const GltfDocument& document_;
  std::vector<bool> is_child_;
  std::vector<bool> reached_;
  std::vector<GlbInstance> instances_;
};

}  // namespace

std::vector<GlbInstance> glb_instances(const GltfDocument& document) { return NodeWalk(document).walk(); }

}  // namespace croquis
