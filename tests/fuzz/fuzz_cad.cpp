// CAD files as far as this program looks at them, and the facets that the reader returns.
#include "fuzz_target.h"

#include "geometry/formats/cad_text.h"

#include <cstring>
#include <fmt/format.h>

namespace {

using namespace voluta;

std::string igesLine(const std::string& text, char section, int number) {
  return fmt::format("{:<72}{}{:>7}\n", text, section, number);
}

std::string readerOutput() {
  std::string bytes = "VCAD0001";
  const auto put = [&](const auto& value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
  };
  for (const std::uint64_t count : {1, 2, 2})
    put(count);
  for (const std::string name : {"base", ""}) {
    put(static_cast<std::uint64_t>(name.size()));
    bytes += name;
    for (const double place : {0.0, 10.0, -5.0})
      put(place);
    put(std::uint64_t{2});
    for (int i = 0; i < 18; ++i)
      put(0.5 * i);
  }
  return bytes;
}

} // namespace

std::vector<std::string> voluta::fuzz::seeds() {
  return {"ISO-10303-21;\nHEADER;\nENDSEC;\nDATA;\n#1=CARTESIAN_POINT('',(0.,0.,0.));\nENDSEC;\n"
          "END-ISO-10303-21;\n",
          igesLine("a file", 'S', 1) + igesLine("1H,,1H;", 'G', 1) + igesLine("116", 'D', 1) +
              igesLine("116,0.,0.,0.;", 'P', 1) +
              igesLine("S      1G      1D      1P      1", 'T', 1),
          readerOutput()};
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string bytes = fuzz::textOf(data, size);
  fuzz::takenOrRefused([&] { geometry::cadKindOf(bytes, "input.step"); });
  fuzz::takenOrRefused([&] { geometry::readCadFacets(bytes, "input.step"); });
  return 0;
}
