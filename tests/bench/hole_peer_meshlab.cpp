// SPDX-License-Identifier: GPL-3.0-or-later
#include <fstream>
#include <sstream>
#include <string>

#include "bench/child_process.h"
#include "bench/hole_peers.h"
#include "croquis/io/mesh_file.h"
#include "support/scratch_folder.h"

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

/// Runs under a display of its own and writes the processor time of the server alone, which the display's isn't part
/// of.
constexpr const char* timed =
    R"(TIMEFORMAT='%U %S'; { time meshlabserver -i "$1" -o "$2" -s "$3" >&3 2>&3; } 3>/dev/null 2>"$4")";

}  // namespace

std::optional<double> meshlab_fill_file(const std::string& in, const std::string& out) {
  if (!is_installed("meshlabserver") || !is_installed("xvfb-run")) return std::nullopt;
  const test::ScratchFolder scratch;
  std::ofstream(scratch / "close.mlx") << script;
  const auto ran =
      cpu_ms_of({"xvfb-run", "-a", "bash", "-c", timed, "bash", in, out, scratch / "close.mlx", scratch / "time"});
  double user = 0, system = 0;
  if (!ran || !(std::ifstream(scratch / "time") >> user >> system)) return std::nullopt;
  return 1e3 * (user + system);
}

std::optional<FilledMesh> meshlab_fill(const PolyMesh& mesh) {
  const test::ScratchFolder scratch;
  Progress progress;
  std::ofstream(scratch / "in.ply", std::ios::binary) << write_mesh(mesh, MeshFormat::Ply, {}, progress).bytes;
  const auto time = meshlab_fill_file(scratch / "in.ply", scratch / "out.ply");
  if (!time) return std::nullopt;
  std::ifstream file(scratch / "out.ply", std::ios::binary);
  std::stringstream bytes;
  bytes << file.rdbuf();
  FilledMesh filled;
  filled.mesh = read_mesh(bytes.str(), MeshFormat::Ply, "MeshLab's output", progress).mesh;
  filled.first_new_face = mesh.face_count();
  filled.cpu_ms = *time;
  return filled;
}

}  // namespace croquis::bench
