#include "ucvt/space_files.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <sstream>
#include <utility>

#include "mesh/mesh_test_support.h"
#include "space/offset.h"
#include "triangulation/frame.h"

namespace ucvt::test {
namespace {

SpaceResult tessellated(const Domain& domain, int sites, int iterations = 10) {
  SpaceOptions options;
  options.sites = sites, options.iterations = iterations;
  return tessellate(domain, options);
}

SpaceResult started_at(const Domain& domain, std::vector<ModelPoint> sites) {
  SpaceOptions options;
  options.initial_sites = std::move(sites), options.iterations = 0;
  return tessellate(domain, options);
}

double signed_area(const TriangleMesh& mesh, const Corners& f) {
  const auto at = [&](std::size_t k) { return mesh.positions[static_cast<std::size_t>(f[k])]; };
  const Position a = at(0), b = at(1), c = at(2);
  return ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])) / 2;
}

/// Every triangle counterclockwise; the sum of their areas.
double checked_area(const TriangleMesh& mesh) {
  double sum = 0;
  for (const Corners& f : mesh.faces) {
    EXPECT_GT(signed_area(mesh, f), 0);
    sum += signed_area(mesh, f);
  }
  return sum;
}

TEST(DelaunayMesh, CoversATorusOnce) {
  for (const Domain& torus : {torus_domain({1, 0}, {0, 1}), torus_domain({1, 0.2}, {-0.3, 2}),
                              torus_domain({1, 0}, {0.5, std::sqrt(0.75)})}) {
    for (const int n : {1, 2, 3, 4, 5, 7, 16, 100}) {
      SCOPED_TRACE(n);
      const SpaceResult result = tessellated(torus, n);
      const TriangleMesh mesh = delaunay_mesh(result);
      EXPECT_EQ(mesh.faces.size(), 2 * static_cast<std::size_t>(n));
      EXPECT_NEAR(checked_area(mesh), torus.area, 1e-9 * torus.area);
      for (std::size_t i = 0; i < result.sites.size(); ++i) {
        EXPECT_EQ(mesh.positions[i], (Position{result.sites[i][0], result.sites[i][1], 0}));
      }
    }
  }
}

TEST(DelaunayMesh, SitesOnOneCircleGiveAFan) {
  const Domain torus = torus_domain({1, 0}, {0, 1});
  std::vector<ModelPoint> grid;
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) {
      grid.push_back({-0.5 + i / 4.0, -0.5 + j / 4.0 + 1e-13 * i, 1});
    }
  }
  // First sites on the domain's sides, then Voronoi vertices; a corner of the domain is no place
  // for a site.
  grid[0] = {-0.4999, -0.4999, 1};
  EXPECT_NEAR(checked_area(delaunay_mesh(started_at(torus, grid))), 1, 1e-9);
  for (ModelPoint& p : grid) {
    p = {p[0] + 0.125, p[1] + 0.125, 1};
  }
  grid[0] = {-0.375, -0.375, 1};
  EXPECT_NEAR(checked_area(delaunay_mesh(started_at(torus, grid))), 1, 1e-9);
}

/// Area on the hyperboloid.
double hyperbolic_area(const TriangleMesh& model) {
  double sum = 0;
  for (const Corners& f : model.faces) {
    const auto at = [&](std::size_t k) { return model.positions[static_cast<std::size_t>(f[k])]; };
    const Frame frame = frame_at(-1, at(0));
    sum += central_triangle_area({-1}, offset_in(frame, at(1)), offset_in(frame, at(2)));
  }
  return sum;
}

TEST(DelaunayMesh, CoversASurfaceOnce) {
  for (const SidePairing pairing : {SidePairing::Opposite, SidePairing::Canonical}) {
    for (const int genus : {2, 3, 5}) {
      const Domain surface = surface_domain(genus, pairing);
      for (const int n : {1, 2, 5, 50, 200}) {
        SCOPED_TRACE(n);
        const SpaceResult result = tessellated(surface, n);
        checked_area(delaunay_mesh(result));
        const TriangleMesh mesh = delaunay_mesh(result, Coordinates::Model);
        EXPECT_EQ(mesh.faces.size(), static_cast<std::size_t>(2 * (n + 2 * genus - 2)));
        EXPECT_NEAR(hyperbolic_area(mesh), surface.area, 1e-7);
        EXPECT_TRUE(std::equal(result.sites.begin(), result.sites.end(), mesh.positions.begin()));
      }
    }
  }
}

TEST(DelaunayMesh, IsInTheCoordinatesAskedFor) {
  const SpaceResult result =
      tessellated(polygon_domain(-1, {{-0.5, -0.5}, {0.6, 0}, {0, 0.7}}), 20);
  const TriangleMesh klein = delaunay_mesh(result);
  const TriangleMesh poincare = delaunay_mesh(result, Coordinates::Poincare);
  const TriangleMesh model = delaunay_mesh(result, Coordinates::Model);
  for (std::size_t i = 0; i < 20; ++i) {
    const Position p = model.positions[i];
    EXPECT_EQ(p, result.sites[i]);
    EXPECT_DOUBLE_EQ(klein.positions[i][0], p[0] / p[2]);
    EXPECT_DOUBLE_EQ(poincare.positions[i][1], p[1] / (1 + p[2]));
    EXPECT_EQ(klein.positions[i][2], 0);
  }
  EXPECT_GT(checked_area(klein), 0);
}

TEST(DelaunayMesh, NeedsATriangle) {
  EXPECT_HAS(refusal([] { delaunay_mesh(tessellated(sphere_domain(), 3)); }), "more of them");
}

/// The words between the tags of the data array of this name.
std::vector<double> data_array(const std::string& xml, const std::string& name) {
  const std::size_t tag = xml.find(name);
  EXPECT_NE(tag, std::string::npos) << name;
  const std::size_t begin = xml.find('>', tag) + 1, end = xml.find("</DataArray>", begin);
  std::istringstream words(xml.substr(begin, end - begin));
  return {std::istream_iterator<double>(words), {}};
}

/// Whether tags close in the order in which they open.
bool well_formed(const std::string& xml) {
  std::vector<std::string> open;
  for (std::size_t at = xml.find('<'); at != std::string::npos; at = xml.find('<', at + 1)) {
    const std::size_t end = xml.find('>', at);
    const std::string tag = xml.substr(at + 1, end - at - 1);
    const std::string name = tag.substr(0, tag.find(' '));
    if (tag[0] == '?' || tag.back() == '/') {
      continue;
    }
    if (tag[0] != '/') {
      open.push_back(name);
    } else if (open.empty() || "/" + open.back() != name) {
      return false;
    } else {
      open.pop_back();
    }
  }
  return open.empty();
}

TEST(CellFile, HoldsEveryCellWithFullPrecision) {
  const TemporaryFolder folder;
  for (const Domain& domain : {sphere_domain(), torus_domain({1, 0}, {0, 1}),
                               polygon_domain(0, {{0, 0}, {1, 0}, {0, 1}})}) {
    const SpaceResult result = tessellated(domain, 30);
    write_cells(folder.file("c.vtu"), result);
    const std::string xml = slurp(folder.file("c.vtu"));
    EXPECT_TRUE(well_formed(xml));
    const std::vector<double> points = data_array(xml, "NumberOfComponents=\"3\"");
    const std::vector<double> connectivity = data_array(xml, "\"connectivity\"");
    const std::vector<double> offsets = data_array(xml, "\"offsets\"");
    EXPECT_EQ(data_array(xml, "\"types\""), std::vector<double>(30, 7));
    ASSERT_EQ(offsets.size(), 30U);
    EXPECT_EQ(connectivity.size(), offsets.back());
    EXPECT_EQ(points.size(), 3 * connectivity.size());
    EXPECT_HAS(xml, "NumberOfPoints=\"" + std::to_string(connectivity.size()) + "\"");
    EXPECT_HAS(xml, "NumberOfCells=\"30\"");
    std::size_t k = 0;
    for (std::size_t i = 0; i < 30; ++i) {
      for (const ModelPoint& p : result.cells[i].corners) {
        const auto at = static_cast<std::size_t>(connectivity[k++]);
        EXPECT_EQ(points[3 * at], domain.kappa > 0 ? p[0] : p[0] / p[2]);
      }
      EXPECT_EQ(k, offsets[i]);
      EXPECT_EQ(data_array(xml, "\"site\"")[i], i);
      EXPECT_EQ(data_array(xml, "\"degree\"")[i], result.cells[i].degree);
      EXPECT_EQ(data_array(xml, "\"area\"")[i], result.cells[i].area);
      EXPECT_EQ(data_array(xml, "\"mass\"")[i], result.cells[i].mass);
      EXPECT_EQ(data_array(xml, "\"energy\"")[i], result.cells[i].energy);
      EXPECT_EQ(data_array(xml, "\"radius\"")[i], result.cells[i].radius);
      EXPECT_EQ(data_array(xml, "\"nearest\"")[i], result.cells[i].nearest);
    }
  }
}

TEST(CellTable, TellsTheDistanceToTheCentroid) {
  const TemporaryFolder folder;
  for (const Domain& domain : {sphere_domain(), polygon_domain(-1, {{0, 0}, {0.9, 0}, {0, 0.9}})}) {
    SpaceResult result = tessellated(domain, 12, 0);
    result.sites[0] = {0, 0, 1};
    const double r = 0.25;
    result.cells[0].centroid = domain.kappa > 0 ? ModelPoint{std::sin(r), 0, std::cos(r)}
                                                : ModelPoint{std::sinh(r), 0, std::cosh(r)};
    write_cell_table(folder.file("c.csv"), result);
    std::istringstream lines(slurp(folder.file("c.csv")));
    std::string line;
    std::getline(lines, line);
    EXPECT_EQ(line, "site,x,y,z,degree,area,mass,energy,radius,nearest,centroid_distance");
    std::getline(lines, line);
    EXPECT_EQ(line.rfind("0,0,0,1,", 0), 0U) << line;
    EXPECT_NEAR(std::stod(line.substr(line.rfind(',') + 1)), r, 1e-15);
  }
}

TEST(SpaceSites, AreReadAsTheyWereWritten) {
  const TemporaryFolder folder;
  const SpaceResult result = tessellated(surface_domain(2, SidePairing::Opposite), 25);
  write_space_sites(folder.file("s.json"), result);
  EXPECT_EQ(read_space_sites(folder.file("s.json"), result.domain), result.sites);
  EXPECT_HAS(refusal([&] { read_space_sites(folder.file("s.json"), sphere_domain()); }),
             "\"hyperbolic\"");
}

TEST(PolygonFile, IsTwoNumbersALine) {
  const TemporaryFolder folder;
  const auto read = [&](const std::string& bytes) {
    return read_polygon(folder.write("p.txt", bytes));
  };
  EXPECT_EQ(read("# corners\r\n0 0\r\n1e-3 +2 # second\n\n-3 4"),
            (std::vector<CentralPoint>{{0, 0}, {1e-3, 2}, {-3, 4}}));
  EXPECT_TRUE(read("").empty());
  EXPECT_HAS(refusal([&] { static_cast<void>(read("0 0\n\n1,2\n")); }), "line 3 ");
}

}  // namespace
}  // namespace ucvt::test
