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

std::string unknownWord(const std::string &what, const std::string &given,
                        const std::string &nearest)
{
  return fmt::format("unknown {} '{}'; the nearest known one is '{}'", what, given, nearest);
}

} // namespace wheelrail
