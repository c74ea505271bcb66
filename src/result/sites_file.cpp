#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "mesh/file_input.h"
#include "mesh/output_file.h"
#include "ucvt/error.h"
#include "ucvt/remesh.h"

namespace ucvt {
namespace {

using nlohmann::json;

/// No count in a file is larger; sums of two fit an int.
constexpr std::int64_t largest_count = 1'000'000'000;

InvalidInput wrong(const std::string& what) {
  return InvalidInput(what + "; give a file that --sites or --checkpoint wrote");
}

bool is_count(const json& value, std::int64_t most) {
  return value.is_number_integer() && value.get<std::int64_t>() >= 0 &&
         value.get<std::int64_t>() <= most;
}

bool are_numbers(const json& list) {
  return list.is_array() &&
         std::all_of(list.begin(), list.end(), [](const json& x) { return x.is_number(); });
}

int read_count(const json& object, const char* name) {
  if (!object.contains(name) || !is_count(object[name], largest_count)) {
    throw wrong(fmt::format("has no count \"{}\" of its progress", name));
  }
  return object[name].get<int>();
}

Site read_site(const json& entry, std::size_t number) {
  const bool valid = entry.is_object() && entry.contains("face") &&
                     is_count(entry["face"], INT32_MAX) && entry.contains("bary") &&
                     are_numbers(entry["bary"]) && entry["bary"].size() == 3;
  if (!valid) {
    throw wrong(
        fmt::format("site {} has no face number with three barycentric coordinates", number));
  }
  return {entry["face"].get<std::int32_t>(), entry["bary"].get<std::array<double, 3>>()};
}

std::vector<double> read_size(const json& size) {
  if (!are_numbers(size) || !std::all_of(size.begin(), size.end(), [](const json& x) {
        return x.get<double>() > 0 && std::isfinite(x.get<double>());
      })) {
    throw wrong("has a \"size\" that is not a list of positive numbers");
  }
  return size.get<std::vector<double>>();
}

RunProgress read_progress(const json& object) {
  if (!object.is_object() || !object.contains("energy") || !are_numbers(object["energy"]) ||
      !object.contains("max_move") || !are_numbers(object["max_move"])) {
    throw wrong("has a \"progress\" that is none");
  }
  RunProgress out;
  out.sites = read_count(object, "sites");
  out.evenings_left = read_count(object, "evenings_left");
  out.round = read_count(object, "round");
  out.evaluations = read_count(object, "evaluations");
  out.moved = read_count(object, "moved");
  out.iterations = read_count(object, "iterations");
  out.energy = object["energy"].get<std::vector<double>>();
  out.max_move = object["max_move"].get<std::vector<double>>();
  return out;
}

json as_json(const RunProgress& progress) {
  return {{"sites", progress.sites},   {"evenings_left", progress.evenings_left},
          {"round", progress.round},   {"evaluations", progress.evaluations},
          {"moved", progress.moved},   {"iterations", progress.iterations},
          {"energy", progress.energy}, {"max_move", progress.max_move}};
}

json as_json(const std::vector<Site>& sites) {
  json list = json::array();
  for (const Site& s : sites) {
    list.push_back({{"face", s.face}, {"bary", s.bary}});
  }
  return list;
}

void write(const std::string& path, const json& object) {
  OutputFile file(path);
  file.write(object.dump());
  file.write("\n");
  file.commit();
}

}  // namespace

SavedSites read_sites(const std::string& path) {
  const json object = json::parse(read_file(path), nullptr, false);
  if (object.is_discarded()) {
    throw wrong("is not JSON");
  }
  if (!object.is_object() || !object.contains("sites") || !object["sites"].is_array()) {
    throw wrong("has no list \"sites\"");
  }
  SavedSites saved;
  for (const json& entry : object["sites"]) {
    saved.sites.push_back(read_site(entry, saved.sites.size()));
  }
  if (saved.sites.empty()) {
    throw wrong("has an empty list \"sites\"");
  }
  if (object.contains("refined_for")) {
    if (!is_count(object["refined_for"], INT32_MAX)) {
      throw wrong("has a \"refined_for\" that is no number of sites");
    }
    saved.refine_for = object["refined_for"].get<int>();
  }
  if (object.contains("size")) {
    saved.size = read_size(object["size"]);
  }
  if (object.contains("progress")) {
    saved.progress = read_progress(object["progress"]);
  }
  return saved;
}

void write_sites(const std::string& path, const RemeshResult& result) {
  write(path, {{"sites", as_json(result.sites)},
               {"refined_for", result.refined_for},
               {"density", result.density},
               {"size", result.size}});
}

void write_sites(const std::string& path, const SavedSites& saved) {
  json object = {
      {"sites", as_json(saved.sites)}, {"refined_for", saved.refine_for}, {"size", saved.size}};
  if (saved.progress) {
    object["progress"] = as_json(*saved.progress);
  }
  write(path, object);
}

}  // namespace ucvt
