// Materials (resources/materials/*.json): density, temperatures, cooling, bridging, price, colour.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace voluta::process {

// The length that a bead of a width bridges.
struct BridgedLength {
  double widthMm = 0.0, lengthMm = 0.0;

  bool operator==(const BridgedLength&) const = default;
};

// Those of PLA.
std::vector<BridgedLength> bridgesOfPla();

// How beads give way under a load. The default is that of PLA (Casavola 2016).
struct Elasticity {
  double alongMPa = 3120.0;  // modulus along a bead
  double acrossMPa = 2770.0; // and across: to the beads beside it, and to the layers
  double shearMPa = 1050.0;  // between them
  double poisson = 0.33;  // within [0, 0.5)

  bool operator==(const Elasticity&) const = default;
};

// The default is PLA, as resources/materials/pla.json.
struct Material {
  std::string id = "pla", label = "PLA";
  double densityGPerCm3 = 1.24;           // > 0
  std::optional<int> nozzleC = 210;       // usual nozzle temperature [°C]; none: unknown
  int nozzleMinC = 170, nozzleMaxC = 250; // range in which a nozzle prints it [°C]
  std::optional<int> bedC = 60;           // usual plate temperature [°C]; none: unknown
  double fan = 1.0;                       // part cooling from the second layer on, 0..1
  std::optional<double> bridgeFan;        // part cooling of bridges, 0..1; none: as elsewhere
  std::optional<double> maxFlowMm3PerS;   // melted at most, whatever the process allows; none: any
  double bridgeWidths = 5.0; // length that a bead bridges, in bead widths, unless the process says
  std::optional<double> bridgeMm; // longest bridge, whatever the process allows; none: any
  // Spans that bridge with a sag of up to 0.2 mm, by ascending bead width; none: unknown
  std::vector<BridgedLength> bridges = bridgesOfPla();
  std::optional<Elasticity> elasticity = Elasticity{}; // none: unknown
  // Age [s] that a bead must, and may at most, have when the next layer covers it; none: any
  std::optional<double> minLayerTimeS, maxLayerTimeS;
  double pricePerKg = 20.0;       // in the user's currency; 0: unknown
  std::string colour = "#D8CFC0"; // #RRGGBB
  std::string notes;              // for people
  // Label and density identify a material that comes with the program in cache keys; the key of any
  // other contains the values that results depend on.
  bool comesWithProgram = true;

  bool operator==(const Material&) const = default;
};

// Returns whether a nozzle at that temperature [°C] prints the material.
bool prints(const Material& material, double nozzleC);

// Returns the longest span that a bead of that width bridges with a sag of up to 0.2 mm [mm]:
// between two widths of `bridges` interpolated; narrower beads bridge as the narrowest; wider ones
// less than the widest, by the power of 3/8 of the widths' ratio. 0: unknown. The law:
// docs/design.md, Replay.
double bridgedMm(const Material& material, double beadWidthMm);

// Reads a material from the text of its file; `name` names the file in errors. Required are id,
// label and density; temperatures that are missing are unknown, the rest is neutral.
// Throws Error{UnreadableFile} if it is not JSON; Error{UnusableInput}, naming file and key, if a
// key is missing or unknown, a value is out of range or temperatures are not ordered.
Material readMaterialText(const std::string& text, const std::string& name);

// Returns the text of a material's file: readMaterialText() returns the same material.
std::string materialText(const Material& material);

// Returns the ids of all materials, those of the user included, sorted.
std::vector<std::string> materialIds();

// Loads a material by its id. Throws Error{Usage} naming the nearest id if it is unknown.
Material loadMaterial(const std::string& id);

// Returns the material with that id, ignoring case ("PLA" is "pla"). A name without a file gives a
// material of that label with density 0, unknown temperatures and a nozzle range as wide as heads
// allow. Throws as readMaterialText().
Material materialNamed(const std::string& name);

} // namespace voluta::process
