// SPDX-License-Identifier: GPL-2.0-or-later
#include "files/friction_log_writer.h"

#include "shared/plain_number.h"
#include "shared/plain_text.h"
#include "shared/printable.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <vector>

namespace mca {

namespace format = mcawr::friction_log;

namespace {

[[noreturn]] void fail(const std::string &path, const std::string &problem)
{
  throw std::runtime_error(
      mcawr::printable("friction log " + path + ": " + mcawr::shortened(problem)));
}

/// What a file under the name of a log holds.
struct Contents {
  std::string head;                                    ///< lines before the one of the columns
  std::vector<std::pair<long long, std::string>> rows; ///< step and line
};

// Devices and pipes hold nothing that could be read again.
bool isThere(const std::string &path)
{
  std::error_code ignored;
  return std::filesystem::is_regular_file(path, ignored) &&
         std::filesystem::file_size(path, ignored) > 0;
}

long long stepOf(const std::string &line, int number, const std::string &path)
{
  std::istringstream words(line);
  std::vector<double> values;
  for (std::string word; words >> word;) {
    const auto value = mcawr::plainNumber(word);
    if (!value)
      fail(path, "line " + std::to_string(number) + ": '" + word + "' is not a finite number");
    values.push_back(*value);
  }
  static_assert(format::columns.front().value == &format::Row::step);
  if (values.size() != format::columnsWritten || !format::isIn(format::Range::Whole, values[0]))
    fail(path, "line " + std::to_string(number) + " is not a row of " +
                   std::to_string(format::columnsWritten) + " numbers that begin with a step");
  return static_cast<long long>(values[0]);
}

Contents read(const std::string &path)
{
  std::ifstream file(path, std::ios::binary);
  std::ostringstream bytes;
  bytes << file.rdbuf();
  const auto [text, problem] = mcawr::plainText(bytes.str());
  if (!problem.empty())
    fail(path, "it " + problem);
  std::istringstream in(text);
  std::string line;
  if (!std::getline(in, line) || line != format::formatLine())
    fail(path, "its first line is not '" + format::formatLine() + "'");
  Contents all = {line + "\n", {}};
  int number = 1;
  while (std::getline(in, line) && ++number && line.compare(0, 1, format::headMark) == 0)
    all.head += line + "\n";
  if (line != format::columnLine())
    fail(path, "line " + std::to_string(number) + " is not '" + format::columnLine() + "'");
  mcawr::RunningChecksum sum;
  sum.add(all.head + line + "\n");
  while (std::getline(in, line) && ++number) {
    if (in.eof()) // no newline: the machine stopped while it was written
      break;
    const long long step = stepOf(line, number, path);
    const std::size_t check = line.rfind(' ') + 1;
    sum.add(line.substr(0, check));
    if (line.substr(check) != std::to_string(sum.value()))
      fail(path, "line " + std::to_string(number) + ": check: " + line.substr(check) +
                     " does not fit: the head, or a row up to here, was changed since it was "
                     "written; give another file");
    sum.add(line.substr(check) + "\n");
    all.rows.emplace_back(step, line);
  }
  return all;
}

std::string rowsWord(LogRows rows)
{
  return rows.number == 0 ? "no row"
                          : std::to_string(rows.number) + " rows, the last one of step " +
                                std::to_string(rows.last);
}

} // namespace

void FrictionLogWriter::begin(const std::string &path, const LogHeader &header, const Units &units,
                              long long step, bool isRestart)
{
  if (isThere(path)) {
    if (isRestart)
      fail(path,
           "it exists, and the restart file holds no log of that name for this fix; give "
           "the fix its former ID and file, before commands like run or mca_links, or another "
           "file");
    const Contents old = read(path);
    if (!old.rows.empty() && old.rows.front().first <= step)
      fail(path, "it exists and has rows from step " + std::to_string(old.rows.front().first) +
                     " on, which this run, at step " + std::to_string(step) +
                     ", would not make again; give another file");
  }
  path_ = path;
  head_ = headOf(header, units);
  rows_ = {};
  open(head_ + format::columnLine() + "\n");
}

void FrictionLogWriter::open(const std::string &text)
{
  file_.begin(path_, text);
  sum_ = {};
  sum_.add(text);
}

std::string FrictionLogWriter::resume(const std::string &path, const LogHeader &header,
                                      const Units &units, long long step, LogRows rows)
{
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path, ignored)) {
    begin(path, header, units, step, true);
    return rows.number == 0 ? ""
                            : "friction log " + path + " with " + rowsWord(rows) +
                                  " is not there, a new one begins";
  }
  const Contents old = read(path);
  path_ = path;
  head_ = old.head;
  check(header, units);
  LogRows kept;
  std::string text = head_ + format::columnLine() + "\n";
  for (const auto &[at, line] : old.rows) {
    if (at > step)
      break;
    kept = {kept.number + 1, at};
    text += line + "\n";
  }
  if (kept.number != rows.number || kept.last != rows.last)
    fail(path, "it has " + rowsWord(kept) + " up to step " + std::to_string(step) +
                   ", the run that wrote the restart file had " + rowsWord(rows) +
                   ": it is another log or rows are missing; give another file to begin anew");
  rows_ = kept;
  open(text);
  const std::string before = versionsIn(head_), now = versionsIn(headOf(header, units));
  return before == now ? ""
                       : "friction log " + path + " was begun by " + before + ", this is " + now;
}

void FrictionLogWriter::check(const LogHeader &header, const Units &units) const
{
  const std::string difference = differenceFrom(head_, header, units);
  if (!difference.empty())
    fail(path_, "its head does not fit: " + difference + "; give another file");
}

void FrictionLogWriter::write(const LogRow &row)
{
  const auto step = static_cast<long long>(row.step);
  std::string line;
  for (const format::Column &column : format::columns) {
    const double value = row.*column.value;
    if (!format::isInRow(value))
      fail(path_, "the row of step " + std::to_string(step) + " has numbers that are not finite");
    line += mcawr::numberWord(value, column.digits) + " ";
  }
  mcawr::RunningChecksum sum = sum_;
  sum.add(line);
  const std::string check = std::to_string(sum.value()) + "\n";
  file_.append(line + check);
  sum.add(check);
  sum_ = sum;
  rows_ = {rows_.number + 1, step};
}

} // namespace mca
