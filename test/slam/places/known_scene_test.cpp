// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slam/places/known_scene.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numeric>

#include "slam/places/history_cost.hpp"
#include "slam/places/seam.hpp"
#include "slam/places/slip_evidence.hpp"
#include "test/modeler/mini_world.hpp"

namespace ribbon_mapper::slam {
namespace {

using ::testing::IsEmpty;
using ::testing::SizeIs;

constexpr double kRadius_m = 1.5;  // of the window that is searched

const AssociationGates kGates{3.2, 0.12};

/// A room that is seen for eight seconds unless told otherwise, from its middle unless a motion is
/// given. A door of 1 m leads through its wall at x = 3, unless it is another place.
struct SeenRoom {
  explicit SeenRoom(const mini_world::Motion& motion = mini_world::tilting_in_place(),
                    double seconds = 8.0, const mini_world::World& world = with_door())
      : modeler(mini_world::model_of(mini_world::drive(world, motion, 0.0, seconds))),
        lines(modeler.observations()) {
    while (lines.has_next()) {
      lines.add_next();
      const std::uint32_t line = lines.size() - 1;
      lines.set_pose(line, lines.T_odom_base(0).inverse(Eigen::Isometry) * lines.T_odom_base(line));
    }
    all.resize(lines.size());
    std::iota(all.begin(), all.end(), 0U);
  }
  void move_from(std::uint32_t first, const Pose& move) {
    for (std::uint32_t i = first; i < lines.size(); ++i) {
      lines.set_pose(i, move * lines.T_start_base(i));
    }
  }
  static mini_world::World with_door() {
    mini_world::World world = mini_world::room();
    const auto is_at_3 = [](const mini_world::Face& face) { return face.normal.x() < -0.5; };
    world.erase(std::remove_if(world.begin(), world.end(), is_at_3), world.end());
    world.push_back(mini_world::plane({-1, 0, 0}, 3.0, {3.0, -2.5, 0.0}, {3.0, -0.5, 2.5}));
    world.push_back(mini_world::plane({-1, 0, 0}, 3.0, {3.0, 0.5, 0.0}, {3.0, 2.5, 2.5}));
    return world;
  }
  Modeler modeler;
  PosedLines lines;
  std::vector<std::uint32_t> all;
  EstimateSettings settings = estimate_settings({});
};

TEST(KnownScene, KnowsWhatItWasMadeOf) {
  const SeenRoom room;
  const KnownScene scene(room.lines, room.all, room.settings);
  const Agreement there =
      agreement_of(room.lines, {0, room.lines.size()}, Pose::Identity(), scene, kGates);
  EXPECT_GT(there.seen_m, 10.0);
  EXPECT_GT(there.known(), 0.95);
  EXPECT_EQ(there.pierced_m, 0.0);
}

TEST(KnownScene, DoesNotKnowItElsewhere) {
  const SeenRoom room;
  const KnownScene scene(room.lines, room.all, room.settings);
  const Agreement turned =
      agreement_of(room.lines, {0, room.lines.size()}, in_space({0.0, 0.0, 0.3}), scene, kGates);
  EXPECT_LT(turned.known(), 0.05);
  const Agreement shifted =
      agreement_of(room.lines, {0, room.lines.size()}, in_space({1.0, 1.0, 0.0}), scene, kGates);
  EXPECT_LT(shifted.known(), 0.05);
  EXPECT_GT(shifted.pierced(), 0.1);  // what is moved out of the room is seen through its walls
}

TEST(KnownScene, BlocksRaysByWallsAndNotByDoors) {
  const SeenRoom room;
  const KnownScene scene(room.lines, room.all, room.settings);
  const Eigen::Vector3d sensor(0.0, 0.0, 1.2);
  EXPECT_TRUE(scene.stands_between(sensor, {6.0, 3.0, 1.2}));
  EXPECT_FALSE(scene.stands_between(sensor, {6.0, 0.3, 1.2}));   // through the door
  EXPECT_FALSE(scene.stands_between(sensor, {2.9, 1.45, 1.2}));  // before the wall
  EXPECT_FALSE(scene.stands_between({6.0, 3.0, 1.2}, sensor));   // from its unseen side
}

TEST(PlaceSearch, FindsTheMoveThatWasMade) {
  SeenRoom room;
  const std::vector<std::uint32_t> older(room.all.begin(), room.all.begin() + 160);
  const KnownScene scene(room.lines, older, room.settings);
  const Pose move = in_space({0.4, -0.7, 0.25});
  room.move_from(160, move);
  const LineRange range{160, room.lines.size()};
  const PlaceSearch search(room.lines, range, scene, room.settings);
  const auto moves = search.moves_about(range.end - 1, kRadius_m);
  ASSERT_EQ(moves.size(), 1U);
  EXPECT_GT(moves.front().agreement.known(), 0.9);
  const Pose rest = moves.front().T_start_start * move;
  EXPECT_LT(rest.translation().norm(), 0.02);
  EXPECT_LT(angle_of(rest), 0.01);
}

/// Eight metres before the room, the robot slipped by 20 degrees: in the room, it is off by 2.8 m.
TEST(PlaceSearch, FindsASlipThatWasMadeALongWayBefore) {
  SeenRoom room;
  const std::vector<std::uint32_t> older(room.all.begin(), room.all.begin() + 160);
  const KnownScene scene(room.lines, older, room.settings);
  const std::uint32_t slipped = 160;
  const Pose there = in_space({-8.0, 0.0, 0.0});
  const Pose slip = there * in_space({0.0, 0.0, 0.35}) * there.inverse(Eigen::Isometry);
  room.lines.set_pose(slipped, there);
  room.move_from(slipped + 1, slip);
  const LineRange range{slipped + 1, room.lines.size()};
  const PlaceSearch search(room.lines, range, scene, room.settings);
  EXPECT_TRUE(search.moves_about(range.end - 1, kRadius_m).empty());
  EXPECT_EQ(search.moves_about(range.end - 1, 2.0 * kRadius_m).size(), 1U);
  const auto moves = search.moves_about(slipped, kRadius_m);
  ASSERT_EQ(moves.size(), 1U);
  const Pose rest = moves.front().T_start_start * slip;
  EXPECT_LT(rest.translation().norm(), 0.05);
  EXPECT_LT(angle_of(rest), 0.01);
}

/// Far from the start, a small turn about it moves the robot a long way.
TEST(PlaceSearch, ComparesMovesByWhatTheyDoToTheRobot) {
  const Pose turn = in_space({0.0, 0.0, 0.02});
  EXPECT_TRUE(is_same_move(turn, Pose::Identity(), Pose::Identity()));
  EXPECT_FALSE(is_same_move(turn, Pose::Identity(), in_space({20.0, 0.0, 1.0})));
}

/// A corridor along x, without an end in sight.
struct SeenCorridor : SeenRoom {
  SeenCorridor() : SeenRoom(mini_world::tilting_in_place(), 8.0, walls()) {}
  static mini_world::World walls() {
    return {mini_world::plane({0, 0, 1}, 0.0),
            mini_world::plane({0, 1, 0}, 1.0, {2.0, -1.0, 0.0}, {20.0, -1.0, 2.5}),
            mini_world::plane({0, -1, 0}, 1.0, {2.0, 1.0, 0.0}, {20.0, 1.0, 2.5})};
  }
};

TEST(OpenDirection, LeadsAlongACorridor) {
  const SeenCorridor corridor;
  const KnownScene scene(corridor.lines, corridor.all, corridor.settings);
  const auto open = open_direction(corridor.lines, {0, corridor.lines.size()}, Pose::Identity(),
                                   scene, corridor.settings);
  ASSERT_TRUE(open);
  EXPECT_GT(std::abs(open->x()), 0.999);
}

TEST(OpenDirection, IsNoneInARoom) {
  const SeenRoom room;
  const KnownScene scene(room.lines, room.all, room.settings);
  EXPECT_FALSE(
      open_direction(room.lines, {0, room.lines.size()}, Pose::Identity(), scene, room.settings));
}

TEST(Seam, LiesWhereLinesAreTorn) {
  SeenRoom room;
  const std::vector<std::uint32_t> older(room.all.begin(), room.all.begin() + 120);
  const KnownScene scene(room.lines, older, room.settings);
  const Pose move = in_space({0.0, 0.0, 0.3});
  room.move_from(200, move);
  const Pose back = move.inverse(Eigen::Isometry);
  const Seam seam = seam_of(room.lines, {120, room.lines.size()}, back, scene, kGates);
  EXPECT_NEAR(seam.first, 200, 10);
  EXPECT_NEAR(seam.end, 200, 10);
  move_behind(seam, back, room.lines);
  EXPECT_LT(angle_of(room.lines.T_start_base(300)), 1e-3);
  EXPECT_LT(angle_of(room.lines.T_start_base(100)), 1e-3);
}

TEST(Seam, HoldsAllLinesThatFitBothWays) {
  SeenRoom room;
  const std::vector<std::uint32_t> older(room.all.begin(), room.all.begin() + 120);
  const KnownScene scene(room.lines, older, room.settings);
  const Seam seam = seam_of(room.lines, {120, 200}, Pose::Identity(), scene, kGates);
  EXPECT_EQ(seam.first, 120U);
  EXPECT_EQ(seam.end, 200U);
  EXPECT_EQ(seam.split, std::nullopt);
}

/// A room that is driven through for 20 s.
struct DrivenRoom : SeenRoom {
  DrivenRoom()
      : SeenRoom({mini_world::around_the_middle, mini_world::to_and_fro, mini_world::no_drift},
                 20.0) {}
  /// Moves the lines from one on. Returns the move that would take them back.
  Pose slip(std::uint32_t line) {
    const Pose move = in_space({0.4, 0.3, 0.2});
    move_from(line, move);
    return move.inverse(Eigen::Isometry);
  }
};

TEST(FittingSlips, LieWhereLinesFitWhatTheyHaveJustSeenOnlyIfMoved) {
  DrivenRoom room;
  const Pose back = room.slip(450);
  const auto slips = fitting_slips(room.lines, {1, room.lines.size()}, back, room.settings);
  ASSERT_FALSE(slips.empty());
  EXPECT_NEAR(slips[0].seam.first, 450, 10);
  EXPECT_NEAR(slips[0].seam.end, 450, 10);
  EXPECT_GT(slips[0].evidence.ribbons, 100.0);
  EXPECT_TRUE(slips[0].evidence.is_explained);
}

TEST(FittingSlips, AreNowhereInLinesThatFitWhereTheyAre) {
  DrivenRoom room;
  const LineRange all{1, room.lines.size()};
  EXPECT_THAT(fitting_slips(room.lines, all, in_space({0.4, 0.3, 0.2}), room.settings), IsEmpty());
  EXPECT_THAT(fitting_slips(room.lines, all, Pose::Identity(), room.settings), IsEmpty());
}

TEST(FittingSlips, AreNotThoseOfAnotherMove) {
  DrivenRoom room;
  room.slip(450);
  const LineRange all{1, room.lines.size()};
  EXPECT_THAT(fitting_slips(room.lines, all, in_space({0.0, 1.0, -0.4}), room.settings), IsEmpty());
}

/// Three seconds are looked at, behind the second in which the robot may be slipping still.
TEST(FittingSlips, AreNotToldFromTooFewLinesBehindThem) {
  DrivenRoom room;
  const std::uint32_t line = room.lines.size() - 60;
  const Pose back = room.slip(line);
  EXPECT_THAT(fitting_slips(room.lines, {line, room.lines.size()}, back, room.settings), IsEmpty());
}

TEST(FittingSlips, AreTwoIfLinesFitInTwoPlaces) {
  DrivenRoom room;
  const Pose back = room.slip(250);
  room.slip(450);
  const auto slips = fitting_slips(room.lines, {1, room.lines.size()}, back, room.settings);
  ASSERT_THAT(slips, SizeIs(2));
  EXPECT_NEAR(slips[0].seam.first, 250, 40);  // a second
  EXPECT_GE(slips[0].evidence.ribbons, slips[1].evidence.ribbons);
  EXPECT_NEAR(slips[1].seam.first, 450, 40);  // a second
}

TEST(SlipEvidence, ContradictsASlipWhereLinesFitWhatTheyHaveJustSeen) {
  DrivenRoom room;
  const Pose back = room.slip(450);
  EXPECT_TRUE(slip_evidence(room.lines, 300, back, room.settings).is_contradicted);
  EXPECT_FALSE(slip_evidence(room.lines, 450, back, room.settings).is_contradicted);
  EXPECT_EQ(slip_evidence(room.lines, room.lines.size() - 1, back, room.settings).ribbons, 0.0);
}

TEST(MostStrained, IsTheSecondThatContradictsItsOdometry) {
  SeenRoom room({mini_world::around_the_middle, mini_world::to_and_fro, mini_world::no_drift});
  const LineRange all{1, room.lines.size()};
  EXPECT_EQ(most_strained(room.lines, all, 3.0), std::nullopt);
  const Pose there = room.lines.T_start_base(200);
  const Pose move = there * in_space({0.0, 0.0, 0.2}) * there.inverse(Eigen::Isometry);
  room.move_from(200, move);
  const std::optional<std::uint32_t> strained = most_strained(room.lines, all, 3.0);
  ASSERT_TRUE(strained);
  EXPECT_LE(*strained, 200U);
  EXPECT_LE(room.lines.seconds_between(*strained, 200), 1.0);
  EXPECT_EQ(most_strained(room.lines, {201, all.end}, 3.0), std::nullopt);
  room.lines.set_slip(200, true);
  EXPECT_EQ(most_strained(room.lines, all, 3.0), std::nullopt);
}

TEST(HistoryCost, IsLessWithoutATear) {
  SeenRoom room;
  const HistoryCost whole = history_cost(room.lines, room.all, room.settings);
  const Pose move = in_space({0.3, 0.2, 0.3});
  room.move_from(200, move);
  const HistoryCost torn = history_cost(room.lines, room.all, room.settings);
  EXPECT_GT(torn.planes, whole.planes);
  EXPECT_GT(torn.total, whole.total);
}

}  // namespace
}  // namespace ribbon_mapper::slam
