#include "conformal/planar_map.h"

namespace ucvt {

Dart PlanarMap::add_edge(Node a, Node b) {
  Dart d{static_cast<std::int32_t>(origin_.size())};
  if (free_.empty()) {
    origin_.resize(origin_.size() + 2);
    next_.resize(origin_.size());
    prev_.resize(origin_.size());
  } else {
    d = free_.back();
    free_.pop_back();
  }
  origin_[d.index()] = a;
  origin_[d.twin().index()] = b;
  return d;
}

Dart PlanarMap::split(Dart d, Node n) {
  const Dart after = next(d), before = prev(d.twin());
  const Dart e = add_edge(n, head(d));
  origin_[d.twin().index()] = n;
  link(e, after);
  link(before, e.twin());
  link(d, e);
  link(e.twin(), d.twin());
  return e;
}

Dart PlanarMap::connect(Dart a, Dart b) {
  const Dart e = add_edge(origin(a), origin(b));
  link(prev(a), e);
  link(prev(b), e.twin());
  link(e, b);
  link(e.twin(), a);
  return e;
}

void PlanarMap::remove(Dart d) {
  link(prev(d), next(d.twin()));
  link(prev(d.twin()), next(d));
  release(d);
}

void PlanarMap::dissolve_head(Dart d) {
  const Dart e = next(d);
  origin_[d.twin().index()] = head(e);
  link(d, next(e));
  link(prev(e.twin()), d.twin());
  release(e);
}

void PlanarMap::release(Dart d) {
  origin_[d.index()] = origin_[d.twin().index()] = {};
  free_.push_back({d.id & ~1});
}

}  // namespace ucvt
