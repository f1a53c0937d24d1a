#include "base/errors.h"

#include <fmt/format.h>

namespace wheelrail {

Error::Error(ExitCode code, const std::string &message)
    : std::runtime_error(message), exitCode(code)
{
}

Error badInput(const std::string &file, int line, const std::string &keyword,
               const std::string &problem)
{
  std::string text = file;
  if (line > 0)
    text += fmt::format(":{}", line);
  if (!keyword.empty())
    text += fmt::format(": {}", keyword);
  Error error(ExitCode::BadInput, fmt::format("{}: {}", text, problem));
  error.fileName = file;
  error.lineNumber = line;
  error.keywordName = keyword;
  return error;
}

} // namespace wheelrail
