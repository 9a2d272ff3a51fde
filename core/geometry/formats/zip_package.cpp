#include "geometry/formats/zip_package.h"

#include "base/error.h"

#include <algorithm>
#include <initializer_list>
#include <zlib.h>

namespace voluta::geometry {

namespace {

constexpr std::uint32_t kEnd = 0x06054b50, kEntry = 0x02014b50, kLocal = 0x04034b50;
constexpr std::size_t kEndSize = 22, kEntrySize = 46, kLocalSize = 30;
// The 64-bit extension: where its end record is, the record, and the extra field of a member.
constexpr std::uint32_t kEnd64Place = 0x07064b50, kEnd64 = 0x06064b50, kSizes64 = 1;
constexpr std::size_t kEnd64PlaceSize = 20, kEnd64Size = 56;
constexpr std::uint64_t kInExtra = 0xffffffffu; // instead of a number that the extra field has
constexpr std::size_t kLongestComment = 0xffff;
constexpr std::uint32_t kMax = 1u << 30; // bytes of a member
constexpr std::uint32_t kStored = 0, kDeflated = 8;
constexpr std::uint32_t kEncrypted = 1;
constexpr std::size_t kStep = 1 << 20;
constexpr std::uint32_t kLarge = 1u << 24, kMaxTimes = 300; // bytes, and maximum expansion factor

// Little-endian. Precondition: within the bytes.
std::uint64_t longNumberAt(std::string_view bytes, std::size_t at, int count = 8) {
  std::uint64_t value = 0;
  for (int i = count; i-- > 0;)
    value = value << 8 | static_cast<unsigned char>(bytes[at + static_cast<std::size_t>(i)]);
  return value;
}
// `count`: up to 4.
std::uint32_t numberAt(std::string_view bytes, std::size_t at, int count) {
  return static_cast<std::uint32_t>(longNumberAt(bytes, at, count));
}

struct Directory {
  std::uint64_t count = 0, at = 0;
};

// Returns where the end record says the directory is; that of the 64-bit extension, if there is
// one, has the last word.
Directory directoryOf(std::string_view bytes, std::size_t end) {
  const Directory plain{numberAt(bytes, end + 10, 2), numberAt(bytes, end + 16, 4)};
  if (end < kEnd64PlaceSize || numberAt(bytes, end - kEnd64PlaceSize, 4) != kEnd64Place)
    return plain;
  const std::uint64_t at = longNumberAt(bytes, end - kEnd64PlaceSize + 8);
  if (at > end || end - at < kEnd64Size || numberAt(bytes, at, 4) != kEnd64)
    return plain;
  return {longNumberAt(bytes, at + 32), longNumberAt(bytes, at + 48)};
}

// Replaces the numbers that are in the extra field, in the order given. Returns false if one is
// missing there.
bool takeFromExtra(std::string_view extra, std::initializer_list<std::uint64_t*> numbers) {
  std::string_view sizes;
  while (extra.size() >= 4) {
    const std::size_t length = numberAt(extra, 2, 2);
    if (length > extra.size() - 4)
      break;
    if (numberAt(extra, 0, 2) == kSizes64)
      sizes = extra.substr(4, length);
    extra.remove_prefix(4 + length);
  }
  for (std::uint64_t* number : numbers)
    if (*number == kInExtra) {
      if (sizes.size() < 8)
        return false;
      *number = longNumberAt(sizes, 0);
      sizes.remove_prefix(8);
    }
  return true;
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
  const Directory directory = directoryOf(bytes, end);
  std::uint64_t at = directory.at;
  for (std::uint64_t i = 0; i < directory.count; ++i) {
    if (at > end || end - at < kEntrySize || numberAt(bytes, at, 4) != kEntry)
      throw damaged();
    const std::size_t length = numberAt(bytes, at + 28, 2);
    const std::size_t extra = numberAt(bytes, at + 30, 2), comment = numberAt(bytes, at + 32, 2);
    if (end - at - kEntrySize < length + extra + comment)
      throw damaged();
    Member member{.method = numberAt(bytes, at + 10, 2),
                  .crc = numberAt(bytes, at + 16, 4),
                  .flags = numberAt(bytes, at + 8, 2),
                  .packed = numberAt(bytes, at + 20, 4),
                  .size = numberAt(bytes, at + 24, 4),
                  .offset = numberAt(bytes, at + 42, 4)};
    if (!takeFromExtra(bytes.substr(at + kEntrySize + length, extra),
                       {&member.size, &member.packed, &member.offset}))
      throw damaged();
    members_[std::string(bytes.substr(at + kEntrySize, length))] = member;
    at += kEntrySize + length + extra + comment;
  }
}

std::vector<std::string> ZipPackage::names() const {
  std::vector<std::string> names;
  for (const auto& [member, entry] : members_)
    names.push_back(member);
  return names;
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
  const std::uint64_t local = m.offset;
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
