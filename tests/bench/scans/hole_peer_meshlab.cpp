// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>
#include <utility>

#include "bench/scans/hole_peers.h"
#include "bench/scans/meshlab_server.h"

namespace croquis::bench {
namespace {

constexpr const char* script = R"(<!DOCTYPE FilterScript>
<FilterScript><filter name="Close Holes">
<Param name="MaxHoleSize" type="RichInt" value="1000000"/>
<Param name="Selected" type="RichBool" value="false"/>
<Param name="NewFaceSelected" type="RichBool" value="false"/>
<Param name="SelfIntersection" type="RichBool" value="false"/>
</filter></FilterScript>
)";

}  // namespace

std::optional<double> meshlab_fill_file(const std::string& in, const std::string& out) {
  return run_meshlab_on_file(script, in, out);
}

std::optional<FilledMesh> meshlab_fill(const PolyMesh& mesh) {
  auto run = run_meshlab(script, mesh);
  if (!run) return std::nullopt;
  return FilledMesh{std::move(run->mesh), mesh.face_count(), run->cpu_ms};
}

}  // namespace croquis::bench
