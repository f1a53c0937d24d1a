// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_CREEP_SWEEP_RESULT_FILES_H
#define WHEELRAIL_CREEP_SWEEP_RESULT_FILES_H

#include "creep/sweep/result_head.h"
#include "shared/output_file.h"

#include <functional>
#include <string>
#include <vector>

namespace wheelrail {

constexpr const char *summaryName = "summary.json";

/// The files of a case, which appear together or not at all.
class ResultFiles {
 public:
  /// \param folder that is there
  /// \param head of all tables and fields
  ResultFiles(std::string folder, ResultHead head)
      : folder_(std::move(folder)), head_(std::move(head))
  {
  }

  /// A file in the folder; the report names it. What ends in ".csv" is checked as a table and gets
  /// the head.
  /// \throws Error (NotConverged) for a number of a table that is not finite; mcawr::OutputError
  void add(const std::string &name, const std::string &content);
  /// The summary, last of all: its "files" are the names of what stands in the folder, itself too.
  /// \param text makes it of these names
  void addSummary(const std::function<std::string(const std::vector<std::string> &)> &text);
  /// Names of files in the folder that were added by `files()`.
  void note(const std::vector<std::string> &names);
  /// A file at a path of its own; the report does not name it.
  void addElsewhere(const std::string &path, const std::string &content);
  /// Path of a file in the folder.
  std::string pathOf(const std::string &name) const { return folder_ + "/" + name; }
  const std::string &folder() const { return folder_; }
  const ResultHead &head() const { return head_; }
  /// For who writes many files at once.
  mcawr::OutputFiles &files() { return files_; }

  /// Puts all of them in place, then removes what the folder's former summary names and this one
  /// does not: results are a set, and stay one.
  /// \param inputs of the run, by their paths, which stay
  /// \throws mcawr::OutputError
  void commit(const std::vector<std::string> &inputs);
  /// Names that `add` got: "creep.csv, summary.json".
  const std::string &names() const { return names_; }

 private:
  std::string folder_, names_;
  ResultHead head_;
  std::vector<std::string> set_; ///< names in the folder
  mcawr::OutputFiles files_;
};

/// What a task leaves in the folder: a file, or several that are written together.
/// \tparam Curves what the task has solved
template<class Curves>
struct Output {
  std::vector<std::string> names; ///< without the folder
  std::function<void(const Curves &, ResultFiles &)> write;
};
template<class Curves>
using Outputs = std::vector<Output<Curves>>;

/// An output of one file.
/// \param text its content
/// \param when whether these results have it
template<class Curves>
Output<Curves> fileOf(
    const std::string &name, std::function<std::string(const Curves &)> text,
    std::function<bool(const Curves &)> when = [](const Curves &) { return true; })
{
  return {{name}, [=](const Curves &curves, ResultFiles &files) {
            if (when(curves))
              files.add(name, text(curves));
          }};
}

/// The summary of a task.
/// \param text  makes it of the results and of the names of all files
template<class Curves>
Output<Curves>
summaryOf(std::function<std::string(const Curves &, const std::vector<std::string> &)> text)
{
  return {{summaryName}, [=](const Curves &curves, ResultFiles &files) {
            files.addSummary([&](const auto &names) { return text(curves, names); });
          }};
}

template<class Curves>
std::vector<std::string> namesOf(const Outputs<Curves> &outputs)
{
  std::vector<std::string> names;
  for (const Output<Curves> &output : outputs)
    names.insert(names.end(), output.names.begin(), output.names.end());
  return names;
}

template<class Curves>
void write(const Outputs<Curves> &outputs, const Curves &curves, ResultFiles &files)
{
  for (const Output<Curves> &output : outputs)
    output.write(curves, files);
}

} // namespace wheelrail
#endif
