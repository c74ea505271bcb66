#include "ucvt/cover.h"

#include <utility>

#include "cover/group_file.h"
#include "mesh/output_file.h"
#include "result/cover_data.h"
#include "result/loops_file.h"
#include "result/uv_file.h"
#include "ucvt/error.h"

namespace ucvt {

namespace {

void write(const std::string& path, const std::string& text) {
  OutputFile file(path);
  file.write(text);
  file.commit();
}

std::shared_ptr<const CoverData> cover_of(UniformizedSurface surface) {
  DeckSystem system = deck_system(surface.value().surface);
  DeckGroup group = deck_group(system);
  return std::make_shared<const CoverData>(
      CoverData{std::move(surface), std::move(system), std::move(group)});
}

}  // namespace

void require_coordinates(int genus, CoverCoordinates coordinates) {
  if (genus == 0) {
    throw InvalidInput(
        "a sphere is its own universal cover and has no deck group; take a surface "
        "of genus 1 or more");
  }
  const bool plane = coordinates == CoverCoordinates::Plane;
  if (genus == 1 && !plane && coordinates != CoverCoordinates::Klein) {
    throw InvalidInput("a torus is laid out in the plane; ask for plane coordinates");
  }
  if (genus > 1 && plane) {
    throw InvalidInput(
        "a hyperbolic surface does not lie in the plane; ask for Klein, Poincare or half-plane "
        "coordinates");
  }
}

Cover::Cover(UniformizedSurface surface) : data_(cover_of(std::move(surface))) {}

const DeckGroup& Cover::group() const {
  return data_->group;
}

std::vector<DeckCopy> Cover::neighbours() const {
  const DeckSystem& s = data_->system;
  std::vector<DeckCopy> out;
  for (Word& word : neighbour_words(data_->group.genus)) {
    const DeckMap m = map_of(s.kappa, word, s.canonical.map);
    out.push_back({std::move(word),
                   model_matrix(s.kappa, m),
                   {m.a.re.value(), m.a.im.value()},
                   {m.b.re.value(), m.b.im.value()}});
  }
  return out;
}

void Cover::write_group(const std::string& path) const {
  write(path, group_json(data_->system, data_->group));
}

void Cover::write_loops(const std::string& path) const {
  write(path, loops_obj(data_->surface.value(), data_->system, data_->group));
}

void Cover::write_uv(const std::string& path, CoverCoordinates coordinates) const {
  require_coordinates(data_->group.genus, coordinates);
  write(path, uv_obj(data_->surface.value(), data_->system, coordinates));
}

}  // namespace ucvt
