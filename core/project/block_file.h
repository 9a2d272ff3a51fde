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

// Whether arrays of T may be stored as their bytes: T consists of numbers only.
template <typename T>
inline constexpr bool kIsPlain =
    std::is_trivially_copyable_v<T> || std::is_same_v<T, Eigen::Vector3d> ||
    std::is_same_v<T, Eigen::Vector3f> || std::is_same_v<T, Eigen::Vector2d>;

std::uint32_t crcOf(std::string_view bytes);

// One row of the table of blocks.
struct BlockRow {
  std::string name;
  std::size_t offset = 0, bytes = 0, item = 0; // [bytes]; `item`: size of one element
  std::uint32_t crc32 = 0;
};

// Collects blocks without copying them: the arrays must outlive the writer, except those of
// addOwned() and addText().
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
  // Begins a block of several arrays; append() adds each.
  void begin(const std::string& name, std::size_t item);
  template <typename T> void append(const std::vector<T>& values) { appendBytes(bytesOf(values)); }

  // Returns the rows of all blocks, with checksums.
  std::vector<BlockRow> table() const;
  // Returns the blocks' bytes in the order they were added; valid while the writer and the arrays
  // live.
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

// Reads blocks and verifies their checksums. `where` (the file) and `bytes` (the body) must outlive
// it.
class BlockReader {
public:
  BlockReader(const std::string& where, std::vector<BlockRow> table, std::string_view bytes)
      : where_(where), table_(std::move(table)), bytes_(bytes) {}

  // Names that are looked up from here on begin with it.
  void setPrefix(std::string prefix) { prefix_ = std::move(prefix); }

  // Throws Error{UnreadableFile} if the block is missing, truncated or damaged, or has items of
  // another size.
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
