// Arrays of a project file that several rows share.
#pragma once

#include "base/error.h"

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace voluta::project {

[[noreturn]] inline void contradiction(const base::Message& what) {
  throw base::Error(base::ErrorCode::UnreadableFile,
                    base::message("the job file is inconsistent: {what}"_text, what), {},
                    "plan the part again"_text);
}

// Hands out an array in consecutive portions. Throws Error{UnreadableFile} beyond its end.
template <typename T> class Portions {
public:
  explicit Portions(std::vector<T> all) : all_(std::move(all)) {}
  std::vector<T> next(std::int64_t count) {
    if (count < 0 || static_cast<std::size_t>(count) > all_.size() - used_)
      contradiction("row beyond the end of its array"_text);
    const auto begin = all_.begin() + static_cast<std::ptrdiff_t>(used_);
    used_ += static_cast<std::size_t>(count);
    return {begin, begin + static_cast<std::ptrdiff_t>(count)};
  }

private:
  std::vector<T> all_;
  std::size_t used_ = 0;
};

} // namespace voluta::project
