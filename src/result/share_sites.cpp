#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/format.h>

#include "ucvt/components.h"
#include "ucvt/error.h"

namespace ucvt {
namespace {

/// Vertices that every simplicial surface of the genus has.
int simplicial_least(int genus) {
  if (genus == 2) {
    return 10;  // the one exception to Heawood's bound
  }
  return static_cast<int>(std::ceil((7 + std::sqrt(1 + 48.0 * genus)) / 2));
}

int least(int genus) {
  return genus == 0 ? 4 : 1;
}

std::vector<int> least_numbers(const std::vector<Component>& components, int (*of_genus)(int)) {
  std::vector<int> out;
  for (const Component& c : components) {
    out.push_back(of_genus(c.surface.genus));
  }
  return out;
}

std::int64_t sum(const std::vector<int>& numbers) {
  return std::accumulate(numbers.begin(), numbers.end(), std::int64_t{0});
}

/// Areas relative to their sum; equal where there is none.
std::vector<double> shares_of_area(const std::vector<Component>& components) {
  std::vector<double> out;
  for (const Component& c : components) {
    out.push_back(survey(c.surface.mesh).area);
  }
  const double total = std::accumulate(out.begin(), out.end(), 0.0);
  for (double& a : out) {
    a = total > 0 && std::isfinite(total) ? a / total : 1 / static_cast<double>(out.size());
  }
  return out;
}

/// Whole numbers near `quotas` that add up to `total`, which is their sum to rounding.
std::vector<int> largest_remainders(const std::vector<double>& quotas, std::int64_t total) {
  std::vector<int> out;
  std::vector<std::size_t> order(quotas.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  for (const double q : quotas) {
    out.push_back(static_cast<int>(q));
  }
  const auto rest = [&](std::size_t i) { return quotas[i] - std::floor(quotas[i]); };
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t i, std::size_t j) { return rest(i) > rest(j); });
  std::int64_t left = total - sum(out);
  for (std::size_t k = 0; left > 0; k = (k + 1) % order.size(), --left) {
    ++out[order[k]];
  }
  return out;
}

/// Those whose share is below the least number get that; the others share what remains.
std::vector<int> share(const std::vector<double>& areas, std::vector<int> numbers,
                       std::int64_t sites) {
  std::vector<bool> fixed(areas.size(), false);
  while (true) {
    double area = 0;
    std::int64_t left = sites;
    for (std::size_t i = 0; i < areas.size(); ++i) {
      area += fixed[i] ? 0 : areas[i];
      left -= fixed[i] ? numbers[i] : 0;
    }
    std::vector<double> quotas;
    std::vector<std::size_t> open;
    bool changed = false;
    for (std::size_t i = 0; i < areas.size(); ++i) {
      if (fixed[i]) {
        continue;
      }
      const double quota = area > 0 ? static_cast<double>(left) * areas[i] / area : 0;
      fixed[i] = quota < numbers[i];
      changed = changed || fixed[i];
      quotas.push_back(quota);
      open.push_back(i);
    }
    if (changed) {
      continue;
    }
    const std::vector<int> shared = largest_remainders(quotas, quotas.empty() ? 0 : left);
    for (std::size_t k = 0; k < open.size(); ++k) {
      numbers[open[k]] = shared[k];
    }
    return numbers;
  }
}

}  // namespace

std::vector<int> share_sites(const std::vector<Component>& components, int sites) {
  if (components.size() == 1) {
    return {sites};
  }
  const std::vector<int> needed = least_numbers(components, least);
  if (sum(needed) > sites) {
    throw InvalidInput(fmt::format("{} sites are too few for {} components; ask for at least {}",
                                   sites, components.size(), sum(needed)));
  }
  const std::vector<int> wanted = least_numbers(components, simplicial_least);
  return share(shares_of_area(components), sum(wanted) <= sites ? wanted : needed, sites);
}

}  // namespace ucvt
