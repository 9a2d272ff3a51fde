#include "base/error.h"
#include "base/files.h"
#include "base/number_list.h"
#include "base/parameters.h"
#include "geometry/repair/diagnosis.h"
#include "geometry/repair/open_surface.h"
#include "project/block_file.h"
#include "project/content_hash.h"
#include "project/file_frame.h"
#include "project/job.h"
#include "project/job_blocks.h"
#include "project/job_magic.h"
#include "project/loaded_part.h"
#include "project/message_json.h"
#include "project/report_fields.h"
#include "voxel/voxel_text.h"

#include <cmath>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace voluta::project {

namespace {
using Json = nlohmann::ordered_json;

constexpr int kFormat = 3;
constexpr int kScopeless = 2; // settings of the job are stored with each item
constexpr FileNames kNames{kJobMagic, "not a Voluta job"_text, "the job file is truncated"_text,
                           "the job file's header is damaged"_text};

base::Error unreadable(const base::Message& what, const std::string& where,
                       const base::Message& remedy = {}) {
  return base::Error(base::ErrorCode::UnreadableFile, what, where, remedy);
}

// ---- choices

Json placementJson(const geometry::Placement& p) {
  return Json{{"rotation", {p.rotation.w(), p.rotation.x(), p.rotation.y(), p.rotation.z()}},
              {"centreMm", {p.centreMm.x(), p.centreMm.y()}},
              {"liftMm", p.liftMm}};
}

geometry::Placement readPlacement(const Json& j) {
  const Json &q = j.at("rotation"), &centre = j.at("centreMm");
  geometry::Placement p;
  p.rotation = Eigen::Quaterniond(q.at(0).get<double>(), q.at(1).get<double>(),
                                  q.at(2).get<double>(), q.at(3).get<double>());
  p.centreMm = {centre.at(0).get<double>(), centre.at(1).get<double>()};
  j.at("liftMm").get_to(p.liftMm);
  return p;
}

// The mesh of a region is in blocks.
Json regionJson(const Region& region) {
  Json j{{"shape", region.shape}, {"use", region.use}, {"parameters", region.parameters}};
  if (!region.name.empty())
    j["name"] = region.name;
  if (region.mesh)
    j["mesh"] = true;
  return j;
}

Json itemJson(const ItemChoices& c) {
  Json j{{"automatic", c.automatic},
         {"platformStays", c.platformStays},
         {"automaticWay", c.automaticStrategy},
         {"mode", c.mode},
         {"growth", c.growth.id()},
         {"platform", c.platform.text()},
         {"scale", c.scale},
         {"units", c.units},
         {"placement", placementJson(c.placement)},
         {"repair", c.repair},
         {"parameters", c.parameters}};
  for (const Region& region : c.regions)
    j["regions"].push_back(regionJson(region));
  return j;
}

// The first item and the first tool at the top, as in projects that had one of each only.
Json choicesJson(const Choices& c) {
  Json j = itemJson(c.item());
  j["cell"] = c.cell;
  j["process"] = c.tool().process;
  j["formats"] = c.formats;
  j["seed"] = c.seed;
  j["jobParameters"] = c.parameters;
  if (c.printOrder == layers::PrintOrder::ByLayer)
    j["printOrder"] = "byLayer";
  if (c.preset != Choices().preset)
    j["preset"] = c.preset;
  for (std::size_t i = 1; i < c.items.size(); ++i)
    j["moreItems"].push_back(itemJson(c.item(i)));
  for (std::size_t i = 1; i < c.tools.size(); ++i)
    j["moreTools"].push_back(Json{{"process", c.tool(i).process}});
  return j;
}

ItemChoices readItem(const Json& j) {
  ItemChoices c;
  c.automatic = j.value("automatic", false);
  c.platformStays = j.value("platformStays", false);
  // Older versions stored an index into a list that has changed since.
  if (const auto strategy = j.find("automaticWay"); strategy != j.end() && strategy->is_string())
    strategy->get_to(c.automaticStrategy);
  j.at("mode").get_to(c.mode);
  c.growth = curved::GrowthScheme(j.at("growth").get<std::string>());
  c.platform = Platform(j.at("platform").get<std::string>());
  j.at("scale").get_to(c.scale);
  c.units = j.value("units", c.units);
  j.at("parameters").get_to(c.parameters);
  c.placement = readPlacement(j.at("placement"));
  j.at("repair").get_to(c.repair);
  for (const Json& region : j.value("regions", Json::array()))
    c.regions.push_back(
        {.name = region.value("name", ""),
         .shape = region.at("shape").get<std::string>(),
         .use = region.at("use").get<std::string>(),
         .parameters = region.at("parameters").get<std::map<std::string, std::string>>()});
  return c;
}

std::string regionBlock(std::size_t region) {
  return fmt::format("region{}", region);
}

void addRegionMeshes(BlockWriter& blocks, const ItemChoices& item) {
  for (std::size_t i = 0; i < item.regions.size(); ++i)
    if (item.regions[i].mesh)
      addMesh(blocks, regionBlock(i), *item.regions[i].mesh);
}

void readRegionMeshes(const BlockReader& blocks, ItemChoices& item) {
  for (std::size_t i = 0; i < item.regions.size(); ++i)
    if (hasMesh(blocks, regionBlock(i)))
      item.regions[i].mesh =
          std::make_shared<geometry::TriangleMesh>(getMesh(blocks, regionBlock(i)));
}

Choices readChoices(const Json& j) {
  Choices c;
  c.item() = readItem(j);
  j.at("cell").get_to(c.cell);
  j.at("process").get_to(c.tool().process);
  j.at("formats").get_to(c.formats);
  j.at("seed").get_to(c.seed);
  if (const auto given = j.find("jobParameters"); given != j.end())
    given->get_to(c.parameters);
  if (j.value("printOrder", "") == "byLayer")
    c.printOrder = layers::PrintOrder::ByLayer;
  c.preset = j.value("preset", c.preset);
  for (const Json& item : j.value("moreItems", Json::array()))
    c.items.push_back(readItem(item));
  for (const Json& tool : j.value("moreTools", Json::array()))
    c.tools.push_back({tool.at("process").get<std::string>()});
  return c;
}

// Renames the parameters whose keys were renamed, and removes those that no longer exist. A value
// of the current key stays. Returns a note about each.
std::vector<base::Message> updateKeys(std::map<std::string, std::string>& parameters) {
  std::vector<base::Message> notes;
  for (const base::RenamedKey& renamed : base::renamedKeys()) {
    auto found = parameters.extract(std::string(renamed.oldKey));
    if (found.empty())
      continue;
    found.key() = renamed.key;
    parameters.insert(std::move(found));
    notes.push_back(base::renamedNote(renamed.oldKey));
  }
  for (const std::string_view key : base::droppedKeys())
    if (parameters.erase(std::string(key)) > 0)
      notes.push_back(base::droppedNote(key));
  return notes;
}

void addNotes(const std::vector<base::Message>& added, JobItem& item) {
  if (added.empty())
    return;
  LoadedPart part = *item.loaded;
  for (std::vector<base::Message>* notes : {&part.readNotes, &part.notes})
    notes->insert(notes->end(), added.begin(), added.end());
  item.loaded = std::make_shared<const LoadedPart>(std::move(part));
}

// Moves the settings of the job from the items to the job; those of the first item count.
void moveToJob(const base::ParameterTable& table, Choices& choices) {
  for (ItemChoices& item : choices.items)
    std::erase_if(item.parameters, [&](const auto& given) {
      const base::ParameterSpec* spec = table.find(given.first);
      const bool isOfJob = spec && spec->scope == base::ParameterScope::Job;
      if (isOfJob && &item == &choices.items.front())
        choices.parameters.insert(given);
      return isOfJob;
    });
}

// ---- the part as loaded

struct DefectName {
  const char* key;
  geometry::Defect geometry::Diagnosis::*defect;
};
using geometry::Diagnosis;
constexpr DefectName kDefectNames[] = {{"boundaryEdges", &Diagnosis::boundaryEdges},
                                       {"nonManifoldEdges", &Diagnosis::nonManifoldEdges},
                                       {"misorientedEdges", &Diagnosis::misorientedEdges},
                                       {"duplicateFaces", &Diagnosis::duplicateFaces},
                                       {"degenerateFaces", &Diagnosis::degenerateFaces},
                                       {"selfIntersections", &Diagnosis::selfIntersections},
                                       {"insideOutComponents", &Diagnosis::insideOutComponents}};

Json pointJson(const Eigen::Vector3d& p) {
  return Json::array({p.x(), p.y(), p.z()});
}
Eigen::Vector3d point(const Json& j) {
  return {j.at(0).get<double>(), j.at(1).get<double>(), j.at(2).get<double>()};
}

Json diagnosisJson(const Diagnosis& d) {
  Json j{{"triangles", d.triangles},   {"vertices", d.vertices},
         {"components", d.components}, {"boundaryLoops", d.boundaryLoops},
         {"watertight", d.watertight}, {"volumeMm3", d.volumeMm3},
         {"areaMm2", d.areaMm2},       {"genus", d.genus ? Json(*d.genus) : Json()}};
  if (!d.boundsMm.isEmpty())
    j["boundsMm"] = Json::array({pointJson(d.boundsMm.min()), pointJson(d.boundsMm.max())});
  for (const DefectName& row : kDefectNames)
    j[row.key] = Json{{"count", (d.*row.defect).count}, {"at", pointJson((d.*row.defect).at)}};
  return j;
}

Diagnosis readDiagnosis(const Json& j) {
  Diagnosis d;
  j.at("triangles").get_to(d.triangles);
  j.at("vertices").get_to(d.vertices);
  j.at("components").get_to(d.components);
  j.at("boundaryLoops").get_to(d.boundaryLoops);
  j.at("watertight").get_to(d.watertight);
  j.at("volumeMm3").get_to(d.volumeMm3);
  j.at("areaMm2").get_to(d.areaMm2);
  if (!j.at("genus").is_null())
    d.genus = j.at("genus").get<int>();
  if (j.contains("boundsMm"))
    d.boundsMm = Eigen::AlignedBox3d(point(j.at("boundsMm").at(0)), point(j.at("boundsMm").at(1)));
  for (const DefectName& row : kDefectNames) {
    j.at(row.key).at("count").get_to((d.*row.defect).count);
    (d.*row.defect).at = point(j.at(row.key).at("at"));
  }
  return d;
}

Json openJson(const geometry::OpenSurface& open) {
  return Json{{"rims", open.rims},
              {"widestMm", open.widestMm},
              {"widestAt", pointJson(open.widestAt)},
              {"plainRims", open.hasPlainRims},
              {"capShare", open.capShare},
              {"sheetTriangles", open.sheetTriangles},
              {"sheetShare", open.sheetShare}};
}
geometry::OpenSurface readOpen(const Json& j) {
  geometry::OpenSurface open;
  j.at("rims").get_to(open.rims);
  j.at("widestMm").get_to(open.widestMm);
  open.widestAt = point(j.at("widestAt"));
  open.hasPlainRims = j.value("plainRims", false); // older projects have none
  j.at("capShare").get_to(open.capShare);
  j.at("sheetTriangles").get_to(open.sheetTriangles);
  j.at("sheetShare").get_to(open.sheetShare);
  return open;
}

// Stores messages as data, so that they can be shown in any language. Earlier versions ignore this
// block and read the English texts.
void addFacts(BlockWriter& out, const Job& job) {
  Json facts = Json::array();
  for (const plan::Finding& finding : job.report.findings)
    facts.push_back(factJson(finding));
  const LoadedPart& loaded = *job.item().loaded;
  out.addText("told", Json{{"findings", std::move(facts)},
                           {"repairs", messagesJson(job.report.item().model.repairs)},
                           {"readNotes", messagesJson(loaded.readNotes)},
                           {"notes", messagesJson(loaded.notes)},
                           {"remains", messagesJson(loaded.remains)}}
                          .dump(-1, ' ', false, Json::error_handler_t::replace));
}

// Restores messages from data, for the present language; older files have English texts only.
void getFacts(const BlockReader& in, Job& job, LoadedPart& part) {
  if (!in.has("told"))
    return;
  const Json j = Json::parse(in.text("told"));
  const Json& facts = j.at("findings");
  for (std::size_t i = 0; i < job.report.findings.size(); ++i)
    readFact(facts.at(i), job.report.findings[i]);
  job.report.item().model.repairs = readMessages(j.at("repairs"));
  part.readNotes = readMessages(j.at("readNotes"));
  part.notes = readMessages(j.at("notes"));
  part.remains = readMessages(j.at("remains"));
}

void addLoaded(BlockWriter& out, const LoadedPart& part) {
  out.addText("source", Json{{"name", part.name},
                             {"repair", part.repair},
                             {"cells", part.cells != nullptr},
                             {"toolPaths", part.toolPaths != nullptr},
                             {"inWorkFrame", part.inWorkFrame},
                             {"mended", part.mesh != part.source},
                             {"readNotes", base::english(part.readNotes)},
                             {"notes", base::english(part.notes)},
                             {"remains", base::english(part.remains)},
                             {"found", diagnosisJson(part.found)},
                             {"open", part.open ? openJson(*part.open) : Json()},
                             {"readS", part.readS},
                             {"repairS", part.repairS}}
                            .dump(-1, ' ', false, Json::error_handler_t::replace));
  if (part.cells)
    out.addText("cells", voxel::writeVoxelText(*part.cells));
  if (part.toolPaths)
    addToolPlan(out, *part.toolPaths, "given");
  addMesh(out, "source", *part.source);
  if (part.mesh != part.source)
    addMesh(out, "mended", *part.mesh);
}

std::shared_ptr<LoadedPart> getLoaded(const BlockReader& in) {
  auto part = std::make_shared<LoadedPart>();
  const Json j = Json::parse(in.text("source"));
  j.at("name").get_to(part->name);
  j.at("repair").get_to(part->repair);
  part->readNotes = readMessages(j.at("readNotes"));
  part->notes = readMessages(j.at("notes"));
  part->remains = readMessages(j.at("remains"));
  part->found = readDiagnosis(j.at("found"));
  if (const auto open = j.find("open"); open != j.end() && !open->is_null())
    part->open = readOpen(*open);
  j.at("readS").get_to(part->readS);
  j.at("repairS").get_to(part->repairS);
  part->source = std::make_shared<geometry::TriangleMesh>(getMesh(in, "source"));
  part->mesh = j.at("mended").get<bool>()
                   ? std::make_shared<geometry::TriangleMesh>(getMesh(in, "mended"))
                   : part->source;
  if (j.value("cells", false)) {
    const std::string text = in.text("cells");
    part->cells = std::make_shared<voxel::VoxelObject>(voxel::readVoxelText(text, part->name));
    part->hash = contentHash(text);
  } else {
    if (j.value("toolPaths", false)) {
      part->toolPaths = std::make_shared<plan::ToolPlan>(getToolPlan(in, "given"));
      part->inWorkFrame = j.value("inWorkFrame", false);
      if (!isSound(*part->toolPaths))
        throw base::Error(base::ErrorCode::UnreadableFile,
                          "the tool-paths of the part's file are damaged"_text);
    }
    part->units = geometry::guessUnits(*part->mesh);
    part->hash = hashOf(*part);
  }
  return part;
}

// ---- results of the stages

Json recordsJson(const Job& job) {
  Json all = Json::array();
  for (const StageRecord& record : job.stages) {
    Json seconds;
    forEachField<Timings>([&](const auto& field) {
      if (record.timings.*field.member != 0.0)
        seconds[field.key] = record.timings.*field.member;
    });
    all.push_back(Json{{"key", record.key}, {"findings", record.findings}, {"timingS", seconds}});
  }
  return all;
}

void readRecords(const Json& j, Job& job) {
  for (std::size_t i = 0; i < kStageCount; ++i) {
    StageRecord& record = job.stages[i];
    j.at(i).at("key").get_to(record.key);
    j.at(i).at("findings").get_to(record.findings);
    const Json& seconds = j.at(i).at("timingS");
    forEachField<Timings>([&](const auto& field) {
      if (seconds.is_object() && seconds.contains(field.key))
        seconds.at(field.key).get_to(record.timings.*field.member);
    });
  }
}

Json tableJson(const std::vector<BlockRow>& rows) {
  Json table = Json::array();
  for (const BlockRow& row : rows)
    table.push_back(Json{{"name", row.name},
                         {"offset", row.offset},
                         {"bytes", row.bytes},
                         {"item", row.item},
                         {"crc32", row.crc32}});
  return table;
}

std::vector<BlockRow> readTable(const Json& j) {
  std::vector<BlockRow> table;
  for (const Json& row : j)
    table.push_back({row.at("name").get<std::string>(), row.at("offset").get<std::size_t>(),
                     row.at("bytes").get<std::size_t>(), row.at("item").get<std::size_t>(),
                     row.at("crc32").get<std::uint32_t>()});
  return table;
}

// Of the blocks of an item behind the first, whose blocks have none.
std::string blockPrefix(std::size_t item) {
  return "item" + std::to_string(item) + ".";
}

// `header`: the job's, or that of an item behind the first.
void readPlaced(const Json& header, const BlockReader& blocks, JobItem& item) {
  header.at("part").get_to(item.partName);
  header.at("scale").get_to(item.scale);
  if (header.at("placed").get<bool>())
    item.part = std::make_shared<geometry::TriangleMesh>(getMesh(blocks, "part"));
  item.platform = getPlatform(blocks);
  if (hasMesh(blocks, "lessPlatform"))
    item.result =
        ReducedPlatform{std::make_shared<geometry::TriangleMesh>(getMesh(blocks, "lessPlatform"))};
}

void readResults(const Json& header, const BlockReader& blocks, JobItem& item) {
  if (header.at("decomposed").get<bool>())
    item.result = Voxels(std::make_shared<curved::Decomposition>(getDecomposition(blocks)));
  if (header.value("pieces", false)) // older projects have no such key
    item.result = Pieces(std::make_shared<planar::PlanarDecomposition>(getPieces(blocks)));
  if (header.at("layered").get<bool>())
    item.layers = std::make_shared<layers::LayerStack>(getLayers(blocks));
  if (header.contains("placement"))
    item.placement = readPlacement(header.at("placement"));
}

void readMoreItems(const Json& header, BlockReader& blocks, Job& job) {
  for (const Json& row : header.value("moreItems", Json::array())) {
    blocks.setPrefix(blockPrefix(job.items.size()));
    JobItem& item = job.items.emplace_back();
    readPlaced(row, blocks, item);
    item.loaded = getLoaded(blocks);
    readResults(row, blocks, item);
    readRegionMeshes(blocks, job.choices.item(job.items.size() - 1));
  }
  blocks.setPrefix({});
}

bool hasSoundScales(const Job& job) {
  return std::ranges::all_of(
      job.items, [](const JobItem& item) { return std::isfinite(item.scale) && item.scale > 0.0; });
}

Job readFrame(const FileFrame& frame, const std::string& where, const base::ParameterTable& table) {
  Job job;
  const Json header = Json::parse(frame.header);
  job.choices = readChoices(header.at("choices"));
  BlockReader blocks(where, readTable(header.at("blocks")), frame.body);
  readPlaced(header, blocks, job.item());
  readRegionMeshes(blocks, job.choices.item());
  if (header.at("planned").get<bool>())
    job.toolPlan = std::make_shared<plan::ToolPlan>(getToolPlan(blocks));
  if (const int dof = header.at("dof").get<int>(); dof > 0)
    job.trajectory = std::make_shared<plan::Trajectory>(getTrajectory(blocks, dof));
  const std::shared_ptr<LoadedPart> loaded = getLoaded(blocks);
  job.item().loaded = loaded;
  readResults(header, blocks, job.item());
  job.report = readReportJson(blocks.text("report"));
  getFacts(blocks, job, *loaded);
  readRecords(header.at("stages"), job);
  job.resumedAt = header.value("resumedAt", std::size_t{0});
  if (!header.at("reached").is_null())
    job.reached = stageOf(header.at("reached").get<std::string>());
  readMoreItems(header, blocks, job);
  if (!hasSoundScales(job) || !isConsistent(job))
    throw unreadable("the job file is inconsistent"_text, where, "plan the part again"_text);
  addNotes(updateKeys(job.choices.parameters), job.item());
  for (std::size_t i = 0; i < job.items.size(); ++i) {
    addNotes(updateKeys(job.choices.item(i).parameters), job.item(i));
    for (Region& region : job.choices.item(i).regions)
      addNotes(updateKeys(region.parameters), job.item(i));
  }
  if (frame.format == kScopeless)
    moveToJob(table, job.choices);
  return job;
}

// The parts of a project file. Large arrays stay in the job and are not copied.
class JobFile {
public:
  explicit JobFile(const Job& job) { add(job); }
  JobFile(const JobFile&) = delete; // its parts are views
  JobFile& operator=(const JobFile&) = delete;
  std::vector<std::string_view> parts() const {
    std::vector<std::string_view> all = blocks_.parts();
    all.insert(all.begin(), head_);
    return all;
  }

private:
  void add(const Job& job);

  BlockWriter blocks_;
  std::string head_;
};

// The blocks of an item; returns its part of the header.
Json addItem(BlockWriter& blocks, const JobItem& item) {
  base::require(item.loaded != nullptr, "an item has a part");
  addLoaded(blocks, *item.loaded);
  if (item.part)
    addMesh(blocks, "part", *item.part);
  addPlatform(blocks, item.platform);
  if (const auto* less = std::get_if<ReducedPlatform>(&item.result); less && less->part)
    addMesh(blocks, "lessPlatform", *less->part);
  if (const Voxels voxels = item.decomposition())
    addDecomposition(blocks, *voxels);
  if (const Pieces pieces = item.pieces())
    addPieces(blocks, *pieces);
  if (item.layers)
    addLayers(blocks, *item.layers);
  Json header{{"part", item.partName},
              {"scale", item.scale},
              {"placed", item.part != nullptr},
              {"decomposed", item.decomposition() != nullptr},
              {"pieces", item.pieces() != nullptr},
              {"layered", item.layers != nullptr}};
  if (item.placement)
    header["placement"] = placementJson(*item.placement);
  return header;
}

void JobFile::add(const Job& job) {
  BlockWriter& blocks = blocks_;
  Json header = addItem(blocks, job.item());
  addRegionMeshes(blocks, job.choices.item());
  for (std::size_t i = 1; i < job.items.size(); ++i) {
    blocks.setPrefix(blockPrefix(i));
    header["moreItems"].push_back(addItem(blocks, job.item(i)));
    addRegionMeshes(blocks, job.choices.item(i));
  }
  blocks.setPrefix({});
  if (job.toolPlan)
    addToolPlan(blocks, *job.toolPlan);
  if (job.trajectory)
    addTrajectory(blocks, *job.trajectory);
  blocks.addText("report", reportJson(job.report));
  addFacts(blocks, job);
  header["choices"] = choicesJson(job.choices);
  header["reached"] = job.reached ? Json(stageName(*job.reached)) : Json();
  header["stages"] = recordsJson(job);
  header["planned"] = job.toolPlan != nullptr;
  header["dof"] = job.trajectory ? job.trajectory->dof : 0;
  header["blocks"] = tableJson(blocks.table());
  if (job.resumedAt > 0)
    header["resumedAt"] = job.resumedAt;
  const std::string text = header.dump(1, ' ', false, Json::error_handler_t::replace);
  head_ = fileHead(kJobMagic, kFormat, text);
}
} // namespace

std::string jobBytes(const Job& job) {
  const JobFile file(job);
  std::string bytes;
  for (const std::string_view part : file.parts())
    bytes += part;
  return bytes;
}

void writeJob(const std::filesystem::path& path, const Job& job) {
  const JobFile file(job);
  base::writeFile(path, file.parts());
}

Job jobOf(std::string_view bytes, const std::string& where, const base::ParameterTable& table) {
  if (bytes.starts_with(kStationMagic))
    throw unreadable("the project of a station of several machines, not of one job"_text, where,
                     "give it to 'together', or the job.voluta of one machine here"_text);
  const FileFrame frame = fileFrame(bytes, where, kNames, kScopeless, kFormat);
  try {
    return readFrame(frame, where, table);
  } catch (const nlohmann::json::exception& e) {
    throw unreadable(
        base::message("the job file's header is damaged: {why}"_text, std::string(e.what())),
        where);
  } catch (const base::Error& e) {
    if (e.code() == base::ErrorCode::UnreadableFile && !e.context().empty())
      throw;
    throw unreadable(e.message(), where, e.remedy());
  }
}

Job readJob(const std::filesystem::path& file, const base::ParameterTable& table) {
  return jobOf(base::readFile(file), file.string(), table);
}

} // namespace voluta::project
