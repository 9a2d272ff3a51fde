// Named arrays in one file, each with a checksum: the body of a project file.
#pragma once

#include "base/error.h"

#include <Eigen/Core>
#include <algorithm>
#include <cstdint>
#include <cstring>
#include <deque>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace voluta::project {

static_assert(sizeof(Eigen::Vector3d) == 3 * sizeof(double));
static_assert(sizeof(Eigen::Vector3f) == 3 * sizeof(float));
static_assert(sizeof(Eigen::Vector2d) == 2 * sizeof(double));

// What arrays may be made of: numbers side by side.
template <typename T>
inline constexpr bool kIsPlain =
    std::is_trivially_copyable_v<T> || std::is_same_v<T, Eigen::Vector3d> ||
    std::is_same_v<T, Eigen::Vector3f> || std::is_same_v<T, Eigen::Vector2d>;

std::uint32_t crcOf(std::string_view bytes);

// One row of the table of blocks.
struct BlockRow {
  std::string name;
  std::size_t offset = 0, bytes = 0, item = 0; // of the block, and of one of its numbers' groups
  std::uint32_t crc32 = 0;
};

// Collects blocks without copying them: arrays that are added have to outlive the writer.
class BlockWriter {
public:
  // Names of blocks that are added from here on begin with it.
  void setPrefix(std::string prefix) { prefix_ = std::move(prefix); }
  template <typename T> void add(const std::string& name, const std::vector<T>& values) {
    begin(name, sizeof(T));
    append(values);
  }
  template <typename T> void addOwned(const std::string& name, const std::vector<T>& values) {
    begin(name, sizeof(T));
    owned_.emplace_back(bytesOf(values));
    appendBytes(owned_.back());
  }
  void addText(const std::string& name, std::string text) {
    begin(name, 1);
    owned_.push_back(std::move(text));
    appendBytes(owned_.back());
  }
  // A block of several arrays one after the other: begin, then append each.
  void begin(const std::string& name, std::size_t item);
  template <typename T> void append(const std::vector<T>& values) { appendBytes(bytesOf(values)); }

  // With checksums.
  std::vector<BlockRow> table() const;
  // What is added, in its order, for as long as the writer and the arrays live.
  std::vector<std::string_view> parts() const;

private:
  template <typename T> static std::string_view bytesOf(const std::vector<T>& values) {
    static_assert(kIsPlain<T>);
    return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)};
  }
  void appendBytes(std::string_view bytes);

  struct Block {
    BlockRow row;
    std::vector<std::string_view> parts;
  };
  std::string prefix_;
  std::vector<Block> blocks_;
  std::deque<std::string> owned_;
  std::size_t size_ = 0;
};

// Gives blocks back, checked. `where` (the file) and `bytes` (the body) outlive it.
class BlockReader {
public:
  BlockReader(const std::string& where, std::vector<BlockRow> table, std::string_view bytes)
      : where_(where), table_(std::move(table)), bytes_(bytes) {}

  // Names that are looked up from here on begin with it.
  void setPrefix(std::string prefix) { prefix_ = std::move(prefix); }

  // Throws Error{UnreadableFile}: missing, cut short, damaged, items of another size.
  template <typename T> std::vector<T> get(const std::string& name) const {
    static_assert(kIsPlain<T>);
    const std::string_view block = checked(name, sizeof(T));
    std::vector<T> values(block.size() / sizeof(T));
    if (!values.empty())
      std::memcpy(static_cast<void*>(values.data()), block.data(), block.size());
    return values;
  }
  std::string text(const std::string& name) const { return std::string(checked(name, 1)); }
  bool has(const std::string& name) const {
    return std::any_of(table_.begin(), table_.end(),
                       [&](const BlockRow& row) { return row.name == prefix_ + name; });
  }

private:
  std::string_view checked(const std::string& name, std::size_t item) const;

  const std::string& where_;
  std::string prefix_;
  std::vector<BlockRow> table_;
  std::string_view bytes_;
};

} // namespace voluta::project
