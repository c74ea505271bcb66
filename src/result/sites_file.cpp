#include <algorithm>
#include <cstdint>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "mesh/file_input.h"
#include "mesh/output_file.h"
#include "ucvt/error.h"
#include "ucvt/remesh.h"

namespace ucvt {
SavedSites read_sites(const std::string& path) {
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
  std::vector<Site> out;
  for (const auto& entry : json["sites"]) {
    const bool valid =
        entry.is_object() && entry.contains("face") && entry["face"].is_number_integer() &&
        entry["face"].get<std::int64_t>() >= 0 && entry["face"].get<std::int64_t>() <= INT32_MAX &&
        entry.contains("bary") && entry["bary"].is_array() && entry["bary"].size() == 3 &&
        std::all_of(entry["bary"].begin(), entry["bary"].end(),
                    [](const auto& b) { return b.is_number(); });
    if (!valid) {
      throw wrong(
          fmt::format("site {} has no face number with three barycentric coordinates", out.size()));
    }
    out.push_back({entry["face"].get<std::int32_t>(),
                   {entry["bary"][0].get<double>(), entry["bary"][1].get<double>(),
                    entry["bary"][2].get<double>()}});
  }
  if (out.empty()) {
    throw wrong("has an empty list \"sites\"");
  }
  SavedSites saved{std::move(out), 0, {}};
  if (json.contains("refined_for") && json["refined_for"].is_number_integer()) {
    saved.refine_for = json["refined_for"].get<int>();
  }
  if (json.contains("size")) {
    const auto& size = json["size"];
    const bool valid = size.is_array() && std::all_of(size.begin(), size.end(), [](const auto& x) {
                         return x.is_number() && x.template get<double>() > 0;
                       });
    if (!valid) {
      throw wrong("has a \"size\" that is not a list of positive numbers");
    }
    saved.size = size.get<std::vector<double>>();
  }
  return saved;
}

void write_sites(const std::string& path, const RemeshResult& result) {
  nlohmann::json json;
  auto& list = json["sites"] = nlohmann::json::array();
  for (const Site& s : result.sites) {
    list.push_back({{"face", s.face}, {"bary", s.bary}});
  }
  json["refined_for"] = result.refined_for;
  json["density"] = result.density;
  json["size"] = result.size;
  OutputFile file(path);
  file.write(json.dump());
  file.write("\n");
  file.commit();
}

}  // namespace ucvt
