// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/scans/meshlab_server.h"

#include <fstream>

#include "bench/child_process.h"
#include "bench/scans/ply_file.h"
#include "support/scratch_folder.h"

namespace croquis::bench {
namespace {

/// Runs under a display of its own and writes the processor time of the server alone, which the display's isn't part
/// of. On one thread: where the machine is busy, others would spend their time waiting for each other.
constexpr const char* timed = R"(TIMEFORMAT='%U %S'; { time OMP_THREAD_LIMIT=1 timeout 600 )"
                              R"(meshlabserver -i "$1" -o "$2" -s "$3" >&3 2>&3; } 3>/dev/null 2>"$4")";

}  // namespace

std::optional<double> run_meshlab_on_file(const std::string& script, const std::string& in, const std::string& out) {
  if (!is_installed("meshlabserver") || !is_installed("xvfb-run")) return std::nullopt;
  const test::ScratchFolder scratch;
  std::ofstream(scratch / "script.mlx") << script;
  const auto ran =
      cpu_ms_of({"xvfb-run", "-a", "bash", "-c", timed, "bash", in, out, scratch / "script.mlx", scratch / "time"});
  double user = 0, system = 0;
  if (!ran || !(std::ifstream(scratch / "time") >> user >> system)) return std::nullopt;
  return 1e3 * (user + system);
}

std::optional<MeshlabRun> run_meshlab(const std::string& script, const PolyMesh& mesh) {
  const test::ScratchFolder scratch;
  write_ply(mesh, scratch / "in.ply");
  const auto time = run_meshlab_on_file(script, scratch / "in.ply", scratch / "out.ply");
  if (!time) return std::nullopt;
  return MeshlabRun{read_ply(scratch / "out.ply"), *time};
}

}  // namespace croquis::bench
