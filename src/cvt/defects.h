// Defects mended: sites taken away and added where that lowers the energy.
//
// Where pieces of a hexagonal pattern do not fit, rows of sites end: at a site with five neighbours next
// to one with seven. No small move changes how many rows there are; a site less or more makes one of
// them shorter or longer (docs/optimisation.md).
#pragma once

#include <memory>

#include "cvt/tessellation.h"

namespace ucvt {

/// So many times takes sites away at defects where that hurts least and adds as many at others where it
/// helps most, or the other way round, and keeps what lowers the energy. A few evaluations of the sites
/// around tell what hurts and helps.
///
/// Returns as many sites as given, with no more energy. Those given should be settled. Throws Cancelled
/// when the monitor said so.
std::unique_ptr<Tessellation> mend_defects(std::unique_ptr<Tessellation> sites, int exchanges,
                                           const Monitor& monitor);

}  // namespace ucvt
