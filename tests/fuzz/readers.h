// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "croquis/geometry/perspective_drawing.h"
#include "croquis/geometry/poly_mesh.h"

/// What must hold for any bytes that a reader of files is given: one table for the fuzzers, damaged and kept inputs.
namespace croquis::test {

/// What became of the bytes that a reader was given.
struct ReaderVerdict {
  std::string broken;  ///< what did not hold; empty when all did
  bool refused = false;
};

/// Reading either throws an Error whose findings have codes and sentences, or gives content that keeps the rules of its
/// type and comes back the same when it is written and read again, as far as the format can hold it.
struct FuzzedReader {
  std::string name;                         ///< of the fuzzer, and of its folders in corpus and regressions
  std::string (*broken)(std::string_view);  ///< what did not hold of what was read; may throw the reader's Error
  std::size_t most_findings;
  bool names_file;      ///< every finding names the file
  bool only_malformed;  ///< every finding is of what is malformed

  ReaderVerdict verdict_on(std::string_view bytes) const;
};

/// All of them. Those of meshes have the names of their formats; "value" is a value in a project file, whose first byte
/// chooses the type.
const std::vector<FuzzedReader>& fuzzed_readers();

/// The one of that name, which must be there.
const FuzzedReader& fuzzed_reader(std::string_view name);

/// Faces and lines are the same.
bool same_connectivity(const PolyMesh& a, const PolyMesh& b);

/// The same tags in the same order; NaN equals itself.
bool same_tags(const MeshTags& a, const MeshTags& b);

/// Equality of all that files hold (not of file and lines); numbers that are not finite equal each other.
bool same_drawing(const PerspectiveDrawing& a, const PerspectiveDrawing& b);

}  // namespace croquis::test
