// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef WHEELRAIL_CREEP_CASE_HELP_H
#define WHEELRAIL_CREEP_CASE_HELP_H

#include <string>

namespace wheelrail {

/// What --help of wr_creep says of cases: worked examples, the table of keywords, exit codes.
std::string caseHelp();

} // namespace wheelrail
#endif
