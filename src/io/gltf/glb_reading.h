// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

#include "croquis/base/report.h"
#include "io/read_context.h"

/// The parts of GLB files, as they are read.
namespace croquis {

/// The two parts of a GLB file (Khronos glTF 2.0, section 4.4), as views into it.
struct GlbContainer {
  std::string_view json;
  std::string_view binary;  ///< empty when there is none
};

/// @throws Error E_SYNTAX when the bytes are no GLB of version 2, E_TRUNCATED when they end before its chunks do
GlbContainer open_glb(std::string_view bytes, ReadContext& context);

/// What glTF calls one of its elements in sentences: accessor 3.
std::string gltf_element(const char* kind, std::size_t index);

/// Reads members of glTF's JSON and reports what is wrong with them.
class GltfDocument {
 public:
  /// @throws Error E_SYNTAX when it isn't JSON, no object, or of another version than 2
  GltfDocument(std::string_view json, ReadContext& context);

  ReadContext& context() const { return context_; }
  const Report& root() const { return root_; }

  /// How many elements a list of the root has; 0 when there is none.
  std::size_t count(const char* list) const;

  /// An object. @throws Error E_INDEX when there is no such element, E_SYNTAX when it is something else
  const Report& element(const char* list, std::size_t index, const std::string& user) const;

  /// A whole number that isn't negative. @throws Error E_SYNTAX when it is something else
  std::optional<std::size_t> index(const Report& object, const char* member, const std::string& owner) const;
  std::size_t index_or(const Report& object, const char* member, std::size_t otherwise, const std::string& owner) const;

  /// The numbers of a list, as many as asked for; nothing when the member is missing. @throws Error E_SYNTAX
  std::optional<std::vector<double>> numbers(const Report& object, const char* member, std::size_t count,
                                             const std::string& owner) const;

  /// Whole numbers that aren't negative, as many as there are. @throws Error E_SYNTAX
  std::vector<std::size_t> indices(const Report& object, const char* member, const std::string& owner) const;

  /// Empty when it is missing or no text.
  static std::string text(const Report& object, const char* member);

  [[noreturn]] void fail(const char* code, const std::string& message) const;

 private:
  ReadContext& context_;
  Report root_;
};

/// The numbers of an accessor; normalized integers become parts of 1.
struct GltfNumbers {
  std::vector<double> values;  ///< components of each element in turn
  std::size_t components = 1;
  bool parts_of_255 = false;  ///< bytes that stand for 0..1

  std::size_t count() const { return values.size() / components; }
};

/// Reads accessors (Khronos glTF 2.0, section 3.6.2): any stride and component type, normalized or not, sparse or not.
/// Every place is compared with its view and buffer before it is read.
class GltfAccessors {
 public:
  /// @param binary what buffer 0 lies in
  GltfAccessors(const GltfDocument& document, std::string_view binary);

  /// How many elements it claims to have, before anything is read. @throws Error E_INDEX, E_SYNTAX
  std::size_t count(std::size_t accessor, const std::string& user) const;

  /// @param most_components 1 for indices, 3 for positions …: what has more or fewer than asked for is refused
  /// @throws Error E_INDEX, E_SYNTAX, E_COUNT (more than there is room for)
  GltfNumbers read(std::size_t accessor, std::size_t least_components, std::size_t most_components,
                   const std::string& user) const;

  /// Of an accessor of whole numbers.
  std::vector<std::size_t> read_indices(std::size_t accessor, const std::string& user) const;

 private:
  struct Layout;
  struct ComponentType;

  ComponentType component_type(const Report& owner, const std::string& name) const;
  std::string_view buffer(std::size_t index, const std::string& user) const;
  std::string_view view_bytes(std::size_t view, std::size_t offset, const std::string& user, std::size_t& stride) const;
  Layout layout_of(const Report& owner, std::size_t view, std::size_t count, const ComponentType& type,
                   std::size_t components, const std::string& name) const;
  void add_sparse(const Report& sparse, const ComponentType& type, const std::string& name, GltfNumbers& numbers) const;

  const GltfDocument& document_;
  std::string_view binary_;
};

/// A node with a mesh, and where it lies.
struct GlbInstance {
  std::size_t node = 0;
  std::size_t mesh = 0;
  Eigen::Matrix4d transform = Eigen::Matrix4d::Identity();
};

/// All of a model's, parents before children, else in the order of their numbers. Linear in the number of nodes.
/// @throws Error E_SYNTAX when a node is reached twice or is its own descendant, E_INDEX
std::vector<GlbInstance> glb_instances(const GltfDocument& document);

}  // namespace croquis
