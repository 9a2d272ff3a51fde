// Writes a zip file in memory.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace voluta::geometry {

// Deflated members, dated 1 January 1980, so that the same members give the same bytes.
class ZipWriter {
public:
  // Throws Error{CannotWrite} beyond 65,535 members or 4 GB.
  void add(std::string_view name, std::string_view bytes);
  // Returns the whole file; the writer is empty afterwards.
  std::string take();

private:
  std::string members_, directory_;
  std::uint32_t count_ = 0;
};

} // namespace voluta::geometry
