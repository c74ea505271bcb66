// The input of the computing commands: a mesh file that is one closed surface or several.
#pragma once

#include <optional>
#include <vector>

#include "app/options.h"
#include "ucvt/components.h"
#include "ucvt/repair.h"

namespace ucvt {

/// The components that are asked for. Vertices and faces that `components` counts are those of the
/// mesh after the repair, where there was one.
struct ClosedInput {
  MeshSurvey counts;                  ///< of the mesh as it was read
  std::vector<Component> components;  ///< none when the surface is open
  std::optional<OpenSurface> open;
  std::optional<RepairReport> repair;
  std::vector<std::int32_t> file_vertex, file_face;  ///< empty: the same; -1: none

  /// Numbers in the file of vertices and faces of the mesh.
  [[nodiscard]] std::vector<std::int32_t> vertices_in_file(std::vector<std::int32_t> numbers) const;
  [[nodiscard]] std::vector<std::int32_t> faces_in_file(std::vector<std::int32_t> numbers) const;
};

/// Whether surfaces with boundary are taken.
enum class Surfaces : char { Closed, ClosedAndOpen };

/// Reads the mesh, repairs it if that is asked for, and tells on stderr what was repaired and when
/// faces had to be turned round. Throws Failure.
ClosedInput read_input(const SharedArguments& shared, Surfaces surfaces = Surfaces::Closed);

/// Throws Failure unless there is one component: `what` takes one.
void require_one_component(const SharedArguments& shared, const ClosedInput& input,
                           const std::string& what);

}  // namespace ucvt
