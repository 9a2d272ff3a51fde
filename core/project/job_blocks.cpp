#include "project/job_blocks.h"

#include "plan/marks.h"
#include "project/block_portions.h"
#include "project/event_blocks.h"
#include "project/named_tools.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <type_traits>
#include <utility>

namespace voluta::project {

namespace {
using Json = nlohmann::ordered_json;

// Number of columns per row.
constexpr std::size_t kPathColumns = 7, kPieceColumns = 4, kPlaneColumns = 4;

// T: numbers or points.
template <typename T> bool allFinite(const std::vector<T>& values) {
  return std::all_of(values.begin(), values.end(), [](const T& value) {
    if constexpr (std::is_arithmetic_v<T>)
      return std::isfinite(value);
    else
      return value.allFinite();
  });
}

bool soundMesh(const geometry::TriangleMesh& mesh) {
  if (!allFinite(mesh.vertices))
    return false;
  for (const auto& triangle : mesh.triangles)
    for (const int v : triangle)
      if (v < 0 || static_cast<std::size_t>(v) >= mesh.vertices.size())
        return false;
  return true;
}

bool soundDecomposition(const curved::Decomposition& d) {
  const Eigen::Vector3i n = d.grid.size;
  constexpr int kMaxCells = 1 << 20; // per side
  if (n.minCoeff() < 0 || n.maxCoeff() > kMaxCells || !d.grid.origin.allFinite() ||
      !std::isfinite(d.grid.pitch) || d.grid.pitch <= 0.0 || !allFinite(d.platform))
    return false;
  const std::size_t cells = d.grid.cellCount();
  const auto sound = [&](const auto& array) { return array.empty() || array.size() == cells; };
  return d.rank.size() == cells && d.frontNormal.size() == cells && sound(d.loss) &&
         sound(d.field) && sound(d.byHead) && sound(d.support) &&
         std::all_of(d.loss.begin(), d.loss.end(),
                     [](curved::Loss loss) { return loss <= curved::Loss::Cascade; });
}

bool soundPieces(const planar::PlanarDecomposition& d) {
  const auto count = static_cast<int>(d.pieces.size());
  return std::all_of(d.pieces.begin(), d.pieces.end(), [&](const planar::Piece& piece) {
    return !piece.solid.mesh.empty() && soundMesh(piece.solid.mesh) && piece.parent >= -1 &&
           piece.parent < count && std::isfinite(piece.base.offsetMm) &&
           piece.base.normal.allFinite();
  });
}

bool soundTrajectory(const plan::Trajectory& t, const plan::ToolPlan* toolPlan) {
  const std::size_t n = t.pointCount();
  if (t.dof <= 0 || t.joints.size() != n * static_cast<std::size_t>(t.dof) || t.move.size() != n ||
      t.waypoint.size() != n || t.extrudedMm3.size() != n || !allFinite(t.joints) ||
      !allFinite(t.timeS))
    return false;
  return std::all_of(t.move.begin(), t.move.end(),
                     [](plan::MoveKind kind) { return kind <= plan::MoveKind::Wipe; }) &&
         std::ranges::is_sorted(t.events, {}, &plan::TrajectoryEvent::point) &&
         std::ranges::all_of(t.events,
                             [&](const plan::TrajectoryEvent& e) {
                               const bool mayEnd = e.kind == plan::EventKind::Mark;
                               // A rest states its outputs before its first motion.
                               const bool mayBegin = e.kind == plan::EventKind::Output;
                               return (e.point > 0 || mayBegin) &&
                                      (e.point < n || (mayEnd && e.point == n)) && e.tool >= 0 &&
                                      (!mayEnd || e.tool < plan::kMarkLinks) &&
                                      std::isfinite(e.feedMm) && e.kind <= plan::kLastEventKind &&
                                      std::isfinite(e.seconds) && e.seconds >= 0.0 &&
                                      std::isfinite(e.volumeMm3) && e.volumeMm3 >= 0.0;
                             }) &&
         std::all_of(t.waypoint.begin(), t.waypoint.end(), [&](std::size_t w) {
           return w == plan::kNoWaypoint || (toolPlan && w < toolPlan->waypointCount());
         });
}

bool holdsWhatItReached(const Job& job) {
  std::size_t left = job.report.findings.size();
  for (const StageRecord& record : job.stages) {
    if (record.findings > left)
      return false;
    left -= record.findings;
  }
  const auto reached = [&](Stage stage) { return job.reached && *job.reached >= stage; };
  const auto all = [&](auto JobItem::*result) {
    return std::ranges::all_of(job.items,
                               [&](const JobItem& item) { return item.*result != nullptr; });
  };
  return (!reached(Stage::Load) || all(&JobItem::part)) &&
         (!reached(Stage::Layers) || all(&JobItem::layers)) &&
         (!reached(Stage::Toolpath) || job.toolPlan) && (!reached(Stage::Replay) || job.trajectory);
}
} // namespace

void addMesh(BlockWriter& out, const std::string& name, const geometry::TriangleMesh& mesh) {
  out.add(name + ".vertices", mesh.vertices);
  out.add(name + ".triangles", mesh.triangles);
}

bool hasMesh(const BlockReader& in, const std::string& name) {
  return in.has(name + ".vertices");
}

geometry::TriangleMesh getMesh(const BlockReader& in, const std::string& name) {
  geometry::TriangleMesh mesh;
  mesh.vertices = in.get<Eigen::Vector3d>(name + ".vertices");
  mesh.triangles = in.get<std::array<int, 3>>(name + ".triangles");
  if (!soundMesh(mesh))
    contradiction("triangles with missing vertices"_text);
  return mesh;
}

void addDecomposition(BlockWriter& out, const curved::Decomposition& d) {
  const Eigen::Vector3d& o = d.grid.origin;
  const Eigen::Vector3i& n = d.grid.size;
  out.addText("decomposition", Json{{"origin", {o.x(), o.y(), o.z()}},
                                    {"pitch", d.grid.pitch},
                                    {"size", {n.x(), n.y(), n.z()}},
                                    {"epsilonMm", d.epsilonMm},
                                    {"growth", d.growth},
                                    {"voxels", d.voxels},
                                    {"layers", d.layers},
                                    {"missed", d.missedVoxels},
                                    {"shadowed", d.shadowedVoxels},
                                    {"unreached", d.unreachedVoxels},
                                    {"cascade", d.cascadeVoxels},
                                    {"byHead", d.headVoxels},
                                    {"support", d.supportVoxels},
                                    {"peelS", d.seconds.peel},
                                    {"growS", d.seconds.grow},
                                    {"smoothS", d.seconds.smooth}}
                                   .dump());
  out.add("decomposition.rank", d.rank);
  out.add("decomposition.field", d.field);
  out.add("decomposition.frontNormal", d.frontNormal);
  out.add("decomposition.platform", d.platform);
  out.add("decomposition.loss", d.loss);
  out.add("decomposition.byHead", d.byHead);
  out.add("decomposition.support", d.support);
}

curved::Decomposition getDecomposition(const BlockReader& in) {
  curved::Decomposition d;
  const Json j = Json::parse(in.text("decomposition"));
  const Json &o = j.at("origin"), &n = j.at("size");
  for (int axis = 0; axis < 3; ++axis) {
    o.at(static_cast<std::size_t>(axis)).get_to(d.grid.origin[axis]);
    n.at(static_cast<std::size_t>(axis)).get_to(d.grid.size[axis]);
  }
  j.at("pitch").get_to(d.grid.pitch);
  j.at("epsilonMm").get_to(d.epsilonMm);
  j.at("growth").get_to(d.growth);
  j.at("voxels").get_to(d.voxels);
  j.at("layers").get_to(d.layers);
  j.at("missed").get_to(d.missedVoxels);
  j.at("shadowed").get_to(d.shadowedVoxels);
  j.at("unreached").get_to(d.unreachedVoxels);
  j.at("peelS").get_to(d.seconds.peel);
  j.at("growS").get_to(d.seconds.grow);
  j.at("smoothS").get_to(d.seconds.smooth);
  d.rank = in.get<std::int32_t>("decomposition.rank");
  d.field = in.get<float>("decomposition.field");
  d.frontNormal = in.get<Eigen::Vector3f>("decomposition.frontNormal");
  d.platform = in.get<Eigen::Vector2d>("decomposition.platform");
  // Older projects lack these.
  d.cascadeVoxels = j.value("cascade", std::size_t{0});
  d.headVoxels = j.value("byHead", std::size_t{0});
  d.supportVoxels = j.value("support", std::size_t{0});
  if (in.has("decomposition.loss"))
    d.loss = in.get<curved::Loss>("decomposition.loss");
  if (in.has("decomposition.byHead"))
    d.byHead = in.get<std::uint8_t>("decomposition.byHead");
  if (in.has("decomposition.support"))
    d.support = in.get<std::uint8_t>("decomposition.support");
  return d;
}

void addPieces(BlockWriter& out, const planar::PlanarDecomposition& d) {
  out.addText("pieces", Json{{"riskyBeforeMm2", d.riskyBeforeMm2},
                             {"riskyMm2", d.riskyMm2},
                             {"sectionMm2", d.sectionMm2},
                             {"blocked", d.blockedPieces},
                             {"searchS", d.seconds.search},
                             {"cutS", d.seconds.cut}}
                            .dump());
  std::vector<std::int64_t> rows;
  std::vector<double> bases;
  for (const planar::Piece& piece : d.pieces) {
    rows.insert(rows.end(), {static_cast<std::int64_t>(piece.solid.mesh.vertices.size()),
                             static_cast<std::int64_t>(piece.solid.mesh.triangles.size()),
                             piece.baseTag, piece.parent});
    const Eigen::Vector3d& n = piece.base.normal;
    bases.insert(bases.end(), {n.x(), n.y(), n.z(), piece.base.offsetMm});
  }
  out.addOwned("pieces.rows", rows);
  out.addOwned("pieces.bases", bases);
  out.begin("pieces.vertices", sizeof(Eigen::Vector3d));
  for (const planar::Piece& piece : d.pieces)
    out.append(piece.solid.mesh.vertices);
  out.begin("pieces.triangles", sizeof(std::array<int, 3>));
  for (const planar::Piece& piece : d.pieces)
    out.append(piece.solid.mesh.triangles);
  out.begin("pieces.tags", sizeof(std::int32_t));
  for (const planar::Piece& piece : d.pieces)
    out.append(piece.solid.tag);
}

planar::PlanarDecomposition getPieces(const BlockReader& in) {
  planar::PlanarDecomposition d;
  const Json j = Json::parse(in.text("pieces"));
  j.at("riskyBeforeMm2").get_to(d.riskyBeforeMm2);
  j.at("riskyMm2").get_to(d.riskyMm2);
  j.at("sectionMm2").get_to(d.sectionMm2);
  j.at("blocked").get_to(d.blockedPieces);
  j.at("searchS").get_to(d.seconds.search);
  j.at("cutS").get_to(d.seconds.cut);
  const auto rows = in.get<std::int64_t>("pieces.rows");
  const auto bases = in.get<double>("pieces.bases");
  const std::size_t count = rows.size() / kPieceColumns;
  if (rows.size() != count * kPieceColumns || bases.size() != count * kPlaneColumns)
    contradiction("size of the table of pieces"_text);
  Portions vertices(in.get<Eigen::Vector3d>("pieces.vertices"));
  Portions triangles(in.get<std::array<int, 3>>("pieces.triangles"));
  Portions tags(in.get<std::int32_t>("pieces.tags"));
  for (std::size_t i = 0; i < count; ++i) {
    const std::int64_t* row = &rows[i * kPieceColumns];
    const double* base = &bases[i * kPlaneColumns];
    planar::Piece piece;
    piece.solid.mesh.vertices = vertices.next(row[0]);
    piece.solid.mesh.triangles = triangles.next(row[1]);
    piece.solid.tag = tags.next(row[1]);
    piece.baseTag = static_cast<std::int32_t>(row[2]);
    piece.parent = static_cast<int>(row[3]);
    piece.base.normal = {base[0], base[1], base[2]};
    piece.base.offsetMm = base[3];
    d.pieces.push_back(std::move(piece));
  }
  return d;
}

namespace {
std::string meshOfInsert(const std::string& name, std::size_t insert) {
  return name + "." + std::to_string(insert);
}

// Plans without inserts need no block.
void addInserts(BlockWriter& out, const std::vector<plan::Insert>& inserts,
                const std::string& name) {
  if (inserts.empty())
    return;
  Json rows = Json::array();
  for (std::size_t i = 0; i < inserts.size(); ++i) {
    const plan::Insert& insert = inserts[i];
    rows.push_back({{"name", insert.name}, {"item", insert.item}, {"layer", insert.layer}});
    addMesh(out, meshOfInsert(name, i), *insert.body);
  }
  out.addText(name, rows.dump(-1, ' ', false, Json::error_handler_t::replace));
}

std::vector<plan::Insert> getInserts(const BlockReader& in, const std::string& name) {
  std::vector<plan::Insert> inserts;
  if (!in.has(name))
    return inserts;
  for (const Json& row : Json::parse(in.text(name)))
    inserts.push_back({row.at("name").get<std::string>(), row.at("item").get<int>(),
                       row.at("layer").get<int>(),
                       std::make_shared<const geometry::TriangleMesh>(
                           getMesh(in, meshOfInsert(name, inserts.size())))});
  return inserts;
}
} // namespace

void addToolPlan(BlockWriter& out, const plan::ToolPlan& p, const std::string& name) {
  out.add(name + ".position", p.position);
  out.add(name + ".direction", p.direction);
  out.add(name + ".width", p.widthMm);
  out.add(name + ".height", p.heightMm);
  out.add(name + ".speed", p.speedMmPerS);
  std::vector<std::int64_t> rows;
  for (const plan::ToolPath& path : p.paths)
    rows.insert(rows.end(),
                {static_cast<std::int64_t>(path.first), static_cast<std::int64_t>(path.count),
                 static_cast<std::int64_t>(path.kind), path.layer, path.patch, path.group,
                 path.closed ? 1 : 0});
  out.addOwned(name + ".paths", rows);
  // Jobs of one item and one tool need no block.
  std::vector<std::int32_t> owners;
  for (const plan::ToolPath& path : p.paths)
    owners.insert(owners.end(), {path.item, path.tool});
  if (std::ranges::any_of(owners, [](std::int32_t owner) { return owner != 0; }))
    out.addOwned(name + ".owners", owners);
  if (!p.isSolid()) { // Solid plans need no block
    std::vector<double> fill;
    for (const plan::FillIntent& item : p.fill)
      fill.insert(fill.end(), {item.shellMm, item.openMm3});
    out.addOwned(name + ".fill", fill);
  }
  std::vector<std::int32_t> rings;
  for (const plan::ToolPath& path : p.paths)
    rings.push_back(path.ring);
  if (std::ranges::any_of(rings, [](std::int32_t ring) { return ring != 0; }))
    out.addOwned(name + ".rings", rings);
  addInserts(out, p.inserts, name + ".inserts");
}

plan::ToolPlan getToolPlan(const BlockReader& in, const std::string& name) {
  plan::ToolPlan p;
  p.position = in.get<Eigen::Vector3d>(name + ".position");
  p.direction = in.get<Eigen::Vector3d>(name + ".direction");
  p.widthMm = in.get<float>(name + ".width");
  p.heightMm = in.get<float>(name + ".height");
  p.speedMmPerS = in.get<float>(name + ".speed");
  const std::vector<std::int64_t> rows = in.get<std::int64_t>(name + ".paths");
  for (std::size_t i = 0; i + kPathColumns <= rows.size(); i += kPathColumns) {
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
  if (in.has(name + ".owners")) {
    const std::vector<std::int32_t> owners = in.get<std::int32_t>(name + ".owners");
    for (std::size_t k = 0; k < p.paths.size() && 2 * k + 1 < owners.size(); ++k) {
      p.paths[k].item = owners[2 * k];
      p.paths[k].tool = owners[2 * k + 1];
    }
  }
  if (in.has(name + ".fill")) {
    const std::vector<double> fill = in.get<double>(name + ".fill");
    for (std::size_t i = 0; i + 1 < fill.size(); i += 2)
      p.fill.push_back({fill[i], fill[i + 1]});
  }
  // Older files have no rings.
  if (in.has(name + ".rings")) {
    const std::vector<std::int32_t> rings = in.get<std::int32_t>(name + ".rings");
    for (std::size_t k = 0; k < p.paths.size() && k < rings.size(); ++k)
      p.paths[k].ring = rings[k];
  }
  p.inserts = getInserts(in, name + ".inserts");
  return p;
}

void addTrajectory(BlockWriter& out, const plan::Trajectory& t) {
  out.add("trajectory.joints", t.joints);
  out.add("trajectory.time", t.timeS);
  std::vector<std::uint8_t> move;
  const std::vector<std::uint64_t> waypoint(t.waypoint.begin(), t.waypoint.end());
  for (const plan::MoveKind kind : t.move)
    move.push_back(static_cast<std::uint8_t>(kind));
  out.addOwned("trajectory.move", move);
  out.addOwned("trajectory.waypoint", waypoint);
  out.add("trajectory.extruded", t.extrudedMm3);
  if (t.firstTool != 0)
    out.addOwned("trajectory.firstTool", std::vector<std::int32_t>{t.firstTool});
  addEvents(out, t.events);
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
  if (in.has("trajectory.firstTool")) {
    const auto first = in.get<std::int32_t>("trajectory.firstTool");
    if (first.size() != 1 || first.front() < 0)
      contradiction("a motion that begins with no tool"_text);
    t.firstTool = first.front();
  }
  auto events = getEvents(in);
  if (!events)
    contradiction("events of unequal number"_text);
  t.events = std::move(*events);
  return t;
}

void addPlatform(BlockWriter& out, const platform::PlatformSolid& platform) {
  out.add("platform", platform.polygon);
  if (platform.rod) {
    out.add("platform.rod", platform.rod->profile);
    out.addText("platform.rodSides", std::to_string(platform.rod->sides));
  }
  if (platform.mesh)
    addMesh(out, "platform.mesh", *platform.mesh);
}

platform::PlatformSolid getPlatform(const BlockReader& in) {
  platform::PlatformSolid platform(in.get<Eigen::Vector2d>("platform"));
  if (in.has("platform.rod")) {
    platform.rod = {in.get<Eigen::Vector2d>("platform.rod"),
                    Json::parse(in.text("platform.rodSides")).get<int>()};
    platform::checkRod(*platform.rod);
  }
  if (hasMesh(in, "platform.mesh"))
    platform.mesh = std::make_shared<geometry::TriangleMesh>(getMesh(in, "platform.mesh"));
  return platform;
}

bool isSound(const plan::ToolPlan& p) {
  if (std::ranges::any_of(p.inserts,
                          [](const plan::Insert& insert) { return insert.body->empty(); }))
    return false;
  const std::size_t n = p.waypointCount();
  if (p.direction.size() != n || p.widthMm.size() != n || p.heightMm.size() != n ||
      p.speedMmPerS.size() != n || !allFinite(p.position) || !allFinite(p.direction) ||
      !std::ranges::all_of(p.fill, [](const plan::FillIntent& fill) {
        return fill.shellMm >= 0.0 && fill.openMm3 >= 0.0 && std::isfinite(fill.openMm3);
      }))
    return false;
  return std::all_of(p.paths.begin(), p.paths.end(), [&](const plan::ToolPath& path) {
    return path.first <= n && path.count <= n - path.first && path.kind <= plan::PathKind::Shot &&
           path.item >= 0 && path.tool >= 0 && path.ring >= 0;
  });
}

namespace {
bool isSoundItem(const JobItem& item, const ItemChoices& choices) {
  const auto regions = std::ssize(choices.regions);
  if (!allFinite(item.platform.polygon))
    return false;
  if (const Voxels voxels = item.decomposition(); voxels && !soundDecomposition(*voxels))
    return false;
  if (const Pieces pieces = item.pieces(); pieces && !soundPieces(*pieces))
    return false;
  return !item.layers || std::ranges::all_of(item.layers->patches, [&](const layers::Patch& patch) {
    return soundMesh(patch.surface) && allFinite(patch.chart.at) && patch.tool >= 0 &&
           patch.region >= 0 && patch.region <= regions;
  });
}
} // namespace

bool isConsistent(const Job& job) {
  if (job.items.size() != job.choices.items.size() || job.items.size() != job.report.items.size() ||
      (job.toolPlan && !isSound(*job.toolPlan)))
    return false;
  for (std::size_t i = 0; i < job.items.size(); ++i)
    if (!isSoundItem(job.item(i), job.choices.item(i)))
      return false;
  if (job.trajectory && !soundTrajectory(*job.trajectory, job.toolPlan.get()))
    return false;
  if (job.resumedAt > 0 && (!job.trajectory || job.resumedAt >= job.trajectory->pointCount()))
    return false;
  return namesKnownOnes(job) && holdsWhatItReached(job);
}

} // namespace voluta::project
