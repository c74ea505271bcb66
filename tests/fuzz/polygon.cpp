// Files of --domain, as polygons in the plane and in the hyperbolic plane.
#include "cvt/domain.h"
#include "fuzz_input.h"
#include "ucvt/space_files.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const ucvt::fuzz::MemoryFile file(ucvt::fuzz::as_text(data, size));
  for (const double kappa : {0.0, -1.0}) {
    ucvt::fuzz::tolerate_faults([&] {
      const ucvt::Domain domain = ucvt::polygon_domain(kappa, ucvt::read_polygon(file.path()));
      if (!(domain.area > 0)) {
        std::abort();
      }
    });
  }
  return 0;
}
