// The interface of a fuzz target to its driver: libFuzzer, or fuzz_driver.cpp where there is none.
#pragma once

#include "base/error.h"

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>
#include <vector>

// Reads `data` as a file of the target's kind. Returns 0; a violation by a reader ends the program.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace voluta::fuzz {

// Whole files to begin from.
std::vector<std::string> seeds();

// Not base::writeFile: files of a moment need not survive a power cut.
inline void write(const char* name, const std::string& bytes) {
  std::ofstream(name, std::ios::binary) << bytes;
}

inline std::string textOf(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

// Ends the program with a message about the violated `condition`.
inline void expect(bool condition, const char* what) {
  if (condition)
    return;
  std::fprintf(stderr, "fuzz: expected that %s\n", what);
  std::abort();
}

// A reader takes bad input or refuses it in one line that names the place: it never fails in
// another way.
template <typename Read> void takenOrRefused(Read read) {
  try {
    read();
  } catch (const base::Error& e) {
    expect(e.code() != base::ErrorCode::Internal, e.what());
    expect(std::string(e.what()).find('\n') == std::string::npos, "an error is one line");
    expect(!e.message().empty(), "an error says what is wrong");
  }
}

} // namespace voluta::fuzz
