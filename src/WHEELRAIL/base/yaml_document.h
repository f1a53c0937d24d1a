// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_BASE_YAML_DOCUMENT_H
#define WHEELRAIL_BASE_YAML_DOCUMENT_H

#include <string>
#include <yaml-cpp/yaml.h>

namespace wheelrail {

/// The one document of a text in YAML; null where the text is empty.
/// `YAML::Load` would leave out in silence what follows the first.
/// \throws YAML::Exception  also at a second document, and at what belongs to none
YAML::Node yamlDocument(const std::string &text);

} // namespace wheelrail
#endif
