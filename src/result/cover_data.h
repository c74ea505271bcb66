// What a Cover holds.
#pragma once

#include "conformal/uniformize.h"
#include "cover/generators.h"
#include "ucvt/cover.h"

namespace ucvt {

struct CoverData {
  UniformizedSurface surface;
  DeckSystem system;
  DeckGroup group;
};

}  // namespace ucvt
