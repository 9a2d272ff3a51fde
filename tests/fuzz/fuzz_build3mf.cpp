// 3MF packages with tool-paths. Inputs are a model and a layer in XML, one behind the other, and
// are packed here, so that changes reach the contents of the package; such as are packages already
// are taken as they are.
#include "fuzz_target.h"
#include "sound_tool_plan.h"

#include "base/run_context.h"
#include "build3mf/build_reader.h"
#include "build3mf/build_writer.h"
#include "helpers/package_3mf.h"

#include <algorithm>
#include <cmath>

using namespace voluta;

namespace {

constexpr const char* kBetween = "<!--layer-->";
constexpr const char* kModel =
    R"(<?xml version="1.0"?><model unit="millimeter" requiredextensions="tp" xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02" xmlns:tp="http://schemas.3mf.io/3dmanufacturing/toolpath/2026/03"><resources>
<tp:toolpathresource id="1" uuid="u" unitfactor="0.01" toolpathtype="6axis"><tp:toolpathprofiles>
<tp:toolpathprofile uuid="00000000-0000-0000-0000-00000000000a" name="wall" beadwidth="1.2" beadheight="0.8" depositionspeed="20">
<tp:modifier attribute="beadwidth" type="nonlinear" minvalue="0.5" maxvalue="2" factor="e"/>
<tp:modifier attribute="depositionspeed" type="constant" minvalue="5" maxvalue="20" factor="g"/>
</tp:toolpathprofile></tp:toolpathprofiles>
<tp:toolpathlayers><tp:toolpathlayer path="/L.xml"/></tp:toolpathlayers></tp:toolpathresource>
</resources><build tp:toolpathid="1"/></model>)";
constexpr const char* kLayer =
    R"(<layer xmlns="http://schemas.3mf.io/3dmanufacturing/toolpath/2026/03"><parts><part id="1" uuid="q"/></parts>
<profiles><profile id="1" uuid="00000000-0000-0000-0000-00000000000A"/></profiles><data/>
<segments><segment type="polyline6d" profileid="1" partid="1">
<point6d x="0" y="0" z="80" i="0" j="0" k="0" w="1"/>
<point6d x="900" y="0" z="80" i="0.1" j="0" k="0" w="1" e1="0" e2="1" g="0.5"><sub t="0.25" e="0.75"/><sub t="0.5" e="1"/></point6d>
<point6d x="900" y="700" z="90" i="0" j="0.2" k="0" w="-1" e="0.3"/>
</segment></segments></layer>)";

std::string packed(const std::string& input) {
  const std::size_t between = input.find(kBetween);
  const std::string model = input.substr(0, between);
  const std::string layer = between == std::string::npos ? "" : input.substr(between + 12);
  test::ZipWriter zip(false);
  zip.add(
      "_rels/.rels",
      "<Relationships xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\">"
      "<Relationship Target=\"/m.model\" Id=\"r\" "
      "Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/></Relationships>");
  zip.add(
      "_rels/m.model.rels",
      "<Relationships xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\">"
      "<Relationship Target=\"/L.xml\" Id=\"r\" "
      "Type=\"http://schemas.3mf.io/3dmanufacturing/toolpath/2026/03/layer\"/></Relationships>");
  zip.add("m.model", model);
  zip.add("L.xml", layer);
  return zip.bytes();
}

} // namespace

std::vector<std::string> fuzz::seeds() {
  const std::string both = std::string(kModel) + kBetween + kLayer;
  return {both, packed(both)};
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string input = fuzz::textOf(data, size);
  fuzz::takenOrRefused([&] {
    const std::string package = input.starts_with("PK") ? input : packed(input);
    build3mf::holdsToolpaths(package);
    fuzz::expectSound(build3mf::readBuild(package, "input.build.3mf", base::RunContext()).plan);
  });
  return 0;
}
