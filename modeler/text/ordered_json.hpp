// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json.hpp>

namespace ribbon_mapper {

#if NLOHMANN_JSON_VERSION_MAJOR == 3 && NLOHMANN_JSON_VERSION_MINOR < 9
/// JSON with sorted keys: before version 3.9, as in Ubuntu 20.04, nlohmann_json keeps no order.
using Json = nlohmann::json;
#else
/// JSON whose keys stand in the order in which they were added.
using Json = nlohmann::ordered_json;
#endif

}  // namespace ribbon_mapper
