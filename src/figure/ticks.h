// Ticks of axes: round numbers and how they are written.
#pragma once

#include <string>
#include <vector>

namespace ucvt {

struct Ticks {
  std::vector<double> at;           ///< ascending, within the range asked for
  std::vector<std::string> labels;  ///< of each; UTF-8
  std::string factor;  ///< what the labels are to be multiplied by, as text; often empty
};

/// At most `count` multiples of 1, 2 or 5 times a power of ten within [lo, hi], labels with the
/// decimals of the step. Requires lo < hi and count >= 2.
Ticks linear_ticks(double lo, double hi, int count);

/// Powers of ten within [lo, hi], every k-th when there are more than `count`; when there are fewer
/// than two decades, also 2 and 5 times those, or else linear ticks. Requires 0 < lo < hi.
Ticks log_ticks(double lo, double hi, int count);

}  // namespace ucvt
