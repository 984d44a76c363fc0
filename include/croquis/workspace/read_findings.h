// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "croquis/base/finding.h"
#include "croquis/document/content_hash.h"
#include "croquis/document/document.h"

namespace croquis {

/// What was found in the files that a document was read from.
///
/// What is said about strokes is true of them as they were read: it is no longer reported once they are changed or
/// deleted, and reported again when that is undone. Strokes that reading left out of the drawing can't be changed. For
/// one thread.
class ReadFindings {
 public:
  /// @param read the document when it was read, with all that the file brought
  void add(const Findings& findings, const Document& read);

  void clear() { findings_.clear(); }

  /// Those that are true of the document as it is now, in the order they were added.
  /// O(#strokes log #findings + samples of the strokes that are named)
  Findings in(const Document& now) const;

 private:
  /// Of strokes with all that they have, by the drawing's node and the stroke's id.
  using StrokeHashes = std::map<std::pair<NodeId, std::string>, ContentHash>;

  struct ReadFinding {
    Finding finding;
    StrokeHashes strokes;  ///< that it names, as they were read
  };

  static StrokeHashes hashes_of(const Document& document, const std::vector<std::string>& names);

  std::vector<ReadFinding> findings_;
};

}  // namespace croquis
