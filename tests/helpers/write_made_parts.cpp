// Writes made parts as STL files: write_made_parts FOLDER FIRST COUNT [thin]
#include "base/files.h"
#include "geometry/formats/mesh_reader.h"
#include "helpers/made_parts.h"
#include "helpers/thin_parts.h"

#include <cstdlib>
#include <filesystem>
#include <fmt/format.h>
#include <string>

int main(int count, char** arguments) {
  const bool thin = count == 5 && std::string(arguments[4]) == "thin";
  if (count != 4 && !thin) {
    fmt::print(stderr, "write_made_parts FOLDER FIRST COUNT [thin]\n");
    return 2;
  }
  std::filesystem::create_directories(arguments[1]);
  const auto first = static_cast<unsigned>(std::atoi(arguments[2])),
             parts = static_cast<unsigned>(std::atoi(arguments[3]));
  for (unsigned seed = first; seed < first + parts; ++seed) {
    const voluta::test::MadePart part =
        thin ? voluta::test::thinPart(seed) : voluta::test::madePart(seed);
    voluta::base::writeFile(std::filesystem::path(arguments[1]) / (part.name + ".stl"),
                            voluta::geometry::writeStl(part.mesh));
  }
  return 0;
}
