#include "app/closed_input.h"

#include <fmt/format.h>

#include "app/failure.h"
#include "ucvt/error.h"

namespace ucvt {
namespace {

std::vector<std::int32_t> mapped(std::vector<std::int32_t> numbers,
                                 const std::vector<std::int32_t>& map) {
  for (std::int32_t& n : numbers) {
    n = map.empty() ? n : map[static_cast<std::size_t>(n)];
  }
  return numbers;
}

/// The components of what was repaired; what could not be is named.
std::vector<Component> repaired_components(const Repaired& repaired) {
  const std::string faults = faults_of(repaired.mesh);
  if (!faults.empty()) {
    throw InvalidInput(fmt::format("after repair ({}) {}; {}", summary_of(repaired.report), faults,
                                   survey(repaired.mesh).orientable
                                       ? "mend it by hand, or allow more with --weld and --holes"
                                       : "give a surface with two sides"));
  }
  return closed_components(repaired.mesh);
}

/// Leaves the component that --component asks for.
void choose_component(const SharedArguments& shared, std::vector<Component>& components) {
  if (shared.component < 0) {
    return;
  }
  if (static_cast<std::size_t>(shared.component) >= components.size()) {
    throw Failure(ExitStatus::Usage,
                  fmt::format("{}: --component asks for {}, but the last one is {}; they are "
                              "counted from 0",
                              input_name(shared.input), shared.component, components.size() - 1));
  }
  components = {std::move(components[static_cast<std::size_t>(shared.component)])};
}

ClosedInput take(const TriangleMesh& mesh, const SharedArguments& shared, Surfaces surfaces) {
  ClosedInput input;
  input.counts = survey(mesh);
  if (shared.repair) {
    Repaired repaired = repair(mesh, shared.repair_options);
    input.components = repaired_components(repaired);
    input.repair = repaired.report;
    input.file_vertex = std::move(repaired.input_vertex);
    input.file_face = std::move(repaired.input_face);
  } else if (surfaces == Surfaces::ClosedAndOpen && input.counts.boundary_edges > 0 &&
             has_boundary(mesh)) {
    input.open = open_surface(mesh);
    return input;
  } else {
    input.components = closed_components(mesh);
  }
  choose_component(shared, input.components);
  return input;
}

}  // namespace

std::vector<std::int32_t> ClosedInput::vertices_in_file(std::vector<std::int32_t> numbers) const {
  return mapped(std::move(numbers), file_vertex);
}

std::vector<std::int32_t> ClosedInput::faces_in_file(std::vector<std::int32_t> numbers) const {
  return mapped(std::move(numbers), file_face);
}

ClosedInput read_input(const SharedArguments& shared, Surfaces surfaces) {
  const std::string name = input_name(shared.input);
  ClosedInput input =
      about_file(name, [&] { return take(read_mesh(shared.input), shared, surfaces); });
  if (input.repair && !shared.quiet) {
    print_line_to_stderr(fmt::format("{}: repair: {}", name, summary_of(*input.repair)));
  }
  std::int64_t turned = input.open ? input.open->reoriented_faces : 0;
  for (const Component& c : input.components) {
    turned += c.surface.reoriented_faces;
  }
  if (turned > 0 && !shared.quiet) {
    print_line_to_stderr(fmt::format("{}: turned {} of {} faces round to agree with {} neighbours",
                                     name, turned, input.counts.faces,
                                     turned == 1 ? "its" : "their"));
  }
  return input;
}

void require_one_component(const SharedArguments& shared, const ClosedInput& input,
                           const std::string& what) {
  if (input.components.size() > 1) {
    throw Failure(ExitStatus::Usage,
                  fmt::format("{}: the surface has {} components, but {} takes one; choose it with "
                              "--component K",
                              input_name(shared.input), input.components.size(), what));
  }
}

}  // namespace ucvt
