// Surfaces for the tests of this room, with their deck groups computed once.
#pragma once

#include <map>
#include <memory>

#include "cover/generators.h"
#include "oracle/surfaces.h"
#include "ucvt/cover.h"

namespace ucvt::test {

struct Covered {
  std::shared_ptr<const Uniformized> t;
  DeckSystem system;
  DeckGroup group;
};

inline Covered covered(const TriangleMesh& mesh) {
  auto t = std::make_shared<const Uniformized>(uniformize_surface(oracle::closed(mesh), {}));
  DeckSystem system = deck_system(t->surface);
  DeckGroup group = deck_group(system);
  return {std::move(t), std::move(system), std::move(group)};
}

/// A surface of genus 1 to 6.
inline const Covered& of_genus(int genus) {
  static std::map<int, Covered> known;
  const auto at = known.find(genus);
  return at != known.end()
             ? at->second
             : known.emplace(genus, covered(oracle::voxel_frame(genus))).first->second;
}

}  // namespace ucvt::test
