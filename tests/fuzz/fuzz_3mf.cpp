// 3MF files. Inputs are the models in them, in XML, and are packed here, so that changes reach what
// stands in the package; such as are packages already are taken as they are.
#include "fuzz_target.h"

#include "geometry/formats/mesh_reader.h"
#include "helpers/package_3mf.h"
#include "sound_mesh.h"

using namespace voluta;

namespace {

constexpr const char* kModel = R"(<?xml version="1.0" encoding="UTF-8"?>
<model unit="millimeter" xml:lang="en-US" xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02">
<metadata name="Title">tetrahedron</metadata>
<resources>
<basematerials id="2"><base name="PLA" displaycolor="#FF8000"/></basematerials>
<object id="1" type="model" pid="2" pindex="0">
<mesh>
<vertices>
<vertex x="0" y="0" z="0"/>
<vertex x="10" y="0" z="0"/>
<vertex x="0" y="10" z="0"/>
<vertex x="0" y="0" z="10"/>
</vertices>
<triangles>
<triangle v1="0" v2="2" v3="1"/>
<triangle v1="0" v2="1" v3="3"/>
<triangle v1="1" v2="2" v3="3" pid="2" p1="0"/>
<triangle v1="2" v2="0" v3="3"/>
</triangles>
</mesh>
</object>
<object id="3" type="model">
<components><component objectid="1" transform="1 0 0 0 1 0 0 0 1 20 0 0"/></components>
</object>
</resources>
<build><item objectid="1"/><item objectid="3" transform="1 0 0 0 1 0 0 0 1 0 30 0"/></build>
</model>
)";

} // namespace

std::vector<std::string> fuzz::seeds() {
  return {kModel, test::package3mf(kModel), test::package3mf(kModel, false)};
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string input = fuzz::textOf(data, size);
  fuzz::takenOrRefused([&] {
    const std::string package = input.starts_with("PK") ? input : test::package3mf(input, false);
    fuzz::expectSound(geometry::readMesh(package, "input.3mf").mesh);
  });
  return 0;
}
