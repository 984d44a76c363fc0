// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <iomanip>
#include <string>
#include <vector>

#include <Eigen/Geometry>
#include <Eigen/SVD>

#include "bench/bench_surface.h"
#include "support/attribute_surface/exact_patches.h"
#include "support/attribute_surface/surfaces.h"

namespace croquis::bench {
namespace {

using namespace croquis::test;

constexpr int rings = 20;

/// How far a patch is from the surface it was cut from, relative to the diagonal of its curves' bounding box.
struct PatchError {
  double rms = 0;
  double max = 0;
  double anisotropy = 1;  ///< mean of the greatest stretch of the map over the least
};

double stretch_ratio(const SurfacePlace& place) {
  Eigen::Matrix<double, 3, 2> jacobian;
  jacobian << place.du, place.dv;
  const Eigen::JacobiSVD<Eigen::Matrix<double, 3, 2>> decomposition(jacobian);
  return decomposition.singularValues()[0] / std::max(1e-12, decomposition.singularValues()[1]);
}

PatchError error_of(const ExactPatch& patch, AttributeMode mode, AttributeDomain domain) {
  AttributeSurfaceOptions options;
  options.mode = mode;
  options.domain = domain;
  const FaceSurface face = first_surface(patch.network, options);
  const BoundingBox box = bounds_of(patch.network);
  PatchError error;
  double area = 0, squares = 0, stretches = 0, domain_area = 0;
  for (const DomainSample& sample : domain_samples(face.domain(), rings)) {
    const SurfacePlace place = face.evaluate(sample.place);
    const double off = (place.point - patch.nearest(place.point)).norm();
    const double piece = sample.area * place.du.cross(place.dv).norm();
    area += piece;
    squares += piece * off * off;
    error.max = std::max(error.max, off);
    domain_area += sample.area;
    stretches += sample.area * stretch_ratio(place);
  }
  const double size = ((*box)[1] - (*box)[0]).norm();
  error.rms = std::sqrt(squares / area) / size;
  error.max /= size;
  error.anisotropy = stretches / domain_area;
  return error;
}

const char* name_of(AttributeMode mode) {
  if (mode == AttributeMode::Paper) return "paper";
  return mode == AttributeMode::Position ? "position" : "smooth";
}

/// Errors of all patches of one mode, uniform and chordlength.
struct ModeErrors {
  std::vector<PatchError> uniform, chordlength;
};

ModeErrors errors_of(AttributeMode mode) {
  ModeErrors errors;
  for (const ExactPatch& patch : exact_patches()) {
    errors.uniform.push_back(error_of(patch, mode, AttributeDomain::Uniform));
    errors.chordlength.push_back(error_of(patch, mode, AttributeDomain::Chordlength));
  }
  return errors;
}

double mean_of(const std::vector<PatchError>& errors, double PatchError::*part) {
  std::vector<double> values;
  for (const PatchError& error : errors) values.push_back(error.*part);
  return geometric_mean(values);
}

void print_means(std::ostream& out, AttributeMode mode, const ModeErrors& errors) {
  const double uniform = mean_of(errors.uniform, &PatchError::rms);
  const double chordlength = mean_of(errors.chordlength, &PatchError::rms);
  std::size_t wins = 0;
  for (std::size_t i = 0; i < errors.uniform.size(); ++i) wins += errors.chordlength[i].rms < errors.uniform[i].rms;
  out << "| " << name_of(mode) << " | " << std::setprecision(3) << 100 * uniform << " | " << 100 * chordlength << " | "
      << std::setprecision(2) << chordlength / uniform << " | " << wins << " of " << errors.uniform.size() << " | "
      << mean_of(errors.chordlength, &PatchError::max) / mean_of(errors.uniform, &PatchError::max) << " | "
      << mean_of(errors.uniform, &PatchError::anisotropy) << " | "
      << mean_of(errors.chordlength, &PatchError::anisotropy) << " |\n";
}

}  // namespace

void bench_surface_domains(std::ostream& out) {
  constexpr AttributeMode modes[] = {AttributeMode::Paper, AttributeMode::Position, AttributeMode::Smooth};
  std::vector<ModeErrors> all;
  for (const AttributeMode mode : modes) all.push_back(errors_of(mode));

  out << "Patches cut from known surfaces, made again from their curves. Error: distance to the surface, root mean "
         "square over the area,\nin % of the diagonal; geometric means. Ratio: chordlength / uniform. Anisotropy: "
         "greatest over least stretch of the map.\n\n"
      << "| mode | uniform | chordlength | ratio | wins | ratio of maxima | anisotropy uniform | chordlength |\n"
      << "|---|---|---|---|---|---|---|---|\n"
      << std::fixed;
  for (std::size_t m = 0; m < all.size(); ++m) print_means(out, modes[m], all[m]);

  out << "\n| patch | paper: uniform | chordlength | ratio | position: uniform | chordlength | ratio | smooth: uniform "
         "| chordlength | ratio |\n|---|---|---|---|---|---|---|---|---|---|\n";
  const std::vector<ExactPatch> patches = exact_patches();
  for (std::size_t i = 0; i < patches.size(); ++i) {
    out << "| " << patches[i].network.name;
    for (const ModeErrors& errors : all) {
      const double uniform = errors.uniform[i].rms, chordlength = errors.chordlength[i].rms;
      out << " | " << std::setprecision(3) << 100 * uniform << " | " << 100 * chordlength << " | "
          << std::setprecision(2) << chordlength / uniform << (chordlength > uniform ? " (uniform wins)" : "");
    }
    out << " |\n";
  }
  out << std::endl;
}

}  // namespace croquis::bench
