// What a finished run keeps of its tessellation: D, and where its sites lie on T.
#pragma once

#include <memory>
#include <vector>

#include "cvt/tessellation.h"

namespace ucvt {

/// Site i is vertex i of D; its frame there and in its place on T is one and the same.
struct CellComplex {
  DelaunayTriangulation delaunay;
  std::vector<Place> places;
};

inline std::shared_ptr<const CellComplex> cell_complex(const Tessellation& sites) {
  std::vector<Place> places;
  for (std::size_t i = 0; i < sites.site_count(); ++i) {
    places.push_back(sites.place({static_cast<std::int32_t>(i)}));
  }
  return std::make_shared<const CellComplex>(CellComplex{sites.delaunay(), std::move(places)});
}

}  // namespace ucvt
