#include "cover/short_generators.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

#include "cover/holonomy.h"

namespace ucvt {
namespace {

/// A move of the descent must shorten the total by this much.
constexpr double least_gain = 1e-9;

/// Rounds of the descent, which seldom takes ten.
constexpr int most_rounds = 200;

/// New generators of some handles as words in the old ones, called 1, 2 (3, 4).
using Move = std::vector<Word>;

/// Twists along a and b, and quarter turns. All keep [1, 2].
const std::vector<Move>& moves_of_one() {
  static const std::vector<Move> moves{{{1, 2}, {2}},  {{1, -2}, {2}},     {{1}, {2, 1}},
                                       {{1}, {2, -1}}, {{1, 2, -1}, {-1}}, {{-2}, {2, 1, -2}}};
  return moves;
}

/// Twists along c = 2^-1 3 4 3^-1, to either side, and exchanges. All keep [1, 2] [3, 4].
std::vector<Move> twists_and_exchanges() {
  const Word c{-2, 3, 4, -3}, back = inverse(c), first{1, 2, -1, -2}, second{3, 4, -3, -4};
  std::vector<Move> out;
  for (const auto& [to, fro] : {std::pair{c, back}, std::pair{back, c}}) {
    out.push_back({product({{1}, to}), product({fro, {2}, to}), product({fro, {3}}), Word{4}});
  }
  out.push_back(
      {{3}, {4}, product({inverse(second), {1}, second}), product({inverse(second), {2}, second})});
  out.push_back(
      {product({first, {3}, inverse(first)}), product({first, {4}, inverse(first)}), {1}, {2}});
  return out;
}

/// The words with every letter replaced by what the earlier move made of it.
Move after(const Move& earlier, const Move& later) {
  Move out;
  for (const Word& w : later) {
    std::vector<Word> parts;
    for (const std::int32_t x : w) {
      const Word& to = earlier[static_cast<std::size_t>(std::abs(x) - 1)];
      parts.push_back(x > 0 ? to : inverse(to));
    }
    out.push_back(product(parts));
  }
  return out;
}

/// Those, alone and after a move of either handle.
const std::vector<Move>& moves_of_two() {
  static const std::vector<Move> moves = [] {
    const std::vector<Move> alone = twists_and_exchanges();
    std::vector<Move> out = alone;
    for (const Move& m : moves_of_one()) {
      Move first = m, second{{1}, {2}};
      first.insert(first.end(), {Word{3}, Word{4}});
      for (Word w : m) {
        for (std::int32_t& x : w) {
          x += x > 0 ? 2 : -2;
        }
        second.push_back(w);
      }
      for (const Move& twist : alone) {
        out.push_back(after(first, twist));
        out.push_back(after(second, twist));
      }
    }
    return out;
  }();
  return moves;
}

/// A canonical system that moves change.
class Descent {
 public:
  Descent(double kappa, CanonicalSystem start, const WordReducer& reduce,
          const std::vector<DeckMap>& loop)
      : kappa_(kappa), now_(std::move(start)), reduce_(reduce), loop_(loop) {}

  CanonicalSystem run() {
    for (int round = 0; round < most_rounds && improve(); ++round) {
    }
    return std::move(now_);
  }

 private:
  /// Tries everything once; false when nothing helped.
  bool improve() {
    const std::size_t handles = now_.map.size() / 2;
    bool better = false;
    read_corners();
    for (std::size_t i = 0; i < handles; ++i) {
      better |= try_moves(moves_of_one(), 2 * i);
      if (i + 1 < handles) {
        better |= try_moves(moves_of_two(), 2 * i);
      }
    }
    better |= try_conjugations();
    return better;
  }

  /// By how much a move of the generators from `first` on shortens the total.
  [[nodiscard]] double gain(const Move& move, std::size_t first) const {
    const auto begin = now_.map.begin() + static_cast<std::ptrdiff_t>(first);
    const std::vector<DeckMap> from(begin, begin + static_cast<std::ptrdiff_t>(move.size()));
    std::vector<DeckMap> to;
    for (const Word& w : move) {
      to.push_back(map_of(kappa_, w, from));
    }
    const DeckMap& corner = corner_[first / 2];
    return total_length(kappa_, from, corner) - total_length(kappa_, to, corner);
  }

  /// The corners at which handles begin, as maps from the first.
  void read_corners() {
    corner_.assign(1, {});
    for (std::size_t i = 0; i < now_.map.size(); i += 2) {
      corner_.push_back(product(kappa_, corner_.back(),
                                map_of(kappa_, {1, 2, -1, -2}, {now_.map[i], now_.map[i + 1]})));
    }
  }

  void take(std::size_t generator, const Word& word) {
    now_.word[generator] = reduce_(word);
    now_.map[generator] = map_of(kappa_, now_.word[generator], loop_);
  }

  /// Makes moves of the generators from `first` on, until none of them is better.
  bool try_moves(const std::vector<Move>& moves, std::size_t first) {
    bool any = false;
    for (std::size_t tried = 0, i = 0; tried < moves.size(); i = (i + 1) % moves.size()) {
      if (gain(moves[i], first) > least_gain) {
        make(moves[i], first);
        any = true, tried = 0;
      } else {
        ++tried;
      }
    }
    return any;
  }

  void make(const Move& move, std::size_t first) {
    const auto begin = now_.word.begin() + static_cast<std::ptrdiff_t>(first);
    const std::vector<Word> old(begin, begin + static_cast<std::ptrdiff_t>(move.size()));
    const Move words = after(old, move);
    for (std::size_t k = 0; k < move.size(); ++k) {
      take(first + k, words[k]);
    }
    read_corners();
  }

  bool try_conjugations() {
    bool any = false;
    for (std::size_t i = 0; i < 2 * now_.map.size(); ++i) {
      const bool back = i % 2 == 1;
      const DeckMap g = back ? inverse(now_.map[i / 2]) : now_.map[i / 2];
      std::vector<DeckMap> to;
      for (const DeckMap& m : now_.map) {
        to.push_back(product(kappa_, product(kappa_, g, m), inverse(g)));
      }
      if (!(total_length(kappa_, to, {}) < total_length(kappa_, now_.map, {}) - least_gain)) {
        continue;
      }
      const Word by = back ? inverse(now_.word[i / 2]) : now_.word[i / 2];
      const std::vector<Word> old = now_.word;
      for (std::size_t k = 0; k < old.size(); ++k) {
        take(k, product({by, old[k], inverse(by)}));
      }
      read_corners();
      any = true;
    }
    return any;
  }

  double kappa_;
  CanonicalSystem now_;
  const WordReducer& reduce_;
  const std::vector<DeckMap>& loop_;
  std::vector<DeckMap> corner_;
};

}  // namespace

double total_length(double kappa, const std::vector<DeckMap>& generator, DeckMap corner) {
  double sum = 0;
  for (const DeckMap& m : generator) {
    sum += 2 * displacement(kappa, m);
  }
  for (const std::int32_t x : commutators(generator.size())) {
    corner = product(kappa, corner, map_of(kappa, {x}, generator));
    sum += displacement(kappa, corner);
  }
  return sum;
}

CanonicalSystem shortened(double kappa, CanonicalSystem start, const WordReducer& reduce,
                          const std::vector<DeckMap>& loop) {
  CanonicalSystem best = std::move(start);
  for (int round = 0; round < most_rounds; ++round) {
    best = Descent(kappa, std::move(best), reduce, loop).run();
    // Another handle may come first.
    const double least = total_length(kappa, best.map);
    CanonicalSystem turned = best;
    for (std::size_t i = 2; i < turned.map.size(); i += 2) {
      std::rotate(turned.word.begin(), turned.word.begin() + 2, turned.word.end());
      std::rotate(turned.map.begin(), turned.map.begin() + 2, turned.map.end());
      if (total_length(kappa, turned.map) < total_length(kappa, best.map) - least_gain) {
        best = turned;
      }
    }
    if (!(total_length(kappa, best.map) < least)) {
      break;
    }
  }
  return best;
}

}  // namespace ucvt
