// SPDX-FileCopyrightText: 2026 ribbon_mapper authors
// SPDX-License-Identifier: BSD-3-Clause
#include "modeler/semantics/annotations.hpp"

#include <gmock/gmock.h>

#include <numeric>

#include "modeler/semantics/plane_label.hpp"
#include "test/modeler/semantics/rectangles.hpp"

namespace ribbon_mapper {
namespace {

using namespace rectangles;
using testing::AllOf;
using testing::HasSubstr;
using testing::ThrowsMessage;
using Texts = std::vector<std::string>;

Plane plane_of(std::int64_t id, std::vector<std::uint32_t> ribbons) {
  Plane plane = level(0, 0, 0, 1, 1, id);
  plane.ribbons = std::move(ribbons);
  return plane;
}

Texts labels_of(const Annotations& annotations, const std::vector<Plane>& planes) {
  Texts labels;
  for (const Annotation* annotation : annotations.of(planes)) {
    labels.push_back(annotation == nullptr ? "" : annotation->label);
  }
  return labels;
}

TEST(Annotations, GoBeforeTheRules) {
  const std::vector<Plane> planes{plane_of(1, {0}), plane_of(2, {1})};
  Annotations annotations;
  annotations.set(2, "my desk", "do not move", planes);
  const auto labels = plane_labels(planes, semantics_of(planes, {}), annotations.of(planes));
  EXPECT_EQ("floor", labels[0].text);
  EXPECT_EQ("my desk", labels[1].text);
  EXPECT_EQ("do not move", labels[1].note);
  EXPECT_EQ(1.0, labels[1].confidence);
}

TEST(Annotations, AreTakenForRoomsAndFloorPlanIfTheyAreLabelsOfTheRules) {
  const std::vector<Plane> planes{plane_of(1, {0}), plane_of(2, {1})};
  const Semantics by_rules = semantics_of(planes, {});
  Annotations annotations;
  annotations.set(1, "my carpet", "", planes);
  annotations.set(2, "ceiling", "", planes);
  const Semantics semantics = with_annotations(by_rules, annotations.of(planes));
  EXPECT_EQ(by_rules.labels[0].label, semantics.labels[0].label);
  EXPECT_EQ(Label::ceiling, semantics.labels[1].label);
  EXPECT_EQ(1.0, semantics.labels[1].confidence);
}

TEST(Annotations, OfUnknownIdsAreRefusedWithThoseThatThereAre) {
  Annotations annotations;
  EXPECT_THAT(
      [&] {
        annotations.set(5, "a", "", {plane_of(1, {}), plane_of(2, {})});
      },
      ThrowsMessage<std::invalid_argument>(AllOf(HasSubstr("id 5"), HasSubstr("1, 2"))));
  EXPECT_THAT([&] { annotations.set(5, "a", "", {}); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("none")));
  EXPECT_TRUE(annotations.by_id().empty());
}

TEST(Annotations, OfManyPlanesAreRefusedInAShortMessage) {
  std::vector<Plane> planes(100'000);
  for (std::size_t i = 0; i < planes.size(); ++i) planes[i].id = static_cast<std::int64_t>(i);
  Annotations annotations;
  EXPECT_THAT([&] { annotations.set(-1, "a", "", planes); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("99950 more")));
}

TEST(Annotations, AreShortAndInOneLine) {
  const std::vector<Plane> planes{plane_of(1, {})};
  Annotations annotations;
  for (const std::string& bad : {std::string(65, 'a'), std::string("a\nb"), std::string("a\tb")}) {
    EXPECT_THROW(annotations.set(1, bad, "", planes), std::invalid_argument) << bad;
  }
  EXPECT_THROW(annotations.set(1, "a", std::string(1001, 'a'), planes), std::invalid_argument);
  EXPECT_THROW(annotations.set(1, "a", "a\nb", planes), std::invalid_argument);
  EXPECT_TRUE(annotations.by_id().empty());
}

TEST(Annotations, AreRemovedByAnEmptyLabel) {
  const std::vector<Plane> planes{plane_of(1, {})};
  Annotations annotations;
  annotations.set(1, "a", "", planes);
  annotations.set(1, "", "", planes);
  EXPECT_TRUE(annotations.by_id().empty());
  EXPECT_THROW(annotations.set(1, "", "", planes), std::invalid_argument) << "there is none";
}

TEST(Annotations, FollowAPlaneThatIsMergedIntoAnother) {
  Annotations annotations;
  const std::vector<Plane> apart{plane_of(1, {0, 1, 2}), plane_of(2, {3, 4})};
  annotations.set(2, "mine", "", apart);
  EXPECT_EQ(Texts{"mine"}, labels_of(annotations, {plane_of(1, {0, 1, 2, 3, 4})}));
  EXPECT_EQ((Texts{"", "mine"}), labels_of(annotations, apart)) << "separated";
}

TEST(Annotations, OfTheSurvivorGoFirstIfTwoAnnotatedPlanesMerge) {
  Annotations annotations;
  const std::vector<Plane> apart{plane_of(1, {0, 1, 2}), plane_of(2, {3, 4})};
  annotations.set(1, "first", "", apart);
  annotations.set(2, "second", "", apart);
  EXPECT_EQ(Texts{"first"}, labels_of(annotations, {plane_of(1, {0, 1, 2, 3, 4})}));
  EXPECT_EQ((Texts{"first", "second"}), labels_of(annotations, apart));
}

TEST(Annotations, FollowNoPlaneByRibbonsThatHaveOtherNumbers) {
  Annotations annotations;
  annotations.set(2, "mine", "", {plane_of(1, {0, 1, 2}), plane_of(2, {3, 4})});
  annotations.forget_ribbons();
  const std::vector<Plane> merged{plane_of(1, {0, 3, 4}), plane_of(3, {1, 2})};
  EXPECT_EQ((Texts{"", ""}), labels_of(annotations, merged));
  const std::vector<Plane> again{plane_of(2, {1, 2})};
  EXPECT_EQ(Texts{"mine"}, labels_of(annotations, again));
  annotations.note_ribbons(again);
  EXPECT_EQ(Texts{"mine"}, labels_of(annotations, {plane_of(1, {1, 2})}));
}

TEST(Annotations, ComeBackFromText) {
  const std::vector<Plane> planes{plane_of(1, {}), plane_of(2, {})};
  Annotations annotations;
  annotations.set(1, "my desk", "do not move", planes);
  annotations.set(2, "T\xc3\xbcr", "", planes);
  const Annotations read = Annotations::from_text(annotations.to_text());
  EXPECT_EQ(annotations.to_text(), read.to_text());
  EXPECT_EQ("do not move", read.by_id().at(1).note);
  EXPECT_TRUE(Annotations::from_text("").by_id().empty());
}

TEST(Annotations, OfMergedPlanesComeBackFromText) {
  Annotations annotations;
  const std::vector<Plane> apart{plane_of(1, {0, 1, 2}), plane_of(2, {3, 4})};
  annotations.set(2, "mine", "", apart);
  Annotations read = Annotations::from_text(annotations.to_text());
  EXPECT_EQ(Texts{"mine"}, labels_of(read, {plane_of(1, {0, 1, 2, 3, 4})}));
  EXPECT_EQ(annotations.to_text(), read.to_text());
}

TEST(Annotations, KeepFewRibbonsOfALargePlane) {
  std::vector<std::uint32_t> many(100'000);
  std::iota(many.begin(), many.end(), 0U);
  Annotations annotations;
  annotations.set(1, "a", "", {plane_of(1, many)});
  EXPECT_EQ(Annotations::kMostRibbons, annotations.by_id().at(1).ribbons.size());
  EXPECT_GT(annotations.by_id().at(1).ribbons.back(), 90'000U);
}

TEST(Annotations, AreRefusedIfTheirTextIsDamaged) {
  for (const std::string bad :
       {"1", "1\ta", "1\ta\tb", "x\ta\tb\t", "1\t\tb\t", "1x\ta\tb\t", "1\ta\tb\t\n1\ta\tb\t",
        "99999999999999999999\ta\tb\t", "1\ta\tb\tx", "1\ta\tb\t1,2", "1\ta\tb\t-1"}) {
    EXPECT_THAT([&] { Annotations::from_text(bad); },
                ThrowsMessage<std::invalid_argument>(HasSubstr("line")))
        << bad;
  }
}

}  // namespace
}  // namespace ribbon_mapper
