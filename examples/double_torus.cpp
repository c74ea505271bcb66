// Writes a double torus, or a chain of any number of tori, as an OFF file.
//
//   example_double_torus OUT.off [--genus G] [--resolution R]
//
// The surface is the zero set of a smooth union of G tori whose centre circles, of radius 1, touch
// in a row along the x axis. It is polygonised by marching tetrahedra on a grid of R cells per unit
// of length. Vertices lie on grid edges and are shared by their tetrahedra, so the mesh is closed
// and manifold by construction; its genus is checked before it is written.
#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <string>
#include <system_error>
#include <unordered_map>
#include <utility>
#include <vector>

namespace {

using Point = std::array<double, 3>;
using Face = std::array<int, 3>;

constexpr double tube_radius = 0.4;
constexpr double blend_radius = 0.1;  ///< length over which neighbouring tori melt together
constexpr double margin = 0.3;        ///< free space between the surface and the grid's boundary

struct Mesh {
  std::vector<Point> vertices;
  std::vector<Face> faces;
};

/// The implicit function: negative inside, close to the distance in units of length.
struct TorusChain {
  int genus = 2;

  [[nodiscard]] double operator()(const Point& p) const {
    double sum = 0;
    for (int i = 0; i < genus; ++i) {
      const double x = p[0] - (2.0 * i - (genus - 1));
      const double tube = std::hypot(std::hypot(x, p[1]) - 1, p[2]) - tube_radius;
      sum += std::exp(-tube / blend_radius);
    }
    return -blend_radius * std::log(sum);
  }
};

/// Marching tetrahedra: every cube of the grid is cut into the six tetrahedra that follow the axes,
/// in some order, from its lowest corner to its highest.
class Polygoniser {
 public:
  Polygoniser(const TorusChain& solid, int resolution) : step_(1.0 / resolution) {
    const Point half{solid.genus + tube_radius + margin, 1 + tube_radius + margin,
                     tube_radius + margin};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      size_[axis] = static_cast<int>(std::ceil(2 * half[axis] / step_)) + 1;
      origin_[axis] = -0.5 * step_ * (size_[axis] - 1);
    }
    stride_ = {1, size_[0], std::int64_t{size_[0]} * size_[1]};
    values_.resize(static_cast<std::size_t>(stride_[2] * size_[2]));
    for (std::size_t node = 0; node < values_.size(); ++node) {
      values_[node] = solid(position(static_cast<std::int64_t>(node)));
    }
  }

  Mesh run() && {
    for (int z = 0; z + 1 < size_[2]; ++z) {
      for (int y = 0; y + 1 < size_[1]; ++y) {
        for (int x = 0; x + 1 < size_[0]; ++x) {
          cube(x + y * stride_[1] + z * stride_[2]);
        }
      }
    }
    return std::move(mesh_);
  }

 private:
  using Tetrahedron = std::array<std::int64_t, 4>;  ///< nodes, positively oriented

  [[nodiscard]] Point position(std::int64_t node) const {
    const std::int64_t x = node % stride_[1];
    const std::int64_t y = node / stride_[1] % size_[1];
    const std::int64_t z = node / stride_[2];
    return {origin_[0] + step_ * static_cast<double>(x),
            origin_[1] + step_ * static_cast<double>(y),
            origin_[2] + step_ * static_cast<double>(z)};
  }

  [[nodiscard]] bool inside(std::int64_t node) const {
    return values_[static_cast<std::size_t>(node)] < 0;
  }

  /// The vertex on the grid edge between two nodes on different sides.
  int vertex(std::int64_t a, std::int64_t b) {
    if (a > b) {
      std::swap(a, b);
    }
    const auto nodes = static_cast<std::int64_t>(values_.size());
    const auto [entry, is_new] =
        vertex_of_edge_.try_emplace(a * nodes + b, static_cast<int>(mesh_.vertices.size()));
    if (is_new) {
      // Kept off the nodes, so that no two vertices coincide.
      const double value_a = values_[static_cast<std::size_t>(a)];
      const double value_b = values_[static_cast<std::size_t>(b)];
      const double t = std::clamp(value_a / (value_a - value_b), 0.05, 0.95);
      const Point from = position(a);
      const Point to = position(b);
      mesh_.vertices.push_back({std::lerp(from[0], to[0], t), std::lerp(from[1], to[1], t),
                                std::lerp(from[2], to[2], t)});
    }
    return entry->second;
  }

  void cube(std::int64_t corner) {
    constexpr std::array<std::array<std::size_t, 3>, 6> axis_orders{
        {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}}};
    for (std::size_t i = 0; i < axis_orders.size(); ++i) {
      const std::int64_t second = corner + stride_[axis_orders[i][0]];
      const std::int64_t third = second + stride_[axis_orders[i][1]];
      const std::int64_t last = third + stride_[axis_orders[i][2]];
      const bool even = i < 3;
      tetrahedron(even ? Tetrahedron{corner, second, third, last}
                       : Tetrahedron{corner, third, second, last});
    }
  }

  /// Adds the piece of surface in a tetrahedron, counterclockwise from outside.
  void tetrahedron(const Tetrahedron& nodes) {
    // Even permutations that bring each node, or each pair of nodes, to the front.
    constexpr std::array<std::array<std::size_t, 4>, 4> lead{
        {{0, 1, 2, 3}, {1, 0, 3, 2}, {2, 3, 0, 1}, {3, 2, 1, 0}}};
    constexpr std::array<std::array<std::size_t, 4>, 6> lead_pair{
        {{0, 1, 2, 3}, {0, 2, 3, 1}, {0, 3, 1, 2}, {1, 2, 0, 3}, {1, 3, 2, 0}, {2, 3, 0, 1}}};
    unsigned mask = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      mask |= inside(nodes[i]) ? 1U << i : 0U;
    }
    if (std::popcount(mask) == 2) {
      for (const auto& order : lead_pair) {
        if (mask == (1U << order[0] | 1U << order[1])) {
          cut_pair(nodes[order[0]], nodes[order[1]], nodes[order[2]], nodes[order[3]]);
        }
      }
      return;
    }
    for (const auto& order : lead) {
      const unsigned alone = 1U << order[0];
      if (mask == alone) {
        cut_corner(nodes[order[0]], nodes[order[1]], nodes[order[2]], nodes[order[3]]);
      } else if (mask == (0xFU ^ alone)) {
        cut_corner(nodes[order[0]], nodes[order[1]], nodes[order[3]], nodes[order[2]]);
      }
    }
  }

  void cut_corner(std::int64_t a, std::int64_t b, std::int64_t c, std::int64_t d) {
    mesh_.faces.push_back({vertex(a, b), vertex(a, c), vertex(a, d)});
  }

  void cut_pair(std::int64_t a, std::int64_t b, std::int64_t c, std::int64_t d) {
    const std::array<int, 4> quad{vertex(a, c), vertex(a, d), vertex(b, d), vertex(b, c)};
    mesh_.faces.push_back({quad[0], quad[1], quad[2]});
    mesh_.faces.push_back({quad[0], quad[2], quad[3]});
  }

  double step_;
  std::array<int, 3> size_{};  ///< nodes along each axis
  Point origin_{};
  std::array<std::int64_t, 3> stride_{};
  std::vector<double> values_;  ///< of the implicit function at each node
  std::unordered_map<std::int64_t, int> vertex_of_edge_;
  Mesh mesh_;
};

int count_components(const Mesh& mesh) {
  std::vector<int> parent(mesh.vertices.size());
  std::iota(parent.begin(), parent.end(), 0);
  const auto root = [&parent](int v) {
    while (parent[static_cast<std::size_t>(v)] != v) {
      int& up = parent[static_cast<std::size_t>(v)];
      up = parent[static_cast<std::size_t>(up)];
      v = up;
    }
    return v;
  };
  int components = static_cast<int>(mesh.vertices.size());
  for (const Face& face : mesh.faces) {
    for (std::size_t i = 0; i < 3; ++i) {
      const int a = root(face[i]);
      const int b = root(face[(i + 1) % 3]);
      if (a != b) {
        parent[static_cast<std::size_t>(a)] = b;
        --components;
      }
    }
  }
  return components;
}

/// Throws unless the mesh is one surface of this genus. Every edge has two faces, so E = 3F/2.
void check_genus(const Mesh& mesh, int genus) {
  const auto euler_number = static_cast<std::int64_t>(mesh.vertices.size()) -
                            static_cast<std::int64_t>(mesh.faces.size()) / 2;
  if (count_components(mesh) != 1 || euler_number != 2 - 2 * genus) {
    throw std::runtime_error("the grid is too coarse for this shape; give a larger --resolution");
  }
}

void write_off(const std::string& path, const Mesh& mesh) {
  std::ofstream file(path);
  file << "OFF\n" << mesh.vertices.size() << ' ' << mesh.faces.size() << " 0\n";
  file << std::setprecision(std::numeric_limits<double>::max_digits10);
  for (const Point& p : mesh.vertices) {
    file << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
  }
  for (const Face& f : mesh.faces) {
    file << "3 " << f[0] << ' ' << f[1] << ' ' << f[2] << '\n';
  }
  file.close();
  if (!file) {
    throw std::runtime_error("cannot write " + path);
  }
}

struct Options {
  std::string path;
  int genus = 2;
  int resolution = 8;
};

int parse_count(const std::string& text, int least, int most) {
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || value < least || value > most) {
    throw std::invalid_argument("'" + text + "' is not a number from " + std::to_string(least) +
                                " to " + std::to_string(most));
  }
  return value;
}

Options parse(const std::vector<std::string>& arguments) {
  Options options;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const bool has_value = i + 1 < arguments.size();
    if (arguments[i] == "--genus" && has_value) {
      options.genus = parse_count(arguments[++i], 1, 100);
    } else if (arguments[i] == "--resolution" && has_value) {
      options.resolution = parse_count(arguments[++i], 4, 64);
    } else if (options.path.empty() && !arguments[i].starts_with("--")) {
      options.path = arguments[i];
    } else {
      throw std::invalid_argument("unexpected argument '" + arguments[i] + "'");
    }
  }
  if (options.path.empty()) {
    throw std::invalid_argument("usage: example_double_torus OUT.off [--genus G] [--resolution R]");
  }
  return options;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const Options options = parse(std::vector<std::string>(argv + 1, argv + argc));
    const Mesh mesh = Polygoniser(TorusChain{options.genus}, options.resolution).run();
    check_genus(mesh, options.genus);
    write_off(options.path, mesh);
    std::cout << options.path << ": " << mesh.vertices.size() << " vertices, " << mesh.faces.size()
              << " faces, genus " << options.genus << '\n';
  } catch (const std::invalid_argument& error) {
    std::cerr << "example_double_torus: " << error.what() << '\n';
    return 2;
  } catch (const std::exception& error) {
    std::cerr << "example_double_torus: " << error.what() << '\n';
    return 1;
  }
  return 0;
}
