#include "mesh_target.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return ucvt::fuzz::read(ucvt::read_stl_text, data, size);
}
