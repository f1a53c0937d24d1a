// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_LAW_LAW_FILE_H
#define WHEELRAIL_LAW_LAW_FILE_H

#include "law/law_use.h"

#include <Eigen/Core>

#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

namespace wheelrail {

/// A law file being read: a JSON object whose keys a law names, with the text it came from, for
/// line numbers. Whatever is wrong is an Error (BadInput) that names file, line and key: what is
/// missing, of the wrong type, out of range (all numbers within +-1e100), unknown, given twice or
/// nested too deep, and a checksum (law_checksum.h) that does not fit the file.
class LawFile {
 public:
  /// \param keys those that the file may have; "checksum" is one of them
  LawFile(std::string path, const std::vector<std::string> &keys);

  /// A line for the user where the file has no checksum; else empty.
  std::string note() const;

  bool has(const std::string &key) const { return json_.contains(key); }
  double number(const std::string &key) const;
  double positive(const std::string &key) const;
  double nonNegative(const std::string &key) const;
  /// \return 0 to the largest int
  int count(const std::string &key) const;
  std::string string(const std::string &key) const;
  /// A list of numbers, however many.
  std::vector<double> numbers(const std::string &key) const;
  /// A list of such lists.
  std::vector<std::vector<double>> lists(const std::string &key) const;
  /// Two numbers >= 0, the second one not below the first.
  Range range(const std::string &key) const;
  /// Ranges by name. \param names those that there may be
  std::map<std::string, Range> ranges(const std::string &key,
                                      const std::vector<std::string> &names) const;
  /// A symmetric, positive semi-definite matrix; nothing where the file has null or no such key.
  /// \param parameters names of its rows, for messages
  std::optional<Eigen::MatrixXd> covariance(const std::string &key,
                                            const std::vector<std::string> &parameters) const;

  [[noreturn]] void fail(const std::string &key, const std::string &problem) const;

 private:
  /// A key that appears twice would take its last value; text that is nested without end would end
  /// the program where the values are looked at.
  void parse();
  void checkKeys(const std::vector<std::string> &keys) const;
  void checkChecksum() const;
  double checked(const std::string &key, const nlohmann::json &value) const;
  const nlohmann::json &at(const std::string &key) const;
  Range rangeOf(const nlohmann::json &value, const std::string &key) const;
  std::vector<double> numbers(const nlohmann::json &value, const std::string &key,
                              std::size_t size) const;
  int lineOf(const std::string &key) const;

  std::string fileName_, text_;
  nlohmann::json json_;
};

} // namespace wheelrail
#endif
