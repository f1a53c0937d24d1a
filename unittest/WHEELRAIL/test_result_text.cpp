// SPDX-License-Identifier: GPL-2.0-or-later
#include "base/errors.h"
#include "base/result_text.h"

#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

using namespace wheelrail;

namespace {

std::string problemOf(const std::function<void()> &action)
{
  try {
    action();
  } catch (const Error &error) {
    EXPECT_EQ(error.code(), ExitCode::NotConverged);
    return error.what();
  }
  return "";
}

} // namespace

TEST(ResultText, JsonHoldsNoNan)
{
  const nlohmann::ordered_json good = {{"a", 1.5}, {"none", nullptr}, {"list", {1, 2.5}}};
  EXPECT_EQ(jsonText("x.json", good, -1), "{\"a\":1.5,\"none\":null,\"list\":[1,2.5]}\n");
  for (double value : {double(NAN), double(INFINITY), -double(INFINITY)}) {
    nlohmann::ordered_json bad = good;
    bad["list"][1] = value;
    EXPECT_NE(problemOf([&] { jsonText("x.json", bad); }).find("x.json: /list/1 is "),
              std::string::npos);
    EXPECT_FALSE(isFinite(bad));
  }
  EXPECT_TRUE(isFinite(good));
}

TEST(ResultText, JsonTakesAnyBytes)
{
  EXPECT_EQ(jsonText("x", {{"file", "K\xf6ln"}}, -1), "{\"file\":\"K\xef\xbf\xbdln\"}\n");
}

TEST(ResultText, TablesHoldNoNan)
{
  const std::string head = "# comment, nan\nspeed,nan,state\n";
  EXPECT_EQ(finiteTable("x.csv", head + "1,2,slip\n"), head + "1,2,slip\n");
  EXPECT_EQ(problemOf([&] { finiteTable("x.csv", head + "1,2,slip\n1,-nan,x\n"); }).substr(0, 26),
            "x.csv: nan of row 2 is -na");
  EXPECT_NE(problemOf([&] { finiteTable("x.csv", head + "inf,2,slip\n"); }).find("speed of row 1"),
            std::string::npos);
}
