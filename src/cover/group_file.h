// The deck group as a JSON file (docs/group.md).
#pragma once

#include <string>

#include "cover/generators.h"

namespace ucvt {

/// The file's text. Numbers of maps have 32 digits: a reader of doubles rounds them, a reader of more
/// gets a group whose relation holds.
std::string group_json(const DeckSystem& system, const DeckGroup& group);

}  // namespace ucvt
