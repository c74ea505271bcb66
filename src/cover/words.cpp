#include "cover/words.h"

#include <algorithm>

namespace ucvt {
namespace {

void append(Word& to, const Word& w) {
  for (const std::int32_t x : w) {
    if (!to.empty() && to.back() == -x) {
      to.pop_back();
    } else {
      to.push_back(x);
    }
  }
}

}  // namespace

Word inverse(const Word& w) {
  Word out(w.rbegin(), w.rend());
  for (std::int32_t& x : out) {
    x = -x;
  }
  return out;
}

Word product(const std::vector<Word>& words) {
  Word out;
  for (const Word& w : words) {
    append(out, w);
  }
  return out;
}

WordReducer::WordReducer(const Word& relator) : length_(relator.size()) {
  for (std::size_t side = 0; side < 2; ++side) {
    const Word w = side == 0 ? relator : inverse(relator);
    next_[side].resize(length_ + 1);
    for (std::size_t i = 0; i < length_; ++i) {
      next_[side][slot(w[i])] = w[(i + 1) % length_];
    }
  }
}

std::size_t WordReducer::slot(std::int32_t letter) const {
  const auto half = static_cast<std::int64_t>(length_ / 2);
  return static_cast<std::size_t>(half + letter);
}

bool WordReducer::shorten_once(Word& w) const {
  for (const auto& next : next_) {
    const auto follows = [&](std::int32_t x) { return next[slot(x)]; };
    for (std::size_t i = 0, end = 0; i < w.size(); i = end) {
      for (end = i + 1; end < w.size() && w[end] == follows(w[end - 1]); ++end) {
      }
      const std::size_t run = end - i;
      if (run <= length_ / 2 || run > length_) {
        continue;
      }
      Word rest;
      for (std::int32_t x = w[end - 1]; rest.size() < length_ - run;) {
        rest.push_back(x = follows(x));
      }
      w = product({Word(w.begin(), w.begin() + static_cast<std::ptrdiff_t>(i)), inverse(rest),
                   Word(w.begin() + static_cast<std::ptrdiff_t>(end), w.end())});
      return true;
    }
  }
  return false;
}

Word WordReducer::operator()(Word w) const {
  w = product({w});
  while (length_ > 4 && shorten_once(w)) {
  }
  return w;
}

Word commutators(std::size_t generators) {
  Word out;
  for (std::size_t i = 0; i < generators; i += 2) {
    const auto a = static_cast<std::int32_t>(i + 1);
    out.insert(out.end(), {a, a + 1, -a, -a - 1});
  }
  return out;
}

}  // namespace ucvt
