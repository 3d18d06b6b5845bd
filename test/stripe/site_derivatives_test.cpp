#include "stripe/site_derivatives.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "stripe/site_normals.h"
#include "support/render_stripe.h"

namespace weld_profiler
{
namespace
{
using test_support::Picture;

Picture noise(int width, int height, int bit_depth)
{
  Picture picture = test_support::blank(width, height, 0.0, bit_depth);
  std::mt19937 random(7);
  std::uniform_int_distribution<int> level(0, bit_depth == 8 ? 255 : 65535);
  for (int v = 0; v < height; ++v)
    for (int u = 0; u < width; ++u)
      picture.set(u, v, level(random));
  return picture;
}

/// Every column that fits, but for holes; rows along a slope, jumping about by up to `jump`.
Sites sitesIn(const Picture& picture, int reach, double slope, int jump)
{
  Sites sites;
  std::mt19937 random(3);
  std::uniform_int_distribution<int> off(-jump, jump);
  for (int u = reach; u < picture.width - reach; ++u)
  {
    const int v = static_cast<int>(0.5 * picture.height + slope * (u - 0.5 * picture.width)) + off(random);
    const bool hole = u % 50 > 46 || (u > 200 && u < 290);
    if (v >= reach && v < picture.height - reach && !hole)
      sites.push_back(Site{ sites.size(), u, v });
  }
  return sites;
}

struct Case
{
  int width, height, bit_depth;
  double slope;
  int jump;
};

const Case kCases[] = { { 400, 80, 8, 0.0, 0 },   { 400, 120, 8, 0.1, 1 },  { 300, 400, 8, 1.5, 2 },
                        { 300, 500, 16, 9.0, 0 }, { 200, 160, 8, 0.0, 60 }, { 21, 41, 8, 0.3, 1 },
                        { 100, 60, 16, 0.2, 5 } };

TEST(SiteDerivatives, AreThoseOfThePixelsOneByOne)
{
  for (const double sigma : { 1.0, 2.25, 5.0 })
    for (const Case& c : kCases)
    {
      const Picture picture = noise(c.width, c.height, c.bit_depth);
      DerivativeKernel kernel;
      kernel.setGaussian(sigma);
      const Sites sites = sitesIn(picture, kernel.reach(), c.slope, c.jump);
      if (c.width > 2 * kernel.reach() + 1 && c.height > 2 * kernel.reach() + 2 * c.jump + 20)
      {
        ASSERT_GT(sites.size(), 1U) << c.width << 'x' << c.height << ", sigma " << sigma;
      }
      SiteDerivatives found;
      found.measure(picture.view(), kernel, sites);
      const double tolerance = 1e-6 * (c.bit_depth == 8 ? 255.0 : 65535.0);
      for (std::size_t i = 0; i < sites.size(); ++i)
      {
        const Derivatives expected = kernel.at(picture.view(), sites[i].u, sites[i].v);
        ASSERT_NEAR(found.x[i], expected.x, tolerance) << sites[i].u << ' ' << sites[i].v;
        ASSERT_NEAR(found.y[i], expected.y, tolerance) << sites[i].u << ' ' << sites[i].v;
        ASSERT_NEAR(found.xx[i], expected.xx, tolerance) << sites[i].u << ' ' << sites[i].v;
        ASSERT_NEAR(found.xy[i], expected.xy, tolerance) << sites[i].u << ' ' << sites[i].v;
        ASSERT_NEAR(found.yy[i], expected.yy, tolerance) << sites[i].u << ' ' << sites[i].v;
      }
    }
}

TEST(SiteDerivatives, OfASiteDoNotDependOnTheOthers)
{
  const Picture picture = noise(400, 120, 8);
  DerivativeKernel kernel;
  kernel.setGaussian(2.25);
  const Sites all = sitesIn(picture, kernel.reach(), 0.1, 2);
  Sites some;
  for (std::size_t i = 1; i < all.size(); i += 3)
    some.push_back(all[i]);
  ASSERT_GT(some.size(), 50U);
  SiteDerivatives of_all;
  SiteDerivatives of_some;
  of_all.measure(picture.view(), kernel, all);
  of_some.measure(picture.view(), kernel, some);
  for (std::size_t i = 0; i < some.size(); ++i)
  {
    // to the bit: how a stripe is cut into tiles changes nothing
    ASSERT_EQ(of_some.y[i], of_all.y[3 * i + 1]);
    ASSERT_EQ(of_some.xy[i], of_all.xy[3 * i + 1]);
  }
}

TEST(SiteDerivatives, OfNoSitesAreNone)
{
  const Picture picture = noise(40, 40, 8);
  DerivativeKernel kernel;
  kernel.setGaussian(2.0);
  SiteDerivatives found;
  found.measure(picture.view(), kernel, {});
  EXPECT_TRUE(found.x.empty());
}

void expectSame(const TemplateNormal& expected, float u, float v)
{
  EXPECT_NEAR(u, expected.u, 1e-5);
  EXPECT_NEAR(v, expected.v, 1e-5);
}

TEST(SiteNormals, AreThoseOfTheTemplatesOneByOne)
{
  int compared = 0;
  for (const Case& c : kCases)
  {
    const Picture picture = noise(c.width, c.height, c.bit_depth);
    Levels levels;
    levels.saturation = c.bit_depth == 8 ? 255.0 : 65535.0;
    levels.count = levels.saturation / 255.0;
    const Sites sites = sitesIn(picture, kTemplateReach, c.slope, c.jump);
    SiteNormals svd;
    SiteNormals pca;
    svd.measureSvd(picture.view(), levels, sites);
    pca.measurePca(picture.view(), levels, sites);
    for (std::size_t i = 0; i < sites.size(); ++i, ++compared)
    {
      const Block block{ sites[i].u, sites[i].v };
      expectSame(svdNormal(picture.view(), levels, block), svd.u[i], svd.v[i]);
      expectSame(pcaNormal(picture.view(), levels, block), pca.u[i], pca.v[i]);
    }
  }
  EXPECT_GT(compared, 800);
}

TEST(SiteNormals, AreUndefinedInAFlatTemplate)
{
  const Picture picture = test_support::blank(20, 20, 90.0);
  const Sites sites = { Site{ 0, 8, 10 }, Site{ 1, 9, 10 } };
  SiteNormals normals;
  normals.measureSvd(picture.view(), Levels{}, sites);
  for (std::size_t i = 0; i < sites.size(); ++i)
    EXPECT_EQ(std::hypot(normals.u[i], normals.v[i]), 0.0F);
  normals.measurePca(picture.view(), Levels{}, sites);
  for (std::size_t i = 0; i < sites.size(); ++i)
    EXPECT_EQ(std::hypot(normals.u[i], normals.v[i]), 0.0F);
}

TEST(BandTiles, MeanEverySiteOnce)
{
  const Picture picture = noise(500, 600, 8);
  for (const double slope : { 0.0, 0.4, 1.5 })
  {
    const Sites sites = sitesIn(picture, 9, slope, 3);
    ASSERT_GT(sites.size(), 50U);
    std::vector<int> meant(sites.size(), 0);
    BandTiles tiles;
    tiles.reset(picture.view(), sites, 9);
    while (tiles.next())
      for (const RowRun& run : tiles.runs())
      {
        EXPECT_LT(sites[run.last].u - sites[run.first].u, kMostRunColumns);
        for (std::size_t i = run.first; i <= run.last; ++i)
        {
          if (sites[i].v != run.row)
            continue;
          ++meant[i];
          EXPECT_EQ(*tiles.at(sites[i].u, run.row), picture.at(sites[i].u, run.row));
          EXPECT_EQ(*tiles.at(sites[i].u + 9, run.row - 9), picture.at(sites[i].u + 9, run.row - 9));
        }
      }
    for (const int times : meant)
      EXPECT_EQ(times, 1);
  }
}
}  // namespace
}  // namespace weld_profiler
