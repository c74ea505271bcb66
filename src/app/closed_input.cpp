#include "app/closed_input.h"

#include <fmt/format.h>

#include "app/failure.h"

namespace ucvt {
namespace {

void tell_turned_faces(const SharedArguments& shared, std::int64_t turned, std::int64_t faces) {
  if (turned > 0 && !shared.quiet) {
    print_line_to_stderr(fmt::format("{}: turned {} of {} faces round to agree with {} neighbours",
                                     input_name(shared.input), turned, faces,
                                     turned == 1 ? "its" : "their"));
  }
}

}  // namespace

ClosedInput read_closed_input(const SharedArguments& shared) {
  ClosedInput input = about_file(input_name(shared.input), [&] {
    const TriangleMesh mesh = read_mesh(shared.input);
    ClosedSurface surface = closed_surface(mesh);
    return ClosedInput{survey(mesh), std::move(surface)};
  });
  tell_turned_faces(shared, input.surface.reoriented_faces, input.counts.faces);
  return input;
}

SurfaceInput read_surface_input(const SharedArguments& shared) {
  SurfaceInput input = about_file(input_name(shared.input), [&] {
    const TriangleMesh mesh = read_mesh(shared.input);
    SurfaceInput read{survey(mesh), {}};
    if (has_boundary(mesh)) {
      read.surface = open_surface(mesh);
    } else {
      read.surface = closed_surface(mesh);
    }
    return read;
  });
  std::visit(
      [&](const auto& s) { tell_turned_faces(shared, s.reoriented_faces, input.counts.faces); },
      input.surface);
  return input;
}

}  // namespace ucvt
