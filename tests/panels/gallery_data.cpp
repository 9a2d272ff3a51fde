#include "gallery_data.h"

#include "plan/finding_kinds.h"
#include "program/dialect.h"

namespace voluta::gallery {

namespace {
std::shared_ptr<const std::string> sampleProgram() {
  QString text = QStringLiteral("def kitten():\n  # Voluta 0.1, cell ur5-fixed\n");
  for (int i = 4000; i < 9000; ++i)
    text += QStringLiteral("  movel(p[0.%1, -0.1042, 0.3121, 2.2214, -2.2214, 0.0], a=0.5, v=0.02, "
                           "r=0.0004)\n")
                .arg(i);
  text += QStringLiteral("end\n");
  return std::make_shared<const std::string>(text.toStdString());
}

project::ReplayReport sampleVerdict(bool passed) {
  project::ReplayReport r;
  r.passed = passed;
  r.coveredFraction = passed ? 0.987 : 0.942;
  r.unsupportedFraction = 0.0012;
  r.overfillFraction = 0.0214;
  r.massRatio = 1.011;
  r.collisions = passed ? 0 : 3;
  r.maxDeviationMm = 0.004;
  r.thresholds = {0.97, 0.005, 0.03, 0.03, 0.05, 0, 0};
  return r;
}

base::Message said(std::string sentence) {
  return base::message("{text}"_text, std::move(sentence));
}
} // namespace

plan::Findings sampleFindings() {
  plan::Findings findings;
  const auto add = [&](const char* stage, bool blocking, const char* reason, const char* remedy) {
    plan::Finding f = plan::verbatimFinding(*plan::stageNamed(stage), "sample", reason, remedy);
    f.blocking = blocking;
    f.where = Eigen::Vector3d(12.4, -3.1, 40.25 + static_cast<double>(findings.size()));
    findings.push_back(f);
  };
  add("layers", false, "The layer over the left ear is thinner than the process likes.",
      "A smaller layer height makes the layers more even.");
  add("decompose", true, "12 voxels behind the ear can't be reached: the front closes over them.",
      "Turn the part by some degrees, or let tiny supports carry them.");
  findings.back().count = 12;
  add("replay", true, "urscript: the wrist meets the plate.", "Lift the part or turn it.");
  findings.back().whenS = 754.2;
  add("load", false, "A hole with 14 edges was closed.", "");
  return findings;
}

panels::MeshSummary sampleMesh() {
  panels::MeshSummary mesh;
  mesh.name = "kitten.stl";
  mesh.triangles = 28196;
  mesh.volumeMm3 = 96250.0;
  mesh.watertight = true;
  mesh.found = {said("1 hole with 14 edges, at 12.4, 3.1, 40.2 mm."_name),
                said("3 triangles without area, the first at 1.0, 2.0, 3.0 mm."_name)};
  mesh.repaired = {said("Closed 1 hole."_name), said("Dropped 3 triangles without area."_name)};
  return mesh;
}

panels::LayerMeasures sampleLayer() {
  panels::LayerMeasures layer;
  layer.index = 41;
  layer.layers = 125;
  layer.patches = 2;
  layer.areaMm2 = 1840.2;
  layer.thicknessMinMm = 0.44;
  layer.thicknessMeanMm = 0.79;
  layer.thicknessMaxMm = 0.98;
  layer.lengthMm = 15230.0;
  layer.timeS = 761.0;
  layer.waypoints = 15230;
  return layer;
}

std::vector<panels::ExportFormat> sampleFormats() {
  const auto text = sampleProgram();
  std::vector<panels::ExportFormat> formats(4);
  formats[0].id = "urscript";
  formats[0].label = "URScript (Universal Robots)";
  formats[0].state = panels::VerdictState::Passed;
  formats[0].verdict = sampleVerdict(true);
  formats[0].files = {{"kitten.script", text}};
  formats[0].plannedS = 700.0;
  formats[0].options = program::optionsOf(program::findDialect("urscript"));
  formats[0].assumptions = {"The arm stops at points without a blend.", "Not tested on a machine."};
  formats[1].id = "gcode-extended";
  formats[1].label = "Extended G-code";
  formats[1].state = panels::VerdictState::Refused;
  formats[1].whyRefused = "coveredFraction, collisions";
  formats[1].verdict = sampleVerdict(false);
  formats[1].files = {{"refused-kitten.gcode", text}};
  formats[2].id = "rapid";
  formats[2].label = "RAPID (ABB)";
  formats[2].foreign = true;
  formats[3].id = "csv";
  formats[3].label = "Joint table (CSV)";
  return formats;
}

} // namespace voluta::gallery
