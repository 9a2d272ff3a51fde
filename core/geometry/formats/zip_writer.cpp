#include "geometry/formats/zip_writer.h"

#include "base/error.h"

#include <utility>
#include <zlib.h>

namespace voluta::geometry {

namespace {

constexpr std::uint64_t kMax = 0xffffffffu; // limit of a zip without its 64-bit extension
constexpr std::uint32_t kMaxMembers = 0xffff;

// Little-endian.
void put(std::string& to, std::uint64_t value, int bytes) {
  for (int i = 0; i < bytes; ++i, value >>= 8)
    to += static_cast<char>(value & 0xff);
}

std::string deflated(std::string_view bytes) {
  z_stream stream{};
  base::require(deflateInit2(&stream, 6, Z_DEFLATED, -MAX_WBITS, 8, Z_DEFAULT_STRATEGY) == Z_OK,
                "a compressor");
  std::string packed(deflateBound(&stream, static_cast<uLong>(bytes.size())), '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  stream.avail_in = static_cast<uInt>(bytes.size());
  stream.next_out = reinterpret_cast<Bytef*>(packed.data());
  stream.avail_out = static_cast<uInt>(packed.size());
  deflate(&stream, Z_FINISH);
  packed.resize(stream.total_out);
  deflateEnd(&stream);
  return packed;
}

} // namespace

void ZipWriter::add(std::string_view name, std::string_view bytes) {
  const auto tooLarge = [] {
    return base::Error(base::ErrorCode::CannotWrite, "too much for a zip file"_text);
  };
  if (bytes.size() > kMax || count_ == kMaxMembers)
    throw tooLarge();
  const std::string packed = deflated(bytes);
  if (members_.size() + directory_.size() + packed.size() + 1024 + 4 * name.size() > kMax)
    throw tooLarge();
  const auto* data = reinterpret_cast<const Bytef*>(bytes.data());
  std::string common; // to both of a member's headers: version needed to length of extra field
  put(common, 20, 2);
  put(common, 0, 2);
  put(common, 8, 2);
  put(common, 0, 2);      // 00:00:00
  put(common, 0x0021, 2); // 1 January 1980
  put(common, crc32(0, data, static_cast<uInt>(bytes.size())), 4);
  put(common, packed.size(), 4);
  put(common, bytes.size(), 4);
  put(common, name.size(), 2);
  put(common, 0, 2);
  put(directory_, 0x02014b50, 4);
  put(directory_, 20, 2);
  directory_ += common;
  put(directory_, 0, 10); // comment, disk, attributes
  put(directory_, members_.size(), 4);
  directory_ += name;
  put(members_, 0x04034b50, 4);
  members_.append(common).append(name).append(packed);
  ++count_;
}

std::string ZipWriter::take() {
  std::string end;
  put(end, 0x06054b50, 4);
  put(end, 0, 4);
  put(end, count_, 2);
  put(end, count_, 2);
  put(end, directory_.size(), 4);
  put(end, members_.size(), 4);
  put(end, 0, 2);
  std::string bytes = std::move(members_) + directory_ + end;
  *this = {};
  return bytes;
}

} // namespace voluta::geometry
