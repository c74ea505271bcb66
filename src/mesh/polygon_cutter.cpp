#include "mesh/polygon_cutter.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace ucvt {
namespace {

constexpr std::uint64_t empty_slot = ~std::uint64_t{0};
// Twice an area in the unit box that rounding of the projection can make from collinear points.
constexpr double flat = 1e-14;
// A used diagonal ranks below every unused one; qualities lie in [-1, 1].
constexpr double used_penalty = 4;
// A quad's second diagonal must be better by this much, so that rounding does not choose.
constexpr double clearly_better = 1e-9;

std::uint64_t edge_key(std::int32_t a, std::int32_t b) {
  const auto [low, high] = std::minmax(a, b);
  return static_cast<std::uint64_t>(low) << 32 | static_cast<std::uint32_t>(high);
}

Position minus(const Position& a, const Position& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

Position cross(const Position& a, const Position& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

double dot(const Position& a, const Position& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// Signed area against `normal` over squared edge lengths: positive when turned like the polygon.
double shape(const Position& a, const Position& b, const Position& c, const Position& normal) {
  const Position ab = minus(b, a), bc = minus(c, b), ca = minus(a, c);
  const double squares = dot(ab, ab) + dot(bc, bc) + dot(ca, ca);
  return squares > 0 ? dot(cross(ab, bc), normal) / squares : 0;
}

// The corner whose vertex comes again later, or the size when all differ.
std::size_t find_repeated(std::span<const std::int32_t> corners) {
  if (corners.size() > 16) {
    std::vector<std::int32_t> sorted(corners.begin(), corners.end());
    std::sort(sorted.begin(), sorted.end());
    const auto twin = std::adjacent_find(sorted.begin(), sorted.end());
    if (twin == sorted.end()) {
      return corners.size();
    }
    return static_cast<std::size_t>(std::find(corners.begin(), corners.end(), *twin) -
                                    corners.begin());
  }
  for (std::size_t i = 0; i < corners.size(); ++i) {
    for (std::size_t j = i + 1; j < corners.size(); ++j) {
      if (corners[i] == corners[j]) {
        return i;
      }
    }
  }
  return corners.size();
}

}  // namespace

EdgeSet::EdgeSet(std::size_t expected)
    : slots_(std::bit_ceil(std::max<std::size_t>(64, expected)), empty_slot) {}

std::size_t EdgeSet::slot(std::uint64_t key) const {
  const std::size_t mask = slots_.size() - 1;
  std::uint64_t hash = key * 0x9E3779B97F4A7C15U;
  hash ^= hash >> 32;
  std::size_t i = static_cast<std::size_t>(hash) & mask;
  while (slots_[i] != empty_slot && slots_[i] != key) {
    i = (i + 1) & mask;
  }
  return i;
}

void EdgeSet::grow() {
  std::vector<std::uint64_t> old(slots_.size() * 2, empty_slot);
  old.swap(slots_);
  for (const std::uint64_t key : old) {
    if (key != empty_slot) {
      slots_[slot(key)] = key;
    }
  }
}

void EdgeSet::insert(std::int32_t a, std::int32_t b) {
  const std::uint64_t key = edge_key(a, b);
  const std::size_t i = slot(key);
  if (slots_[i] == key) {
    return;
  }
  slots_[i] = key;
  if (++size_ * 10 > slots_.size() * 7) {
    grow();
  }
}

bool EdgeSet::contains(std::int32_t a, std::int32_t b) const {
  return slots_[slot(edge_key(a, b))] != empty_slot;
}

void PolygonCutter::add_boundary(std::span<const std::int32_t> corners) {
  for (std::size_t i = 0; i < corners.size(); ++i) {
    edges_.insert(corners[i], corners[(i + 1) % corners.size()]);
  }
}

void PolygonCutter::emit(std::int32_t a, std::int32_t b, std::int32_t c,
                         std::vector<Corners>& triangles) {
  triangles.push_back({a, b, c});
  edges_.insert(a, b);
  edges_.insert(b, c);
  edges_.insert(c, a);
}

void PolygonCutter::cut(std::span<const std::int32_t> corners, std::vector<Corners>& triangles) {
  if (corners.size() == 3) {
    triangles.push_back({corners[0], corners[1], corners[2]});
    return;
  }
  if (const std::size_t twice = find_repeated(corners); twice < corners.size()) {
    // A fan from there gives a face that shows the fault.
    cut_fan(corners, twice, triangles);
    return;
  }
  const Position normal = load_points(corners);
  if (corners.size() == 4) {
    cut_quad(corners, normal, triangles);
    return;
  }
  if (dot(normal, normal) == 0) {
    cut_fan(corners, best_apex(corners), triangles);
    return;
  }
  project(corners, normal);
  cut_leftover(normal, clip_ears(triangles), triangles);
}

// Clips until four corners are left or nothing is an ear; returns a corner that is left.
std::int32_t PolygonCutter::clip_ears(std::vector<Corners>& triangles) {
  const auto size = static_cast<std::int32_t>(ring_.size());
  for (std::int32_t i = 0; i < size; ++i) {
    classify(i);
  }
  reflex_.swap(late_reflex_);
  late_reflex_.clear();
  std::sort(reflex_.begin(), reflex_.end(), [this](std::int32_t a, std::int32_t b) {
    return ring_[static_cast<std::size_t>(a)].x < ring_[static_cast<std::size_t>(b)].x;
  });
  std::int32_t left = size, start = 0;
  while (left > 4) {
    if (ears_.empty()) {
      // At first, and when clipping has freed ears that others stood in.
      for (std::int32_t i = 0; i < size; ++i) {
        offer(i);
      }
      if (ears_.empty()) {
        break;
      }
    }
    const Ear ear = ears_.top();
    ears_.pop();
    if (ear.version != ring_[static_cast<std::size_t>(ear.corner)].version) {
      continue;
    }
    start = clip(ear.corner, triangles);
    --left;
  }
  return start;
}

// Returns a corner that is left.
std::int32_t PolygonCutter::clip(std::int32_t corner, std::vector<Corners>& triangles) {
  Corner& tip = ring_[static_cast<std::size_t>(corner)];
  Corner& prev = ring_[static_cast<std::size_t>(tip.prev)];
  Corner& next = ring_[static_cast<std::size_t>(tip.next)];
  emit(prev.vertex, tip.vertex, next.vertex, triangles);
  tip.version = -1;
  prev.next = tip.next;
  next.prev = tip.prev;
  for (const std::int32_t side : {tip.prev, tip.next}) {
    classify(side);
  }
  for (const std::int32_t side : {tip.prev, tip.next}) {
    offer(side);
  }
  return tip.prev;
}

void PolygonCutter::cut_leftover(const Position& normal, std::int32_t start,
                                 std::vector<Corners>& triangles) {
  std::vector<std::int32_t> rest;
  std::vector<Position> points;
  for (std::int32_t i = start; rest.empty() || i != start;) {
    const auto at = static_cast<std::size_t>(i);
    rest.push_back(ring_[at].vertex);
    points.push_back(points_[at]);
    i = ring_[at].next;
  }
  points_.swap(points);
  if (rest.size() == 4) {
    cut_quad(rest, normal, triangles);
  } else {
    cut_fan(rest, best_apex(rest), triangles);
  }
}

void PolygonCutter::cut_fan(std::span<const std::int32_t> corners, std::size_t apex,
                            std::vector<Corners>& triangles) {
  const std::size_t n = corners.size();
  for (std::size_t i = 1; i + 1 < n; ++i) {
    emit(corners[apex], corners[(apex + i) % n], corners[(apex + i + 1) % n], triangles);
  }
}

std::size_t PolygonCutter::best_apex(std::span<const std::int32_t> corners) const {
  const std::size_t n = corners.size();
  for (std::size_t apex = 0; apex < n; ++apex) {
    std::size_t i = 2;
    while (i + 1 < n && !edges_.contains(corners[apex], corners[(apex + i) % n])) {
      ++i;
    }
    if (i + 1 == n) {
      return apex;
    }
  }
  return 0;
}

void PolygonCutter::cut_quad(std::span<const std::int32_t> corners, const Position& normal,
                             std::vector<Corners>& triangles) {
  const auto& p = points_;
  double first =
      std::min(shape(p[0], p[1], p[2], normal), shape(p[0], p[2], p[3], normal)) + clearly_better;
  double second = std::min(shape(p[1], p[2], p[3], normal), shape(p[1], p[3], p[0], normal));
  if (edges_.contains(corners[0], corners[2])) {
    first -= used_penalty;
  }
  if (edges_.contains(corners[1], corners[3])) {
    second -= used_penalty;
  }
  cut_fan(corners, second > first ? 1 : 0, triangles);
}

// Moves the polygon to the origin and to size one, step by step so that nothing overflows; returns
// the Newell normal of unit length, or zero.
Position PolygonCutter::load_points(std::span<const std::int32_t> corners) {
  double largest = 0;
  points_.clear();
  for (const std::int32_t v : corners) {
    points_.push_back(positions_[static_cast<std::size_t>(v)]);
    for (const double c : points_.back()) {
      largest = std::max(largest, std::abs(c));
    }
  }
  const int down = largest > 0 ? -std::ilogb(largest) : 0;
  double extent = 0;
  for (Position& point : points_) {
    for (double& c : point) {
      c = std::ldexp(c, down);
    }
  }
  const Position origin = points_.front();
  for (Position& point : points_) {
    point = minus(point, origin);
    for (const double c : point) {
      extent = std::max(extent, std::abs(c));
    }
  }
  if (!(extent > 0)) {
    return {0, 0, 0};
  }
  const int up = -std::ilogb(extent);
  for (Position& point : points_) {
    for (double& c : point) {
      c = std::ldexp(c, up);
    }
  }
  Position normal = {0, 0, 0};
  for (std::size_t i = 1; i + 1 < points_.size(); ++i) {
    const Position part = cross(points_[i], points_[i + 1]);
    for (std::size_t k = 0; k < 3; ++k) {
      normal[k] += part[k];
    }
  }
  const double length = std::sqrt(dot(normal, normal));
  if (!(length > flat)) {
    return {0, 0, 0};
  }
  for (double& c : normal) {
    c /= length;
  }
  return normal;
}

void PolygonCutter::project(std::span<const std::int32_t> corners, const Position& normal) {
  const Position helper = std::abs(normal[0]) < 0.6 ? Position{1, 0, 0} : Position{0, 1, 0};
  Position u = cross(helper, normal);
  const double length = std::sqrt(dot(u, u));
  for (double& c : u) {
    c /= length;
  }
  const Position v = cross(normal, u);
  const auto size = static_cast<std::int32_t>(points_.size());
  ring_.assign(points_.size(), Corner());
  late_reflex_.clear();
  ears_ = {};
  for (std::int32_t i = 0; i < size; ++i) {
    const auto at = static_cast<std::size_t>(i);
    ring_[at].vertex = corners[at];
    ring_[at].x = dot(points_[at], u);
    ring_[at].y = dot(points_[at], v);
    ring_[at].prev = (i + size - 1) % size;
    ring_[at].next = (i + 1) % size;
  }
}

double PolygonCutter::area(std::int32_t a, std::int32_t b, std::int32_t c) const {
  const Corner& p = ring_[static_cast<std::size_t>(a)];
  const Corner& q = ring_[static_cast<std::size_t>(b)];
  const Corner& r = ring_[static_cast<std::size_t>(c)];
  return (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
}

void PolygonCutter::classify(std::int32_t corner) {
  Corner& c = ring_[static_cast<std::size_t>(corner)];
  const bool reflex = !(area(c.prev, corner, c.next) > flat);
  if (reflex && !c.reflex) {
    late_reflex_.push_back(corner);
  }
  c.reflex = reflex;
}

// Whether the other corner lies in the triangle that clipping this one would make.
bool PolygonCutter::blocks(std::int32_t other, std::int32_t corner) const {
  const Corner& tip = ring_[static_cast<std::size_t>(corner)];
  const Corner& c = ring_[static_cast<std::size_t>(other)];
  if (c.version < 0 || !c.reflex || other == tip.prev || other == tip.next) {
    return false;
  }
  if (area(tip.prev, corner, other) < -flat || area(corner, tip.next, other) < -flat ||
      area(tip.next, tip.prev, other) < -flat) {
    return false;
  }
  const auto same_place = [&](std::int32_t i) {
    const Corner& p = ring_[static_cast<std::size_t>(i)];
    return p.x == c.x && p.y == c.y;
  };
  return !same_place(tip.prev) && !same_place(tip.next);
}

// Only a reflex corner can be in the way, and only one in the triangle's range of x.
bool PolygonCutter::is_ear(std::int32_t corner) const {
  const Corner& tip = ring_[static_cast<std::size_t>(corner)];
  if (tip.reflex) {
    return false;
  }
  const double before = ring_[static_cast<std::size_t>(tip.prev)].x;
  const double after = ring_[static_cast<std::size_t>(tip.next)].x;
  const double low = std::min({before, tip.x, after}) - flat;
  const double high = std::max({before, tip.x, after}) + flat;
  const auto x = [this](std::int32_t i) { return ring_[static_cast<std::size_t>(i)].x; };
  for (auto other = std::lower_bound(reflex_.begin(), reflex_.end(), low,
                                     [&](std::int32_t i, double bound) { return x(i) < bound; });
       other != reflex_.end() && x(*other) <= high; ++other) {
    if (blocks(*other, corner)) {
      return false;
    }
  }
  return std::none_of(late_reflex_.begin(), late_reflex_.end(),
                      [&](std::int32_t other) { return blocks(other, corner); });
}

void PolygonCutter::offer(std::int32_t corner) {
  Corner& tip = ring_[static_cast<std::size_t>(corner)];
  if (tip.version < 0) {
    return;
  }
  ++tip.version;
  if (!is_ear(corner)) {
    return;
  }
  const Corner& prev = ring_[static_cast<std::size_t>(tip.prev)];
  const Corner& next = ring_[static_cast<std::size_t>(tip.next)];
  const auto square = [](const Corner& a, const Corner& b) {
    return (a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y);
  };
  double quality = area(tip.prev, corner, tip.next) /
                   (square(prev, tip) + square(tip, next) + square(next, prev));
  if (edges_.contains(prev.vertex, next.vertex)) {
    quality -= used_penalty;
  }
  ears_.push({quality, corner, tip.version});
}

}  // namespace ucvt
