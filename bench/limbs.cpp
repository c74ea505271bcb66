// Writes the meshes that `bench/acceptance limbs` measures: a cube of 8 vertices, a capped cylinder 30
// times as long as its girth, an octopus of eight such arms, and the two with a third of that length.
//
//   ucvt_bench_limbs FOLDER
#include "oracle/limbs.h"

#include <cstdlib>
#include <exception>
#include <iostream>
#include <string>

#include "oracle/meshes.h"

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: ucvt_bench_limbs FOLDER\n";
    return 2;
  }
  try {
    const std::string folder = std::string(argv[1]) + "/";
    ucvt::write_mesh(folder + "cube.off", ucvt::oracle::cube());
    for (const int length : {10, 30}) {
      const std::string name = std::to_string(length) + ".off";
      ucvt::write_mesh(folder + "cylinder" + name, ucvt::oracle::capped_cylinder(length, 12));
      ucvt::write_mesh(folder + "octopus" + name, ucvt::oracle::octopus(length, 3));
    }
  } catch (const std::exception& e) {
    std::cerr << e.what() << '\n';
    return 1;
  }
}
