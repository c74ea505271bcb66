#include "mesh/boundary_loops.h"

#include <cmath>
#include <limits>
#include <unordered_map>

#include "mesh/edge_groups.h"

namespace ucvt {
namespace {

class Tracer {
 public:
  Tracer(const TriangleMesh& mesh, Fans& fans)
      : mesh_(mesh), fans_(fans), used_(fans.twin.size(), false) {
    for (std::size_t i = 0; i < fans_.twin.size(); ++i) {
      if (fans_.twin[i] < 0) {
        const auto side = static_cast<std::int32_t>(i);
        leaving_[side_head(mesh_, side)].push_back(side);
      }
    }
  }

  std::vector<BoundaryLoop> run() {
    for (std::size_t i = 0; i < fans_.twin.size(); ++i) {
      if (fans_.twin[i] < 0 && !used_[i]) {
        walk_from(static_cast<std::int32_t>(i));
      }
    }
    return std::move(loops_);
  }

 private:
  /// Walks along the hole and cuts a loop off whenever a vertex comes up again.
  void walk_from(std::int32_t side) {
    std::vector<std::int32_t> path;
    std::unordered_map<std::int32_t, std::size_t>
        at;  // of a vertex on the path: the side it leaves by
    while (side >= 0) {
      used_[static_cast<std::size_t>(side)] = true;
      at[side_head(mesh_, side)] = path.size();
      path.push_back(side);
      const std::int32_t here = side_tail(mesh_, side);
      side = next(side);
      const auto found = at.find(here);
      if (found == at.end()) {
        continue;
      }
      const std::size_t first = found->second;
      BoundaryLoop loop;
      for (std::size_t k = first; k < path.size(); ++k) {
        loop.vertices.push_back(side_head(mesh_, path[k]));
        loop.sides.push_back(path[k]);
        at.erase(loop.vertices.back());
      }
      path.resize(first);
      loops_.push_back(std::move(loop));
      side = path.empty() ? -1 : next(path.back());
    }
  }

  /// The side to go on with at the vertex where this one ends; -1: none.
  std::int32_t next(std::int32_t side) {
    const std::int32_t here = side_tail(mesh_, side);
    const std::int32_t fan = fans_.fan.find(side);
    std::int32_t best = -1;
    double best_rank = std::numeric_limits<double>::infinity();
    for (const std::int32_t other : leaving_[here]) {
      if (used_[static_cast<std::size_t>(other)]) {
        continue;
      }
      // The same fan again comes last: all other fans and holes lie between.
      constexpr double full_turn = 8;
      const bool same = fans_.fan.find(Fans::end_corner(other)) == fan;
      const double rank =
          angle(here, side_head(mesh_, side), side_tail(mesh_, other)) + (same ? full_turn : 0);
      if (best < 0 || rank < best_rank) {
        best = other, best_rank = rank;
      }
    }
    return best;
  }

  [[nodiscard]] double angle(std::int32_t corner, std::int32_t a, std::int32_t b) const {
    const auto at = [&](std::int32_t v, std::size_t k) {
      return mesh_.positions[static_cast<std::size_t>(v)][k];
    };
    Position u{}, w{};
    for (std::size_t k = 0; k < 3; ++k) {
      u[k] = at(a, k) - at(corner, k), w[k] = at(b, k) - at(corner, k);
    }
    const double m = std::hypot(u[0], u[1], u[2]), n = std::hypot(w[0], w[1], w[2]);
    double sine = 0, cosine = 0;
    for (std::size_t k = 0; k < 3 && m > 0 && n > 0; ++k) {
      sine += std::pow(u[k] / m - w[k] / n, 2), cosine += std::pow(u[k] / m + w[k] / n, 2);
    }
    return 2 * std::atan2(std::sqrt(sine), std::sqrt(cosine));
  }

  const TriangleMesh& mesh_;
  Fans& fans_;
  std::vector<bool> used_;
  std::unordered_map<std::int32_t, std::vector<std::int32_t>> leaving_;
  std::vector<BoundaryLoop> loops_;
};

}  // namespace

std::vector<BoundaryLoop> boundary_loops(const TriangleMesh& mesh, Fans& fans) {
  return Tracer(mesh, fans).run();
}

}  // namespace ucvt
