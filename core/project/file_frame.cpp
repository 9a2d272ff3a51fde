#include "project/file_frame.h"

#include "base/error.h"
#include "project/block_file.h"

#include <charconv>

namespace voluta::project {

namespace {
base::Error unreadableFrame(const base::Message& what, const std::string& where,
                            const base::Message& remedy = {}) {
  return base::Error(base::ErrorCode::UnreadableFile, what, where, remedy);
}

// Removes a number and the character after it from the front; returns false if there is none.
bool takeNumber(std::string_view& text, char end, std::size_t& value) {
  const auto [rest, status] = std::from_chars(text.data(), text.data() + text.size(), value);
  const auto used = static_cast<std::size_t>(rest - text.data());
  if (status != std::errc{} || used >= text.size() || *rest != end)
    return false;
  text.remove_prefix(used + 1);
  return true;
}
} // namespace

FileFrame fileFrame(std::string_view bytes, const std::string& where, const FileNames& names,
                    int oldest, int newest) {
  if (!bytes.starts_with(names.magic))
    throw unreadableFrame(names.other, where);
  std::string_view rest = bytes.substr(names.magic.size());
  std::size_t format = 0, length = 0, crc = 0;
  if (!takeNumber(rest, '\n', format) || format < static_cast<std::size_t>(oldest))
    throw unreadableFrame("the first line of the job file is damaged or truncated"_text, where);
  if (format > static_cast<std::size_t>(newest))
    throw unreadableFrame(
        base::message("saved by a newer version of Voluta (format {format}; this version reads "
                      "up to {newest})"_text,
                      format, newest),
        where, "open it with the version that saved it"_text);
  if (!takeNumber(rest, ' ', length) || !takeNumber(rest, '\n', crc) || length > rest.size())
    throw unreadableFrame(names.truncated, where);
  FileFrame frame{static_cast<int>(format), rest.substr(0, length), rest.substr(length)};
  if (crcOf(frame.header) != crc)
    throw unreadableFrame(names.damaged, where);
  return frame;
}

std::string fileHead(std::string_view magic, int format, const std::string& header) {
  return std::string(magic) + std::to_string(format) + "\n" + std::to_string(header.size()) + " " +
         std::to_string(crcOf(header)) + "\n" + header;
}

} // namespace voluta::project
