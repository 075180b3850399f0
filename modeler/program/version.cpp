// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/program/version.hpp"

namespace ribbon_mapper {

std::string version() { return RIBBON_MAPPER_VERSION; }

}  // namespace ribbon_mapper
