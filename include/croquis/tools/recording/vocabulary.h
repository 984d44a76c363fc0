// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "croquis/tools/recording/step.h"

namespace croquis::recorded {

/// What a recording may hold: kinds of steps, and the names of what `expect` counts and measures. Each tool has its
/// own; a host adds them up.
class Vocabulary {
 public:
  /// @param kind outlives this
  /// @throws Error (Category::Internal) when another kind has the same verb and mark
  void add(const StepKind& kind);
  void add_count(const std::string& name) { counts_.push_back(name); }
  void add_range(const std::string& name) { ranges_.push_back(name); }
  void add(const Vocabulary& other);  ///< @throws Error as above

  const std::vector<const StepKind*>& kinds() const { return kinds_; }
  const std::vector<std::string>& counts() const { return counts_; }  ///< "faces": so many
  const std::vector<std::string>& ranges() const { return ranges_; }  ///< "dihedral": from a number to a number

  /// The kind of a line. @throws Mistake
  const StepKind& kind_of(Fields& fields) const;

 private:
  std::vector<const StepKind*> kinds_;
  std::vector<std::string> counts_;
  std::vector<std::string> ranges_;
};

/// The vocabulary of a tool.
template <StepValue... Steps>
Vocabulary vocabulary_of(const std::vector<std::string>& counts, const std::vector<std::string>& ranges = {}) {
  Vocabulary made;
  (made.add(step_kind<Steps>()), ...);
  for (const std::string& count : counts) made.add_count(count);
  for (const std::string& range : ranges) made.add_range(range);
  return made;
}

}  // namespace croquis::recorded
