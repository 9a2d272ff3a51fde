// libFuzzer target over all program readers; not part of the default build:
//   clang++ -std=c++20 -g -fsanitize=fuzzer,address,undefined -I core -I /usr/include/eigen3 \
//     tests/fuzz/program_reader_fuzz.cpp core/program/*.cpp core/robot/*.cpp ...
#include "process/process.h"
#include "program/dialect.h"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace voluta;
  const std::string text(reinterpret_cast<const char*>(data), size);
  const process::Process process;
  program::detectDialect("input", text);
  for (const program::Dialect& dialect : program::dialects()) {
    const plan::ReadProgram read = program::readProgram(dialect.id, {{"input", text}}, process);
    for (const plan::ProgramMotion& motion : read.motions)
      if (!motion.position.allFinite() || !motion.base_T_tcp.matrix().allFinite())
        std::abort();
  }
  return 0;
}
