// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>

#include "bench/scans/remesh_peers.h"

namespace croquis::bench {

std::optional<MeshlabRun> meshlab_poisson(const PolyMesh& mesh, int depth) {
  const std::string script = R"(<!DOCTYPE FilterScript>
<FilterScript><filter name="Surface Reconstruction: Screened Poisson">
<Param name="visibleLayer" type="RichBool" value="false"/>
<Param name="depth" type="RichInt" value=")" +
                             std::to_string(depth) + R"("/>
<Param name="fullDepth" type="RichInt" value="5"/>
<Param name="cgDepth" type="RichInt" value="0"/>
<Param name="scale" type="RichFloat" value="1.1"/>
<Param name="samplesPerNode" type="RichFloat" value="1.5"/>
<Param name="pointWeight" type="RichFloat" value="4"/>
<Param name="iters" type="RichInt" value="8"/>
<Param name="confidence" type="RichBool" value="false"/>
<Param name="preClean" type="RichBool" value="true"/>
</filter></FilterScript>
)";
  return run_meshlab(script, mesh);
}

}  // namespace croquis::bench
