// SPDX-License-Identifier: GPL-2.0-or-later
#include "nist.h"

#include <fstream>
#include <sstream>
#include <stdexcept>

NistProblem readNist(const std::string &path)
{
  std::ifstream file(path);
  if (!file)
    throw std::runtime_error("cannot read " + path);
  NistProblem problem;
  std::vector<std::vector<double>> table; // start 1, start 2, certified, deviation
  bool inData = false;
  for (std::string line; std::getline(file, line);) {
    std::istringstream words(line);
    std::string first;
    words >> first;
    if (line.rfind("Data:", 0) == 0 && !table.empty()) {
      inData = true;
    } else if (inData) {
      std::istringstream numbers(line);
      double y = 0.0;
      double x = 0.0;
      if (numbers >> y >> x) {
        problem.y.push_back(y);
        problem.x.push_back(x);
      }
    } else if (line.rfind("Residual Sum of Squares:", 0) == 0) {
      problem.sumOfSquares = std::stod(line.substr(line.find(':') + 1));
    } else if (first.size() == 2 && first[0] == 'b' && std::isdigit(first[1])) {
      std::string equals;
      std::vector<double> row(4);
      words >> equals;
      if (equals == "=" && words >> row[0] >> row[1] >> row[2] >> row[3])
        table.push_back(row);
    }
  }
  const auto n = static_cast<Eigen::Index>(table.size());
  problem.starts.assign(2, Eigen::VectorXd(n));
  problem.certified.resize(n);
  problem.deviation.resize(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    problem.starts[0][i] = table[i][0];
    problem.starts[1][i] = table[i][1];
    problem.certified[i] = table[i][2];
    problem.deviation[i] = table[i][3];
  }
  if (n == 0 || problem.x.empty())
    throw std::runtime_error("no NIST problem: " + path);
  return problem;
}
