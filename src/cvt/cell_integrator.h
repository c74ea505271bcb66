// Exact moments of Voronoi cells over a surface with a density.
//
// A cell is the convex set of points no farther from its site than from the site's neighbours in D.
// T is developed face by face over it from the face under the site: a face inside the cell adds its
// precomputed weights, a face that straddles the boundary is clipped in its own barycentric
// coordinates (geodesics are straight there) and integrated. No sampling.
#pragma once

#include <cstdint>
#include <vector>

#include "space/moments.h"
#include "triangulation/uniform_surface.h"

namespace ucvt {

class CellIntegrator {
 public:
  /// Takes the density at the vertices of T; it is linear over each face's chord triangle. Keeps a
  /// reference to t.
  CellIntegrator(const UniformSurface& t, std::vector<double> density);

  [[nodiscard]] const UniformSurface& surface() const { return t_; }
  [[nodiscard]] const std::vector<double>& density() const { return density_; }
  [[nodiscard]] double total_mass() const;

  /// Scratch memory of one thread; 8 bytes per face of T.
  class Workspace {
   public:
    explicit Workspace(const CellIntegrator& integrator)
        : stamp_(integrator.weights_.size(), 0), newest_(stamp_.size(), -1) {}

   private:
    friend class CellIntegrator;
    /// A face of T where it lies in the site's frame; lifts of one face are chained.
    struct Developed {
      Place place;
      std::array<std::uint64_t, 3> outside;  ///< per corner, bit j: nearer to neighbour j
      std::int32_t older;
    };
    std::vector<std::uint32_t> stamp_;
    std::vector<std::int32_t> newest_;
    std::uint32_t cell_ = 0;
    std::vector<Developed> developed_;
    std::vector<Barycentric> polygon_, clipped_;
  };

  /// Moments of the cell of the site at the origin of `place`'s frame, whose neighbours in D lie at
  /// `neighbours` in that frame. Faces are visited in a fixed order: the result has the same bits
  /// on every thread.
  Moments integrate(const Place& place, const std::vector<Offset>& neighbours,
                    Workspace& work) const;

 private:
  Workspace::Developed& add(Workspace& work, Face face) const;
  /// True when the face of h was developed with h's ends at u and v.
  [[nodiscard]] bool is_developed(const Workspace& work, Halfedge h, const Offset& u,
                                  const Offset& v) const;
  void cross_into(Workspace& work, std::size_t from, std::size_t side,
                  const std::vector<Offset>& neighbours) const;
  [[nodiscard]] std::uint64_t outside(const Offset& p, const std::vector<Offset>& neighbours) const;
  /// Leaves the part of the face inside the cell in work.polygon_.
  void clip(Workspace& work, const Workspace::Developed& d,
            const std::vector<Offset>& neighbours) const;

  const UniformSurface& t_;
  std::vector<double> density_;
  std::vector<Weights> weights_;
};

}  // namespace ucvt
