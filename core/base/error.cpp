#include "base/error.h"

#include <utility>

namespace voluta::base {

namespace {
std::string oneLine(const std::string& message, const std::string& context,
                    const std::string& remedy) {
  std::string line = context.empty() ? message : context + ": " + message;
  if (!remedy.empty())
    line += " (" + remedy + ")";
  for (char& c : line)
    if (c == '\n' || c == '\r')
      c = ' ';
  return line;
}
} // namespace

Error::Error(ErrorCode code, std::string message, std::string context, std::string remedy)
    : code_(code), message_(std::move(message)), context_(std::move(context)),
      remedy_(std::move(remedy)), line_(oneLine(message_, context_, remedy_)) {}

void failPrecondition(std::string_view what) {
  throw Error(ErrorCode::Internal, "broken precondition: " + std::string(what));
}

} // namespace voluta::base
