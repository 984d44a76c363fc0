// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "io/gltf/gltf_document.h"

namespace croquis {

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

}  // namespace croquis
