// SPDX-License-Identifier: GPL-3.0-or-later
// What a host does: take an operation from the registry, show its parameters, run it, read its report.
// 04_run_operation SKETCH.svg
#include <iostream>
#include <memory>

#include "croquis/io/file.h"
#include "croquis/io/svg_drawing.h"
#include "croquis/operators/all_operations.h"

int main(int argc, char** argv) {
  using namespace croquis;
  if (argc != 2) return 2;
  const Registry registry = all_operations();
  const Operation& inflate = *registry.find("inflate");
  for (const ParameterDescription& parameter : inflate.describe().parameters) {
    std::cout << parameter.name << " = " << to_text(parameter.default_value) << ": " << parameter.sentence << "\n";
  }

  Progress progress([](double fraction, const std::string& step) {
    std::cout << static_cast<int>(100 * fraction) << " % " << step << "\n";
  });
  Context context{progress};
  const Drawing drawing = read_svg_drawing(read_file(argv[1]), argv[1], progress).drawing;
  const OperationResult result =
      run(inflate, {{"drawing", std::make_shared<const Drawing>(drawing)}}, {{"min-gap", 0.2}}, context);
  const auto details = result.outputs.at("details").as<Report>();
  std::cout << details->at("crossings").as_integer() << " crossings, " << details->at("panels").as_integer()
            << " panels\n";
  return 0;
}
