// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sim/rays/embree_caster.hpp"

#if RIBBON_MAPPER_EMBREE == 3
#include <embree3/rtcore.h>
#else
#include <embree4/rtcore.h>
#endif

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <new>
#include <stdexcept>
#include <type_traits>

namespace ribbon_mapper::sim {
namespace {

using Eigen::Vector3d;

/// Gives Embree's objects back.
struct Release {
  void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
  void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
  void operator()(RTCGeometry geometry) const { rtcReleaseGeometry(geometry); }
};
template <typename Handle>
using Owner = std::unique_ptr<std::remove_pointer_t<Handle>, Release>;

/// A triangle's plane in double precision.
struct Surface {
  Vector3d point, normal;  ///< the normal is not of unit length
  int face;

  double range_m(const Ray& ray) const {
    return normal.dot(point - ray.origin) / normal.dot(ray.direction);
  }
};

Vector3d normal_of(const Triangle& triangle) {
  const auto& [a, b, c] = triangle.corners_m;
  return (b - a).cross(c - a);
}

/// Slightly longer than the range, so that rounding to float loses no surface within it.
float reach_m(double max_range_m) { return static_cast<float>(max_range_m * (1.0 + 1e-5)); }

RTCRayHit query_of(const Ray& ray, double max_range_m) {
  const Eigen::Vector3f origin = ray.origin.cast<float>(), direction = ray.direction.cast<float>();
  RTCRayHit query{};
  query.ray.org_x = origin.x(), query.ray.org_y = origin.y(), query.ray.org_z = origin.z();
  query.ray.dir_x = direction.x(), query.ray.dir_y = direction.y();
  query.ray.dir_z = direction.z();
  query.ray.tfar = reach_m(max_range_m);
  query.ray.mask = ~0U;
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  return query;
}

void intersect(RTCScene scene, RTCRayHit& query) {
#if RIBBON_MAPPER_EMBREE == 3
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcIntersect1(scene, &context, &query);
#else
  rtcIntersect1(scene, &query);
#endif
}

class EmbreeCaster : public RayCaster {
 public:
  explicit EmbreeCaster(const std::vector<Triangle>& triangles)
      : device_(rtcNewDevice("threads=1")), scene_(device_ ? rtcNewScene(device_.get()) : nullptr) {
    if (!scene_) throw std::runtime_error("Embree cannot be started; use the ray caster bullet");
    std::vector<Triangle> solid;
    for (const Triangle& triangle : triangles) {
      const Vector3d normal = normal_of(triangle);
      if (normal.squaredNorm() == 0.0) continue;  // without area
      solid.push_back(triangle);
      surfaces_.push_back({triangle.corners_m[0], normal, triangle.face});
    }
    add(solid);
    rtcSetSceneFlags(scene_.get(), RTC_SCENE_FLAG_ROBUST);
    rtcSetSceneBuildQuality(scene_.get(), RTC_BUILD_QUALITY_HIGH);
    rtcCommitScene(scene_.get());
    if (rtcGetDeviceError(device_.get()) != RTC_ERROR_NONE)
      throw std::runtime_error("Embree refuses this world; use the ray caster bullet");
  }

  std::optional<Hit> cast(const Ray& ray, double max_range_m) const override {
    RTCRayHit query = query_of(ray, max_range_m);
    while (true) {
      intersect(scene_.get(), query);
      if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
      const Surface& surface = surfaces_[query.hit.primID];
      const double range_m = surface.range_m(ray);
      if (range_m > 0.0 && range_m < max_range_m) return Hit{range_m, surface.face};
      // Only rounding to float put this surface within the range: go on behind it.
      query.ray.tnear = std::nextafter(query.ray.tfar, std::numeric_limits<float>::infinity());
      query.ray.tfar = reach_m(max_range_m);
      query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    }
  }

 private:
  void add(const std::vector<Triangle>& triangles) {
    const Owner<RTCGeometry> geometry(rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_TRIANGLE));
    auto* vertices = static_cast<float*>(
        rtcSetNewGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                3 * sizeof(float), 3 * triangles.size()));
    auto* indices = static_cast<unsigned*>(
        rtcSetNewGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                3 * sizeof(unsigned), triangles.size()));
    if (!vertices || !indices) throw std::bad_alloc();
    unsigned count = 0;
    for (const Triangle& triangle : triangles)
      for (const Vector3d& corner : triangle.corners_m) {
        for (int i = 0; i < 3; ++i) *vertices++ = static_cast<float>(corner[i]);
        *indices++ = count++;
      }
    rtcCommitGeometry(geometry.get());
    rtcAttachGeometry(scene_.get(), geometry.get());
  }

  Owner<RTCDevice> device_;
  Owner<RTCScene> scene_;
  std::vector<Surface> surfaces_;  ///< by Embree's index of the triangle
};

}  // namespace

std::unique_ptr<const RayCaster> make_embree_caster(const std::vector<Triangle>& triangles) {
  return std::make_unique<EmbreeCaster>(triangles);
}

}  // namespace ribbon_mapper::sim
