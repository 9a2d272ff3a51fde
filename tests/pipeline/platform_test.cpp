// Properties of every kind of platform.
#include "project/platform.h"

#include "base/error.h"
#include "geometry/convex_polygon.h"
#include "modes/mode_table.h"
#include "project/platform_kinds.h"

#include <gtest/gtest.h>
#include <set>

using namespace voluta;
using project::Platform;
using project::PlatformField;
using project::PlatformKind;
using project::platformKinds;
using project::PlatformUse;

namespace {

std::vector<Platform> oneOfEach() {
  std::vector<Platform> all;
  for (const PlatformKind& kind : platformKinds())
    all.push_back(kind.file.empty() ? Platform(kind) : Platform(kind, "folder/a body:1.stl"));
  return all;
}

std::string refusal(const std::string& text) {
  try {
    Platform{text};
  } catch (const base::Error& error) {
    EXPECT_EQ(error.code(), base::ErrorCode::Usage);
    return error.what();
  }
  ADD_FAILURE() << text << " is taken";
  return {};
}

// Signed, twice; > 0 for counter-clockwise.
double areaOf(const std::vector<Eigen::Vector2d>& polygon) {
  double area = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Eigen::Vector2d &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    area += a.x() * b.y() - a.y() * b.x();
  }
  return area;
}

const std::vector<Eigen::Vector2d> kStanding{{-3, -2}, {4, -2}, {4, 5}, {-3, 5}, {0, 0}};

TEST(Platform, IsReadBackFromItsText) {
  for (const Platform& platform : oneOfEach()) {
    EXPECT_EQ(Platform(platform.text()), platform) << platform.text();
    for (std::size_t f = 0; f < platform.sizesMm().size(); ++f)
      for (const double mm : {platform.kind().fields[f].minimum, platform.kind().fields[f].maximum,
                              12.345, 1.0 / 3.0}) {
        std::vector<double> sizes = platform.sizesMm();
        sizes[f] = mm;
        const Platform other(platform.kind(), sizes);
        EXPECT_EQ(Platform(other.text()), other) << other.text();
      }
  }
  EXPECT_EQ(Platform().text(), "fit:0");
  EXPECT_EQ(Platform("fit"), Platform());
}

TEST(Platform, WordsAreUniqueAndTheNearestIsNamed) {
  std::set<std::string_view> words;
  for (const PlatformKind& kind : platformKinds()) {
    EXPECT_TRUE(words.insert(kind.word).second) << kind.word;
    EXPECT_EQ(&project::findPlatformKind(kind.word), &kind);
    const std::string wrong = std::string(kind.word) + "q:5";
    EXPECT_NE(refusal(wrong).find(std::string("did you mean ") + std::string(kind.word)),
              std::string::npos);
  }
}

TEST(Platform, FieldsBeyondTheirRangeAreNamed) {
  for (const PlatformKind& kind : platformKinds())
    for (std::size_t f = 0; f < kind.fields.size(); ++f) {
      const PlatformField& field = kind.fields[f];
      EXPECT_LT(field.minimum, field.maximum);
      EXPECT_GE(field.usual, field.minimum);
      EXPECT_LE(field.usual, field.maximum);
      for (const double mm : {field.minimum - 0.5, 2.0 * field.maximum}) {
        std::string text = std::string(kind.word) + ":";
        for (std::size_t i = 0; i < kind.fields.size(); ++i)
          text += (i ? "x" : "") + std::to_string(i == f ? mm : kind.fields[i].usual);
        EXPECT_NE(refusal(text).find(field.name), std::string::npos) << text;
      }
    }
}

TEST(Platform, InvalidSizesAreRefusedWithTheForm) {
  for (const PlatformKind& kind : platformKinds()) {
    const std::string word(kind.word), form = project::platformForm(kind);
    if (!kind.file.empty()) {
      EXPECT_NE(refusal(word).find(form), std::string::npos);
      EXPECT_NE(refusal(word + ":").find(form), std::string::npos);
      continue;
    }
    if (kind.fields.empty()) {
      EXPECT_NE(refusal(word + ":9").find(form), std::string::npos);
      continue;
    }
    const std::string size = Platform(kind).text().substr(word.size() + 1);
    for (const std::string& wrong :
         {word + ":a", word + ":" + size + "x", word + ":" + size + "x1x", word + ":nan",
          word + ":" + size + "x1"})
      EXPECT_NE(refusal(wrong).find(form), std::string::npos) << wrong;
    EXPECT_TRUE(kind.bare || refusal(word).find(form) != std::string::npos) << word;
  }
}

TEST(Platform, IsListedInTheHelpAndHasTexts) {
  using enum PlatformUse;
  const std::string forms = project::platformForms({Plate, Rod, Body});
  for (const PlatformKind& kind : platformKinds()) {
    EXPECT_NE(forms.find(project::platformForm(kind)), std::string::npos) << forms;
    EXPECT_FALSE(kind.shown.empty());
    ASSERT_FALSE(kind.uses.empty());
    for (const PlatformKind::As& as : kind.uses)
      EXPECT_FALSE(as.label.empty());
    for (const PlatformField& field : kind.fields)
      EXPECT_FALSE(field.label.empty());
  }
}

TEST(Platform, PlatesAreConvexAndWhereTheyShouldBe) {
  for (const Platform& platform : oneOfEach()) {
    if (!platform.isFor(PlatformUse::Plate)) {
      EXPECT_THROW(platform.plateAround(kStanding), base::Error) << platform.text();
      continue;
    }
    const auto plate = platform.plateAround(kStanding);
    ASSERT_GE(plate.size(), 3u) << platform.text();
    EXPECT_GT(areaOf(plate), 0.0) << platform.text();
    if (!platform.isOfCell()) {
      EXPECT_NEAR(areaOf(geometry::convexPolygon(plate)), areaOf(plate), 1e-6) << platform.text();
    }
    if (platform.marginMm()) {
      EXPECT_THROW(platform.plateAround({}), base::Error);
      const auto wide = platform.withMarginMm(7.0).plateAround(kStanding);
      EXPECT_GT(areaOf(wide), areaOf(plate));
      EXPECT_EQ(platform.withMarginMm(7.0).marginMm(), 7.0);
    } else if (platform.isOfCell()) {
      EXPECT_EQ(plate, kStanding) << "whichever the cell has";
      EXPECT_THROW(platform.plateAround({}), base::Error);
    } else {
      Eigen::Vector2d low = plate[0], high = plate[0];
      for (const Eigen::Vector2d& p : plate) {
        low = low.cwiseMin(p);
        high = high.cwiseMax(p);
      }
      EXPECT_LT((low + high).norm(), 1e-9) << platform.text() << ": about the origin";
      EXPECT_EQ(platform.plateAround({}).size(), plate.size());
    }
  }
}

TEST(Platform, RodsAreAboutTheOriginAndBodiesHaveAFile) {
  for (const Platform& platform : oneOfEach()) {
    EXPECT_EQ(platform.isBody(), !platform.file().empty()) << platform.text();
    const auto rod = platform.rod(6);
    EXPECT_EQ(rod.has_value(), platform.kind().rod != nullptr);
    if (!rod)
      continue;
    EXPECT_TRUE(platform.isFor(PlatformUse::Rod));
    EXPECT_NO_THROW(platform::checkRod(*rod));
    EXPECT_EQ(rod->sides, 6);
    EXPECT_NEAR(rod->profile.front().x() + rod->profile.back().x(), 0.0, 1e-9);
  }
}

// Every kind is of use to a mode, and every use that a mode has is one of a kind.
TEST(Platform, EveryKindIsTakenByAMode) {
  std::set<std::string_view> taken;
  for (const modes::Mode& mode : modes::modeTable()) {
    const auto kinds = project::platformKindsFor(mode.platforms);
    EXPECT_FALSE(kinds.empty()) << mode.id;
    for (const PlatformKind* kind : kinds)
      taken.insert(kind->word);
  }
  EXPECT_EQ(taken.size(), platformKinds().size());
}

} // namespace
