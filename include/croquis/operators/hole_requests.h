// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "croquis/base/parameter.h"
#include "croquis/geometry/vector.h"
#include "croquis/hole_filling/fill_holes.h"

/// The parameters of the operation `fill` that name holes: `select`, `only`, and `holes`, what is asked for single
/// holes, as text that people can write.
///
/// Requests are separated by ';', each is `HOLES: REQUEST, REQUEST…`. HOLES are numbers and ranges (`2`, `5-7`),
/// separated by ',', '+' or spaces. A REQUEST is one of
///
///     fill  leave  bridge  rbf  smooth  flat
///     kernel NAME   bulge NUMBER   trim RINGS   through X Y Z
///
/// such as `3: leave; 5-7: flat, bulge 0.4; 4: through 0.1 0.2 0.3; 2+9: bridge`. `through` may come several times.
namespace croquis {

using hole_filling::HoleRequest;

/// The words for a Fairness and a Kernel, and what they stand for: nothing for other words.
std::string_view name_of(hole_filling::Fairness fairness);
std::string_view name_of(implicit::Kernel kernel);
std::optional<hole_filling::Fairness> fairness_named(std::string_view name);
std::optional<implicit::Kernel> kernel_named(std::string_view name);

/// Ids of holes: numbers and ranges ("0,3-5"), separated by commas, semicolons or spaces. Ascending, each once.
/// @throws Error (E_PARAMETER) naming every part that is neither
std::vector<Index> parse_hole_ids(const std::string& text);

/// Linear in the text and the ids that it names.
/// @throws Error with one E_PARAMETER finding for every part that isn't as above, naming it
std::vector<HoleRequest> parse_hole_requests(const std::string& text);

/// Those that a value of the parameter `holes` stands for; what a program wrote isn't parsed again.
std::vector<HoleRequest> requests_in(const ParameterValue& value);

/// Which holes are filled, whatever their diameters, and what is asked for single ones.
struct FillChoice {
  hole_filling::Selection select = hole_filling::Selection::Inner;
  std::vector<Index> only;  ///< ids instead of a selection; empty for the selection
  std::vector<HoleRequest> requests;
};

/// The selection of that name: "inner", "all", "all-but-largest" or "none".
hole_filling::Selection parse_selection(std::string_view name);

/// What these parameters ask for. Requests that a program wrote aren't parsed again.
/// @param parameters complete (see croquis::complete)
/// @throws Error (E_PARAMETER) for ids or requests that can't be parsed
FillChoice read_fill_choice(const ParameterValues& parameters);

/// The parameters that ask for it.
ParameterValues to_parameters(const FillChoice& choice);

/// The text that parse_hole_requests turns back into the same requests. One without holes, or that asks for nothing
/// about them, is left out: it has no text.
/// @param requests of finite numbers, within their ranges
std::string to_text(std::span<const HoleRequest> requests);

}  // namespace croquis
