#include "laws/packing.h"

#include <gtest/gtest.h>

using mca::HexagonalPacking;

TEST(Packing, CellTilesThePlane)
{
  // a block of n x m automata takes n d by m d sqrt(3)/2
  const HexagonalPacking cell{2.5, 3.0};
  const double block = 7 * 2.5 * 6 * 2.5 * std::sqrt(0.75) * 3.0;
  EXPECT_NEAR(7 * 6 * cell.cellVolume(), block, 1e-12 * block);
}

TEST(Packing, StressWeightIsQSOverV)
{
  const HexagonalPacking cell{0.7, 1.9};
  EXPECT_NEAR(0.5 * 0.7 * cell.contactArea() / cell.cellVolume(), HexagonalPacking::stressWeight(),
              1e-15);
}

TEST(Packing, SixContactAreasMakeTheCellsSurface)
{
  const HexagonalPacking cell{2.0, 1.0}; // a hexagon of width d has the side d/sqrt(3)
  EXPECT_NEAR(cell.contactArea(), 2.0 / std::sqrt(3.0), 1e-15);
  EXPECT_NEAR(HexagonalPacking::coordination * 0.5 * 0.5 * 2.0 * cell.contactArea(),
              cell.cellVolume(), 1e-14);
}

TEST(Packing, MassHasTheDensityOfTheSolid)
{
  const double pi = std::acos(-1.0);
  const HexagonalPacking cell{2.5, 1.0};
  EXPECT_NEAR(cell.mass(0.0078) / (0.0078 * pi / 4 * 2.5 * 2.5), 2 * std::sqrt(3.0) / pi, 1e-14);
  EXPECT_NEAR(cell.inertia(0.0078), cell.mass(0.0078) * 2.5 * 2.5 / 8, 1e-17);
}

TEST(Packing, EverythingIsProportionalToTheThickness)
{
  const HexagonalPacking thin{2.5, 1.0}, thick{2.5, 4.0};
  EXPECT_DOUBLE_EQ(thick.cellVolume(), 4 * thin.cellVolume());
  EXPECT_DOUBLE_EQ(thick.contactArea(), 4 * thin.contactArea());
  EXPECT_DOUBLE_EQ(thick.inertia(1.0), 4 * thin.inertia(1.0));
}
