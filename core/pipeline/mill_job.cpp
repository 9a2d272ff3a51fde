#include "pipeline/mill_job.h"

#include "base/json_node.h"
#include "program/gcode/gcode_milling.h"

#include <array>
#include <nlohmann/json.hpp>
#include <utility>

namespace voluta::pipeline {

namespace {
using Json = nlohmann::ordered_json;
using base::JsonNode;

constexpr std::string_view kFormat = "voluta milling 1";

// The lengths of a rule, by their keys.
constexpr std::array<std::pair<const char*, double milling::MillRule::*>, 9> kLengths{
    {{"lineMm", &milling::MillRule::lineMm},
     {"roughingMm", &milling::MillRule::roughingMm},
     {"acrossMm", &milling::MillRule::acrossMm},
     {"alongMm", &milling::MillRule::alongMm},
     {"skinMm", &milling::MillRule::skinMm},
     {"clearanceMm", &milling::MillRule::clearanceMm},
     {"webMm", &milling::MillRule::webMm},
     {"stripMm", &milling::MillRule::stripMm},
     {"pitchMm", &milling::MillRule::pitchMm}}};

std::array<JsonNode, 3> threeOf(const JsonNode& node) {
  const std::vector<JsonNode> items = node.items();
  if (items.size() != 3)
    node.fail("does not have three numbers"_text);
  return {items[0], items[1], items[2]};
}

geometry::TriangleMesh meshOf(const JsonNode& node) {
  geometry::TriangleMesh mesh;
  for (const JsonNode& vertex : node.at("vertices").items()) {
    const auto [x, y, z] = threeOf(vertex);
    mesh.vertices.emplace_back(x.number(), y.number(), z.number());
  }
  for (const JsonNode& triangle : node.at("triangles").items()) {
    std::array<int, 3> corners{};
    const std::array<JsonNode, 3> numbers = threeOf(triangle);
    for (std::size_t k = 0; k < 3; ++k) {
      corners[k] = numbers[k].integer();
      if (corners[k] < 0 || static_cast<std::size_t>(corners[k]) >= mesh.vertices.size())
        triangle.fail("refers to a missing vertex"_text);
    }
    mesh.triangles.push_back(corners);
  }
  if (mesh.triangles.empty())
    node.fail("has no triangles"_text);
  return mesh;
}
} // namespace

std::string writeMillJob(const geometry::TriangleMesh& part, const MillOrder& order) {
  const milling::MillRule& rule = order.rule;
  Json job{{"format", kFormat},
           {"name", order.name},
           {"material", rule.data.id},
           {"cutterMm", rule.cutter.diameterMm},
           {"teeth", rule.cutter.teeth}};
  for (const auto& [key, length] : kLengths)
    job[key] = rule.*length;
  Json vertices = Json::array(), triangles = Json::array();
  for (const Eigen::Vector3d& v : part.vertices)
    vertices.push_back({v.x(), v.y(), v.z()});
  for (const auto& t : part.triangles)
    triangles.push_back({t[0], t[1], t[2]});
  job["part"] = {{"vertices", std::move(vertices)}, {"triangles", std::move(triangles)}};
  return job.dump() + "\n";
}

bool isMillJob(std::string_view text) {
  return text.starts_with("{\"format\":\"" + std::string(kFormat) + "\"");
}

MillJob readMillJob(std::string_view text, const std::string& file) {
  const JsonNode node = JsonNode::parse(text, file);
  MillJob job;
  if (node.at("format").text() != kFormat)
    node.at("format").fail("is another version"_text);
  job.order.name = node.at("name").text();
  job.order.layDown = false;
  const milling::CuttingData* data = milling::cuttingDataFor(node.at("material").text());
  if (!data)
    node.at("material").fail("is unknown"_text);
  job.order.rule.data = *data;
  job.order.rule.cutter = {node.at("cutterMm").positive(), node.at("teeth").integer()};
  for (const auto& [key, length] : kLengths)
    job.order.rule.*length = node.at(key).notNegative();
  job.part = meshOf(node.at("part"));
  return job;
}

milling::CutVerdict verifyMilling(std::string_view program, const MillJob& job,
                                  const base::RunContext& ctx) {
  const milling::MillPlan plan = milling::planMilling(job.part, job.order.rule, ctx.sub(0.0, 0.6));
  return milling::judgeCuts(program::readMillingGcode(program), plan, job.order.rule,
                            ctx.sub(0.6, 1.0));
}

} // namespace voluta::pipeline
