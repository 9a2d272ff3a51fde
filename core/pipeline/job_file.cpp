#include "base/error.h"
#include "base/files.h"
#include "pipeline/job.h"

#include <boost/crc.hpp>
#include <cstring>
#include <nlohmann/json.hpp>
#include <type_traits>

namespace voluta::pipeline {

namespace {
using Json = nlohmann::ordered_json;

constexpr std::string_view kMagic = "VOLUTA 1\n";
static_assert(sizeof(Eigen::Vector3d) == 3 * sizeof(double));
static_assert(sizeof(Eigen::Vector2d) == 2 * sizeof(double));

std::uint32_t crcOf(std::string_view bytes) {
  boost::crc_32_type crc;
  crc.process_bytes(bytes.data(), bytes.size());
  return crc.checksum();
}

// Collects blocks; each becomes one row of the header's table.
class BlockWriter {
public:
  template <typename T> void add(const std::string& name, const std::vector<T>& values) {
    static_assert(std::is_trivially_copyable_v<T> || std::is_same_v<T, Eigen::Vector3d> ||
                  std::is_same_v<T, Eigen::Vector2d>);
    const std::string_view bytes(reinterpret_cast<const char*>(values.data()),
                                 values.size() * sizeof(T));
    table_.push_back(Json{{"name", name},
                          {"offset", bytes_.size()},
                          {"bytes", bytes.size()},
                          {"item", sizeof(T)},
                          {"crc32", crcOf(bytes)}});
    bytes_.append(bytes);
  }
  const Json& table() const { return table_; }
  const std::string& bytes() const { return bytes_; }

private:
  Json table_ = Json::array();
  std::string bytes_;
};

class BlockReader {
public:
  BlockReader(std::string where, const Json& table, std::string_view bytes)
      : where_(std::move(where)), table_(table), bytes_(bytes) {}

  template <typename T> std::vector<T> get(const std::string& name) const {
    for (const Json& row : table_) {
      if (row.at("name") != name)
        continue;
      const auto offset = row.at("offset").get<std::size_t>();
      const auto length = row.at("bytes").get<std::size_t>();
      if (offset > bytes_.size() || length > bytes_.size() - offset)
        throw base::Error(base::ErrorCode::UnreadableFile, "the job file is cut short", where_,
                          "plan the part again");
      const std::string_view block = bytes_.substr(offset, length);
      if (row.at("item").get<std::size_t>() != sizeof(T) || length % sizeof(T) != 0 ||
          crcOf(block) != row.at("crc32").get<std::uint32_t>())
        throw base::Error(base::ErrorCode::UnreadableFile,
                          "block '" + name + "' of the job file is damaged", where_,
                          "plan the part again");
      std::vector<T> values(length / sizeof(T));
      std::memcpy(static_cast<void*>(values.data()), block.data(), length);
      return values;
    }
    throw base::Error(base::ErrorCode::UnreadableFile, "the job file lacks '" + name + "'", where_,
                      "plan the part again");
  }

private:
  std::string where_;
  const Json& table_;
  std::string_view bytes_;
};

// Paths are stored as columns, so that the format doesn't depend on the struct's layout.
void addToolPlan(BlockWriter& out, const plan::ToolPlan& p) {
  out.add("plan.position", p.position);
  out.add("plan.direction", p.direction);
  out.add("plan.width", p.widthMm);
  out.add("plan.height", p.heightMm);
  out.add("plan.speed", p.speedMmPerS);
  std::vector<std::int64_t> rows;
  for (const plan::ToolPath& path : p.paths)
    rows.insert(rows.end(),
                {static_cast<std::int64_t>(path.first), static_cast<std::int64_t>(path.count),
                 static_cast<std::int64_t>(path.kind), path.layer, path.patch, path.group,
                 path.closed ? 1 : 0});
  out.add("plan.paths", rows);
}

plan::ToolPlan getToolPlan(const BlockReader& in) {
  plan::ToolPlan p;
  p.position = in.get<Eigen::Vector3d>("plan.position");
  p.direction = in.get<Eigen::Vector3d>("plan.direction");
  p.widthMm = in.get<float>("plan.width");
  p.heightMm = in.get<float>("plan.height");
  p.speedMmPerS = in.get<float>("plan.speed");
  const std::vector<std::int64_t> rows = in.get<std::int64_t>("plan.paths");
  for (std::size_t i = 0; i + 7 <= rows.size(); i += 7) {
    plan::ToolPath path;
    path.first = static_cast<std::size_t>(rows[i]);
    path.count = static_cast<std::size_t>(rows[i + 1]);
    path.kind = static_cast<plan::PathKind>(rows[i + 2]);
    path.layer = static_cast<int>(rows[i + 3]);
    path.patch = static_cast<int>(rows[i + 4]);
    path.group = static_cast<int>(rows[i + 5]);
    path.closed = rows[i + 6] != 0;
    p.paths.push_back(path);
  }
  return p;
}

void addTrajectory(BlockWriter& out, const plan::Trajectory& t) {
  out.add("trajectory.joints", t.joints);
  out.add("trajectory.time", t.timeS);
  std::vector<std::uint8_t> move;
  std::vector<std::uint64_t> waypoint(t.waypoint.begin(), t.waypoint.end());
  for (const plan::MoveKind kind : t.move)
    move.push_back(static_cast<std::uint8_t>(kind));
  out.add("trajectory.move", move);
  out.add("trajectory.waypoint", waypoint);
  out.add("trajectory.extruded", t.extrudedMm3);
}

plan::Trajectory getTrajectory(const BlockReader& in, int dof) {
  plan::Trajectory t;
  t.dof = dof;
  t.joints = in.get<double>("trajectory.joints");
  t.timeS = in.get<double>("trajectory.time");
  for (const std::uint8_t kind : in.get<std::uint8_t>("trajectory.move"))
    t.move.push_back(static_cast<plan::MoveKind>(kind));
  for (const std::uint64_t w : in.get<std::uint64_t>("trajectory.waypoint"))
    t.waypoint.push_back(static_cast<std::size_t>(w));
  t.extrudedMm3 = in.get<double>("trajectory.extruded");
  return t;
}

void requireConsistent(const Job& job, const std::string& where) {
  bool good = true;
  if (const auto& mesh = job.part) {
    for (const auto& triangle : mesh->triangles)
      for (const int v : triangle)
        good = good && v >= 0 && static_cast<std::size_t>(v) < mesh->vertices.size();
  }
  if (job.toolPlan) {
    const plan::ToolPlan& p = *job.toolPlan;
    const std::size_t n = p.waypointCount();
    good = good && p.direction.size() == n && p.widthMm.size() == n && p.heightMm.size() == n &&
           p.speedMmPerS.size() == n;
    for (const plan::ToolPath& path : p.paths)
      good = good && path.first <= n && path.count <= n - path.first;
  }
  if (job.trajectory) {
    const plan::Trajectory& t = *job.trajectory;
    const std::size_t n = t.pointCount();
    good = good && t.dof > 0 && t.joints.size() == n * static_cast<std::size_t>(t.dof) &&
           t.move.size() == n && t.waypoint.size() == n && t.extrudedMm3.size() == n;
    for (const std::size_t w : t.waypoint)
      good =
          good && (w == plan::kNoWaypoint || (job.toolPlan && w < job.toolPlan->waypointCount()));
  }
  if (!good)
    throw base::Error(base::ErrorCode::UnreadableFile, "the job file contradicts itself", where,
                      "plan the part again");
}
} // namespace

std::string jobBytes(const Job& job) {
  base::require(job.part != nullptr, "jobBytes: a job has a part");
  BlockWriter blocks;
  blocks.add("part.vertices", job.part->vertices);
  blocks.add("part.triangles", job.part->triangles);
  blocks.add("platform", job.platform);
  if (job.toolPlan)
    addToolPlan(blocks, *job.toolPlan);
  if (job.trajectory)
    addTrajectory(blocks, *job.trajectory);
  const Choices& c = job.choices;
  const Json header{{"part", job.partName},
                    {"scale", job.scale},
                    {"choices", Json{{"mode", c.mode},
                                     {"growth", c.growth},
                                     {"platform", c.platform},
                                     {"cell", c.cell},
                                     {"process", c.process},
                                     {"scale", c.scale},
                                     {"formats", c.formats},
                                     {"parameters", c.parameters},
                                     {"seed", c.seed}}},
                    {"planned", job.toolPlan != nullptr},
                    {"dof", job.trajectory ? job.trajectory->dof : 0},
                    {"blocks", blocks.table()}};
  const std::string text = header.dump(1);
  return std::string(kMagic) + std::to_string(text.size()) + "\n" + text + blocks.bytes();
}

void writeJob(const std::filesystem::path& file, const Job& job) {
  base::writeFile(file, jobBytes(job));
}

Job readJob(const std::filesystem::path& file) {
  const std::string where = file.string();
  const std::string bytes = base::readFile(file);
  const auto damaged = [&](const std::string& what) {
    return base::Error(base::ErrorCode::UnreadableFile, what, where);
  };
  if (bytes.compare(0, 7, "VOLUTA ") != 0)
    throw damaged("not a Voluta job");
  if (bytes.compare(0, kMagic.size(), kMagic) != 0)
    throw damaged("a job of another version of Voluta");
  const std::size_t lineEnd = bytes.find('\n', kMagic.size());
  if (lineEnd == std::string::npos || lineEnd - kMagic.size() > 12)
    throw damaged("the job file is cut short");
  Job job;
  try {
    const std::size_t length = std::stoul(bytes.substr(kMagic.size(), lineEnd - kMagic.size()));
    if (length > bytes.size() - lineEnd - 1)
      throw damaged("the job file is cut short");
    const std::string_view all = bytes;
    const Json header = Json::parse(all.substr(lineEnd + 1, length));
    const Json& c = header.at("choices");
    job.partName = header.at("part").get<std::string>();
    job.scale = header.at("scale").get<double>();
    c.at("mode").get_to(job.choices.mode);
    c.at("growth").get_to(job.choices.growth);
    c.at("platform").get_to(job.choices.platform);
    c.at("cell").get_to(job.choices.cell);
    c.at("process").get_to(job.choices.process);
    c.at("scale").get_to(job.choices.scale);
    c.at("formats").get_to(job.choices.formats);
    c.at("parameters").get_to(job.choices.parameters);
    c.at("seed").get_to(job.choices.seed);
    const BlockReader blocks(where, header.at("blocks"), all.substr(lineEnd + 1 + length));
    geometry::TriangleMesh mesh;
    mesh.vertices = blocks.get<Eigen::Vector3d>("part.vertices");
    mesh.triangles = blocks.get<std::array<int, 3>>("part.triangles");
    job.part = std::make_shared<geometry::TriangleMesh>(std::move(mesh));
    job.platform = blocks.get<Eigen::Vector2d>("platform");
    if (header.at("planned").get<bool>())
      job.toolPlan = std::make_shared<plan::ToolPlan>(getToolPlan(blocks));
    if (const int dof = header.at("dof").get<int>(); dof > 0)
      job.trajectory = std::make_shared<plan::Trajectory>(getTrajectory(blocks, dof));
  } catch (const nlohmann::json::exception& e) {
    throw damaged(std::string("the job file's header is damaged: ") + e.what());
  } catch (const std::logic_error&) {
    throw damaged("the job file's header is damaged");
  }
  requireConsistent(job, where);
  return job;
}

} // namespace voluta::pipeline
