// CVTs of the bare spaces: how good and how fast. Prints markdown tables.
//
//   ucvt_bench_spaces               all of it; sizes from 10,000 to 1,000,000 sites
//   ucvt_bench_spaces N...          the cost per site at these sizes only
//
// Every size runs in a process of its own, so that its greatest memory is its own.
#include "ucvt/spaces.h"

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <numbers>
#include <string>
#include <tuple>
#include <vector>

#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "cvt/domain.h"
#include "cvt/space_sites.h"

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// In a process of its own; false when that failed.
bool apart(const std::function<void()>& work) {
  std::fflush(stdout);
  const pid_t child = fork();
  if (child == 0) {
    work();
    std::fflush(stdout);
    std::_Exit(0);
  }
  int status = 1;
  return child > 0 && waitpid(child, &status, 0) == child && status == 0;
}

ucvt::SpaceOptions lloyd(int sites, int iterations, double tolerance) {
  ucvt::SpaceOptions out;
  out.sites = sites, out.iterations = iterations, out.tolerance = tolerance;
  out.keep_cells = false, out.threads = 1;
  out.method = ucvt::Method::Lloyd, out.init = ucvt::InitialSites::Random;
  return out;
}

/// The default: L-BFGS, level by level, to rest.
ucvt::SpaceOptions usual(int sites) {
  ucvt::SpaceOptions out;
  out.sites = sites;
  out.keep_cells = false, out.threads = 1;
  return out;
}

void quality_row(const std::string& name, const ucvt::Domain& domain,
                 const ucvt::SpaceOptions& options) {
  const auto start = Clock::now();
  const ucvt::SpaceResult r = tessellate(domain, options);
  const double hexagonal = 5 / (18 * std::sqrt(3.0)) * domain.area * domain.area / options.sites;
  fmt::print("| {} | {} | {} | {}{} | {:.4f} | {:.2f} % | {:.1f} |\n", name, options.sites,
             r.cvt.method, r.cvt.iterations, r.cvt.converged ? "" : " (not at rest)",
             r.cvt.energy.back() / hexagonal, 100 * r.uniformity.hexagons, seconds_since(start));
  std::fflush(stdout);
}

void quality() {
  fmt::print(
      "| domain | sites | method | iterations | E / E_hex | degree 6 | s |\n"
      "| --- | --- | --- | --- | --- | --- | --- |\n");
  const std::vector<std::tuple<std::string, ucvt::Domain, int>> cases{
      {"sphere", ucvt::sphere_domain(), 1000},
      {"sphere", ucvt::sphere_domain(), 10000},
      {"square torus", ucvt::torus_domain({1, 0}, {0, 1}), 1000},
      {"surface of genus 2", ucvt::surface_domain(2, ucvt::SidePairing::Opposite), 1000},
      {"square", ucvt::polygon_domain(0, {{0, 0}, {1, 0}, {1, 1}, {0, 1}}), 1000}};
  for (const auto& [name, domain, sites] : cases) {
    quality_row(name, domain, lloyd(sites, 200, 0));
    quality_row(name, domain, usual(sites));
  }
  fmt::print("\n");
}

void icosahedron() {
  const double side = std::acos(std::sqrt(5.0) / 3), apart = std::acos(1 / std::sqrt(5.0));
  const double exact = 2 * (4 * std::numbers::pi - 30 * side * std::sin(apart / 2));
  fmt::print("| seed | iterations | E / E_icosahedron - 1 |\n| --- | --- | --- |\n");
  for (const std::uint64_t seed : {1, 2, 3, 4, 5}) {
    ucvt::SpaceOptions options = lloyd(12, 5000, 1e-8);
    options.seed = seed;
    const ucvt::SpaceResult r = tessellate(ucvt::sphere_domain(), options);
    fmt::print("| {} | {} | {:.1e} |\n", seed, r.cvt.iterations, r.cvt.energy.back() / exact - 1);
  }
  fmt::print("\n");
}

void cost(int n) {
  const ucvt::Domain sphere = ucvt::sphere_domain();
  const auto count = static_cast<std::size_t>(n);
  double inserting = 0;
  {
    auto points = ucvt::random_points(sphere, count, 1);
    ucvt::sort_along_curve(points);
    const auto start = Clock::now();
    const auto sites = make_sites(sphere, points);
    inserting = seconds_since(start);
  }
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const auto inserted = usage.ru_maxrss;
  const int iterations = 10;
  const ucvt::SpaceResult r = tessellate(sphere, lloyd(n, iterations, 0));
  getrusage(RUSAGE_SELF, &usage);
  fmt::print("| {} | {:.2f} | {:.2f} | {:.0f} | {:.0f} |\n", n, 1e6 * inserting / n,
             1e6 * r.cvt.seconds / iterations / n, 1024.0 * static_cast<double>(inserted) / n,
             1024.0 * static_cast<double>(usage.ru_maxrss) / n);
}

}  // namespace

int main(int argc, char** argv) {
  std::vector<int> sizes{10000, 30000, 100000, 300000, 1000000};
  bool well = true;
  if (argc > 1) {
    sizes.clear();
    for (int i = 1; i < argc; ++i) {
      sizes.push_back(std::atoi(argv[i]));
    }
  } else {
    well = apart(quality) && apart(icosahedron);
  }
  fmt::print(
      "| sites | insertion, us a site | Lloyd, us a site and iteration | bytes a site after "
      "insertion | bytes a site |\n| --- | --- | --- | --- | --- |\n");
  for (const int n : sizes) {
    well = apart([n] { cost(n); }) && well;
  }
  return well ? 0 : 1;
}
