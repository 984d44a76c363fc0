// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "croquis/base/parameter.h"
#include "croquis/geometry/vector.h"
#include "croquis/hole_filling/fill_holes.h"

/// The parameters of the operation `fill` that name holes: `select`, `only`, and `holes`, what is wanted of single
/// holes, as text that people can write.
///
/// Wishes are separated by ';', each is `HOLES: WISH, WISH…`. HOLES are numbers and ranges (`2`, `5-7`), separated by
/// ',', '+' or spaces. A WISH is one of
///
///     fill  leave  bridge  rbf  smooth  flat
///     kernel NAME   bulge NUMBER   trim RINGS   through X Y Z
///
/// such as `3: leave; 5-7: flat, bulge 0.4; 4: through 0.1 0.2 0.3; 2+9: bridge`. `through` may come several times.
namespace croquis {

/// What one of them asks for. Empty or absent: not asked for, the parameters for all holes count.
struct HoleWish {
  std::vector<Index> holes = {};              ///< ids, in the order written
  bool bridge = false;                        ///< one patch joins these rims, two or more, as a band
  std::optional<bool> fill = {};              ///< false for `leave`; any other wish but `trim` fills the hole too
  std::string fairness = {};                  ///< "", "rbf", "smooth" or "flat"
  std::string kernel = {};                    ///< "" or one of the choices of the parameter `kernel`
  std::optional<double> bulge = {};           ///< -1..1
  std::optional<std::int64_t> trim_rim = {};  ///< 0..3 rings of faces
  std::vector<Vec3> through = {};             ///< places that the patch goes through, model units

  friend bool operator==(const HoleWish&, const HoleWish&) = default;
};

/// Ids of holes: numbers and ranges ("0,3-5"), separated by commas, semicolons or spaces. Ascending, each once.
/// @throws Error (E_PARAMETER) naming every part that is neither
std::vector<Index> parse_hole_ids(const std::string& text);

/// Linear in the text and the ids that it names.
/// @throws Error with one E_PARAMETER finding for every part that isn't as above, naming it
std::vector<HoleWish> parse_hole_wishes(const std::string& text);

/// Those that a value of the parameter `holes` stands for; what a program wrote isn't parsed again.
std::vector<HoleWish> wishes_in(const ParameterValue& value);

/// Which holes are filled, whatever their diameters, and what is wanted of single ones.
struct FillChoice {
  hole_filling::Selection select = hole_filling::Selection::Inner;
  std::vector<Index> only;  ///< ids instead of a selection; empty for the selection
  std::vector<HoleWish> wishes;
};

/// The selection of that name: "inner", "all", "all-but-largest" or "none".
hole_filling::Selection parse_selection(std::string_view name);

/// What these parameters ask for. Wishes that a program wrote aren't parsed again.
/// @param parameters complete (see croquis::complete)
/// @throws Error (E_PARAMETER) for ids or wishes that can't be parsed
FillChoice read_fill_choice(const ParameterValues& parameters);

/// The parameters that ask for it.
ParameterValues to_parameters(const FillChoice& choice);

/// The text that parse_hole_wishes turns back into the same wishes. A wish without holes, or that asks for nothing
/// about them, is left out: it has no text.
/// @param wishes of finite numbers, within their ranges
std::string to_text(std::span<const HoleWish> wishes);

}  // namespace croquis
