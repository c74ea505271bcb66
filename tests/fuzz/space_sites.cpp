#include "cvt/domain.h"
#include "fuzz_input.h"
#include "ucvt/space_files.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const ucvt::fuzz::MemoryFile file(ucvt::fuzz::as_text(data, size));
  static const ucvt::Domain sphere = ucvt::sphere_domain();
  ucvt::fuzz::tolerate_faults([&] {
    for (const ucvt::ModelPoint& p : ucvt::read_space_sites(file.path(), sphere)) {
      static_cast<void>(ucvt::contains(sphere, p));
    }
  });
  return 0;
}
