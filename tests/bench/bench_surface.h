// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <ostream>
#include <vector>

#include "croquis/attribute_surface/face_surface.h"

/// Sections of the benchmark of attribute surfaces.
namespace croquis::bench {

/// Uniform against chordlength domains: how far patches of known surfaces are off, and how even their maps are.
void bench_surface_domains(std::ostream& out);

/// Where bumps appear when points are put on patches, by three ways to find their footprints.
void bench_surface_placement(std::ostream& out);

/// Evaluation against a bicubic Bézier patch, and a car while a point is dragged.
void bench_surface_speed(std::ostream& out);

/// A place in the middle of a small piece of a domain.
struct DomainSample {
  Vec2 place = Vec2::Zero();
  double area = 0;  ///< of the piece
};

/// Pieces that cover a domain: in the fan over each side `rings` by `rings` of equal area.
std::vector<DomainSample> domain_samples(const DomainPolygon& domain, int rings);

/// exp of the mean logarithm.
double geometric_mean(const std::vector<double>& values);

}  // namespace croquis::bench
