// Members of a zip that is at hand in memory.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace voluta::geometry {

// Stored and deflated members, up to 1 GB each; neither encrypted ones nor zip64.
class ZipPackage {
public:
  // `bytes` and `name` (of the file, for errors) outlive this. Throws Error{UnreadableFile}: not a
  // zip, cut short, its directory damaged.
  ZipPackage(std::string_view bytes, const std::string& name);

  bool has(const std::string& member) const { return members_.contains(member); }
  // The first member, by name, that ends so.
  std::optional<std::string> firstEndingIn(std::string_view ending) const;
  // What its directory says a member comes to, bytes; 0 where it is not there.
  std::size_t sizeOf(const std::string& member) const;
  // Throws Error{UnreadableFile}: not there, packed in another way, damaged.
  std::string member(const std::string& member) const;

private:
  struct Member {
    std::uint32_t method = 0, crc = 0, packed = 0, size = 0, offset = 0, flags = 0;
  };
  std::string_view bytes_;
  const std::string& name_;
  std::map<std::string, Member> members_;
};

} // namespace voluta::geometry
