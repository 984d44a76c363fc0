// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "croquis/document/document.h"

/// What is no part of a document but lies beside it in files, so that people find what they had.
namespace croquis {

/// What nobody can compute again: of a step that doesn't fit what it is given now, and of the steps after it.
struct KeptResult {
  Value result;  ///< what it gave last to the next step; may be empty
  Value edited;  ///< of a step of edits: the mesh that they were made for; may be empty

  friend bool operator==(const KeptResult&, const KeptResult&) = default;
};

/// By node.
using KeptResults = std::map<NodeId, KeptResult>;

/// A document that undo leads back to.
struct PastDocument {
  std::string label;  ///< of what was done then
  Document document;
};

/// A document that people keep under a name, to come back to it.
struct Version {
  std::string name;
  Document document;
  std::vector<std::uint8_t> picture_png = {};  ///< small; may be empty
};

struct KeptWork {
  KeptResults results = {};
  std::vector<PastDocument> past = {};  ///< the oldest first
  std::vector<Version> versions = {};   ///< in the order they were saved
};

}  // namespace croquis
