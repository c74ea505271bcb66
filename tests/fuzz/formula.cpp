#include "cvt/formula.h"

#include "fuzz_input.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(ucvt::fuzz::as_text(data, size));
  for (const double kappa : {1.0, 0.0, -1.0}) {
    ucvt::fuzz::tolerate_faults([&] {
      const ucvt::DensityFormula density(text, kappa);
      static_cast<void>(density.is_constant());
      static_cast<void>(density(ucvt::ModelPoint{0, 0, 1}));
    });
  }
  return 0;
}
