#include "program/tmscript/tmscript_frames.h"

#include "program/common/program_text.h"

#include <charconv>

namespace voluta::program {

namespace {

constexpr std::string_view kHeader = "$TMSCT,";
constexpr std::size_t kEnd = 4; // ",*" and two digits

std::string checksum(std::string_view bytes) {
  unsigned sum = 0;
  for (const char c : bytes)
    sum ^= static_cast<unsigned char>(c);
  constexpr std::string_view kDigits = "0123456789ABCDEF";
  return {kDigits[sum >> 4U], kDigits[sum & 15U]};
}

std::optional<unsigned> hexadecimal(std::string_view digits) {
  unsigned value = 0;
  const auto [end, error] =
      std::from_chars(digits.data(), digits.data() + digits.size(), value, 16);
  if (error != std::errc() || end != digits.data() + digits.size())
    return std::nullopt;
  return value;
}

TmFrame broken(std::string_view line, std::string_view script, base::Message reason) {
  return {.id = {},
          .script = script,
          .length = line.size(),
          .sound = false,
          .reason = std::move(reason)};
}

// Returns the text between the third comma of a broken frame and its end.
std::string_view scriptOf(std::string_view line) {
  std::size_t at = 0;
  for (int commas = 0; commas < 3; ++commas) {
    at = line.find(',', at);
    if (at == std::string_view::npos)
      return {};
    ++at;
  }
  const std::size_t end = line.rfind(",*");
  return line.substr(at, end == std::string_view::npos || end < at ? line.npos : end - at);
}

} // namespace

std::string tmFrame(std::string_view id, std::string_view script) {
  const std::string content =
      joined({"TMSCT,", std::to_string(id.size() + 1 + script.size()), ",", id, ",", script, ","});
  return joined({"$", content, "*", checksum(content), "\r\n"});
}

TmFrame takeTmFrame(std::string_view text) {
  std::string_view line = text.substr(0, text.find('\n'));
  line = trimmed(line);
  const std::string_view script = scriptOf(line);
  if (!text.starts_with(kHeader))
    return broken(line, script, "the frame is not a script for a listen node"_text);
  std::size_t bytes = 0;
  const char* const first = text.data() + kHeader.size();
  const auto [digits, error] = std::from_chars(first, text.data() + text.size(), bytes);
  const auto from = static_cast<std::size_t>(digits - text.data()) + 1; // After the comma
  if (error != std::errc() || from > text.size() || *digits != ',')
    return broken(line, script, "frame without a length"_text);
  if (bytes > text.size() || text.size() - from < bytes + kEnd ||
      text.substr(from + bytes, 2) != ",*")
    return broken(line, script, "the frame's length differs from the stated one"_text);
  const std::size_t end = from + bytes + kEnd;
  const auto said = hexadecimal(text.substr(end - 2, 2));
  if (!said || *said != *hexadecimal(checksum(text.substr(1, from + bytes))))
    return broken(line, script, "wrong checksum: the frame was modified or truncated"_text);
  const std::string_view content = text.substr(from, bytes);
  const std::size_t comma = content.find(',');
  if (comma == 0 || comma == std::string_view::npos)
    return broken(line, script, "frame without a name"_text);
  return {.id = content.substr(0, comma),
          .script = content.substr(comma + 1),
          .length = end,
          .sound = true,
          .reason = {}};
}

void TmFrameNumbers::add(std::string_view id, std::size_t line) {
  constexpr std::size_t kMaxDigits = 9;
  long number = 0;
  const auto [end, error] = std::from_chars(id.data(), id.data() + id.size(), number);
  if (error != std::errc() || id.size() > kMaxDigits || end != id.data() + id.size())
    number = last_.value_or(0) + 1;
  else if (last_ && number == *last_ + 1)
    ++steps_;
  else if (last_)
    others_.push_back({line, std::string(id), lastId_});
  last_ = number;
  lastId_ = id;
}

std::vector<TmFrameGap> TmFrameNumbers::gaps() const {
  return steps_ > others_.size() ? others_ : std::vector<TmFrameGap>();
}

} // namespace voluta::program
