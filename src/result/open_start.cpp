#include "result/open_start.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "conformal/uniformize.h"
#include "ucvt/error.h"

namespace ucvt {
namespace {

/// Times that boundary sites are spread wider when they are too many.
constexpr int max_tries = 20;

/// Fewer sites inside are not worth a level before them.
constexpr std::size_t least_inside = 60;

/// Of closing gaps in the boundary.
constexpr int max_rounds = 10;

/// Where the log scales span more over all but the ends of the surface, few sites do not resolve the density.
/// At corners, which are cones of the double, they span as much as T resolves; that is a small part.
constexpr double steep_span = 4.3, ends = 0.01;

/// The coarsest level comes to rest, the others roughly, as on closed surfaces.
const OptimizeOptions at_rest{.evaluations = 200, .tolerance = 1e-4, .least_decrease = 1e-5};
const OptimizeOptions settled{.evaluations = 100, .tolerance = 1e-3, .least_decrease = 1e-4};

/// A surface point at a vertex of T.
SurfacePoint at_vertex(const UniformSurface& t, std::int32_t v) {
  const Halfedge h = t.connectivity().outgoing({v});
  SurfacePoint p{h.face(), {0, 0, 0}};
  p.bary[static_cast<std::size_t>(h.id % 3)] = 1;
  return p;
}

bool is_steep(const Uniformized& t) {
  std::vector<std::pair<double, double>> scales;
  double area = 0;
  for (std::size_t v = 0; v < t.log_scale.size(); ++v) {
    scales.emplace_back(t.log_scale[v], t.vertex_area_3d[v]);
    area += t.vertex_area_3d[v];
  }
  std::sort(scales.begin(), scales.end());
  double above = 0, low = scales.back().first, high = low;
  for (std::size_t i = scales.size(); i-- > 0;) {
    above += scales[i].second;
    high = above <= ends * area ? scales[i].first : high;
    low = above <= (1 - ends) * area ? scales[i].first : low;
  }
  return high - low > steep_span;
}

class OpenStart {
 public:
  OpenStart(const OpenDouble& made, const SurfaceMass& mass, const RemeshOptions& options)
      : made_(made),
        t_(made.surface.value()),
        mass_(mass),
        options_(options),
        by_levels_(options.init == InitialSites::Multilevel && !is_steep(t_)) {}

  [[nodiscard]] OpenSites sites(std::size_t asked, double spacing) const {
    const auto boundary = sparse_boundary(asked, spacing);
    OpenSites out = on_boundary(boundary);
    if (asked <= out.line.size()) {
      refuse(asked, out);
    }
    const std::size_t inside = asked - out.line.size();
    if (auto pairs = level_by_level(inside, spacing)) {
      out.layout.pairs = std::move(*pairs);
      return out;
    }
    for (const std::int32_t v : inner_sites(made_.half, made_.curves, boundary, inside)) {
      const std::int32_t image = made_.doubled.mirror[static_cast<std::size_t>(v)];
      out.layout.pairs.push_back({at_vertex(t_.surface, v), at_vertex(t_.surface, image)});
    }
    return out;
  }

 private:
  using Pairs = std::vector<std::array<SurfacePoint, 2>>;

  /// Sites on the boundary: fewer than asked for in all, if its loops and corners allow that.
  [[nodiscard]] std::vector<std::vector<BoundarySite>> sparse_boundary(std::size_t asked,
                                                                       double spacing) const {
    auto out = boundary_sites(made_.half, made_.curves, spacing);
    for (int tries = 0; tries < max_tries && count(out) >= asked; ++tries) {
      spacing *= 1.25;
      out = boundary_sites(made_.half, made_.curves, spacing);
    }
    return out;
  }

  static std::size_t count(const std::vector<std::vector<BoundarySite>>& boundary) {
    std::size_t sum = 0;
    for (const auto& loop : boundary) {
      sum += loop.size();
    }
    return sum;
  }

  [[nodiscard]] OpenSites on_boundary(
      const std::vector<std::vector<BoundarySite>>& boundary) const {
    OpenSites out;
    for (const auto& loop : boundary) {
      out.loops.emplace_back();
      for (const BoundarySite& site : loop) {
        out.loops.back().push_back(out.line.size());
        out.line.push_back(site);
        out.layout.on_line.push_back(at_vertex(t_.surface, site.vertex));
        out.layout.fixed.push_back(site.fixed);
      }
    }
    return out;
  }

  [[noreturn]] static void refuse(std::size_t asked, const OpenSites& sites) {
    const auto corners = std::count(sites.layout.fixed.begin(), sites.layout.fixed.end(), true);
    throw InvalidInput(fmt::format(
        "{} sites are too few for a boundary of {} loop{} with {} corner{}; ask for at least {}",
        asked, sites.loops.size(), sites.loops.size() == 1 ? "" : "s", corners,
        corners == 1 ? "" : "s", sites.line.size() + 1));
  }

  /// Sites inside and the middles of edges between sites, from a level of a fourth as many; none when
  /// there is no such level.
  [[nodiscard]] std::optional<Pairs> level_by_level(std::size_t inside, double spacing) const {
    if (!by_levels_) {
      return std::nullopt;
    }
    // n sites inside and b on the boundary have 3 n + b - 3 chi edges but for those along it.
    const std::size_t on_line = count(boundary_sites(made_.half, made_.curves, 2 * spacing));
    const auto euler = std::int64_t{1 - t_.report.genus};  // half of the double's
    const std::int64_t four =
        static_cast<std::int64_t>(inside) - static_cast<std::int64_t>(on_line) + 3 * euler;
    const auto coarse = static_cast<std::size_t>(std::max<std::int64_t>(0, four + 3) / 4);
    if (coarse < least_inside) {
      return std::nullopt;
    }
    try {
      Pairs out = refined(sites(coarse + on_line, 2 * spacing), inside);
      if (out.size() < inside) {
        // Gaps in the boundary took sites away; about as many will be.
        const std::size_t more = (inside - out.size()) / 3 + 1;
        out = refined(sites(coarse + more + on_line, 2 * spacing), inside);
      }
      return out.size() == inside ? std::optional(std::move(out)) : std::nullopt;
    } catch (const NumericalError&) {
      return std::nullopt;
    }
  }

  /// Fewer than wanted where there are too few edges.
  [[nodiscard]] Pairs refined(OpenSites coarse, std::size_t inside) const {
    OptimizeOptions how = coarse.layout.pairs.size() < 4 * least_inside ? at_rest : settled;
    how.method = options_.method;
    for (int round = 0; round < max_rounds; ++round) {
      MirrorSites sites(mass_, coarse.layout);
      if (optimize(sites, how, options_.monitor).cancelled) {
        throw Cancelled("interrupted; no output was written");
      }
      const HalfView half(sites, coarse.loops, sides_in_half(t_, sites, made_.half.faces.size()));
      coarse.layout = sites.layout();
      const std::vector<HalfView::Gap> gaps = half.gaps();
      if (gaps.empty()) {
        return with_middles(half, std::move(coarse.layout.pairs), inside);
      }
      close_gaps(gaps, coarse);
      how = settled;
      how.method = options_.method;
    }
    return {};
  }

  static Pairs with_middles(const HalfView& half, Pairs pairs, std::size_t inside) {
    for (const Halfedge h : half.inner_edges()) {
      if (pairs.size() < inside) {
        pairs.push_back(half.middle(h));
      }
    }
    return pairs;
  }

  const OpenDouble& made_;
  const Uniformized& t_;
  const SurfaceMass& mass_;
  const RemeshOptions& options_;
  bool by_levels_;
};

}  // namespace

void close_gaps(const std::vector<HalfView::Gap>& gaps, OpenSites& sites) {
  MirrorLayout& layout = sites.layout;
  std::vector<bool> gone(layout.pairs.size(), false);
  std::vector<std::vector<std::size_t>> loops(sites.loops.size());
  const auto after = [&](std::size_t p) {
    for (const HalfView::Gap& gap : gaps) {
      if (gap.from == p && gap.pair && !gone[*gap.pair]) {
        gone[*gap.pair] = true;
        return &gap;
      }
    }
    return static_cast<const HalfView::Gap*>(nullptr);
  };
  for (std::size_t k = 0; k < loops.size(); ++k) {
    for (const std::size_t p : sites.loops[k]) {
      loops[k].push_back(p);
      if (const HalfView::Gap* gap = after(p)) {
        loops[k].push_back(sites.line.size());
        sites.line.push_back({-1, sites.line[p].arc, false});
        layout.on_line.push_back(gap->foot);
        layout.fixed.push_back(false);
      }
    }
  }
  sites.loops = std::move(loops);
  std::vector<std::array<SurfacePoint, 2>> kept;
  for (std::size_t i = 0; i < gone.size(); ++i) {
    if (!gone[i]) {
      kept.push_back(layout.pairs[i]);
    }
  }
  layout.pairs = std::move(kept);
}

OpenSites open_start(const OpenDouble& made, const SurfaceMass& mass, double spacing,
                     const RemeshOptions& options) {
  return OpenStart(made, mass, options).sites(static_cast<std::size_t>(options.sites), spacing);
}

}  // namespace ucvt
