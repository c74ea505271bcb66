#include "result/polygon_triangles.h"

#include <algorithm>
#include <numeric>

namespace ucvt {
namespace {

using Bary = std::array<double, 3>;

/// Areas up to this part of the face are taken for flat. Rounding is twenty times smaller, so that no
/// two polygons on the two sides of a line both find an ear of positive area over the same corners:
/// they would cut off the same diagonal, and the surface would branch there.
constexpr double flat = 1e-14;

/// Corners as near as this to the one before stand in the way of all ears; they are put in at the end.
constexpr double together = 1e-12;

/// The triangle's share of the face, signed; exactly 0 for three points on one side of the face.
double area(const Bary& a, const Bary& b, const Bary& c) {
  return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
         a[2] * (b[0] * c[1] - b[1] * c[0]);
}

double distance2(const Bary& a, const Bary& b) {
  const double x = a[0] - b[0], y = a[1] - b[1], z = a[2] - b[2];
  return x * x + y * y + z * z;
}

class EarCutter {
 public:
  explicit EarCutter(std::span<const Bary> corner) : corner_(corner), quality_(corner.size()) {
    for (std::size_t i = 0; i < corner.size(); ++i) {
      if (left_.empty() || !is_near(left_.back(), i)) {
        left_.push_back(i);
      }
    }
    while (left_.size() > 1 && is_near(left_.back(), left_.front())) {
      left_.pop_back();
    }
    if (left_.size() < 3) {
      left_.resize(corner.size());
      std::iota(left_.begin(), left_.end(), 0);
    }
    kept_ = left_;
  }

  PolygonTriangles run() {
    cut_all();
    for (std::size_t n = 0; n < kept_.size(); ++n) {
      put_in_between(kept_[n], kept_[n + 1 == kept_.size() ? 0 : n + 1]);
    }
    return std::move(out_);
  }

 private:
  [[nodiscard]] bool is_near(std::size_t a, std::size_t b) const {
    return distance2(corner_[a], corner_[b]) < together * together;
  }

  void cut_all() {
    for (std::size_t n = 0; n < left_.size(); ++n) {
      measure(n);
    }
    while (left_.size() > 3) {
      std::size_t ear = best();
      if (quality_[left_[ear]] <= 0) {
        // Corners cut off since may have stood in the way of others.
        for (std::size_t n = 0; n < left_.size(); ++n) {
          measure(n);
        }
        ear = best();
      }
      if (quality_[left_[ear]] <= 0) {
        fan(left_, left_);
        return;
      }
      cut(ear);
    }
    add(left_[0], left_[1], left_[2]);
  }

  /// Puts the corners left out between a and b in: the triangle there becomes a fan round a new point,
  /// for a diagonal from one of them might be drawn by a polygon beside this one too.
  void put_in_between(std::size_t a, std::size_t b) {
    if ((a + 1) % corner_.size() == b) {
      return;
    }
    const auto from = static_cast<std::int32_t>(a), to = static_cast<std::int32_t>(b);
    for (std::size_t t = 0; t < out_.triangles.size(); ++t) {
      for (std::size_t k = 0; k < 3; ++k) {
        const Corners f = out_.triangles[t];
        if (f[k] != from || f[(k + 1) % 3] != to) {
          continue;
        }
        const auto apex = static_cast<std::size_t>(f[(k + 2) % 3]);
        out_.triangles.erase(out_.triangles.begin() + static_cast<std::ptrdiff_t>(t));
        std::vector<std::size_t> round{b, apex};
        for (std::size_t i = a; i != b; i = (i + 1) % corner_.size()) {
          round.push_back(i);
        }
        fan(round, {a, b, apex});
        return;
      }
    }
  }

  [[nodiscard]] std::size_t before(std::size_t n) const {
    return n == 0 ? left_.size() - 1 : n - 1;
  }
  [[nodiscard]] std::size_t after(std::size_t n) const { return n + 1 == left_.size() ? 0 : n + 1; }

  void add(std::size_t a, std::size_t b, std::size_t c) {
    out_.triangles.push_back(
        {static_cast<std::int32_t>(a), static_cast<std::int32_t>(b), static_cast<std::int32_t>(c)});
  }

  /// How round the ear at a corner is; 0 when it cannot be cut off.
  void measure(std::size_t n) {
    const std::size_t i = left_[before(n)], j = left_[n], k = left_[after(n)];
    const Bary &a = corner_[i], &b = corner_[j], &c = corner_[k];
    const double size = area(a, b, c);
    quality_[j] = 0;
    if (!(size > flat)) {
      return;
    }
    for (const std::size_t other : left_) {
      const Bary& p = corner_[other];
      if (other != i && other != j && other != k && area(a, b, p) >= -flat &&
          area(b, c, p) >= -flat && area(c, a, p) >= -flat) {
        return;
      }
    }
    quality_[j] = size / std::max({distance2(a, b), distance2(b, c), distance2(c, a)});
  }

  [[nodiscard]] std::size_t best() const {
    std::size_t out = 0;
    for (std::size_t n = 1; n < left_.size(); ++n) {
      out = quality_[left_[n]] > quality_[left_[out]] ? n : out;
    }
    return out;
  }

  void cut(std::size_t n) {
    add(left_[before(n)], left_[n], left_[after(n)]);
    left_.erase(left_.begin() + static_cast<std::ptrdiff_t>(n));
    measure(n % left_.size());
    measure(before(n % left_.size()));
  }

  /// Joins a round to a new point, the mean of some others.
  void fan(std::span<const std::size_t> round, const std::vector<std::size_t>& about) {
    const std::size_t centre = corner_.size() + out_.added.size();
    Bary mean{};
    for (const std::size_t i : about) {
      const Bary& p = i < corner_.size() ? corner_[i] : out_.added[i - corner_.size()];
      for (std::size_t k = 0; k < 3; ++k) {
        mean[k] += p[k] / static_cast<double>(about.size());
      }
    }
    out_.added.push_back(mean);
    for (std::size_t n = 0; n < round.size(); ++n) {
      add(round[n], round[n + 1 == round.size() ? 0 : n + 1], centre);
    }
  }

  std::span<const Bary> corner_;
  std::vector<std::size_t> left_, kept_;
  std::vector<double> quality_;  // by corner
  PolygonTriangles out_;
};

}  // namespace

PolygonTriangles triangulate_polygon(std::span<const Bary> corner) {
  return EarCutter(corner).run();
}

PolygonTriangles fan_of_polygon(std::span<const Bary> corner) {
  PolygonTriangles out;
  const std::size_t n = corner.size();
  Bary& mean = out.added.emplace_back();
  for (std::size_t i = 0; i < n; ++i) {
    out.triangles.push_back({static_cast<std::int32_t>(i), static_cast<std::int32_t>((i + 1) % n),
                             static_cast<std::int32_t>(n)});
    for (std::size_t k = 0; k < 3; ++k) {
      mean[k] += corner[i][k] / static_cast<double>(n);
    }
  }
  return out;
}

}  // namespace ucvt
