// SPDX-License-Identifier: GPL-2.0-or-later
#include "base/yaml_document.h"

#include <sstream>
#include <yaml-cpp/eventhandler.h>

namespace wheelrail {
namespace {

/// Where a document begins; all that it holds is passed over.
class DocumentStart : public YAML::EventHandler {
 public:
  YAML::Mark mark;

  void OnDocumentStart(const YAML::Mark &at) override { mark = at; }
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark &, YAML::anchor_t) override {}
  void OnAlias(const YAML::Mark &, YAML::anchor_t) override {}
  void OnScalar(const YAML::Mark &, const std::string &, YAML::anchor_t,
                const std::string &) override
  {
  }
  void OnSequenceStart(const YAML::Mark &, const std::string &, YAML::anchor_t,
                       YAML::EmitterStyle::value) override
  {
  }
  void OnSequenceEnd() override {}
  void OnMapStart(const YAML::Mark &, const std::string &, YAML::anchor_t,
                  YAML::EmitterStyle::value) override
  {
  }
  void OnMapEnd() override {}
};

} // namespace

// Not YAML::LoadAll: it has no end where a comma follows the document.
YAML::Node yamlDocument(const std::string &text)
{
  YAML::Node document = YAML::Load(text);
  std::istringstream input(text);
  YAML::Parser parser(input);
  DocumentStart start;
  if (parser.HandleNextDocument(start) && parser.HandleNextDocument(start))
    throw YAML::Exception(start.mark, "a second document (after '---'), or what belongs to none; "
                                      "one is allowed");
  return document;
}

} // namespace wheelrail
