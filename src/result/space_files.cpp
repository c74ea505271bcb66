#include "ucvt/space_files.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "mesh/file_input.h"
#include "mesh/output_file.h"
#include "mesh/text_scanner.h"
#include "result/space_points.h"
#include "ucvt/error.h"

namespace ucvt {
namespace {

/// Appends numbers one by one, with full precision, to a file.
class NumberWriter {
 public:
  explicit NumberWriter(const std::string& path) : file_(path) {}

  void text(std::string_view text) { file_.write(text); }
  template <typename... Values>
  void line(fmt::format_string<const Values&...> format, const Values&... values) {
    line_.clear();
    fmt::vformat_to(std::back_inserter(line_), format, fmt::make_format_args(values...));
    line_ += '\n';
    file_.write(line_);
  }
  void commit() { file_.commit(); }

 private:
  OutputFile file_;
  std::string line_;
};

/// Writes a VTK data array with what `each` gives for every cell.
template <typename Each>
void write_array(NumberWriter& out, const std::vector<SpaceCell>& cells, std::string_view type,
                 std::string_view name, const Each& each) {
  out.line(R"(<DataArray type="{}" Name="{}" format="ascii">)", type, name);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    out.line("{}", each(i));
  }
  out.text("</DataArray>\n");
}

void write_points(NumberWriter& out, const SpaceResult& result, Coordinates coordinates) {
  out.text("<Points>\n<DataArray type=\"Float64\" NumberOfComponents=\"3\" format=\"ascii\">\n");
  for (const SpaceCell& cell : result.cells) {
    for (const ModelPoint& corner : cell.corners) {
      const Position p = written_position(result.domain.kappa, corner, coordinates);
      out.line("{} {} {}", p[0], p[1], p[2]);
    }
  }
  out.text("</DataArray>\n</Points>\n");
}

void write_polygons(NumberWriter& out, const std::vector<SpaceCell>& cells) {
  constexpr int vtk_polygon = 7;
  out.text("<Cells>\n<DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">\n");
  std::size_t point = 0;
  std::string line;
  for (const SpaceCell& cell : cells) {
    line.clear();
    for (std::size_t k = 0; k < cell.corners.size(); ++k) {
      fmt::format_to(std::back_inserter(line), "{} ", point++);
    }
    line += '\n';
    out.text(line);
  }
  out.text("</DataArray>\n");
  std::size_t end = 0;
  write_array(out, cells, "Int64", "offsets",
              [&](std::size_t i) { return end += cells[i].corners.size(); });
  write_array(out, cells, "UInt8", "types", [](std::size_t) { return vtk_polygon; });
  out.text("</Cells>\n");
}

/// "sphere", "torus", "plane" or "hyperbolic": the commands.
const char* space_name(DomainKind kind) {
  switch (kind) {
    case DomainKind::Sphere:
      return "sphere";
    case DomainKind::Torus:
      return "torus";
    case DomainKind::PlanePolygon:
      return "plane";
    default:
      return "hyperbolic";
  }
}

double distance(double kappa, const ModelPoint& p, const ModelPoint& q) {
  const double x = p[0] - q[0], y = p[1] - q[1], z = p[2] - q[2];
  const double half = std::sqrt(std::max(0.0, x * x + y * y + kappa * z * z)) / 2;
  return kappa > 0   ? 2 * std::asin(std::min(1.0, half))
         : kappa < 0 ? 2 * std::asinh(half)
                     : 2 * half;
}

bool is_point(const nlohmann::json& entry) {
  return entry.is_array() && entry.size() == 3 && entry[0].is_number() && entry[1].is_number() &&
         entry[2].is_number();
}

}  // namespace

void write_cells(const std::string& path, const SpaceResult& result, Coordinates coordinates) {
  const std::vector<SpaceCell>& cells = result.cells;
  std::size_t points = 0;
  for (const SpaceCell& cell : cells) {
    points += cell.corners.size();
  }
  NumberWriter out(path);
  out.text(
      "<?xml version=\"1.0\"?>\n"
      "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" "
      "header_type=\"UInt64\">\n<UnstructuredGrid>\n");
  out.line(R"(<Piece NumberOfPoints="{}" NumberOfCells="{}">)", points, cells.size());
  write_points(out, result, coordinates);
  write_polygons(out, cells);
  out.text("<CellData>\n");
  write_array(out, cells, "Int64", "site", [](std::size_t i) { return i; });
  write_array(out, cells, "Int32", "degree", [&](std::size_t i) { return cells[i].degree; });
  constexpr std::pair<const char*, double SpaceCell::*> measures[] = {
      {"area", &SpaceCell::area},
      {"mass", &SpaceCell::mass},
      {"energy", &SpaceCell::energy},
      {"radius", &SpaceCell::radius},
      {"nearest", &SpaceCell::nearest}};
  for (const auto& [name, measure] : measures) {
    write_array(out, cells, "Float64", name, [&](std::size_t i) { return cells[i].*measure; });
  }
  out.text("</CellData>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n");
  out.commit();
}

void write_cell_table(const std::string& path, const SpaceResult& result) {
  NumberWriter out(path);
  out.text("site,x,y,z,degree,area,mass,energy,radius,nearest,centroid_distance\n");
  for (std::size_t i = 0; i < result.cells.size(); ++i) {
    const SpaceCell& c = result.cells[i];
    const ModelPoint& p = result.sites[i];
    out.line("{},{},{},{},{},{},{},{},{},{},{}", i, p[0], p[1], p[2], c.degree, c.area, c.mass,
             c.energy, c.radius, c.nearest, distance(result.domain.kappa, p, c.centroid));
  }
  out.commit();
}

void write_space_sites(const std::string& path, const SpaceResult& result) {
  NumberWriter out(path);
  out.line(R"({{"space": "{}", "sites": [)", space_name(result.domain.kind));
  for (std::size_t i = 0; i < result.sites.size(); ++i) {
    const ModelPoint& p = result.sites[i];
    out.line("[{}, {}, {}]{}", p[0], p[1], p[2], i + 1 < result.sites.size() ? "," : "");
  }
  out.text("]}\n");
  out.commit();
}

std::vector<ModelPoint> read_space_sites(const std::string& path, const Domain& domain) {
  const auto json = nlohmann::json::parse(read_file(path), nullptr, false);
  const auto wrong = [](const std::string& what) {
    return InvalidInput(what + "; give a file that --sites wrote");
  };
  if (json.is_discarded()) {
    throw wrong("is not JSON");
  }
  if (!json.is_object() || !json.contains("sites") || !json["sites"].is_array()) {
    throw wrong("has no list \"sites\"");
  }
  if (!json.contains("space") || !json["space"].is_string()) {
    throw wrong("has no \"space\"");
  }
  if (json["space"] != space_name(domain.kind)) {
    throw InvalidInput(fmt::format("holds sites of the space \"{}\"; give one of \"{}\"",
                                   json["space"].get<std::string>(), space_name(domain.kind)));
  }
  std::vector<ModelPoint> out;
  for (const auto& entry : json["sites"]) {
    if (!is_point(entry)) {
      throw wrong(fmt::format("site {} is not three numbers", out.size()));
    }
    out.push_back(entry.get<ModelPoint>());
  }
  if (out.empty()) {
    throw wrong("has an empty list \"sites\"");
  }
  return out;
}

std::vector<CentralPoint> read_polygon(const std::string& path) {
  const std::string text = read_file(path);
  TextScanner scanner(text);
  std::vector<CentralPoint> out;
  for (std::string_view first = scanner.word(); !first.empty(); first = scanner.word()) {
    CentralPoint corner{};
    const std::int64_t line = scanner.line();
    if (!parse_real(first, corner[0]) || !parse_real(scanner.word_in_line(), corner[1]) ||
        !scanner.word_in_line().empty()) {
      throw InvalidInput(
          fmt::format("line {} is not the two numbers of a corner; write one 'x y' a line", line));
    }
    out.push_back(corner);
  }
  return out;
}

}  // namespace ucvt
