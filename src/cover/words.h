// Words in the generators of a surface's group, letters +-(i + 1).
#pragma once

#include <array>
#include <vector>

#include "cover/cut_graph.h"

namespace ucvt {

Word inverse(const Word& w);

/// The words one after the other, freely reduced.
Word product(const std::vector<Word>& words);

/// Shortens words by a relator in which every letter occurs once in each direction: whatever runs
/// along more than half of it goes the other way round (Dehn's algorithm). Two letters: only freely.
class WordReducer {
 public:
  explicit WordReducer(const Word& relator);
  [[nodiscard]] Word operator()(Word w) const;

 private:
  [[nodiscard]] bool shorten_once(Word& w) const;
  [[nodiscard]] std::size_t slot(std::int32_t letter) const;

  std::size_t length_;
  /// By letter: what follows it in the relator, and in the inverse of that.
  std::array<std::vector<std::int32_t>, 2> next_;
};

/// The product of commutators of a1, b1, a2, b2, ...
Word commutators(std::size_t generators);

}  // namespace ucvt
