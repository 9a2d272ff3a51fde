#include "base/error.h"

#include <algorithm>
#include <utility>

namespace voluta::base {

namespace {
std::string inOneLine(std::string text) {
  // Texts of damaged files may have any characters, and NUL ends a line for its readers.
  for (char& c : text)
    if (c == '\n' || c == '\r' || c == '\t')
      c = ' ';
    else if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F)
      c = '?';
  return text;
}
} // namespace

Error::Error(ErrorCode code, Message message, Value context, Message remedy)
    : code_(code), message_(std::move(message)), context_(std::move(context)),
      remedy_(std::move(remedy)), line_(inOneLine(english(whole()))) {}

Message Error::whole() const {
  if (context_.empty())
    return remedy_.empty() ? message_ : base::message("{what} ({remedy})"_text, message_, remedy_);
  return remedy_.empty()
             ? base::message("{where}: {what}"_text, context_, message_)
             : base::message("{where}: {what} ({remedy})"_text, context_, message_, remedy_);
}

Message lineOf(std::string_view file, long long line) {
  return message("{file}, line {line}"_text, file, std::to_string(line));
}

void failPrecondition(std::string_view what) {
  throw Error(ErrorCode::Internal, message("broken precondition: {what}"_text, what));
}

} // namespace voluta::base
