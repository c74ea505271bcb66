// Files of any format, told from their content.
#include "mesh_target.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const ucvt::fuzz::MemoryFile file(ucvt::fuzz::as_text(data, size));
  return ucvt::fuzz::read([&](std::string_view) { return ucvt::read_mesh(file.path()); }, data,
                          size);
}
