// SPDX-License-Identifier: GPL-2.0-or-later
#include "base/errors.h"
#include "base/program_files.h"
#include "base/random_number.h"
#include "contact/line/profile.h"
#include "shared/pi.h"

#include <cmath>
#include <complex>
#include <filesystem>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

using namespace wheelrail;
using Vector = Eigen::VectorXd;

namespace {
using mcawr::pi;

FractalSurface standard()
{
  FractalSurface surface;
  surface.rmsSlope = 0.02;
  surface.wavelengthMin = 0.1e-3;
  surface.wavelengthMax = 10e-3;
  surface.seed = 7;
  return surface;
}

/// A file in a folder of its own that goes with the object.
class TextFile {
 public:
  explicit TextFile(const std::string &text)
      : path((std::filesystem::temp_directory_path() / fmt::format("wr-profile-{}.txt", ::getpid()))
                 .string())
  {
    writeOutputFile(path, text);
  }
  ~TextFile() { std::filesystem::remove(path); }
  std::string path;
};

std::string messageOf(const std::string &text)
{
  const TextFile file(text);
  try {
    readProfile(file.path);
  } catch (const Error &error) {
    EXPECT_EQ(error.code(), ExitCode::BadInput);
    return error.what();
  }
  return "";
}

std::string column(int n)
{
  std::string text;
  for (int i = 0; i < n; ++i)
    text += fmt::format("{}\n", std::sin(0.1 * i));
  return text;
}
} // namespace

TEST(FractalProfile, HasTheSlopeAndHeightAskedFor)
{
  FractalSurface surface = standard();
  const double length = 20e-3;
  EXPECT_NEAR(profileStatistics("", fractalProfile(surface, 16384, length)).rmsSlope, 0.02, 2e-5);
  surface.rmsSlope = 0.0;
  surface.rmsHeight = 5e-6;
  EXPECT_NEAR(profileStatistics("", fractalProfile(surface, 4096, length)).rmsHeight, 5e-6, 1e-9);
}

TEST(FractalProfile, SeedAloneDecides)
{
  const FractalSurface surface = standard();
  const Vector coarse = fractalProfile(surface, 2000, 20e-3).height;
  const Vector fine = fractalProfile(surface, 6000, 20e-3).height; // every third centre is shared
  for (int i = 0; i < 2000; ++i)
    EXPECT_NEAR(coarse[i], fine[3 * i + 1], 1e-15);
  FractalSurface other = surface;
  other.seed = 8;
  EXPECT_GT((fractalProfile(other, 2000, 20e-3).height - coarse).norm(), 0.1 * coarse.norm());
}

TEST(FractalProfile, SpectrumFallsWithTheHurstExponent)
{
  const int n = 4096;
  const Vector z = fractalProfile(standard(), n, 20e-3).height;
  const auto amplitude = [&](int wave) {
    std::complex<double> sum = 0.0;
    for (int i = 0; i < n; ++i)
      sum += z[i] * std::polar(1.0, 2.0 * pi * wave * i / n);
    return std::abs(sum);
  };
  EXPECT_NEAR(amplitude(5) / amplitude(40), std::pow(8.0, 0.8 + 0.5), 1e-9);
  EXPECT_LT(amplitude(1), 1e-9 * amplitude(5));   // longer than 10 mm
  EXPECT_LT(amplitude(201), 1e-9 * amplitude(5)); // shorter than 0.1 mm
}

TEST(FractalProfile, RefusesWavesTheCellsCannotCarry)
{
  EXPECT_THROW(fractalProfile(standard(), 512, 20e-3), Error);
  FractalSurface surface = standard();
  surface.wavelengthMin = surface.wavelengthMax = 7e-3; // 20/7 is not a whole number
  EXPECT_THROW(fractalProfile(surface, 512, 20e-3), Error);
}

TEST(UniformNumber, IsUniformAndReproducible)
{
  double sum = 0.0, squares = 0.0;
  const int n = 20000;
  for (int i = 0; i < n; ++i) {
    const double x = uniformNumber(3, static_cast<std::uint64_t>(i));
    ASSERT_GE(x, 0.0);
    ASSERT_LT(x, 1.0);
    sum += x;
    squares += x * x;
  }
  EXPECT_NEAR(sum / n, 0.5, 0.01);
  EXPECT_NEAR(squares / n, 1.0 / 3.0, 0.01);
  EXPECT_EQ(uniformNumber(3, 5), uniformNumber(3, 5));
  EXPECT_NE(uniformNumber(3, 5), uniformNumber(4, 5));
}

TEST(ReadProfile, OneColumnWithSpacing)
{
  const TextFile file("# rail of 1998: measured by hand\n# height: um\n# spacing: 5 um\n" +
                      column(40));
  const Profile profile = readProfile(file.path);
  EXPECT_DOUBLE_EQ(profile.spacing, 5e-6);
  ASSERT_EQ(profile.height.size(), 40);
  EXPECT_NEAR(profile.height[10], std::sin(1.0) * 1e-6, 1e-12);
}

TEST(ReadProfile, TwoColumnsOfUnequalPositions)
{
  std::string text = "# height: um\n# position: mm\n";
  for (int i = 0; i < 50; ++i)
    text += fmt::format("{},{}\n", 0.1 * i + 0.001 * (i % 3), 2.0 * i);
  const TextFile file(text);
  const Profile profile = readProfile(file.path);
  EXPECT_NEAR(profile.spacing, (4.9 + 0.001) / 49 * 1e-3, 1e-12);
  EXPECT_NEAR(profile.height[25], 50e-6, 0.05e-6);
}

TEST(ReadProfile, BadFilesGiveOneClearLine)
{
  const std::string header = "# height: um\n# spacing: 5 um\n";
  EXPECT_NE(messageOf(column(40)).find("height"), std::string::npos);
  EXPECT_NE(messageOf("# height: um\n" + column(40)).find("spacing"), std::string::npos);
  EXPECT_NE(messageOf("# height: K\n" + column(40)).find(":1: height: "), std::string::npos);
  EXPECT_NE(messageOf("# height: um\n# spacing: 5\n" + column(40)).find(":2: "), std::string::npos);
  for (const char *spacing : {"-5 um", "0 m", "1e-300 m", "1e300 m"})
    EXPECT_NE(messageOf(std::string("# height: um\n# spacing: ") + spacing + "\n" + column(40))
                  .find("allowed range [1e-12, 1000] m"),
              std::string::npos)
        << spacing;
  EXPECT_NE(messageOf(header + "1\n2\nthree\n").find(":5: column 1: 'three'"), std::string::npos);
  EXPECT_NE(messageOf(header + "1\nnan\n").find("finite"), std::string::npos);
  EXPECT_NE(messageOf(header + "1\ninf\n").find("finite"), std::string::npos);
  EXPECT_NE(messageOf(header + "1\n2 3\n").find(":4: "), std::string::npos);
  EXPECT_NE(messageOf(header + "1\n2\n3\n").find("at least 16"), std::string::npos);
  EXPECT_NE(messageOf(header).find("0 points"), std::string::npos);
  EXPECT_NE(messageOf("# height: um\n# position: mm\n1 1\n0.5 1\n").find("increase"),
            std::string::npos);
}

TEST(ReadProfile, EmptyCellsAreRefused)
{
  const std::string one = "# height: um\n# spacing: 5 um\n";
  const std::string two = "# height: um\n# position: mm\n";
  EXPECT_NE(messageOf(one + ",\n" + column(40)).find(":3: column 1: ',' is not"),
            std::string::npos);
  EXPECT_NE(messageOf(one + ";;;\n" + column(40)).find(":3: column 1: is empty"),
            std::string::npos);
  EXPECT_NE(messageOf(one + "1,\n" + column(40)).find(":3: column 1: '1,' is not"),
            std::string::npos);
  EXPECT_NE(messageOf(two + "0, ,1\n").find(":3: column 2: is empty"), std::string::npos);
  EXPECT_NE(messageOf(two + " , 1\n").find(":3: column 1: is empty"), std::string::npos);
}

TEST(ReadProfile, SeparatorsMayHaveBlanks)
{
  for (const char *between : {",", ", ", " , ", ";", "\t", "   "}) {
    std::string text = "# height: um\n# position: mm\n";
    for (int i = 0; i < 20; ++i)
      text += fmt::format("{}{}{}\n", 0.01 * i, between, i % 3);
    EXPECT_EQ(messageOf(text), "") << between;
  }
}

// What Excel writes in half of Europe, and what other machines write: the same profile.
TEST(ReadProfile, FilesOfOtherMachines)
{
  std::string one = "# height: \xc2\xb5m\n# spacing: 5 um\n";
  std::string two = "# height: um\n# position: mm\n";
  for (int i = 0; i < 20; ++i) {
    one += fmt::format("{:.1f}\n", 0.5 * (i % 3));
    two += fmt::format("{:.3f};{:.1f}\n", 0.005 * i, 0.5 * (i % 3));
  }
  const auto heights = [](const std::string &text) {
    const TextFile file(text);
    return readProfile(file.path).height;
  };
  const auto changed = [](std::string text, const std::string &from, const std::string &to) {
    for (auto at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
      text.replace(at, from.size(), to);
    return text;
  };
  const Vector expected = heights(one);
  ASSERT_EQ(expected[1], 0.5e-6);
  EXPECT_EQ(heights(changed(one, "\n", "\r\n")), expected);
  EXPECT_EQ(heights(changed(one, "\n", "\r")), expected);
  EXPECT_EQ(heights("\xef\xbb\xbf" + one), expected);
  EXPECT_EQ(heights(changed(one, "\xc2\xb5", "\xb5")), expected); // Latin-1
  EXPECT_EQ(heights(changed(one, ".", ",")), expected);
  EXPECT_LT((heights(two) - expected).norm(), 1e-15);
  EXPECT_EQ(heights(changed(two, ".", ",")), heights(two));
  EXPECT_EQ(heights(changed(changed(two, ".", ","), ";", "\t")), heights(two));
  EXPECT_NE(messageOf(changed(changed(two, ".", ","), ";", ", ")).find("decimal comma"),
            std::string::npos);
}

TEST(ReadProfile, TheHeadIsGivenOnce)
{
  const std::string head = "# height: um\n# spacing: 5 um\n";
  EXPECT_NE(messageOf(head + "# height: mm\n" + column(40)).find(":3: height: is given once"),
            std::string::npos);
  EXPECT_NE(messageOf(head + column(20) + "# height: mm\n" + column(20)).find("is given once"),
            std::string::npos);
  EXPECT_EQ(messageOf(head + column(20) + "# pause: none of ours\n" + column(20)), "");
}

TEST(ReadProfile, NumbersBeyondAnySurfaceAreRefused)
{
  const std::string head = "# height: m\n# position: m\n";
  EXPECT_NE(messageOf(head + "0 1e308\n").find(":3: height: 1e+308 is not allowed"),
            std::string::npos);
  EXPECT_NE(messageOf(head + "-1e308 0\n1e308 0\n").find(":3: position: "), std::string::npos);
  EXPECT_NE(messageOf(head + "0 0\n1e-308 0\n").find("does not increase by 1e-12 m"),
            std::string::npos);
}

TEST(PrepareProfile, DetrendTakesOffThePolynomial)
{
  Profile profile{1e-5, Vector(500)};
  for (int i = 0; i < 500; ++i)
    profile.height[i] = 3.0 - 0.2 * i + 1e-3 * i * i;
  EXPECT_LT(detrended(profile, 2).height.cwiseAbs().maxCoeff(), 1e-9);
  EXPECT_NEAR(detrended(profile, 0).height.mean(), 0.0, 1e-9);
  EXPECT_GT(detrended(profile, 1).height.cwiseAbs().maxCoeff(), 1.0);
  EXPECT_EQ(detrended(profile, -1).height, profile.height);
}

TEST(PrepareProfile, FilterHalvesTheWaveAtTheCutoff)
{
  for (const auto &[wavelength, left] : {std::pair{1e-3, 0.5}, {4e-3, 0.9576}, {0.5e-3, 0.0625}}) {
    Profile profile{1e-5, Vector(4000)};
    for (int i = 0; i < 4000; ++i)
      profile.height[i] = std::cos(2.0 * pi * i * profile.spacing / wavelength);
    const Vector smooth = lowPassed(profile, 1e-3, "").height.segment(1000, 2000);
    EXPECT_NEAR(smooth.maxCoeff(), left, 2e-3);
  }
  const Profile profile{1e-5, Vector::Zero(100)};
  EXPECT_THROW(lowPassed(profile, 1e-5, ""), Error);
  EXPECT_THROW(lowPassed(profile, 1.0, ""), Error);
}

TEST(PrepareProfile, ResamplingKeepsTheMeanOfEachCell)
{
  Profile line{1e-5, Vector::LinSpaced(1001, 0.0, 1.0)};
  const Profile cells = resampled(line, 100, 5e-5, ""); // the middle half
  for (int i = 0; i < 100; ++i)
    EXPECT_NEAR(cells.height[i], 0.25 + 0.5 * (i + 0.5) / 100, 1e-12);
  EXPECT_NEAR(resampled(line, 37, 1e-2 / 37, "").height.mean(), 0.5, 1e-12);
  EXPECT_THROW(resampled(line, 101, 1e-4, ""), Error);
}

TEST(PrepareProfile, StatisticsOfAWave)
{
  Profile wave{1e-5, Vector(1000)};
  for (int i = 0; i < 1000; ++i)
    wave.height[i] = 1e-6 * std::sin(2.0 * pi * i / 100);
  const ProfileStatistics s = profileStatistics("wave", wave);
  EXPECT_NEAR(s.rmsHeight, 1e-6 / std::sqrt(2.0), 1e-10);
  EXPECT_NEAR(s.meanWavelength, 1e-3, 1e-6);
  EXPECT_NEAR(s.shortestWavelength, 2e-5, 1e-12);
  EXPECT_NEAR(s.longestWavelength, 1e-2, 1e-12);
}
