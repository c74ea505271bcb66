#include "cover/layout.h"

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

}  // namespace ucvt
