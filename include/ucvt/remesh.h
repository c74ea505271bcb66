// Remeshing: a centroidal Voronoi tessellation on the uniformized surface, and its dual mesh.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ucvt/mesh.h"
#include "ucvt/uniformize.h"

namespace ucvt {

/// A site: a face of T and barycentric coordinates in its chord triangle.
struct Site {
  std::int32_t face = 0;
  std::array<double, 3> bary{1.0 / 3, 1.0 / 3, 1.0 / 3};
};

enum class InitialSites : char { Multilevel, Random, Farthest };

enum class Method : char { Lbfgs, Lloyd };

/// How far a run had come at a restart point: what going on from its sites needs to know.
struct RunProgress {
  int sites = 0;           ///< that were asked for
  int evenings_left = 0;   ///< rounds of evening sizes, on steep surfaces
  int round = 0;           ///< rounds done of making room for a simplicial dual mesh
  int evaluations = 0;     ///< done in the current optimisation
  std::int64_t moved = 0;  ///< sites taken away elsewhere to keep their number
  // CvtReport so far.
  int iterations = 0;
  std::vector<double> energy, max_move;
};

/// The sites of a run, and what its T and density are made from.
struct SavedSites {
  std::vector<Site> sites;
  int refine_for = 0;
  std::vector<double> size;
  std::optional<RunProgress> progress = std::nullopt;  ///< of a run that has not ended
};

/// Is handed the state of a run at every restart point.
using Checkpoint = std::function<void(const SavedSites&)>;

struct RemeshOptions {
  int sites = 1000;
  std::uint64_t seed = 1;
  InitialSites init = InitialSites::Multilevel;
  Method method = Method::Lbfgs;
  std::vector<Site> initial_sites;   ///< when not empty: start here; their number is `sites`
  int refine_for = 0;                ///< refine T for this many sites; 0: for `sites`
  std::vector<double> initial_size;  ///< RemeshResult::size to start from; empty: 1 everywhere
  /// When given: `initial_sites`, `refine_for` and `initial_size` are of a run that came so far. With
  /// the surface and the other options of that run the result is the same to the bit as its own.
  std::optional<RunProgress> progress = std::nullopt;
  int iterations = 1000;  ///< evaluations of all cells, at most, after the initial state
  /// Of the largest move, relative to the site's spacing. 0: 1e-3, or the end of L-BFGS where ten steps
  /// lower the energy by less than 1e-4 of it.
  double tolerance = 0;
  bool ensure_simplicial =
      true;         ///< make room for a simplicial dual mesh, with a few more sites if need be
  int threads = 0;  ///< 0: all cores; results do not depend on it
  Monitor monitor;
  Checkpoint checkpoint = nullptr;  ///< called between evaluations, from the calling thread
};

/// Mean, coefficient of variation and range.
struct Spread {
  double mean = 0, cv = 0, min = 0, max = 0;
};

struct CvtReport {
  std::string method;  ///< "lbfgs" or "lloyd"
  std::int64_t sites = 0;
  int iterations = 0;  ///< evaluations of all cells
  bool converged = false;
  std::vector<double> energy;  ///< sum over cells of int rho chord^2, at first and after each step
  std::vector<double> max_move;  ///< largest distance from a centroid over the spacing, likewise
  double seconds = 0;            ///< of the iterations
};

/// The paper's measures of uniformity (its section 5.3), in the uniform metric.
struct UniformityReport {
  Spread radius, nearest, area;
  std::map<int, std::int64_t> degree;  ///< sites by number of neighbours
  double hexagons = 0;                 ///< share of degree 6
};

/// A mesh's triangles: Q = 6/sqrt(3) area/(half perimeter x longest edge), angles in degrees.
struct MeshQuality {
  double q_min = 0, q_avg = 0;
  double angle_min_deg = 0, angle_min_avg_deg = 0;
  double below_30 = 0;  ///< share of triangles with an angle below 30 degrees
  double regular = 0;   ///< share of vertices of degree 6
};

/// Measures a triangle mesh. Requires at least one face.
MeshQuality measure_quality(const TriangleMesh& mesh);

struct RemeshReport {
  std::int64_t vertices = 0, faces = 0;
  int genus = 0;           ///< of an open surface: with its holes filled
  int boundary_loops = 0;  ///< as the input's
  bool simplicial = false;
  std::int64_t sites_added = 0;
  MeshQuality quality;
};

struct CellComplex;
struct HalfOfDouble;

struct RemeshResult {
  TriangleMesh mesh;            ///< dual mesh: closed, oriented, of the input's genus
  UniformizedSurface surface;   ///< T as it was used, refined for the number of sites
  std::vector<Site> sites;      ///< on T; site i is vertex i of the mesh
  int refined_for = 0;          ///< number of sites that T was refined for
  std::vector<double> density;  ///< at the vertices of T
  std::vector<double> size;     ///< cell size asked for at T's vertices; 1: as all, 1/2: half that
  CvtReport cvt;
  /// Of so many small regular hexagons fitted to the density, 5/(18 sqrt 3) (int sqrt rho)^2/N: the least
  /// energy for large N (Gersho 1979).
  double hexagonal_energy = 0;
  UniformityReport uniformity;
  Spread cell_area_3d;  ///< cell areas on the input surface, in its units
  RemeshReport report;
  std::shared_ptr<const CellComplex> cells = nullptr;  ///< what `partition` cuts by; opaque
  std::shared_ptr<const HalfOfDouble> half =
      nullptr;  ///< of an open surface: its part of them; opaque
};

/// Remeshes a closed surface with a CVT of uniform density on the surface.
///
/// Running out of iterations is a status (`cvt.converged`), not an error. Throws InvalidInput when
/// the options do not fit (fewer than four sites on a sphere, fewer than one elsewhere, initial
/// sites, sizes or progress that do not fit), Cancelled when the monitor said so, NumericalError as `uniformize`.
RemeshResult remesh(const ClosedSurface& surface, const RemeshOptions& options = {});

/// Remeshes a surface with boundary with a CVT of the surface doubled across its boundary, kept
/// symmetric (docs/boundaries.md).
///
/// The mesh has the surface's genus and boundary loops; `sites` counts its vertices, those on the
/// boundary among them. These lie on the edges of the input's boundary, one at every corner that turns
/// by more than 30 degrees. `surface` of the result is T of the double, `sites` are all of the double's
/// (on the boundary first, then pair by pair), and so are `cells`; uniformity is that of the double,
/// and a boundary vertex' cell is counted with its mirror image. `init` may be Multilevel or Farthest;
/// checkpoints are not called. Throws as for closed surfaces, and InvalidInput when there are fewer sites
/// than the boundary needs, or initial sites are asked for.
RemeshResult remesh(const OpenSurface& surface, const RemeshOptions& options = {});

/// Reads and writes the sites of a tessellation as JSON (docs/formats.md).
SavedSites read_sites(const std::string& path);
void write_sites(const std::string& path, const RemeshResult& result);
void write_sites(const std::string& path, const SavedSites& saved);

/// Options that start from saved sites; `sites` is set to the number that their run was asked for.
void start_from(RemeshOptions& options, SavedSites saved);

}  // namespace ucvt
