// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sim/rays/ray_caster.hpp"

#include <stdexcept>

#include "sim/rays/bullet_caster.hpp"
#ifdef RIBBON_MAPPER_WITH_EMBREE
#include "sim/rays/embree_caster.hpp"
#endif

namespace ribbon_mapper::sim {
namespace {

void require_available(RayCasterKind kind) {
  if (is_available(kind)) return;
  throw std::invalid_argument(
      "ray caster 'embree' is not in this build: install Embree (package libembree-dev on Debian "
      "12), configure and build again, or use bullet");
}

}  // namespace

RayCasterKind ray_caster_kind_from(const std::string& name) {
  if (name == "bullet") return RayCasterKind::bullet;
  if (name != "embree")
    throw std::invalid_argument("ray caster '" + name + "' is unknown; use bullet or embree");
  require_available(RayCasterKind::embree);
  return RayCasterKind::embree;
}

bool is_available(RayCasterKind kind) {
#ifdef RIBBON_MAPPER_WITH_EMBREE
  return kind == RayCasterKind::bullet || kind == RayCasterKind::embree;
#else
  return kind == RayCasterKind::bullet;
#endif
}

std::unique_ptr<const RayCaster> make_ray_caster(RayCasterKind kind,
                                                 const std::vector<Triangle>& triangles) {
  require_available(kind);
#ifdef RIBBON_MAPPER_WITH_EMBREE
  if (kind == RayCasterKind::embree) return make_embree_caster(triangles);
#endif
  return make_bullet_caster(triangles);
}

}  // namespace ribbon_mapper::sim
