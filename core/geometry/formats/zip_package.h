// Reads members of a zip file in memory.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace voluta::geometry {

// Reads stored and deflated members, up to 1 GB each, also of packages with the 64-bit extension
// (zip64); no encrypted ones.
class ZipPackage {
public:
  // `bytes` and `name` (of the file, for errors) must outlive this. Throws Error{UnreadableFile} if
  // it is not a zip, is truncated, or its directory is damaged.
  ZipPackage(std::string_view bytes, const std::string& name);

  bool has(const std::string& member) const { return members_.contains(member); }
  // Returns the names of all members, in alphabetical order.
  std::vector<std::string> names() const;
  // Returns the first member, by name, with this ending.
  std::optional<std::string> firstEndingIn(std::string_view ending) const;
  // Returns the unpacked size of a member according to the directory [bytes]; 0 if there is no such
  // member.
  std::size_t sizeOf(const std::string& member) const;
  // Throws Error{UnreadableFile} if the member is missing, compressed with another method or
  // damaged.
  std::string member(const std::string& member) const;

private:
  struct Member {
    std::uint32_t method = 0, crc = 0, flags = 0;
    std::uint64_t packed = 0, size = 0, offset = 0;
  };
  std::string_view bytes_;
  const std::string& name_;
  std::map<std::string, Member> members_;
};

} // namespace voluta::geometry
