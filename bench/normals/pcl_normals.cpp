// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/features/normal_3d.h>
#include <pcl/point_types.h>
#include <pcl/search/kdtree.h>

#include <cstdio>
#include <memory>

#include "bench/normals/normals_peer.hpp"
#include "bench/stopwatch.hpp"

namespace ribbon_mapper::bench {
namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;

/// Three lines in PCL's types, relative to the sensor: floats far from the origin lose millimetres.
struct Sample {
  Cloud::Ptr three = std::make_shared<Cloud>();    // all returns
  Cloud::Ptr queries = std::make_shared<Cloud>();  // points of our surfels' beams
  Cloud::Ptr middle = std::make_shared<Cloud>();   // all returns of the middle line
  std::vector<pcl::Indices> neighbours;            // of each query, as in our method
  std::vector<int> query_of_beam;
  pcl::PointCloud<pcl::Normal> normals;  // of the queries
};

pcl::PointXYZ to_pcl(const Eigen::Vector3d& point, const Eigen::Vector3d& origin) {
  const Eigen::Vector3f p = (point - origin).cast<float>();
  return {p.x(), p.y(), p.z()};
}

Sample converted(const NormalsInput& lines) {
  Sample sample;
  const Eigen::Vector3d origin = lines.middle().first_origin;
  std::vector<std::vector<int>> index;  // by line: index of each beam in `three`
  for (const ScanLine* line : {&lines.lines[0], &lines.lines[1], &lines.lines[2]}) {
    index.emplace_back(line->size(), -1);
    for (std::size_t i = 0; i < line->size(); ++i) {
      if (!line->has_return(i)) continue;
      index.back()[i] = static_cast<int>(sample.three->size());
      sample.three->push_back(to_pcl(line->points[i], origin));
      if (line == &lines.middle()) sample.middle->push_back(sample.three->back());
    }
  }
  sample.query_of_beam.assign(lines.middle().size(), -1);
  std::vector<BeamRange> around(lines.middle().size());
  for (std::size_t k = 0; k < lines.beams.size(); ++k) around[lines.beams[k]] = lines.around[k];
  for (const Surfel& surfel : lines.surfels) {
    sample.query_of_beam[surfel.beam] = static_cast<int>(sample.queries->size());
    sample.queries->push_back(to_pcl(lines.middle().points[surfel.beam], origin));
    pcl::Indices& list = sample.neighbours.emplace_back();
    const BeamRange& near = around[surfel.beam];
    for (const auto& line : index) {
      for (std::size_t i = near.begin; i < near.end; ++i) {
        if (line[i] >= 0) list.push_back(line[i]);
      }
    }
  }
  return sample;
}

using Samples = std::shared_ptr<std::vector<Sample>>;

std::function<Eigen::Vector3d(std::size_t, std::size_t)> reader(const Samples& samples) {
  return [samples](std::size_t s, std::size_t beam) {
    const Sample& sample = (*samples)[s];
    const int query = sample.query_of_beam[beam];
    if (query < 0) return no_normal();
    return sample.normals[query].getNormalVector3fMap().cast<double>().eval();
  };
}

/// Returns a peer that estimates normals at the cloud `points` of each sample, with the three lines
/// as search surface.
NormalsPeer with_search(const std::string& name, const Samples& samples, Cloud::Ptr Sample::*points,
                        double radius_m, int neighbours) {
  NormalsPeer peer;
  peer.name = name;
  const auto output = std::make_shared<pcl::PointCloud<pcl::Normal>>();
  for (const Sample& sample : *samples) peer.normals += (sample.*points)->size();
  peer.run = [=] {
    for (Sample& sample : *samples) {
      pcl::NormalEstimation<pcl::PointXYZ, pcl::Normal> estimation;
      estimation.setInputCloud(sample.*points);
      estimation.setSearchSurface(sample.three);
      estimation.setSearchMethod(std::make_shared<pcl::search::KdTree<pcl::PointXYZ>>());
      if (radius_m > 0.0) estimation.setRadiusSearch(radius_m);
      if (neighbours > 0) estimation.setKSearch(neighbours);
      const bool is_query = points == &Sample::queries;
      estimation.compute(is_query ? sample.normals : *output);
    }
  };
  if (points == &Sample::queries) peer.normal_at = reader(samples);
  return peer;
}

NormalsPeer without_search(const Samples& samples) {
  NormalsPeer peer;
  peer.name = "pcl::computePointNormal on our neighbour lists";
  for (const Sample& sample : *samples) peer.normals += sample.queries->size();
  peer.run = [samples] {
    for (Sample& sample : *samples) {
      sample.normals.resize(sample.queries->size());
      for (std::size_t i = 0; i < sample.queries->size(); ++i) {
        Eigen::Vector4f plane;
        float curvature = 0.0F;
        pcl::computePointNormal(*sample.three, sample.neighbours[i], plane, curvature);
        sample.normals[i].getNormalVector3fMap() = plane.head<3>();
      }
    }
  };
  peer.normal_at = reader(samples);
  return peer;
}

}  // namespace

std::vector<NormalsPeer> pcl_normals(const std::vector<NormalsInput>& lines,
                                     double neighbourhood_m) {
  // Each peer has its own copy, which holds the normals of its last run.
  const auto copy = [&lines] {
    auto samples = std::make_shared<std::vector<Sample>>();
    for (const NormalsInput& sample : lines) samples->push_back(converted(sample));
    return samples;
  };
  const auto within = [&copy](double radius_m, Cloud::Ptr Sample::*points, const char* which) {
    char name[64];
    std::snprintf(name, sizeof name, "pcl::NormalEstimation r %.2f m%s", radius_m, which);
    return with_search(name, copy(), points, radius_m, 0);
  };
  return {within(neighbourhood_m, &Sample::queries, ""),
          within(2.0 * neighbourhood_m, &Sample::queries, ""),
          with_search("pcl::NormalEstimation k 30", copy(), &Sample::queries, 0.0, 30),
          within(neighbourhood_m, &Sample::middle, ", every beam"), without_search(copy())};
}

}  // namespace ribbon_mapper::bench
