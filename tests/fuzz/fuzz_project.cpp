// Project files. Their sums are put right first, so that changes reach the data that the sums
// guard: a program that writes projects may be wrong too.
#include "fuzz_target.h"

#include "pipeline/sample_job.h"
#include "pipeline/stage_options.h"
#include "project/block_file.h"
#include "project/report.h"

#include <nlohmann/json.hpp>

using namespace voluta;

namespace {

using Json = nlohmann::ordered_json;

// How the header of a project ends: no other line is a brace alone.
constexpr std::string_view kEnd = "\n}";

// A project as the input of this target: the lengths and sums are left out.
std::string inputOf(const std::string& project) {
  const std::size_t format = project.find('\n') + 1;
  const std::size_t header = project.find('\n', format) + 1;
  return project.substr(0, format) + project.substr(header);
}

void putSumsRight(Json& header, std::string_view body) {
  if (!header.is_object() || !header.contains("blocks") || !header["blocks"].is_array())
    return;
  for (Json& row : header["blocks"]) {
    if (!row.is_object() || !row.contains("offset") || !row.contains("bytes") ||
        !row["offset"].is_number_unsigned() || !row["bytes"].is_number_unsigned())
      continue;
    const auto offset = row["offset"].get<std::size_t>();
    if (offset <= body.size())
      row["crc32"] = project::crcOf(body.substr(offset, row["bytes"].get<std::size_t>()));
  }
}

std::string projectOf(const std::string& input) {
  const std::size_t format = input.find('\n');
  const std::size_t end = input.find(kEnd, format == std::string::npos ? 0 : format);
  if (end == std::string::npos)
    return input;
  const std::size_t body = end + kEnd.size();
  std::string header = input.substr(format + 1, body - format - 1);
  const std::string_view rest = std::string_view(input).substr(body);
  Json json = Json::parse(header, nullptr, false);
  if (!json.is_discarded()) {
    putSumsRight(json, rest);
    header = json.dump(1, ' ', false, Json::error_handler_t::replace);
  }
  const std::string project = input.substr(0, format + 1) + std::to_string(header.size()) + " " +
                              std::to_string(project::crcOf(header));
  return project + "\n" + header + std::string(rest);
}

} // namespace

std::vector<std::string> fuzz::seeds() {
  const project::Job job = test::sampleJob();
  project::Job part;
  part.item().loaded = job.item().loaded;
  part.item().partName = "box.stl";
  return {inputOf(project::jobBytes(job)), inputOf(project::jobBytes(test::sampleJobOfPieces())),
          inputOf(project::jobBytes(part))};
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::write("input.voluta", projectOf(fuzz::textOf(data, size)));
  fuzz::takenOrRefused([] {
    const project::Job job = project::readJob("input.voluta", pipeline::allParameters());
    fuzz::expect(job.item().loaded != nullptr, "a project has a part");
    // The calls made for every project that is opened.
    for (const auto stage : {project::Stage::Load, project::Stage::Layers, project::Stage::Motion})
      project::upTo(job, stage);
    project::upTo(job, std::nullopt);
    project::reportJson(job.report);
    project::jobBytes(job);
  });
  return 0;
}
