// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "algorithms/remeshing/solids/signed_surface.h"
#include "croquis/implicit/field.h"
#include "croquis/implicit/marching_cubes.h"

namespace croquis::remeshing {

/// Several surfaces as one solid: the union of what they enclose, less the cavities of those that look inwards.
///
/// A cavity belongs to the smallest body that it lies in, and is taken out of that one alone. Cavities without a body
/// are all in one that is larger than everything. Surfaces with borders count as bodies that end there, or as cavities
/// where they look inwards in a body.
class UnitedSolid {
 public:
  /// @param members at least one; must outlive this @param cell the scale of what happens at borders, model units
  UnitedSolid(std::span<const std::unique_ptr<const SignedSurface>> members, double cell);

  struct Place {
    double value = 0;  ///< negative inside; the distance of the member that decides here, or less where that is far
    Vec3 gradient = Vec3::Zero();
    Index member = no_index;  ///< that decides here
  };
  Place at(const Vec3& place) const { return Walk(*this).at(place); }

  /// Answers for places that are near each other, fast: where a surface is far off, its side alone is kept.
  class Walk {
   public:
    explicit Walk(const UnitedSolid& solid)
        : solid_(solid), last_(solid.members_.size(), {Vec3::Zero(), std::numeric_limits<double>::infinity()}) {}
    Place at(const Vec3& place);

   private:
    /// Where a member was asked for last.
    struct Last {
      Vec3 place = Vec3::Zero();
      double distance = 0;  // signed, to the surface; infinite when it wasn't asked for yet
    };
    Place of_member(Index member, const Vec3& place, bool is_cavity);
    Place of_solid(std::size_t number, const Vec3& place);

    const UnitedSolid& solid_;
    std::vector<Last> last_;
    friend class UnitedSolid;
  };

  /// Of many places at once, on several threads.
  std::vector<Place> at(std::span<const Vec3> places, int threads, Progress& progress) const;

  /// This as a field. It must outlive what it returns.
  implicit::Field field() const;

  /// Where borders cut the field off: places on its surface where no member is. Empty when all are closed.
  implicit::Covered covered() const;

  implicit::Box box() const;

 private:
  struct Solid {
    Index body = no_index;  // none: all of space
    std::vector<Index> cavities;
  };

  bool lies_in(Index cavity, Index body) const;
  void assign_cavities(std::span<const Index> cavities);
  bool is_there(const Vec3& place, Walk& walk) const;

  std::span<const std::unique_ptr<const SignedSurface>> members_;
  double cell_;
  std::vector<Solid> solids_;
};

}  // namespace croquis::remeshing
