// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "eval/version.hpp"

namespace ribbon_mapper::eval {

std::string version() { return RIBBON_MAPPER_VERSION; }

}  // namespace ribbon_mapper::eval
