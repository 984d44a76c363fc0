// SPDX-License-Identifier: GPL-3.0-or-later
// Writes the attribute networks of examples/data: write_example_networks FOLDER
#include <fstream>
#include <iostream>
#include <string>

#include "croquis/io/attribute_network_file.h"
#include "support/attribute_surface/gallery.h"

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: write_example_networks FOLDER\n";
    return 2;
  }
  for (const croquis::AttributeNetwork& network : croquis::test::gallery_networks()) {
    std::ofstream file(std::string(argv[1]) + "/" + network.name + ".json", std::ios::binary);
    file << croquis::write_attribute_network(network);
    if (!file.good()) {
      std::cerr << "can't write " << network.name << ".json into " << argv[1] << '\n';
      return 1;
    }
  }
  return 0;
}
