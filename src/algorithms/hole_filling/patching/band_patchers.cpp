// SPDX-License-Identifier: GPL-3.0-or-later
#include <optional>
#include <utility>
#include <vector>

#include "algorithms/hole_filling/patching/patcher.h"
#include "algorithms/hole_filling/triangulation/band_triangulation.h"

namespace croquis::hole_filling {
namespace {

std::optional<HolePatch> patch_of(const HoleSite& site, std::optional<std::vector<std::array<Index, 3>>> triangles) {
  if (!triangles) return std::nullopt;
  for (auto& t : *triangles) {
    for (Index& corner : t) corner = site.vertices[corner];
  }
  HolePatch patch;
  patch.holes = site.holes;
  patch.triangles = std::move(*triangles);
  return patch;
}

class ZipPatcher : public Patcher {
 public:
  const char* method() const override { return "zip"; }

  std::optional<HolePatch> attempt(const HoleSite& site, Progress& progress) const override {
    return patch_of(site, zip_triangulation(site.polygon, BandCost::Length, progress));
  }
};

class BandPatcher : public Patcher {
 public:
  explicit BandPatcher(bool shortest) : shortest_(shortest) {}

  const char* method() const override { return shortest_ ? "band-shortest" : "band"; }

  std::optional<HolePatch> attempt(const HoleSite& site, Progress& progress) const override {
    return patch_of(site, band_triangulation(site.polygon, shortest_ ? BandCost::Length : BandCost::Area, progress));
  }

 private:
  bool shortest_;
};

}  // namespace

std::shared_ptr<const Patcher> zip_patcher() { return std::make_shared<ZipPatcher>(); }
std::shared_ptr<const Patcher> band_patcher(bool shortest) { return std::make_shared<BandPatcher>(shortest); }

}  // namespace croquis::hole_filling
