#include "app/closed_input.h"

#include <fmt/format.h>

#include "app/failure.h"

namespace ucvt {

ClosedInput read_closed_input(const SharedArguments& shared) {
  const std::string name = input_name(shared.input);
  ClosedInput input = about_file(name, [&] {
    const TriangleMesh mesh = read_mesh(shared.input);
    ClosedSurface surface = closed_surface(mesh);
    return ClosedInput{survey(mesh), std::move(surface)};
  });
  if (const std::int64_t turned = input.surface.reoriented_faces; turned > 0 && !shared.quiet) {
    print_line_to_stderr(fmt::format("{}: turned {} of {} faces round to agree with {} neighbours",
                                     name, turned, input.counts.faces,
                                     turned == 1 ? "its" : "their"));
  }
  return input;
}

}  // namespace ucvt
