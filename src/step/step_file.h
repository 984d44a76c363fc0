// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "croquis/base/progress.h"
#include "croquis/geometry/brep.h"
#include "croquis/perspective/bicubic_fit.h"

/// STEP files (ISO 10303-21, schema AP214) of solids, for CAD programs. OpenCASCADE writes them; programs can be built
/// without it.
namespace croquis {

/// What a model unit of the file is.
enum class LengthUnit : std::uint8_t { Millimetre, Centimetre, Metre, Inch };

/// "mm", "cm", "m" or "inch" ("in"); nothing for other words.
std::optional<LengthUnit> length_unit_named(std::string_view word);

/// Whether a path ends in .step or .stp, in letters of either case.
bool is_step_path(std::string_view path);

struct StepOptions {
  std::string name = "solid";  ///< of the product
  LengthUnit unit = LengthUnit::Millimetre;
  std::vector<std::string> face_names;  ///< of the B-rep's faces; may be empty
  BicubicFitOptions fit;
};

struct StepFile {
  std::string bytes;
  std::size_t faces = 0;  ///< as written: a face of n patches is n faces
  std::size_t edges = 0;
  double error = 0;  ///< model units: greatest distance of a written surface from its patch
};

/// Why this program can't write STEP files, as a sentence that says what to install; empty where it can.
std::string why_no_step();

/// A closed shell becomes a manifold solid, with its voids; open shells stay surfaces. Planes, lines and rational
/// curves are exact; Gregory patches are bicubic B-spline surfaces within the fit's tolerance. Edges next to patches
/// are the cubics that the patches were spanned from. Edges have the names of their strokes. The same solid gives the
/// same bytes.
/// @throws Error (E_NO_STEP, Category::Usage: built without OpenCASCADE; E_STEP_FILE: no faces, or it refuses the
/// solid), Cancelled
StepFile write_step(const Brep& brep, const StepOptions& options, Progress& progress);

}  // namespace croquis
