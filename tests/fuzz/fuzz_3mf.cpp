// 3MF files. Inputs are the models in them, in XML, and are packed here, so that changes reach the
// contents of the package; such as are packages already are taken as they are.
#include "fuzz_target.h"

#include "base/error.h"
#include "geometry/formats/mesh_reader.h"
#include "geometry/formats/threemf_parts.h"
#include "helpers/package_3mf.h"
#include "motion/layer_event_text.h"
#include "project/file_events.h"
#include "project/file_regions.h"
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

// A lattice of two beams and a ball, a support, and an item that is not to be printed.
constexpr const char* kLattice = R"(<?xml version="1.0" encoding="UTF-8"?>
<model unit="inch" xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02"
 xmlns:b="http://schemas.microsoft.com/3dmanufacturing/beamlattice/2017/02"
 xmlns:s="http://schemas.microsoft.com/3dmanufacturing/slice/2015/07" requiredextensions="b">
<resources>
<object id="1"><mesh><vertices><vertex x="0" y="0" z="0"/><vertex x="9" y="0" z="0"/>
<vertex x="0" y="8" z="0"/></vertices>
<b:beamlattice radius="1" minlength="0.1" cap="butt" clippingmode="none" ballmode="mixed" ballradius="2">
<b:beams><b:beam v1="0" v2="1" r1="2" r2="1" cap1="sphere"/><b:beam v1="1" v2="2"/></b:beams>
<b:balls><b:ball vindex="2" r="1.5"/></b:balls></b:beamlattice></mesh></object>
<object id="2" type="support" s:slicestackid="4" s:meshresolution="lowres"><components>
<component objectid="1"/></components></object>
</resources>
<build><item objectid="1" printable="0"/><item objectid="1"/><item objectid="2"/></build>
</model>
)";

// Settings of slicers, which follow a model behind this line.
constexpr const char* kSplit = "\n<!-- settings -->\n";
constexpr const char* kPrusa =
    R"(<config><object id="1"><metadata type="object" key="extruder" value="2"/>
<volume firstid="0" lastid="1"><metadata type="volume" key="volume_type" value="NegativeVolume"/></volume>
<volume firstid="2" lastid="3"><metadata type="volume" key="modifier" value="1"/></volume></object></config>)";
constexpr const char* kBambu =
    R"(<config><object id="3"><metadata key="name" value="a"/><part id="1" subtype="negative_part">
<metadata key="name" value="b"/></part></object><plate><metadata key="x" value="1"/><model_instance/></plate></config>)";

constexpr const char* kModifiers =
    R"(<config><object id="1"><volume firstid="0" lastid="3"><metadata key="volume_type" value="ParameterModifier"/>
<metadata key="perimeters" value="3"/><metadata key="fill_density" value="20%"/><metadata key="extruder" value="2"/></volume>
<range min_z="1" max_z="4.5"><option opt_key="fill_pattern">grid</option><option opt_key="layer_height">0.2</option></range>
</object><code print_z="2.5" type="1"/><layer top_z="3" type="2" extruder="2"/></config>)";

// Paint, which changes reach in the model, and all kinds of volumes and events.
constexpr const char* kPainted = R"(<?xml version="1.0" encoding="UTF-8"?>
<model unit="millimeter" xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02"
 xmlns:slic3rpe="http://schemas.slic3r.org/3mf/2017/06"><resources><object id="1"><mesh><vertices>
<vertex x="0" y="0" z="0"/><vertex x="10" y="0" z="0"/><vertex x="0" y="10" z="0"/><vertex x="0" y="0" z="10"/>
</vertices><triangles>
<triangle v1="0" v2="2" v3="1" slic3rpe:custom_supports="4" paint_seam="48483"/>
<triangle v1="0" v2="1" v3="3" paint_color="0C1CFC0FC04A8963" slic3rpe:mmu_segmentation="44851"/>
<triangle v1="1" v2="2" v3="3" paint_supports="8" slic3rpe:custom_seam="400A"/>
<triangle v1="2" v2="0" v3="3" paint_color="481" paint_fuzzy_skin="4"/>
</triangles></mesh></object></resources><build><item objectid="1"/></build></model>
)";
constexpr const char* kPlaces =
    R"(<config><object id="1"><volume firstid="0" lastid="0"><metadata key="volume_type" value="SupportEnforcer"/></volume>
<volume firstid="1" lastid="1"><metadata key="volume_type" value="SupportBlocker"/></volume></object>
<code print_z="2.5" type="1" extra="Nut; ok"/><layer top_z="3" type="2" extruder="2"/><layer top_z="4" type="0" color="#FF0000"/>
<layer top_z="5" type="4"/></config>)";

std::string packageOf(const std::string& input) {
  const std::size_t at = input.find(kSplit);
  if (at == std::string::npos)
    return test::package3mf(input, false);
  const std::string settings = input.substr(at + std::string_view(kSplit).size());
  test::ZipWriter zip(false, input.size() % 2 == 0);
  test::addRelations(zip);
  zip.add("3D/3dmodel.model", input.substr(0, at));
  zip.add("Metadata/Slic3r_PE_model.config", settings);
  zip.add("Metadata/model_settings.config", settings);
  zip.add("Metadata/Prusa_Slicer_layer_config_ranges.xml", settings);
  zip.add("Metadata/custom_gcode_per_layer.xml", settings);
  zip.add("Metadata/Slic3r_PE.config", "; layer_height = 0.2\n");
  zip.add("Other/member", "x");
  return zip.bytes();
}

// The events of any file are a value of their parameter.
void expectEvents(const std::string& layerEvents) {
  bool areSound = true;
  try {
    motion::layerEventsOf(layerEvents);
  } catch (const base::Error&) {
    areSound = false;
  }
  fuzz::expect(areSound, "events of a file are events of layers");
}

} // namespace

std::vector<std::string> fuzz::seeds() {
  test::ZipWriter wide(true, true);
  test::addRelations(wide);
  wide.add("3D/3dmodel.model", kModel);
  return {kModel,
          kLattice,
          std::string(kModel) + kSplit + kPrusa,
          std::string(kModel) + kSplit + kBambu,
          std::string(kModel) + kSplit + kModifiers,
          std::string(kPainted) + kSplit + kPlaces,
          test::package3mf(kModel),
          test::package3mf(kModel, false),
          wide.bytes()};
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string input = fuzz::textOf(data, size);
  fuzz::takenOrRefused([&] {
    const std::string package = input.starts_with("PK") ? input : packageOf(input);
    fuzz::expectSound(geometry::readMesh(package, "input.3mf").mesh);
    std::vector<base::Message> notes;
    for (const geometry::PartOfFile& part : geometry::read3mfParts(package, "input.3mf")) {
      for (const project::Region& region : project::regionsOfFile(part.modifiers, notes, {}))
        if (region.mesh)
          fuzz::expectSound(*region.mesh);
      expectEvents(project::eventsOfFile(part.events, 1e9, notes).layerEvents);
    }
  });
  return 0;
}
