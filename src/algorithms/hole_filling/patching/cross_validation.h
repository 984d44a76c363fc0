// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "algorithms/hole_filling/patching/patcher.h"

namespace croquis::hole_filling {

/// How well methods repair what is known: discs of the surface beside a hole are hidden, filled again, and compared.
/// What is best there is a fair guess for the hole itself.
class CrossValidation {
 public:
  /// Chooses up to six discs around the site's rims, as far from one another as can be, each of half the hole's
  /// diameter at most, and makes a small mesh with that hole for each. Linear in the surface within a diameter.
  /// @throws Cancelled
  CrossValidation(const HoleSite& site, Progress& progress);

  /// None where the known surface is too small: then nothing can be measured.
  std::size_t probe_count() const { return probes_.size(); }

  /// Mean distance of hidden surface to what the method puts there, model units; infinite when there is no probe or it
  /// makes no patch for one. Costs one patch per probe.
  /// @throws Cancelled
  double error(const Patcher& patcher, Progress& progress) const;

  /// The same for each probe; NaN where the method makes no patch.
  std::vector<double> errors(const Patcher& patcher, Progress& progress) const;

 private:
  struct Probe {
    PolyMesh mesh;
    HoleAnalysis analysis;
    Index hole = 0;
    std::vector<Vec3> hidden;  ///< places on what was removed
  };

  double error_at(const Probe& probe, const Patcher& patcher, Progress& progress) const;

  PatchWish wish_;  ///< of the site, without bulge and places to go through: these are no guess about the surface
  std::vector<Probe> probes_;
};

}  // namespace croquis::hole_filling
