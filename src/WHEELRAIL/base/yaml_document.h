// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_BASE_YAML_DOCUMENT_H
#define WHEELRAIL_BASE_YAML_DOCUMENT_H

#include <string>
#include <vector>
#include <yaml-cpp/yaml.h>

namespace wheelrail {

/// The one document of a text in YAML; null where the text is empty.
/// `YAML::Load` would leave out all but the first in silence.
/// \throws YAML::Exception  also at the second document
inline YAML::Node yamlDocument(const std::string &text)
{
  const std::vector<YAML::Node> documents = YAML::LoadAll(text);
  if (documents.size() > 1)
    throw YAML::Exception(documents[1].Mark(), "a second document (after '---'); one is allowed");
  return documents.empty() ? YAML::Node() : documents.front();
}

} // namespace wheelrail
#endif
