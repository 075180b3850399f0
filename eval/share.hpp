// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

namespace ribbon_mapper::eval {

/// Where config/, worlds/ and the figure scripts are: beside the installed programs, otherwise in
/// the sources that they were built from.
std::filesystem::path share_directory();

}  // namespace ribbon_mapper::eval
