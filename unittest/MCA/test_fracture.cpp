#include "laws/fracture.h"

#include <gtest/gtest.h>

using namespace mca;

TEST(Fracture, StrainIntensityOfPureOpening)
{
  EXPECT_DOUBLE_EQ(strainIntensity2(0.04, 0.0), 0.04 * 0.04);
  EXPECT_EQ(strainIntensity2(-0.04, 0.0), 0.0); // compression does not break
  EXPECT_EQ(strainIntensity2(0.0, 0.0), 0.0);
}

TEST(Fracture, StrainIntensityOfShearHasNoSign)
{
  EXPECT_DOUBLE_EQ(strainIntensity2(0.0, 0.03), 4.0 / 3 * 0.03 * 0.03);
  EXPECT_EQ(strainIntensity2(0.0, -0.03), strainIntensity2(-0.01, 0.03));
  EXPECT_DOUBLE_EQ(strainIntensity2(0.02, 0.03), 0.02 * 0.02 + 4.0 / 3 * 0.03 * 0.03);
}

TEST(Fracture, LinkIntensity)
{
  EXPECT_DOUBLE_EQ(linkIntensity2(92, 0), 92.0 * 92.0);
  EXPECT_EQ(linkIntensity2(-92, 0), 0.0);
  EXPECT_DOUBLE_EQ(linkIntensity2(30, -40), 30.0 * 30.0 + 3 * 40.0 * 40.0);
  EXPECT_DOUBLE_EQ(linkIntensity2(-30, 40), 3 * 40.0 * 40.0);
}
