// Pictures of surfaces, of their universal covers, and of tessellations on both, as SVG text.
//
// A surface is shown in orthographic projection, hidden parts removed: an image inside of the SVG
// document, as large in pixels as it is shown, with legends and labels as text. A cover is drawn by
// lines and shapes alone. Figures 13 to 18 of the paper are such pictures; examples/paper-figures
// makes them. The same input gives the same bytes, whatever the number of threads.
#pragma once

#include <string>

#include "ucvt/cover.h"
#include "ucvt/mesh.h"
#include "ucvt/partition.h"
#include "ucvt/remesh.h"
#include "ucvt/uniformize.h"

namespace ucvt {

/// Where a surface is seen from: the direction from the surface to the viewer as longitude and
/// latitude about the z axis, which is up. (-90, 90) looks down the z axis with x to the right and y
/// up, as suits meshes whose y axis is up. Roll turns the picture counterclockwise.
struct Camera {
  double lon_deg = -60, lat_deg = 25, roll_deg = 0;
};

struct SurfacePictureOptions {
  Camera camera;
  int width = 800;  ///< of the figure, in pixels: 100 to 4000; the height follows
  // Without it GCC warns of every designated initializer that leaves the title out.
  std::string title = {};  // NOLINT(readability-redundant-member-init)
};

/// What is shown of a uniformized surface, on the input's shape.
enum class SurfaceValue : char {
  None,   ///< the plain surface
  Area,   ///< log10 of the conformal factor A_3D/A_2D, which is 0 where it is the whole surface's
  Angle,  ///< distortion of angles by the largest over the smallest stretch; 1 where there is none
};

/// Draws the input surface, plain or coloured by how uniformization distorts it, with a legend.
///
/// Area: by vertex, of the star's areas on the input and in the uniform metric (the paper's cf).
/// Angle: by vertex, the mean over the faces of T round it of the stretch from the flat triangle on
/// the input surface to the chord triangle in T. Faces that Ptolemy flips touched have no such
/// triangle and do not count; a vertex that has no others shows grey. The colours end at the 2nd and
/// the 98th percentile (Angle: at 1). Throws InvalidInput when the camera is not finite or the width
/// is out of range, as all functions here.
std::string surface_picture(const UniformizedSurface& surface, SurfaceValue value = {},
                            const SurfacePictureOptions& options = {});

/// Draws the canonical generators a1, b1, ... as coloured tubes on the plain input surface, with
/// labels where they are seen and a legend (figure 13 (a) of the paper).
std::string loops_picture(const Cover& cover, const SurfacePictureOptions& options = {});

/// Draws the input surface with the cells of a tessellation in the colours of the partition, their
/// boundaries dark, the sites as dots. Requires `cells` to be the partition of `result`.
std::string cells_picture(const RemeshResult& result, const Partition& cells,
                          const SurfacePictureOptions& options = {});

enum class MeshStyle : char {
  HiddenLines,  ///< shaded faces, dark edges, hidden ones removed
  Wireframe,    ///< all edges, those farther away lighter (figure 17 (b) of the paper)
};

/// Draws the triangles of a mesh. Throws InvalidInput when it has none or a coordinate is not
/// finite.
std::string mesh_picture(const TriangleMesh& mesh, MeshStyle style = {},
                         const SurfacePictureOptions& options = {});

struct CoverPictureOptions {
  /// Klein or Plane for a torus, whose plane is meant by both; all but Plane for a hyperbolic surface.
  CoverCoordinates coordinates = CoverCoordinates::Klein;
  bool mesh_edges = false;  ///< draw the edges of T too
  int width = 800;          ///< of the figure, in pixels: 100 to 20000
  // See SurfacePictureOptions.
  std::string title = {};  // NOLINT(readability-redundant-member-init)
};

/// Draws the fundamental 4g-gon, unshaded, with the names of its sides, and the 16 g^2 - 8 g copies
/// that share a side or a corner with it, shaded (figure 13 (b) of the paper).
///
/// The picture's centre is the normalized sum of the corners. Groups of class `copies`, `domain`,
/// `mesh`, `boundary`, `labels`. Throws InvalidInput when the coordinates do not belong to the
/// geometry.
std::string cover_picture(const Cover& cover, const CoverPictureOptions& options = {});

/// Draws the cells of a tessellation in the cover: those of the sites in the fundamental polygon,
/// which is unshaded, and their images in the shaded copies. Sites are black dots, their images
/// white ones, centroids hollow ones (figures 14 (a, b), 15 and 16 of the paper).
///
/// As `cover_picture` otherwise; mesh edges are not drawn. Groups of class `copies`, `domain`,
/// `copy-cells`, `cells`, `boundary`, `copy-sites`, `sites`, `centroids`. On a surface of genus 0,
/// both halves of the sphere, as by `space_picture`; the coordinates do not count then. Throws
/// InvalidInput also when the result keeps no cells.
std::string cell_cover_picture(const RemeshResult& result, const CoverPictureOptions& options = {});

}  // namespace ucvt
