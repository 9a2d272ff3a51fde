#include "project/block_file.h"

#include <boost/crc.hpp>

namespace voluta::project {

std::uint32_t crcOf(std::string_view bytes) {
  boost::crc_32_type crc;
  crc.process_bytes(bytes.data(), bytes.size());
  return crc.checksum();
}

void BlockWriter::begin(const std::string& name, std::size_t item) {
  blocks_.push_back({{name, size_, 0, item, 0}, {}});
}

void BlockWriter::appendBytes(std::string_view bytes) {
  blocks_.back().row.bytes += bytes.size();
  blocks_.back().parts.push_back(bytes);
  size_ += bytes.size();
}

std::vector<BlockRow> BlockWriter::table() const {
  std::vector<BlockRow> rows;
  for (const Block& block : blocks_) {
    boost::crc_32_type crc;
    for (const std::string_view part : block.parts)
      crc.process_bytes(part.data(), part.size());
    rows.push_back(block.row);
    rows.back().crc32 = crc.checksum();
  }
  return rows;
}

void BlockWriter::appendTo(std::string& file) const {
  for (const Block& block : blocks_)
    for (const std::string_view part : block.parts)
      file.append(part);
}

std::string_view BlockReader::checked(const std::string& name, std::size_t item) const {
  const auto unreadable = [&](const base::Message& what) {
    return base::Error(base::ErrorCode::UnreadableFile, what, where_, "plan the part again"_text);
  };
  for (const BlockRow& row : table_) {
    if (row.name != name)
      continue;
    if (row.offset > bytes_.size() || row.bytes > bytes_.size() - row.offset)
      throw unreadable("the job file is cut short"_text);
    const std::string_view block = bytes_.substr(row.offset, row.bytes);
    if (row.item != item || block.size() % item != 0 || crcOf(block) != row.crc32)
      throw unreadable(base::message("block '{name}' of the job file is damaged"_text, name));
    return block;
  }
  throw unreadable(base::message("the job file lacks '{name}'"_text, name));
}

} // namespace voluta::project
