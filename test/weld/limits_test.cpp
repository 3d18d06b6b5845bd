#include "weld_profiler/weld/limits.h"

#include <cmath>

#include <gtest/gtest.h>

#include "weld/sections.h"

using namespace weld_profiler;

namespace
{
const double kNanometre = 1e-9;  // limits are formulas: they are exact

/// Of the shipped table [mm]; NaN where the table has none.
double limitMm(Imperfection imperfection, QualityLevel level, double t_mm, double b_mm = 12.0)
{
  const Limits limits = Limits::shipped();
  const WeldKind kind = imperfection == Imperfection::Convexity ? WeldKind::Fillet : WeldKind::Butt;
  const double t = t_mm * kMillimetre;
  const LimitEntry* entry = limits.find(imperfection, kind, t, t);
  if (entry == nullptr)
    return std::nan("");
  return evaluate(entry->at(level), { { b_mm * kMillimetre, 0.0 }, {}, t, t }).value / kMillimetre;
}

struct Case
{
  double dimension_mm;
  double b, c, d;  // [mm]
};
}  // namespace

TEST(Limits, OfExcessWeldMetalFollowTheWidth)
{
  // 1 mm + 0.10, 0.15, 0.25 b; caps of 5, 7, 10 mm bind from 40, 40, 36 mm
  for (const Case& c : { Case{ 12.0, 2.2, 2.8, 4.0 }, Case{ 50.0, 5.0, 7.0, 10.0 }, Case{ 36.0, 4.6, 6.4, 10.0 },
                         Case{ 35.9, 4.59, 6.385, 9.975 }, Case{ 40.0, 5.0, 7.0, 10.0 }, Case{ 4.0, 1.4, 1.6, 2.0 } })
  {
    EXPECT_NEAR(limitMm(Imperfection::ExcessWeldMetal, QualityLevel::B, 5.0, c.dimension_mm), c.b, kNanometre);
    EXPECT_NEAR(limitMm(Imperfection::ExcessWeldMetal, QualityLevel::C, 5.0, c.dimension_mm), c.c, kNanometre);
    EXPECT_NEAR(limitMm(Imperfection::ExcessWeldMetal, QualityLevel::D, 5.0, c.dimension_mm), c.d, kNanometre);
  }
}

TEST(Limits, OfConvexityHaveLowerCaps)
{
  for (const Case& c : { Case{ 12.0, 2.2, 2.8, 4.0 }, Case{ 50.0, 3.0, 4.0, 5.0 } })
  {
    EXPECT_NEAR(limitMm(Imperfection::Convexity, QualityLevel::B, 5.0, c.dimension_mm), c.b, kNanometre);
    EXPECT_NEAR(limitMm(Imperfection::Convexity, QualityLevel::C, 5.0, c.dimension_mm), c.c, kNanometre);
    EXPECT_NEAR(limitMm(Imperfection::Convexity, QualityLevel::D, 5.0, c.dimension_mm), c.d, kNanometre);
  }
}

TEST(Limits, OfUndercutInThickPlatesFollowTheThickness)
{
  for (const Case& c : { Case{ 4.0, 0.2, 0.4, 0.8 }, Case{ 3.1, 0.155, 0.31, 0.62 }, Case{ 5.0, 0.25, 0.5, 1.0 },
                         Case{ 12.0, 0.5, 0.5, 1.0 } })
  {
    EXPECT_NEAR(limitMm(Imperfection::Undercut, QualityLevel::B, c.dimension_mm), c.b, kNanometre);
    EXPECT_NEAR(limitMm(Imperfection::Undercut, QualityLevel::C, c.dimension_mm), c.c, kNanometre);
    EXPECT_NEAR(limitMm(Imperfection::Undercut, QualityLevel::D, c.dimension_mm), c.d, kNanometre);
  }
}

TEST(Limits, OfUndercutInThinPlatesAllowShortOnesOnly)
{
  const Limits limits = Limits::shipped();
  for (const double t : { 0.5e-3, 1e-3, 3e-3 })
  {
    const LimitEntry* entry = limits.find(Imperfection::Undercut, WeldKind::Butt, t, t);
    ASSERT_NE(entry, nullptr) << t;
    EXPECT_EQ(entry->at(QualityLevel::B).rule, LevelLimit::Rule::NotPermitted);
    EXPECT_EQ(entry->at(QualityLevel::C).rule, LevelLimit::Rule::Short);
    EXPECT_EQ(entry->at(QualityLevel::D).rule, LevelLimit::Rule::Short);
    EXPECT_NEAR(limitMm(Imperfection::Undercut, QualityLevel::C, t / kMillimetre), 0.1 * t / kMillimetre, kNanometre);
    EXPECT_NEAR(limitMm(Imperfection::Undercut, QualityLevel::D, t / kMillimetre), 0.2 * t / kMillimetre, kNanometre);
  }
}

TEST(Limits, OfMisalignmentPoresAndFillAreThoseOfTheTable)
{
  EXPECT_NEAR(limitMm(Imperfection::Misalignment, QualityLevel::B, 8.0), 0.8, kNanometre);
  EXPECT_NEAR(limitMm(Imperfection::Misalignment, QualityLevel::C, 8.0), 1.2, kNanometre);
  EXPECT_NEAR(limitMm(Imperfection::Misalignment, QualityLevel::D, 8.0), 2.0, kNanometre);
  EXPECT_NEAR(limitMm(Imperfection::Misalignment, QualityLevel::D, 40.0), 5.0, kNanometre);
  EXPECT_NEAR(limitMm(Imperfection::Misalignment, QualityLevel::B, 2.0), 0.4, kNanometre);
  EXPECT_NEAR(limitMm(Imperfection::Misalignment, QualityLevel::D, 2.0), 0.7, kNanometre);
  EXPECT_NEAR(limitMm(Imperfection::SurfacePore, QualityLevel::C, 5.0), 1.0, kNanometre);
  EXPECT_NEAR(limitMm(Imperfection::SurfacePore, QualityLevel::D, 5.0), 1.5, kNanometre);
  EXPECT_NEAR(limitMm(Imperfection::SurfacePore, QualityLevel::D, 20.0), 3.0, kNanometre);
  EXPECT_NEAR(limitMm(Imperfection::IncompleteFill, QualityLevel::D, 4.0), 1.0, kNanometre);
  EXPECT_NEAR(limitMm(Imperfection::IncompleteFill, QualityLevel::B, 20.0), 0.5, kNanometre);
}

TEST(Limits, AreNotThereOutsideTheirThickness)
{
  EXPECT_TRUE(std::isnan(limitMm(Imperfection::IncompleteFill, QualityLevel::D, 3.0))) << "thicker than 3 mm only";
  EXPECT_TRUE(std::isnan(limitMm(Imperfection::SurfacePore, QualityLevel::D, 3.0)));
  EXPECT_TRUE(std::isnan(limitMm(Imperfection::ExcessWeldMetal, QualityLevel::D, 0.4))) << "below the standard's scope";
  EXPECT_FALSE(std::isnan(limitMm(Imperfection::ExcessWeldMetal, QualityLevel::D, 0.5)));
  EXPECT_FALSE(std::isnan(limitMm(Imperfection::Undercut, QualityLevel::D, 0.5)));
  EXPECT_TRUE(std::isnan(limitMm(Imperfection::Undercut, QualityLevel::D, 0.49)));
}

TEST(Limits, WithoutAThicknessAreThoseThatNameNone)
{
  const Limits limits = Limits::shipped();
  EXPECT_NE(limits.find(Imperfection::ExcessWeldMetal, WeldKind::Butt, {}, {}), nullptr);
  EXPECT_NE(limits.find(Imperfection::ToeAngle, WeldKind::Fillet, {}, {}), nullptr);
  EXPECT_EQ(limits.find(Imperfection::Undercut, WeldKind::Butt, {}, {}), nullptr);
  EXPECT_EQ(limits.find(Imperfection::Misalignment, WeldKind::Butt, {}, {}), nullptr);
}

TEST(Limits, AreThereForTheirKindOfWeldOnly)
{
  const Limits limits = Limits::shipped();
  const double t = 5e-3;
  EXPECT_EQ(limits.find(Imperfection::ExcessWeldMetal, WeldKind::Fillet, t, t), nullptr);
  EXPECT_EQ(limits.find(Imperfection::Convexity, WeldKind::Butt, t, t), nullptr);
  EXPECT_EQ(limits.find(Imperfection::Misalignment, WeldKind::Fillet, t, t), nullptr);
  for (const Imperfection imperfection : imperfections())
    EXPECT_EQ(limits.find(imperfection, WeldKind::None, t, t), nullptr) << name(imperfection);
}

TEST(Limits, CarryTheSigmaOfTheWidthUpToTheirCap)
{
  const LevelLimit limit =
      Limits::shipped().find(Imperfection::ExcessWeldMetal, WeldKind::Butt, {}, {})->at(QualityLevel::D);
  const auto sigma = [&limit](double b) { return evaluate(limit, { { b, 1e-4 }, {}, {}, {} }).sigma; };
  EXPECT_NEAR(sigma(12e-3), 0.25 * 1e-4, 1e-12);
  EXPECT_NEAR(sigma(36.1e-3), 0.25 * 1e-4, 1e-12) << "1 sigma beyond the cap the width may lie below it";
  EXPECT_EQ(sigma(36.3e-3), 0.0);
}

TEST(Limits, AreNotKnownWhereTheWidthIsNot)
{
  const LevelLimit limit =
      Limits::shipped().find(Imperfection::ExcessWeldMetal, WeldKind::Butt, {}, {})->at(QualityLevel::D);
  EXPECT_FALSE(evaluate(limit, { {}, {}, 5e-3, 5e-3 }).measured());
}

TEST(Limits, SayWhichOfThemWereRead)
{
  // read: 502, 503, 5011, 2017; from memory: 505, 507, 511, the short rule; a bead on a plate by analogy
  const Limits limits = Limits::shipped();
  ASSERT_EQ(limits.entries().size(), 13u);
  for (const LimitEntry& entry : limits.entries())
  {
    const int number = isoNumber(entry.imperfection);
    const bool read = number == 502 || number == 503 || number == 5011 || number == 2017;
    EXPECT_EQ(entry.verified, read && entry.kinds.front() != WeldKind::BeadOnPlate) << number;
    EXPECT_FALSE(entry.edition.empty()) << number;
  }
  EXPECT_FALSE(limits.shortRule().verified);
  EXPECT_DOUBLE_EQ(limits.shortRule().length, 0.025);
  EXPECT_DOUBLE_EQ(limits.shortRule().per, 0.1);
  EXPECT_DOUBLE_EQ(limits.shortRule().share, 0.25);
}

TEST(WeldKind, HasTheNamesOfParametersAndFiles)
{
  EXPECT_STREQ(name(WeldKind::None), "none");
  EXPECT_STREQ(name(WeldKind::Butt), "butt");
  EXPECT_STREQ(name(WeldKind::Fillet), "fillet");
  EXPECT_STREQ(name(WeldKind::BeadOnPlate), "bead_on_plate");
}
