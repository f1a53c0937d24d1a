// SPDX-License-Identifier: GPL-2.0-or-later
#include "base/errors.h"
#include "law/friction_table.h"

#include <fstream>
#include <gtest/gtest.h>

using namespace wheelrail;

namespace {

const std::string head = "# pressure: MPa\n# speed: km/h\n";
const std::string good = head + "# measured by nobody\nspeed, mu, pressure\n"
                                "0, 0.5, 100\n36, 0.4, 100\n0, 0.3, 300\n36, 0.1, 300\n";

std::string write(const std::string &content)
{
  const auto *test = testing::UnitTest::GetInstance()->current_test_info();
  const std::string path = testing::TempDir() + "table_" + test->name() + ".csv";
  std::ofstream(path) << content;
  return path;
}

std::string problemOf(const std::string &content)
{
  try {
    readFrictionTable(write(content));
  } catch (const Error &error) {
    EXPECT_EQ(error.code(), ExitCode::BadInput);
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
    return error.what();
  }
  return "";
}

void expectContains(const std::string &text, const std::string &part)
{
  EXPECT_NE(text.find(part), std::string::npos) << "'" << text << "' lacks '" << part << "'";
}

} // namespace

TEST(FrictionTable, IsBilinearAndConstantBeyondItsBorder)
{
  const FrictionTable table = readFrictionTable(write(good));
  EXPECT_EQ(table.pressure, (std::vector<double>{1e8, 3e8}));
  EXPECT_EQ(table.speed.front(), 0.0);
  EXPECT_NEAR(table.speed.back(), 10.0, 1e-12);
  EXPECT_DOUBLE_EQ(table(1e8, 0.0), 0.5);
  EXPECT_NEAR(table(3e8, 10.0), 0.1, 1e-15);
  EXPECT_NEAR(table(2e8, 5.0), (0.5 + 0.4 + 0.3 + 0.1) / 4.0, 1e-12);
  EXPECT_NEAR(table(1.5e8, 2.0), 0.75 * (0.5 - 0.1 * 0.2) + 0.25 * (0.3 - 0.2 * 0.2), 1e-12);
  EXPECT_DOUBLE_EQ(table(0.0, 0.0), 0.5);
  EXPECT_NEAR(table(9e9, 99.0), 0.1, 1e-15);
  EXPECT_NEAR(table(0.0, 99.0), 0.4, 1e-15);
  // one pressure: mu of the speed alone
  const FrictionTable row =
      readFrictionTable(write(head + "pressure,speed,mu\n5,0,0.3\n5,36,0.2\n"));
  EXPECT_NEAR(row(1e12, 5.0), 0.25, 1e-12);
}

// The strict reader of rows, and the text of other machines, serve tables too.
TEST(FrictionTable, OfOtherMachines)
{
  const auto changed = [](std::string text, const std::string &from, const std::string &to) {
    for (auto at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
      text.replace(at, from.size(), to);
    return text;
  };
  const std::string european = changed(changed(good, ", ", ";"), "0.", "0,");
  for (const std::string &text :
       {european, changed(european, ";", "\t"), changed(good, "\n", "\r\n"),
        changed(good, "\n", "\r"), "\xef\xbb\xbf" + good, changed(good, "nobody", "M\xfcller")}) {
    const FrictionTable table = readFrictionTable(write(text));
    EXPECT_EQ(table.mu(1, 1), 0.1) << text;
    EXPECT_EQ(table.mu(0, 1), 0.4) << text;
  }
  expectContains(problemOf(changed(good, "0.5", "0,5")), ":5: 4 cells; 3 are expected (a decimal");
  expectContains(problemOf(changed(good, "0, 0.5, 100", "0, , 100")), ":5: column 2: is empty");
}

TEST(FrictionTable, BadContentIsOneClearLine)
{
  expectContains(problemOf(""), "empty");
  expectContains(problemOf(head + "pressure,speed,mu\n"), "holds no row of numbers");
  expectContains(problemOf("pressure,speed,mu\n1,2,0.3\n"), ":1: pressure: no line '# pressure: ");
  expectContains(problemOf("# pressure: m/s\n" + good), ":1: pressure: ");
  expectContains(problemOf(head + head + good), "is given once");
  expectContains(problemOf(head + "pressure,velocity,mu\n"), "unknown column 'velocity'; known: ");
  expectContains(problemOf(head + "pressure,speed\n"), "the column 'mu' is needed");
  expectContains(problemOf(head + "pressure,speed,mu,mu\n"), "the column 'mu' is needed, once");
  const std::string names = head + "pressure,speed,mu\n";
  expectContains(problemOf(names + "1,2\n"), ":4: 2 cells; 3 are expected");
  expectContains(problemOf(names + "1,2,x\n"), ":4: mu: 'x' is not a number");
  expectContains(problemOf(names + "1,2,0\n"),
                 "mu: '0' is not allowed, must be > 0 and at most 10");
  expectContains(problemOf(names + "-1,2,0.3\n"), "pressure: '-1' is not allowed");
  expectContains(problemOf(names + "1,2,nan\n"), ":4: mu: ");
  expectContains(problemOf(names + "1,2,0.3\n1,2,0.4\n"),
                 ":5: this pressure and speed stand twice");
  expectContains(problemOf(names + "1,2,0.3\n3,4,0.4\n"),
                 "has no mu at a pressure of 1 MPa and a speed of 4 km/h");
}
