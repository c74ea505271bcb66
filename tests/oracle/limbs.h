// Closed meshes of genus 0 with long thin limbs: log scales on them span hundreds.
#pragma once

#include "ucvt/mesh.h"

namespace ucvt::oracle {

/// A tube of girth 1, so many times as long, with a hemisphere at either end; `meridians` quadrilaterals
/// round it, each about a square cut in two.
TriangleMesh capped_cylinder(double length, int meridians);

/// A sphere with eight such tubes, each closed by one hemisphere, on the faces of an octahedron inside:
/// an octahedron subdivided `levels` times (at least 2), its faces' middle quarters drawn out.
TriangleMesh octopus(double arm_length, int levels);

}  // namespace ucvt::oracle
