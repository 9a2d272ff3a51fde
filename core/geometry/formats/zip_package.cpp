#include "geometry/formats/zip_package.h"

#include "base/error.h"

#include <algorithm>
#include <zlib.h>

namespace voluta::geometry {

namespace {

constexpr std::uint32_t kEnd = 0x06054b50, kEntry = 0x02014b50, kLocal = 0x04034b50;
constexpr std::size_t kEndSize = 22, kEntrySize = 46, kLocalSize = 30;
constexpr std::size_t kLongestComment = 0xffff;
constexpr std::uint32_t kMax = 1u << 30; // bytes of a member
constexpr std::uint32_t kStored = 0, kDeflated = 8;
constexpr std::uint32_t kEncrypted = 1;
constexpr std::size_t kStep = 1 << 20;
constexpr std::uint32_t kLarge = 1u << 24, kMaxTimes = 300; // bytes, and maximum expansion factor

// Little-endian. Precondition: within the bytes.
std::uint32_t numberAt(std::string_view bytes, std::size_t at, int count) {
  std::uint32_t value = 0;
  for (int i = count; i-- > 0;)
    value = value << 8 | static_cast<unsigned char>(bytes[at + static_cast<std::size_t>(i)]);
  return value;
}

// Returns the position of the end record, which is last except for a comment; npos if there is
// none.
std::size_t findEnd(std::string_view bytes) {
  if (bytes.size() < kEndSize)
    return std::string_view::npos;
  const std::size_t last = bytes.size() - kEndSize;
  for (std::size_t back = 0; back <= std::min(last, kLongestComment); ++back)
    if (numberAt(bytes, last - back, 4) == kEnd)
      return last - back;
  return std::string_view::npos;
}

// Returns false if the data are invalid or their length is not `size`.
bool inflateTo(std::string_view packed, std::size_t size, std::string& text) {
  z_stream stream{};
  if (inflateInit2(&stream, -MAX_WBITS) != Z_OK)
    return false;
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data()));
  stream.avail_in = static_cast<uInt>(packed.size());
  int status = Z_OK;
  while (status == Z_OK && text.size() <= size) {
    // In steps, so that a wrong announced size allocates little.
    const std::size_t before = text.size();
    text.resize(before + std::min(kStep, size - before + 1));
    stream.next_out = reinterpret_cast<Bytef*>(text.data() + before);
    stream.avail_out = static_cast<uInt>(text.size() - before);
    status = inflate(&stream, Z_NO_FLUSH);
    text.resize(text.size() - stream.avail_out);
  }
  inflateEnd(&stream);
  return status == Z_STREAM_END && text.size() == size;
}

} // namespace

ZipPackage::ZipPackage(std::string_view bytes, const std::string& name)
    : bytes_(bytes), name_(name) {
  const auto damaged = [&] {
    return base::Error(base::ErrorCode::UnreadableFile, "not a zip file, or truncated"_text, name_);
  };
  const std::size_t end = findEnd(bytes);
  if (end == std::string_view::npos)
    throw damaged();
  const std::uint32_t count = numberAt(bytes, end + 10, 2);
  std::size_t at = numberAt(bytes, end + 16, 4);
  for (std::uint32_t i = 0; i < count; ++i) {
    if (at > end || end - at < kEntrySize || numberAt(bytes, at, 4) != kEntry)
      throw damaged();
    const std::size_t length = numberAt(bytes, at + 28, 2);
    const std::size_t further = numberAt(bytes, at + 30, 2) + numberAt(bytes, at + 32, 2);
    if (end - at - kEntrySize < length + further)
      throw damaged();
    members_[std::string(bytes.substr(at + kEntrySize, length))] = {
        .method = numberAt(bytes, at + 10, 2),
        .crc = numberAt(bytes, at + 16, 4),
        .packed = numberAt(bytes, at + 20, 4),
        .size = numberAt(bytes, at + 24, 4),
        .offset = numberAt(bytes, at + 42, 4),
        .flags = numberAt(bytes, at + 8, 2)};
    at += kEntrySize + length + further;
  }
}

std::optional<std::string> ZipPackage::firstEndingIn(std::string_view ending) const {
  for (const auto& [member, entry] : members_)
    if (member.ends_with(ending))
      return member;
  return std::nullopt;
}

std::size_t ZipPackage::sizeOf(const std::string& member) const {
  const auto found = members_.find(member);
  return found == members_.end() ? 0 : found->second.size;
}

std::string ZipPackage::member(const std::string& member) const {
  const auto unreadable = [&](const base::Message& what) {
    return base::Error(base::ErrorCode::UnreadableFile,
                       base::message("'{member}' in it {what}"_text, member, what), name_);
  };
  const auto found = members_.find(member);
  if (found == members_.end())
    throw unreadable("is missing"_text);
  const Member& m = found->second;
  if (m.flags & kEncrypted)
    throw unreadable("is encrypted"_text);
  if (m.size > kMax)
    throw unreadable("is larger than 1 GB"_text);
  const std::size_t local = m.offset;
  if (local > bytes_.size() || bytes_.size() - local < kLocalSize ||
      numberAt(bytes_, local, 4) != kLocal)
    throw unreadable("is damaged"_text);
  const std::size_t begin =
      local + kLocalSize + numberAt(bytes_, local + 26, 2) + numberAt(bytes_, local + 28, 2);
  if (begin > bytes_.size() || bytes_.size() - begin < m.packed)
    throw unreadable("is truncated"_text);
  const std::string_view packed = bytes_.substr(begin, m.packed);
  // Protects against zip bombs: real data do not compress this well.
  if (m.size > kLarge && m.size / kMaxTimes > m.packed)
    throw unreadable("unpacks to an implausible size"_text);
  std::string text;
  if (m.method == kStored)
    text = packed;
  else if (m.method != kDeflated)
    throw unreadable("is compressed with an unsupported method"_text);
  else if (!inflateTo(packed, m.size, text))
    throw unreadable("is damaged"_text);
  const auto* data = reinterpret_cast<const Bytef*>(text.data());
  if (text.size() != m.size || crc32(0, data, static_cast<uInt>(text.size())) != m.crc)
    throw unreadable("is damaged"_text);
  return text;
}

} // namespace voluta::geometry
