#include "process/process.h"

#include "base/data_files.h"
#include "base/error.h"
#include "base/files.h"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace voluta::process {

namespace {
using nlohmann::json;

void checkHead(const HeadShape& head, const std::string& where) {
  const auto& s = head.sections;
  bool good = s.size() >= 2 && s.front().zMm == 0.0;
  for (std::size_t i = 0; i < s.size(); ++i)
    good = good && s[i].radiusMm >= 0.0 && (i == 0 || s[i].zMm >= s[i - 1].zMm);
  if (!good)
    throw base::Error(base::ErrorCode::UnusableInput, "the head's sections do not rise from z = 0",
                      where);
}
} // namespace

HeadShape erodedHead(const HeadShape& head, double toleranceMm) {
  HeadShape eroded = head;
  for (HeadSection& s : eroded.sections) {
    s.zMm += toleranceMm;
    s.radiusMm = std::max(0.0, s.radiusMm - toleranceMm);
  }
  return eroded;
}

Process readProcess(const std::filesystem::path& file) {
  const std::string where = file.string();
  Process p;
  try {
    const json j = json::parse(base::readFile(file));
    p.id = j.at("id").get<std::string>();
    p.label = j.at("label").get<std::string>();
    p.nozzleDiameterMm = j.at("nozzleDiameterMm").get<double>();
    const json& height = j.at("layerHeightMm");
    p.layerHeightMm = height.at("default").get<double>();
    p.layerHeightMinMm = height.at("min").get<double>();
    p.layerHeightMaxMm = height.at("max").get<double>();
    const json& width = j.at("beadWidthMm");
    p.beadWidthMm = width.at("default").get<double>();
    p.beadWidthMinMm = width.at("min").get<double>();
    p.beadWidthMaxMm = width.at("max").get<double>();
    p.stepMm = j.at("stepMm").get<double>();
    p.speedMmPerS = j.at("speedMmPerS").get<double>();
    p.travelSpeedMmPerS = j.at("travelSpeedMmPerS").get<double>();
    p.accelerationMmPerS2 = j.at("accelerationMmPerS2").get<double>();
    p.contactToleranceMm = j.at("contactToleranceMm").get<double>();
    p.maxFlowMm3PerS = j.at("maxFlowMm3PerS").get<double>();
    p.primeS = j.at("primeS").get<double>();
    p.material = j.at("material").get<std::string>();
    p.densityGPerCm3 = j.at("densityGPerCm3").get<double>();
    for (const json& section : j.at("head"))
      p.head.sections.push_back({section.at(0).get<double>(), section.at(1).get<double>()});
  } catch (const json::exception& e) {
    throw base::Error(base::ErrorCode::UnusableInput,
                      std::string("not a process description: ") + e.what(), where);
  }
  checkHead(p.head, where);
  return p;
}

std::vector<std::string> processIds() {
  return base::dataFileIds("processes");
}

Process loadProcess(const std::string& id) {
  return readProcess(base::dataFile("processes", id, "process"));
}

} // namespace voluta::process
