// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include <embree3/rtcore.h>

#include <limits>

#include "bench/rays/rays_peer.hpp"

namespace ribbon_mapper::bench {
namespace {

struct Scene {
  RTCDevice device = rtcNewDevice("threads=1");
  RTCScene scene = rtcNewScene(device);
  ~Scene() {
    rtcReleaseScene(scene);
    rtcReleaseDevice(device);
  }
};

std::shared_ptr<Scene> scene_of(const std::vector<sim::Triangle>& triangles) {
  auto scene = std::make_shared<Scene>();
  RTCGeometry geometry = rtcNewGeometry(scene->device, RTC_GEOMETRY_TYPE_TRIANGLE);
  auto* vertices = static_cast<float*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0,
                                                               RTC_FORMAT_FLOAT3, 3 * sizeof(float),
                                                               3 * triangles.size()));
  auto* indices = static_cast<unsigned*>(
      rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                              3 * sizeof(unsigned), triangles.size()));
  for (std::size_t i = 0; i < 3 * triangles.size(); ++i) {
    const Eigen::Vector3d& corner = triangles[i / 3].corners_m[i % 3];
    for (int axis = 0; axis < 3; ++axis) *vertices++ = static_cast<float>(corner[axis]);
    *indices++ = static_cast<unsigned>(i);
  }
  rtcSetGeometryBuildQuality(geometry, RTC_BUILD_QUALITY_HIGH);
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(scene->scene, geometry);
  rtcReleaseGeometry(geometry);
  rtcSetSceneBuildQuality(scene->scene, RTC_BUILD_QUALITY_HIGH);
  rtcCommitScene(scene->scene);
  return scene;
}

RTCRayHit ray_hit_of(const Ray& ray, double max_range_m) {
  RTCRayHit hit{};
  hit.ray.org_x = static_cast<float>(ray.origin.x());
  hit.ray.org_y = static_cast<float>(ray.origin.y());
  hit.ray.org_z = static_cast<float>(ray.origin.z());
  hit.ray.dir_x = static_cast<float>(ray.direction.x());
  hit.ray.dir_y = static_cast<float>(ray.direction.y());
  hit.ray.dir_z = static_cast<float>(ray.direction.z());
  hit.ray.tfar = static_cast<float>(max_range_m);
  hit.ray.mask = ~0u;
  hit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  return hit;
}

}  // namespace

RayCasting embree(const std::vector<sim::Triangle>& triangles) {
  auto scene = scene_of(triangles);
  return [scene](const std::vector<Ray>& rays, double max_range_m, std::vector<float>& ranges) {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    for (std::size_t i = 0; i < rays.size(); ++i) {
      RTCRayHit hit = ray_hit_of(rays[i], max_range_m);
      rtcIntersect1(scene->scene, &context, &hit);
      ranges[i] = hit.hit.geomID == RTC_INVALID_GEOMETRY_ID ? std::numeric_limits<float>::infinity()
                                                            : hit.ray.tfar;
    }
  };
}

}  // namespace ribbon_mapper::bench
