#include "fuzz_input.h"
#include "ucvt/remesh.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const ucvt::fuzz::MemoryFile file(ucvt::fuzz::as_text(data, size));
  ucvt::fuzz::tolerate_faults([&] {
    ucvt::RemeshOptions options;
    ucvt::start_from(options, ucvt::read_sites(file.path()));
  });
  return 0;
}
