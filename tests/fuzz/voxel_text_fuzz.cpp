// libFuzzer target over the reader of text voxel objects; not part of the default build:
//   clang++ -std=c++20 -g -fsanitize=fuzzer,address,undefined -I core -I /usr/include/eigen3 \
//     tests/fuzz/voxel_text_fuzz.cpp core/voxel/voxel_*.cpp core/base/error.cpp ... -lfmt
#include "base/error.h"
#include "voxel/voxel_text.h"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace voluta;
  const std::string text(reinterpret_cast<const char*>(data), size);
  voxel::looksLikeVoxelText(text);
  try {
    const voxel::VoxelObject object = voxel::readVoxelText(text, "input");
    if (object.solid.size() != static_cast<std::size_t>(object.size.prod()) ||
        object.platform.empty() || (object.solid.size() < 100'000 && surfaceOf(object).empty()))
      std::abort();
  } catch (const base::Error& e) {
    if (e.code() == base::ErrorCode::Internal || e.context().empty())
      std::abort();
  }
  return 0;
}
