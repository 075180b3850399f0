// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

namespace ribbon_mapper {

/// Returns the present name of a configuration key of an earlier version, or nothing if no key had
/// that name.
std::optional<std::string> present_name_of(const std::string& former_key);

}  // namespace ribbon_mapper
