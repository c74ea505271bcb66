#include "cover/layout.h"

#include <cstdlib>

#include "ucvt/error.h"

namespace ucvt {

std::vector<std::array<Offset, 3>> fundamental_domain(const UniformSurface& t, Face root) {
  std::vector<std::array<Offset, 3>> out(t.connectivity().face_count());
  std::vector<char> placed(out.size(), 0);
  std::vector<Face> queue{root};
  out[root.index()] = place_of(t, {root}).corner;
  placed[root.index()] = 1;
  for (std::size_t i = 0; i < queue.size(); ++i) {
    const Face f = queue[i];
    for (std::size_t side = 0; side < 3; ++side) {
      const Halfedge h = halfedges(f)[side], twin = t.connectivity().twin(h);
      if (placed[twin.face().index()]) {
        continue;
      }
      placed[twin.face().index()] = 1;
      const Offset u = out[f.index()][side], v = out[f.index()][(side + 1) % 3];
      auto& corner = out[twin.face().index()];
      const auto j = static_cast<std::size_t>(twin.id % 3);
      corner[j] = v, corner[(j + 1) % 3] = u, corner[(j + 2) % 3] = t.develop(h, u, v);
      queue.push_back(twin.face());
    }
  }
  return out;
}

std::vector<DeckMap> laid_out(const UniformSurface& t, const DeckSystem& s) {
  const auto corner = corner_maps(s.kappa, s.cut.rim, s.loop);
  std::vector<DeckMap> out;
  for (std::size_t i = 0; i < t.connectivity().halfedge_count(); ++i) {
    const Vertex v = t.connectivity().origin({static_cast<std::int32_t>(i)});
    const auto letters = static_cast<std::size_t>(s.cut.letters_before[i]);
    out.push_back(product(s.kappa, corner[letters], s.frame[v.index()]));
  }
  return out;
}

DeckMap across_cut(const UniformSurface& t, const DeckSystem& s, Halfedge h) {
  // The end of the edge as the twin's face knows it goes to where the face of h knows it.
  const auto corner = corner_maps(s.kappa, s.cut.rim, s.loop);
  const auto at = [&](Halfedge k) {
    return corner[static_cast<std::size_t>(s.cut.letters_before[k.index()])];
  };
  return product(s.kappa, at(h), inverse(at(t.connectivity().twin(h).next())));
}

std::array<double, 2> coordinates_of(double kappa, const DeckMap& m, CoverCoordinates c) {
  const auto pair = [](const PreciseComplex& p, const DoubleDouble& by) {
    return std::array<double, 2>{(p.re / by).value(), (p.im / by).value()};
  };
  const PreciseComplex twice = DoubleDouble{2} * (m.a * m.b);
  const DoubleDouble z = norm2(m.a) - DoubleDouble{kappa} * norm2(m.b);
  switch (c) {
    case CoverCoordinates::Poincare:
      return pair(m.a * m.b, norm2(m.a));
    case CoverCoordinates::HalfPlane: {
      // i (1 + w)/(1 - w), multiplied out: its height keeps its digits however near the rim w is.
      const PreciseComplex gap = conj(m.a) + DoubleDouble{-1} * m.b;
      return pair({-twice.im, 1}, norm2(gap));
    }
    default:
      return pair(twice, z);
  }
}

}  // namespace ucvt
