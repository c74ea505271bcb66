// The neighbours of sites, as their cells ask for them.
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "triangulation/delaunay.h"

namespace ucvt {

/// The neighbours of every site, in D's order round it, in memory one after the other.
class Stars {
 public:
  explicit Stars(const DelaunayTriangulation& d);

  [[nodiscard]] std::span<const Offset> offsets(Vertex site) const {
    return {offset_.data() + first_[site.index()], size(site)};
  }
  [[nodiscard]] std::span<const Vertex> sites(Vertex site) const {
    return {site_.data() + first_[site.index()], size(site)};
  }
  /// The first place of a neighbour in the star of the site; the star's size where it has none.
  [[nodiscard]] std::size_t find(Vertex site, Vertex neighbour) const {
    const auto star = sites(site);
    return static_cast<std::size_t>(std::find(star.begin(), star.end(), neighbour) - star.begin());
  }
  /// From the frames of the neighbours to the site's.
  [[nodiscard]] std::span<const Isometry> frames(Vertex site) const {
    return {frame_.data() + first_[site.index()], size(site)};
  }
  /// h of the points at the radius of the circle about the site that touches its cell's boundary.
  [[nodiscard]] double inner_h(Vertex site) const { return inner_h_[site.index()]; }
  /// The chord to the farthest neighbour.
  [[nodiscard]] double reach(Vertex site) const { return reach_[site.index()]; }
  [[nodiscard]] std::size_t site_count() const { return inner_h_.size(); }

 private:
  [[nodiscard]] std::size_t size(Vertex site) const {
    return first_[site.index() + 1] - first_[site.index()];
  }
  std::vector<std::size_t> first_;
  std::vector<Offset> offset_;
  std::vector<Vertex> site_;
  std::vector<Isometry> frame_;
  std::vector<double> inner_h_, reach_;
};

}  // namespace ucvt
