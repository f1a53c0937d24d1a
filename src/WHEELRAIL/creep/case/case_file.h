// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_CREEP_CASE_CASE_FILE_H
#define WHEELRAIL_CREEP_CASE_CASE_FILE_H

#include "creep/line/creep_curve.h"
#include "creep/line/static_contact.h"
#include "creep/patch/patch_curve.h"
#include "creep/sweep/creep_task.h"

#include <memory>
#include <string>
#include <variant>
#include <vector>

namespace YAML {
class Node;
}

namespace wheelrail {

/// What a case file asks for, in the words of the physics, and the file itself with everything
/// filled in.
/// Values and their combinations were checked when it was read; files that it names were not
/// opened.
struct Case {
  /// A line contact that rolls, or carries a tangential force without rolling (mode static); or a
  /// point contact.
  std::variant<CreepSpecification, StaticSpecification, PatchSpecification> task;
  /// The complete configuration as a case file: reading it gives the same case.
  std::string text;

  /// The task, ready to be solved.
  std::unique_ptr<CreepTask> open() const;
  /// Path of the case file, as given.
  std::string path;
  /// Files that the case names, by the path that will be opened: law, measured surfaces.
  std::vector<std::string> files() const;
  /// All files that a run reads: those that the case names, and its own.
  std::vector<std::string> inputs() const;
  /// All that decides the results, for a journal: the text, and the content of the files it names
  /// as checksums. Reads them.
  /// \throws Error (BadInput) for a file that cannot be read
  std::string identity() const;
};

/// Reads a case file (YAML) and then "keyword=value" changes, the value in YAML as in the file.
/// Profile and law files that are named in it are looked for from the working folder, then from the
/// case file's; they are not read here.
/// \return all in SI units
/// \throws Error (BadInput) for the file, with line and keyword; Error (Usage) for changes
/// \param path of the case file
/// \param changes of --set, later ones over earlier ones
Case readCase(const std::string &path, const std::vector<std::string> &changes = {});

/// Reads a case file.
/// \param changes  a tree: a map of keywords with their values
Case readChangedCase(const std::string &path, const YAML::Node &changes);

/// A case of a text in YAML, or of a tree, that stands in no file: what it names is looked for from
/// the working folder.
/// \param name of the text or the tree, as messages say it
Case caseOfText(const std::string &name, const std::string &text);
/// \param tree     a map of keywords, or of groups of them, with their values
/// \param changes  likewise
Case caseOfTree(const std::string &name, const YAML::Node &tree, const YAML::Node &changes);
Case caseOfTree(const std::string &name, const YAML::Node &tree);

} // namespace wheelrail
#endif
