#include "cover/canonical_system.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "cover/holonomy.h"

namespace ucvt {
namespace {

/// Second letters are looked for this near to the first one, if there are any.
constexpr std::size_t least_window = 64;

/// A part of the rim: a letter, or a handle that has been collected.
struct Item {
  std::int32_t letter = 0;  ///< 0: a handle
  std::size_t handle = 0;
  Word word;
  DeckMap map;
};

/// Two linked pairs of the rim a P b Q a^-1 R b^-1 S, turned round so that a comes first: the places
/// of a, b, a^-1, b^-1 before the turn.
struct Handle {
  std::size_t a = 0, b = 0, a_back = 0, b_back = 0;
};

class Collector {
 public:
  Collector(double kappa, const Word& rim, const std::vector<DeckMap>& loop)
      : kappa_(kappa), loop_(loop), reduce_(rim) {
    for (const std::int32_t x : rim) {
      items_.push_back({x, 0, {x}, map_of(kappa, {x}, loop)});
    }
  }

  CanonicalSystem run() {
    for (std::size_t i = 0; i < loop_.size() / 2; ++i) {
      collect(shortest());
    }
    CanonicalSystem out;
    for (const Item& item : items_) {
      for (const std::size_t g : {2 * item.handle, 2 * item.handle + 1}) {
        out.word.push_back(found_.word[g]);
        out.map.push_back(found_.map[g]);
      }
    }
    return out;
  }

 private:
  [[nodiscard]] DeckMap times(const DeckMap& p, const DeckMap& q) const {
    return product(kappa_, p, q);
  }

  /// The map of the items after `from` and before `to`, going round.
  [[nodiscard]] DeckMap between(std::size_t from, std::size_t to) const {
    const DeckMap part = times(inverse(before_[from + 1]), before_[to]);
    return from < to ? part : times(times(inverse(before_[from + 1]), before_.back()), before_[to]);
  }

  /// a (R Q)^-1 and R Q P b R^-1, of which the commutator times R Q P is a P b Q a^-1 R b^-1.
  [[nodiscard]] std::array<DeckMap, 2> maps(const Handle& h) const {
    const DeckMap p = between(h.a, h.b), q = between(h.b, h.a_back),
                  r = between(h.a_back, h.b_back);
    const DeckMap rq = times(r, q);
    return {times(items_[h.a].map, inverse(rq)),
            times(times(rq, p), times(items_[h.b].map, inverse(r)))};
  }

  [[nodiscard]] double length(const std::array<DeckMap, 2>& m) const {
    const DeckMap rim = times(times(m[0], m[1]), times(inverse(m[0]), inverse(m[1])));
    return 2 * displacement(kappa_, m[0]) + 2 * displacement(kappa_, m[1]) +
           displacement(kappa_, rim);
  }

  /// The linked pairs with the shortest loops, among those near to each other on a long rim.
  Handle shortest() {
    Handle best;
    std::size_t window = least_window;
    while (!find_shortest(window, best)) {
      window *= 2;
    }
    return best;
  }

  bool find_shortest(std::size_t window, Handle& best) {
    const std::size_t n = items_.size();
    before_.assign(1, {});
    for (const Item& item : items_) {
      before_.push_back(times(before_.back(), item.map));
    }
    std::vector<std::size_t> back(n, n);
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < n && items_[i].letter != 0; ++j) {
        back[i] = items_[j].letter == -items_[i].letter ? j : back[i];
      }
    }
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t a = 0; a < n; ++a) {
      // Places counted from a on.
      const auto round = [&](std::size_t i) { return (i + n - a) % n; };
      for (std::size_t b = (a + 1) % n; round(b) < window && round(b) != 0 && back[a] < n;
           b = (b + 1) % n) {
        if (back[b] == n || round(b) > round(back[a]) || round(back[b]) <= round(back[a])) {
          continue;
        }
        const Handle h{a, b, back[a], back[b]};
        if (const double l = length(maps(h)); l < least) {
          least = l, best = h;
        }
      }
    }
    return least < std::numeric_limits<double>::infinity() || window > n;
  }

  [[nodiscard]] std::vector<Item> items_between(std::size_t from, std::size_t to) const {
    std::vector<Item> out;
    for (std::size_t i = (from + 1) % items_.size(); i != to; i = (i + 1) % items_.size()) {
      out.push_back(items_[i]);
    }
    return out;
  }

  static Word word_of(const std::vector<Item>& items) {
    std::vector<Word> parts;
    for (const Item& item : items) {
      parts.push_back(item.word);
    }
    return product(parts);
  }

  void collect(const Handle& h) {
    const auto p = items_between(h.a, h.b), q = items_between(h.b, h.a_back);
    const auto r = items_between(h.a_back, h.b_back), s = items_between(h.b_back, h.a);
    const Word wr = word_of(r), rq = product({wr, word_of(q)});
    const Word a = reduce_(product({items_[h.a].word, inverse(rq)}));
    const Word b = reduce_(product({rq, word_of(p), items_[h.b].word, inverse(wr)}));
    Item handle{0, found_.word.size() / 2, reduce_(product({a, b, inverse(a), inverse(b)})), {}};
    handle.map = map_of(kappa_, handle.word, loop_);
    for (const Word* w : {&a, &b}) {
      found_.word.push_back(*w);
      found_.map.push_back(map_of(kappa_, *w, loop_));
    }
    items_.assign(1, std::move(handle));
    for (const auto* part : {&r, &q, &p, &s}) {
      items_.insert(items_.end(), part->begin(), part->end());
    }
  }

  double kappa_;
  const std::vector<DeckMap>& loop_;
  WordReducer reduce_;
  std::vector<Item> items_;
  std::vector<DeckMap> before_;
  CanonicalSystem found_;
};

}  // namespace

CanonicalSystem collect_handles(double kappa, const Word& rim, const std::vector<DeckMap>& loop) {
  return Collector(kappa, rim, loop).run();
}

}  // namespace ucvt
