// Sites on a surface with a mirror symmetry, moved so that they stay symmetric.
//
// The surface is a double (docs/boundaries.md): sites come in pairs, one on either half, or lie on the
// mirror line and stay on it. An optimiser sees one of each pair and those on the line, with the
// energy of one half: the mean of a pair's cells, half of a cell on the line.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "cvt/tessellation.h"

namespace ucvt {

/// The way from one site's frame to that of its mirror image, a reflection; its own inverse.
struct Reflection {
  double cosine = 1, sine = 0;  ///< a direction at angle a goes to alpha - a; this is alpha

  [[nodiscard]] Offset operator()(const Offset& p) const {
    return {cosine * p.x + sine * p.y, sine * p.x - cosine * p.y, p.h};
  }
  /// The directions that it keeps: this one and its opposite.
  [[nodiscard]] std::array<double, 2> axis() const;
};

/// Sites of a double: on the mirror line first, then pair by pair.
struct MirrorLayout {
  std::vector<SurfacePoint> on_line;
  std::vector<bool> fixed;  ///< of those on the line: must not move
  std::vector<std::array<SurfacePoint, 2>> pairs;

  /// Vertex numbers of the sites of a pair.
  [[nodiscard]] Vertex of_pair(std::size_t pair, std::size_t side) const {
    return {static_cast<std::int32_t>(on_line.size() + 2 * pair + side)};
  }
};

class MirrorSites : public SiteSystem {
 public:
  /// Requires sites that are symmetric to rounding of T. Keeps a reference to the mass. Throws as
  /// Tessellation, and NumericalError when a site's surroundings are not the image of its partner's.
  MirrorSites(const SurfaceMass& mass, const MirrorLayout& layout);

  [[nodiscard]] const Tessellation& tessellation() const { return sites_; }
  [[nodiscard]] std::size_t line_count() const { return line_count_; }
  [[nodiscard]] bool on_line(Vertex site) const { return site.index() < line_count_; }
  [[nodiscard]] Vertex partner(Vertex site) const;
  [[nodiscard]] const Reflection& reflection(Vertex site) const {
    return reflection_[site.index()];
  }

  /// The sites where they are now.
  [[nodiscard]] MirrorLayout layout() const;
  /// The place at an offset in a site's frame.
  [[nodiscard]] SurfacePoint point_at(Vertex site, const Offset& at) const;

  /// Along the mirror line from p, in the direction +1 or -1 of its axis: the halfedge of D that runs
  /// along it, if one does, or else the first of the two that it passes between.
  struct Ahead {
    Halfedge halfedge;
    bool on_line = false;
  };
  [[nodiscard]] Ahead look_ahead(Vertex p, int direction) const;

  [[nodiscard]] Space space() const override { return sites_.space(); }
  [[nodiscard]] std::size_t site_count() const override {
    return line_count_ + (sites_.site_count() - line_count_) / 2;
  }
  void measure(std::vector<CellState>& out) const override;
  void move(const std::vector<Offset>& target) override;
  void save() override { sites_.save(); }
  void restore() override { sites_.restore(); }

 private:
  /// The site that stands for number i of those that an optimiser sees.
  [[nodiscard]] Vertex shown(std::size_t i) const;
  /// Undoes what the tessellation did to places on edges of T, which would spoil the symmetry.
  void put_exactly(const UniformSurface& t, const std::vector<SurfacePoint>& points);
  [[nodiscard]] Reflection find_reflection(Vertex site) const;

  std::size_t line_count_;
  std::vector<bool> fixed_;
  Tessellation sites_;
  const UniformSurface& t_;
  std::vector<Reflection> reflection_;
};

}  // namespace ucvt
