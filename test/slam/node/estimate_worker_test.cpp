// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slam/node/estimate_worker.hpp"

#include <gtest/gtest.h>

#include "test/modeler/mini_world.hpp"

namespace ribbon_mapper::slam {
namespace {

using mini_world::Lines;

/// Returns the same function of time after three seconds at its start.
mini_world::PoseByTime after_rest(const mini_world::PoseByTime& pose) {
  return [pose](double time_s) { return pose(std::max(0.0, time_s - 3.0)); };
}

Lines lines_of_circle(double from_s, double to_s) {
  const mini_world::Motion circle{after_rest(mini_world::around_the_middle), mini_world::to_and_fro,
                                  after_rest(mini_world::wandering_drift)};
  return mini_world::drive(mini_world::room(), circle, from_s, to_s);
}

/// Returns a line as the node gets it, posed by odometry alone, in an odom frame that is turned.
ReadyLine ready(const mini_world::Line& line, const Pose& T_odom_world = Pose::Identity()) {
  LinePoses poses = line.poses;
  poses.T_odom_base_first = T_odom_world * poses.T_odom_base_first;
  poses.T_odom_base_last = T_odom_world * poses.T_odom_base_last;
  poses.T_map_base = interpolate(poses.T_odom_base_first, poses.T_odom_base_last, 0.5);
  return {line.beams, poses, "laser"};
}

void add(const Lines& lines, EstimateWorker& worker) {
  for (const mini_world::Line& line : lines) worker.add(ready(line));
}

/// Waits until the worker has closed. Returns all its news as one.
EstimateNews news_until_closed(EstimateWorker& worker) {
  EstimateNews all;
  while (!all.is_closed) {
    EstimateNews news = worker.take_news();
    all.outcomes.insert(all.outcomes.end(), news.outcomes.begin(), news.outcomes.end());
    if (news.revision) all.revision = std::move(news.revision);
    if (news.now) all.now = news.now;
    for (const std::string& reason : news.refused_base_scans)
      all.refused_base_scans.push_back(reason);
    all.status = news.status;
    all.is_closed = news.is_closed;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return all;
}

TEST(EstimateWorker, FindsWhatTheEstimateFinds) {
  const Lines lines = lines_of_circle(0.0, 8.0);
  LiveEstimate alone({}, {});
  for (const mini_world::Line& line : lines) alone.add(ready(line));
  alone.finish();
  const std::vector<StampedPose> expected = alone.trajectory();

  EstimateWorker worker({}, {});
  add(lines, worker);
  worker.close();
  const EstimateNews news = news_until_closed(worker);
  EXPECT_EQ(news.outcomes.size(), lines.size());
  EXPECT_EQ(worker.lines_behind(), 0u);
  EXPECT_EQ(worker.seconds_behind(), 0.0);
  EXPECT_EQ(news.status.windows, 2u);
  ASSERT_TRUE(news.revision);
  ASSERT_EQ(news.revision->size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_EQ((*news.revision)[i].stamp, expected[i].stamp);
    EXPECT_EQ((*news.revision)[i].T_map_base.matrix(), expected[i].T_map_base.matrix());
  }
  ASSERT_TRUE(news.now);
  EXPECT_EQ(news.now->stamp, expected.back().stamp);
}

TEST(EstimateWorker, AResetForgetsWhatWasInTheQueue) {
  const Lines before = lines_of_circle(0.0, 4.0), after = lines_of_circle(5.0, 6.0);
  EstimateWorker worker({}, {});
  add(before, worker);
  worker.close();
  worker.reset();
  add(after, worker);
  worker.close();
  const EstimateNews news = news_until_closed(worker);
  EXPECT_EQ(news.outcomes.size(), after.size());
  ASSERT_TRUE(news.revision);
  EXPECT_GE(news.revision->front().stamp, after.front().beams.stamp);
  EXPECT_EQ(news.status.windows, 0u);
}

TEST(EstimateWorker, ClosesWithoutLines) {
  EstimateWorker worker({}, {});
  worker.close();
  const EstimateNews news = news_until_closed(worker);
  EXPECT_EQ(news.status.lines, 0u);
  EXPECT_FALSE(news.revision);
}

TEST(EstimateWorker, EndsWithWorkInItsQueue) {
  EstimateWorker worker({}, {});
  add(lines_of_circle(0.0, 4.0), worker);
}

TEST(LiveEstimate, SaysWhichLinesAreRefused) {
  const Lines lines = lines_of_circle(0.0, 0.2);
  LiveEstimate estimate({}, {});
  for (const mini_world::Line& line : lines) {
    EXPECT_EQ(estimate.add(ready(line)).defect, "");
  }
  EXPECT_EQ(estimate.add(ready(lines[0])).result, LineResult::out_of_order);
  ReadyLine wrong = ready(lines[1]);
  wrong.poses.T_odom_base_first.translation().x() = std::nan("");
  const LineOutcome outcome = estimate.add(wrong);
  EXPECT_EQ(outcome.result, LineResult::malformed);
  EXPECT_EQ(outcome.defect, "a pose is not finite");
}

/// Returns the pose of now after lines in an odom frame.
PoseOfNow now_in(const Pose& T_odom_world) {
  LiveEstimate estimate({}, {});
  for (const mini_world::Line& line : lines_of_circle(0.0, 5.0)) {
    estimate.add(ready(line, T_odom_world));
  }
  return estimate.now();
}

TEST(EstimateWorker, ABaseLaserRefinesTheOdometry) {
  const double end_s = 12.0;
  const mini_world::Motion level{after_rest(mini_world::around_the_middle),
                                 [](double) { return 0.0; },
                                 after_rest(mini_world::wandering_drift)};
  const Lines lines = lines_of_circle(0.0, end_s),
              scans = mini_world::drive(mini_world::room(), level, 0.0, end_s);
  ASSERT_EQ(lines.size(), scans.size());
  EstimateWorker worker({}, {}, true);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    worker.add_base_scan(ready(scans[i]));
    worker.add(ready(lines[i]));
  }
  worker.add_base_scan(ready(scans[0]));
  worker.close();
  const EstimateNews news = news_until_closed(worker);
  EXPECT_EQ(news.outcomes.size(), lines.size());
  EXPECT_GT(news.status.base_scans, lines.size() / 2);
  EXPECT_EQ(news.refused_base_scans.size(), 1U);
}

TEST(LiveEstimate, TheCovarianceIsAlongTheAxesOfMap) {
  Pose turned = Pose::Identity();
  turned.linear() = Eigen::AngleAxisd(M_PI / 2.0, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  turned.translation() = Eigen::Vector3d(3.0, -2.0, 0.0);
  const PoseOfNow a = now_in(Pose::Identity()), b = now_in(turned);
  Matrix6 to_b = Matrix6::Zero();
  to_b.topLeftCorner<3, 3>() = to_b.bottomRightCorner<3, 3>() = turned.linear();
  const Matrix6 expected = to_b * a.covariance * to_b.transpose();
  const double size = a.covariance.norm();
  EXPECT_GT((a.covariance - expected).norm(), 0.1 * size);  // so that the test can fail
  EXPECT_LT((b.covariance - expected).norm(), 0.001 * size);
}

TEST(LiveEstimate, MapIsOdomAtTheStartAndTheDifferenceIsTheDrift) {
  Pose turned = Pose::Identity();
  turned.translation() = Eigen::Vector3d(3.0, -2.0, 0.0);
  LiveEstimate estimate({}, {});
  const Lines lines = lines_of_circle(0.0, 12.0);
  std::optional<PoseOfNow> first;
  for (const mini_world::Line& line : lines) {
    estimate.add(ready(line, turned));
    if (!first && estimate.newest() > Time(0)) first = estimate.now();
  }
  ASSERT_TRUE(first);
  EXPECT_LT(first->T_map_odom().translation().norm(), 0.005);
  const PoseOfNow last = estimate.now();
  const auto has_stamp = [&](const StampedPose& pose) { return pose.stamp == last.stamp; };
  const std::vector<StampedPose> truth = mini_world::true_trajectory(lines);
  const auto here = std::find_if(truth.begin(), truth.end(), has_stamp);
  ASSERT_NE(here, truth.end());
  const Pose error = (turned * here->T_map_base).inverse() * last.T_map_base;
  EXPECT_LT(error.translation().norm(), 0.05);
  EXPECT_GT(last.T_map_odom().translation().norm(), 0.05);
}

}  // namespace
}  // namespace ribbon_mapper::slam
