#include "cover/words.h"

#include <cmath>

#include <gtest/gtest.h>

#include "cover/canonical_system.h"
#include "cover/holonomy.h"
#include "cover/short_generators.h"
#include "cover_surfaces.h"

namespace ucvt {
namespace {

TEST(Words, ProductsAreFreelyReduced) {
  EXPECT_EQ(product({{1, 2}, {-2, -1, 3}}), Word{3});
  EXPECT_EQ(inverse(Word{1, -2, 3}), (Word{-3, 2, -1}));
  EXPECT_EQ(commutators(4), (Word{1, 2, -1, -2, 3, 4, -3, -4}));
}

TEST(Words, DehnsAlgorithmGoesTheShortWayRound) {
  const Word relator = commutators(4);
  const WordReducer reduce(relator);
  EXPECT_EQ(reduce(relator), Word{});
  EXPECT_EQ(reduce(inverse(relator)), Word{});
  EXPECT_EQ(reduce({1, 2, -1, -2, 3}), (Word{4, 3, -4}));
  // Across the relator's end.
  EXPECT_EQ(reduce({4, -3, -4, 1, 2}), (Word{-3, 2, 1}));
  EXPECT_EQ(reduce({1, 2, -1, -2}), (Word{1, 2, -1, -2}));
}

TEST(Words, DehnsAlgorithmKeepsTheElement) {
  const auto& s = test::of_genus(3).system;
  const WordReducer reduce(s.cut.rim);
  std::mt19937_64 random(5);
  for (int i = 0; i < 50; ++i) {
    Word w;
    while (w.size() < 30) {
      const std::size_t from = random() % 12, length = random() % 12;
      for (std::size_t k = 0; k < length; ++k) {
        w.push_back(s.cut.rim[(from + k) % 12]);
      }
    }
    const Word shorter = reduce(w);
    const DeckMap left = product(-1, map_of(-1, w, s.loop), inverse(map_of(-1, shorter, s.loop)));
    EXPECT_LT(off_identity(left), 1e-9);
    EXPECT_LE(shorter.size(), product({w}).size());
  }
}

TEST(CanonicalSystem, HoldsForTheOppositeSidesOfARegularPolygon) {
  for (const int genus : {2, 3}) {
    // x1 x2 ... x2g x1^-1 ... x2g^-1: no two neighbouring sides are linked into a handle of their own.
    Word rim;
    for (int sign : {1, -1}) {
      for (int i = 1; i <= 2 * genus; ++i) {
        rim.push_back(sign * i);
      }
    }
    // Translations across opposite sides of the regular 4g-gon, apart from rounding.
    const double angle = M_PI / (2 * genus);
    const double in = 1 / (std::tan(angle / 2) * 1), along = std::sqrt(in * in - 1);
    std::vector<DeckMap> sides;
    for (int i = 0; i < 2 * genus; ++i) {
      const double turn = i * (angle + M_PI);
      sides.push_back({{in, 0}, {along * std::cos(turn), along * std::sin(turn)}});
    }
    auto loops = sides;
    const RelationFit p = project_to_relation(-1, rim, loops);
    ASSERT_TRUE(p.converged) << p.before << " " << p.after;
    const CanonicalSystem raw = collect_handles(-1, rim, loops);
    const CanonicalSystem found = shortened(-1, raw, WordReducer(rim), loops);
    for (const CanonicalSystem& s : {raw, found}) {
      ASSERT_EQ(s.map.size(), 2U * static_cast<unsigned>(genus));
      EXPECT_LT(off_identity(map_of(-1, commutators(s.map.size()), s.map)), 1e-15);
    }
    EXPECT_LE(total_length(-1, found.map), total_length(-1, raw.map));
  }
}

/// Twists between handles and in them are undone by the descent.
TEST(CanonicalSystem, TwistsAreFoundAgain) {
  for (const int genus : {2, 3}) {
    const auto& s = test::of_genus(genus).system;
    const WordReducer reduce(s.cut.rim);
    for (const bool back : {false, true}) {
      CanonicalSystem twisted = s.canonical;
      auto& w = twisted.word;
      const Word c = product({inverse(w[1]), w[2], w[3], inverse(w[2])});
      const Word to = back ? inverse(c) : c, fro = inverse(to);
      w[0] = product({w[0], to});
      w[1] = product({fro, w[1], to});
      w[2] = product({fro, w[2]});
      w[3] = product({w[3], w[2]});
      for (std::size_t i = 0; i < w.size(); ++i) {
        twisted.map[i] = map_of(-1, w[i], s.loop);
      }
      const CanonicalSystem found = shortened(-1, twisted, reduce, s.loop);
      EXPECT_LT(off_identity(map_of(-1, commutators(w.size()), found.map)), 1e-12);
      const double before = total_length(-1, twisted.map), after = total_length(-1, found.map);
      EXPECT_LT(after, 0.7 * before);
      EXPECT_LT(after, 1.2 * total_length(-1, s.canonical.map));
    }
  }
}

TEST(Neighbours, AreSixteenGenusSquaredLessEight) {
  for (int genus = 1; genus <= 6; ++genus) {
    const auto words = neighbour_words(genus);
    ASSERT_EQ(words.size(), static_cast<std::size_t>(16 * genus * genus - 8 * genus));
    const auto& s = test::of_genus(genus).system;
    std::vector<DeckMap> maps;
    for (const Word& w : words) {
      maps.push_back(map_of(s.kappa, w, s.canonical.map));
      EXPECT_GT(off_identity(maps.back()), 1e-3);
    }
    for (std::size_t i = 0; i < maps.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        ASSERT_GT(difference(maps[i], maps[j]), 1e-3) << genus;
      }
    }
  }
}

}  // namespace
}  // namespace ucvt
