// Genus 0: a flat metric on the surface less one vertex, then back onto the sphere.
//
// With the puncture at infinity the sphere is a plane: its link is held so that all its vertices are
// equally far from infinity, every other angle sum becomes 2 pi, and the result is a convex
// Delaunay polygon (Springborn 2019, bound-constrained form: docs/uniformization.md). Inverse
// stereographic projection, from where the conformal barycentre falls on the centre, makes it an
// inscribed polyhedron.
#pragma once

#include "conformal/metric_solver.h"

namespace ucvt {

/// Finds log scales u, and the Delaunay triangulation they belong to, with which the chords of t are
/// those of a polyhedron inscribed in the unit sphere.
///
/// `weight` (one per vertex) is balanced: its conformal barycentre lies at the centre, unless half
/// of it sits at one vertex. Requires a Delaunay triangulation of a sphere. Tries one puncture after
/// another; converged is false when none of them works. Where `enough` says so of log scales good to about
/// 1e-6 it stops there.
MetricSolver::Result solve_sphere(IntrinsicTriangulation& t, std::vector<double>& u,
                                  const std::vector<double>& weight,
                                  const MetricSolver::Enough& enough,
                                  const MetricSolver::Watch& watch);

}  // namespace ucvt
