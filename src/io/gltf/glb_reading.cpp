// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/gltf/glb_reading.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>

#include <Eigen/Geometry>

#include "croquis/io/json.h"
#include "io/json/report_reader.h"
#include "io/little_endian.h"

namespace croquis {
namespace {

/// Indices and byte counts fit four bytes in any file that is read.
constexpr double largest_whole = 4294967295.0;

std::optional<double> any_number_of(const Report& report) {
  return is_number(&report) ? std::optional(report.as_number()) : std::nullopt;
}

std::optional<std::size_t> whole_of(const Report& report) {
  const std::optional<double> number = any_number_of(report);
  if (!number || *number < 0 || *number > largest_whole || std::floor(*number) != *number) return std::nullopt;
  return static_cast<std::size_t>(*number);
}

}  // namespace

std::string gltf_element(const char* kind, std::size_t index) {
  return std::string(kind) + " " + std::to_string(index);
}

GltfDocument::GltfDocument(std::string_view json, ReadContext& context)
    : context_(context),
      root_(read_json(json.substr(0, json.find_last_not_of(std::string_view(" \0", 2)) + 1), context.file_name())) {
  if (report_as<Report::Object>(&root_) == nullptr) fail("E_SYNTAX", "the model's description is no object");
  const Report* asset = member_of(root_, "asset");
  const std::string version = asset == nullptr ? "" : text(*asset, "version");
  if (!version.starts_with("2.")) fail("E_SYNTAX", "the model's description names no version 2 of glTF");
}

void GltfDocument::fail(const char* code, const std::string& message) const { context_.fail(code, message, {}); }

std::size_t GltfDocument::count(const char* list) const {
  const auto* elements = report_as<Report::Array>(member_of(root_, list));
  return elements == nullptr ? 0 : elements->size();
}

const Report& GltfDocument::element(const char* list, std::size_t index, const std::string& user) const {
  const auto* elements = report_as<Report::Array>(member_of(root_, list));
  const std::size_t held = elements == nullptr ? 0 : elements->size();
  if (index >= held) {
    fail("E_INDEX",
         user + " uses entry " + std::to_string(index) + " of '" + list + "', which has " + std::to_string(held));
  }
  const Report& found = (*elements)[index];
  if (report_as<Report::Object>(&found) == nullptr) {
    fail("E_SYNTAX", "entry " + std::to_string(index) + " of '" + list + "' is no object");
  }
  return found;
}

std::optional<std::size_t> GltfDocument::index(const Report& object, const char* member,
                                               const std::string& owner) const {
  const Report* value = member_of(object, member);
  if (value == nullptr) return std::nullopt;
  const std::optional<std::size_t> whole = whole_of(*value);
  if (!whole) fail("E_SYNTAX", "'" + std::string(member) + "' of " + owner + " is no whole number from 0");
  return whole;
}

std::size_t GltfDocument::index_or(const Report& object, const char* member, std::size_t otherwise,
                                   const std::string& owner) const {
  return index(object, member, owner).value_or(otherwise);
}

std::optional<std::vector<double>> GltfDocument::numbers(const Report& object, const char* member, std::size_t count,
                                                         const std::string& owner) const {
  const Report* value = member_of(object, member);
  if (value == nullptr) return std::nullopt;
  const auto* list = report_as<Report::Array>(value);
  std::vector<double> result;
  for (std::size_t i = 0; list != nullptr && list->size() == count && i < count; ++i) {
    if (const std::optional<double> number = any_number_of((*list)[i])) result.push_back(*number);
  }
  if (result.size() != count) {
    fail("E_SYNTAX",
         "'" + std::string(member) + "' of " + owner + " is no list of " + std::to_string(count) + " numbers");
  }
  return result;
}

std::vector<std::size_t> GltfDocument::indices(const Report& object, const char* member,
                                               const std::string& owner) const {
  const Report* value = member_of(object, member);
  if (value == nullptr) return {};
  std::vector<std::size_t> result;
  const auto* list = report_as<Report::Array>(value);
  const auto refuse = [&] {
    fail("E_SYNTAX", "'" + std::string(member) + "' of " + owner + " is no list of whole numbers from 0");
  };
  if (list == nullptr) refuse();
  for (const Report& entry : *list) {
    const std::optional<std::size_t> whole = whole_of(entry);
    if (!whole) refuse();
    result.push_back(*whole);
  }
  return result;
}

std::string GltfDocument::text(const Report& object, const char* member) {
  const auto* value = report_as<std::string>(member_of(object, member));
  return value == nullptr ? std::string() : *value;
}

namespace {

constexpr std::size_t glb_header_size = 12;  // magic, version, length
constexpr std::size_t chunk_header_size = 8;
constexpr std::uint32_t json_chunk = 0x4e4f534a;
constexpr std::uint32_t binary_chunk = 0x004e4942;

/// The chunk that begins at `at`, which moves to its end.
std::string_view next_chunk(std::string_view bytes, std::size_t& at, std::uint32_t& type, ReadContext& context) {
  if (bytes.size() - at < chunk_header_size) {
    context.fail("E_TRUNCATED", "the file ends within the header of a chunk", at_byte(at));
  }
  const std::size_t length = load_little_endian<std::uint32_t>(bytes.data() + at);
  type = load_little_endian<std::uint32_t>(bytes.data() + at + 4);
  const std::size_t begin = at + chunk_header_size;
  if (length > bytes.size() - begin) {
    context.fail("E_TRUNCATED",
                 "a chunk claims " + std::to_string(length) + " bytes, but only " +
                     std::to_string(bytes.size() - begin) + " follow",
                 at_byte(at));
  }
  at = begin + length;
  return bytes.substr(begin, length);
}

}  // namespace

GlbContainer open_glb(std::string_view bytes, ReadContext& context) {
  if (!bytes.starts_with("glTF")) context.fail("E_SYNTAX", "the file doesn't begin with 'glTF'", at_byte(0));
  if (bytes.size() < glb_header_size) context.fail("E_TRUNCATED", "the file ends within its header", at_byte(0));
  const auto version = load_little_endian<std::uint32_t>(bytes.data() + 4);
  if (version != 2) {
    context.fail("E_SYNTAX", "this is glTF version " + std::to_string(version) + ", and only version 2 is read",
                 at_byte(4));
  }
  const std::size_t length = load_little_endian<std::uint32_t>(bytes.data() + 8);
  if (length > bytes.size()) {
    context.fail(
        "E_TRUNCATED",
        "the header claims " + std::to_string(length) + " bytes, but the file has " + std::to_string(bytes.size()),
        at_byte(8));
  }
  if (length < bytes.size()) {
    context.warn("W_TRAILING", std::to_string(bytes.size() - length) + " bytes after the model were passed over",
                 at_byte(length));
  }
  bytes = bytes.substr(0, length);
  if (length < glb_header_size) context.fail("E_TRUNCATED", "the header claims less than itself", at_byte(8));

  GlbContainer container;
  std::size_t at = glb_header_size;
  std::uint32_t type = 0;
  container.json = next_chunk(bytes, at, type, context);
  if (type != json_chunk) context.fail("E_SYNTAX", "the first chunk isn't JSON", at_byte(glb_header_size));
  while (at < bytes.size() && container.binary.empty()) {
    const std::string_view chunk = next_chunk(bytes, at, type, context);
    if (type == binary_chunk) container.binary = chunk;  // others are extensions, to be passed over
  }
  return container;
}

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
