// Text voxel objects.
#include "fuzz_target.h"

#include "voxel/voxel_text.h"

using namespace voluta;

std::vector<std::string> fuzz::seeds() {
  return {"1100\n0100\n----\n", "010\n-1-\n", "0110\n0110\n\n0110\n0000\n\n----\n----\n",
          "01000\r\n01000\r\n01100\r\n-----\r\n"};
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text = fuzz::textOf(data, size);
  voxel::looksLikeVoxelText(text);
  fuzz::takenOrRefused([&] {
    const voxel::VoxelObject object = voxel::readVoxelText(text, "input");
    fuzz::expect(object.size.minCoeff() > 0, "an object has a size");
    fuzz::expect(object.solid.size() == static_cast<std::size_t>(object.size.prod()),
                 "every cell is known");
    fuzz::expect(!object.platform.empty(), "an object stands on a platform");
    if (object.solid.size() < 100'000)
      fuzz::expect(!voxel::surfaceOf(object).empty(), "an object has a surface");
  });
  return 0;
}
