// The report of a run as JSON (docs/formats.md) and as lines for people.
//
// Lengths are in the input's units, angles in degrees, times in seconds.
#pragma once

#include <chrono>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "ucvt/components.h"
#include "ucvt/cover.h"
#include "ucvt/remesh.h"
#include "ucvt/repair.h"
#include "ucvt/spaces.h"

namespace ucvt {

using Json = nlohmann::ordered_json;

/// `input`: the mesh as it was read. The genus is null where a surface has none.
Json input_report(const std::string& file, const MeshSurvey& counts);

Json uniformization_report(const UniformizationReport& report);

/// `group`: what was checked of the deck group.
Json group_report(const DeckGroup& group);

/// `cvt`, `uniformity`, `surface` and `remesh` of a result, put into a report.
void add_remesh_report(Json& report, const RemeshResult& result);

/// The same of several components together, and `components`, a list with all of it for each.
void add_joined_report(Json& report, const std::vector<Component>& components,
                       const std::vector<RemeshResult>& results, const JoinedReport& joined);

/// `repair`: what was done to the mesh.
Json repair_report(const RepairReport& repair);

/// `space`, `cvt`, `uniformity` and their like of a tessellation of a space, put into a report.
void add_space_report(Json& report, const std::string& domain, const SpaceResult& result,
                      bool uniform_density);

Json quality_report(const MeshQuality& quality);

/// `seconds`, `peak_memory_bytes` and `version`, put into a report.
void add_run_report(Json& report, std::chrono::steady_clock::time_point start);

/// The text of the file: indented, always valid UTF-8.
std::string report_text(const Json& report);

/// Whether the genus means something: a manifold surface with two sides.
bool has_genus(const MeshSurvey& counts);

/// Of such a surface: the number of handles, summed over its components.
std::int64_t genus_of(const MeshSurvey& counts);

/// Threads that a computation uses when it is asked for this many (0: all cores).
int threads_used(int asked);

/// The final energy over that of as many regular hexagons of the same total area in the plane.
double energy_over_hexagonal(const SpaceResult& result);

/// The final energy over that of small regular hexagons fitted to the density; of several components
/// the mean by sites.
double energy_over_hexagonal(std::span<const RemeshResult> results);

/// What is to be said about sites that did not converge.
std::string not_converged(const CvtReport& cvt, double tolerance);

double seconds_since(std::chrono::steady_clock::time_point start);
std::int64_t peak_memory_bytes();

/// What a summary says, as pairs of name and value.
using Lines = std::vector<std::pair<std::string, std::string>>;

/// The text of a summary, the values one below the other.
std::string aligned(const Lines& lines);

/// The same with time and peak memory of the run at its end.
std::string aligned(Lines lines, std::chrono::steady_clock::time_point start);

}  // namespace ucvt
