// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>

#include "modeler/modeler.hpp"

int main() {
  const ribbon_mapper::Modeler modeler(ribbon_mapper::ModelerConfig{});
  std::printf("planes: %zu\n", modeler.planes().size());
}
