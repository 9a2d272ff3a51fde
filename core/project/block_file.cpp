#include "project/block_file.h"

#include <zlib.h>

namespace voluta::project {

namespace {
uLong crcAfter(uLong crc, std::string_view bytes) {
  // crc32_z would restart the checksum for a null pointer, which an empty view may have
  if (bytes.empty())
    return crc;
  return crc32_z(crc, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size());
}
} // namespace

std::uint32_t crcOf(std::string_view bytes) {
  return static_cast<std::uint32_t>(crcAfter(0, bytes));
}

void BlockWriter::begin(const std::string& name, std::size_t item) {
  blocks_.push_back({{prefix_ + name, size_, 0, item, 0}, {}});
}

void BlockWriter::appendBytes(std::string_view bytes) {
  blocks_.back().row.bytes += bytes.size();
  blocks_.back().parts.push_back(bytes);
  size_ += bytes.size();
}

std::vector<BlockRow> BlockWriter::table() const {
  std::vector<BlockRow> rows;
  for (const Block& block : blocks_) {
    uLong crc = 0;
    for (const std::string_view part : block.parts)
      crc = crcAfter(crc, part);
    rows.push_back(block.row);
    rows.back().crc32 = static_cast<std::uint32_t>(crc);
  }
  return rows;
}

std::vector<std::string_view> BlockWriter::parts() const {
  std::vector<std::string_view> all;
  for (const Block& block : blocks_)
    all.insert(all.end(), block.parts.begin(), block.parts.end());
  return all;
}

std::string_view BlockReader::checked(const std::string& name, std::size_t item) const {
  const auto unreadable = [&](const base::Message& what) {
    return base::Error(base::ErrorCode::UnreadableFile, what, where_, "plan the part again"_text);
  };
  for (const BlockRow& row : table_) {
    if (row.name != prefix_ + name)
      continue;
    if (row.offset > bytes_.size() || row.bytes > bytes_.size() - row.offset)
      throw unreadable("the job file is truncated"_text);
    const std::string_view block = bytes_.substr(row.offset, row.bytes);
    if (row.item != item || block.size() % item != 0 || crcOf(block) != row.crc32)
      throw unreadable(base::message("block '{name}' of the job file is damaged"_text, name));
    return block;
  }
  throw unreadable(base::message("block '{name}' is missing in the job file"_text, name));
}

} // namespace voluta::project
