// Where the sites of the bare spaces start: given, at random, or level by level.
#pragma once

#include <memory>

#include "cvt/cell_measure.h"
#include "cvt/space_sites.h"

namespace ucvt {

/// The sites that the options ask for, before they are moved.
///
/// A multilevel start is one of closed domains; polygons start at random. Throws InvalidInput when the
/// number of sites, or those that are given, do not fit the domain; Cancelled; NumericalError.
std::unique_ptr<SpaceSites> start_sites(const Domain& domain, const SpaceOptions& options,
                                        const CellMeasure& measure);

}  // namespace ucvt
