#include "curved/decomposition.h"
#include "layers/layer_stack.h"
#include "pipeline/stage_options.h"
#include "plan/tool_plan.h"
#include "plan/trajectory.h"
#include "planar/pieces.h"
#include "planar/planar_decomposition.h"
#include "project/job.h"
#include "project/loaded_part.h"

#include "base/error.h"
#include "base/files.h"
#include "helpers/temporary_folder.h"
#include "pipeline/sample_job.h"
#include "project/block_file.h"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <limits>
#include <random>

using namespace voluta;
using project::Job;
using project::Stage;
using test::sampleJob;

namespace {

class JobFile : public ::testing::Test {
protected:
  std::string errorOf(const std::string& bytes) const {
    try {
      readBack(bytes);
    } catch (const base::Error& e) {
      EXPECT_EQ(e.code(), base::ErrorCode::UnreadableFile);
      return e.what();
    }
    return "no error";
  }
  Job readBack(const std::string& bytes) const {
    // Not base::writeFile: thousands of files need not survive a power cut.
    std::ofstream(folder_ / "job.voluta", std::ios::binary) << bytes;
    return project::readJob(folder_ / "job.voluta", pipeline::allParameters());
  }
  const test::TemporaryFolder folder_;
};

// CRC-32 as zip, PNG and the files of before have it.
TEST_F(JobFile, ChecksumsAreThoseOfTheStandard) {
  EXPECT_EQ(project::crcOf("123456789"), 0xCBF43926U);
  EXPECT_EQ(project::crcOf({}), 0U);
  project::BlockWriter blocks;
  const std::vector<char> first{'1', '2', '3', '4'}, none, last{'5', '6', '7', '8', '9'};
  blocks.begin("digits", 1);
  for (const std::vector<char>* part : {&first, &none, &last})
    blocks.append(*part);
  EXPECT_EQ(blocks.table().front().crc32, 0xCBF43926U);
}

TEST_F(JobFile, IsWrittenAsItsBytesAre) {
  const Job job = sampleJob();
  project::writeJob(folder_ / "written.voluta", job);
  EXPECT_EQ(base::readFile(folder_ / "written.voluta"), project::jobBytes(job));
}

TEST_F(JobFile, IsReadBackUnchanged) {
  const Job job = sampleJob();
  const std::string bytes = project::jobBytes(job);
  const Job back = readBack(bytes);
  EXPECT_EQ(back.item().partName, job.item().partName);
  EXPECT_EQ(back.item().scale, job.item().scale);
  EXPECT_EQ(back.choices.item().parameters, job.choices.item().parameters);
  EXPECT_EQ(back.choices.parameters, job.choices.parameters);
  EXPECT_EQ(back.choices.formats, job.choices.formats);
  EXPECT_EQ(back.item().part->vertices, job.item().part->vertices);
  EXPECT_EQ(back.item().part->triangles, job.item().part->triangles);
  EXPECT_EQ(back.item().platform.polygon, job.item().platform.polygon);
  EXPECT_EQ(back.toolPlan->position, job.toolPlan->position);
  EXPECT_EQ(back.toolPlan->heightMm, job.toolPlan->heightMm);
  EXPECT_EQ(back.toolPlan->paths[0].layer, 4);
  EXPECT_EQ(back.toolPlan->paths[0].kind, plan::PathKind::Infill);
  EXPECT_TRUE(back.toolPlan->paths[0].closed);
  EXPECT_EQ(back.trajectory->joints, job.trajectory->joints);
  EXPECT_EQ(back.trajectory->waypoint, job.trajectory->waypoint);
  EXPECT_EQ(project::jobBytes(back), bytes);
}

// Files without rings are those of older versions.
TEST_F(JobFile, RingsOfWallsAreReadBack) {
  Job job = sampleJob();
  EXPECT_EQ(project::jobBytes(job).find("toolPlan.rings"), std::string::npos);
  plan::ToolPlan ringed = *job.toolPlan;
  ringed.paths[0].ring = 3;
  job.toolPlan = std::make_shared<plan::ToolPlan>(ringed);
  EXPECT_EQ(readBack(project::jobBytes(job)).toolPlan->paths[0].ring, 3);
  EXPECT_EQ(readBack(project::jobBytes(sampleJob())).toolPlan->paths[0].ring, 0);
  ringed.paths[0].ring = -1;
  job.toolPlan = std::make_shared<plan::ToolPlan>(ringed);
  EXPECT_NE(errorOf(project::jobBytes(job)), "no error");
}

TEST_F(JobFile, PartIsReadBackUnchanged) {
  const Job job = sampleJob();
  const Job back = readBack(project::jobBytes(job));
  EXPECT_EQ(back.item().loaded->name, "box.stl");
  EXPECT_EQ(back.item().loaded->source->triangles.size(), 11u);
  EXPECT_EQ(back.item().loaded->mesh->triangles, job.item().loaded->mesh->triangles);
  EXPECT_EQ(back.item().loaded->hash, job.item().loaded->hash);
  EXPECT_EQ(back.item().loaded->notes, job.item().loaded->notes);
  EXPECT_EQ(base::english(back.item().loaded->notes.front()), "omitted: 1 facet");
  EXPECT_EQ(back.item().loaded->found.boundaryEdges.count, 3u);
  EXPECT_EQ(back.item().loaded->found.boundaryEdges.at, job.item().loaded->found.boundaryEdges.at);
  EXPECT_FALSE(back.item().loaded->found.watertight);
  EXPECT_EQ(back.item().loaded->found.boundsMm.max(), job.item().loaded->found.boundsMm.max());
  EXPECT_EQ(back.choices.item().placement.rotation.coeffs(),
            job.choices.item().placement.rotation.coeffs());
  EXPECT_EQ(back.choices.item().placement.centreMm, job.choices.item().placement.centreMm);
  EXPECT_EQ(back.choices.item().placement.liftMm, 0.5);
  EXPECT_TRUE(back.choices.item().repair);
}

TEST_F(JobFile, PiecesAreReadBack) {
  const Job job = test::sampleJobOfPieces();
  const Job back = readBack(project::jobBytes(job));
  EXPECT_EQ(back.item().decomposition(), nullptr);
  ASSERT_EQ(back.item().pieces()->pieces.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    const planar::Piece &p = back.item().pieces()->pieces[i], &q = job.item().pieces()->pieces[i];
    EXPECT_EQ(p.solid.mesh.vertices, q.solid.mesh.vertices);
    EXPECT_EQ(p.solid.mesh.triangles, q.solid.mesh.triangles);
    EXPECT_EQ(p.solid.tag, q.solid.tag);
    EXPECT_EQ(p.base.normal, q.base.normal);
    EXPECT_EQ(p.base.offsetMm, q.base.offsetMm);
    EXPECT_EQ(p.baseTag, q.baseTag);
    EXPECT_EQ(p.parent, q.parent);
  }
  EXPECT_EQ(back.item().pieces()->riskyBeforeMm2, 12.0);
  EXPECT_EQ(back.item().pieces()->riskyMm2, 0.5);
  EXPECT_EQ(back.item().pieces()->sectionMm2, 100.0);
  EXPECT_EQ(back.item().pieces()->blockedPieces, 1u);
  EXPECT_EQ(back.item().pieces()->seconds.cut, 0.5);
}

TEST_F(JobFile, VoxelsLayersAndReportAreReadBack) {
  const Job job = sampleJob();
  const Job back = readBack(project::jobBytes(job));
  const curved::Decomposition &d = *back.item().decomposition(), &was = *job.item().decomposition();
  EXPECT_EQ(d.rank, was.rank);
  EXPECT_EQ(d.field[1], was.field[1]);
  EXPECT_TRUE(std::isnan(d.field[2]));
  EXPECT_EQ(d.frontNormal, was.frontNormal);
  EXPECT_EQ(d.loss, was.loss);
  EXPECT_EQ(d.byHead, was.byHead);
  EXPECT_EQ(d.support, was.support);
  EXPECT_EQ(d.cascadeVoxels + d.headVoxels + d.supportVoxels, 3u);
  EXPECT_EQ(d.grid.size, was.grid.size);
  EXPECT_EQ(d.grid.origin, was.grid.origin);
  EXPECT_EQ(d.grid.pitch, was.grid.pitch);
  EXPECT_EQ(d.epsilonMm, was.epsilonMm);
  EXPECT_EQ(d.platform, was.platform);
  EXPECT_EQ(d.growth, was.growth);
  EXPECT_EQ(d.shadowedVoxels, 1u);
  EXPECT_EQ(d.seconds.grow, 0.25);
  ASSERT_EQ(back.item().layers->patches.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    const layers::Patch &p = back.item().layers->patches[i], &q = job.item().layers->patches[i];
    EXPECT_EQ(p.surface.vertices, q.surface.vertices);
    EXPECT_EQ(p.surface.triangles, q.surface.triangles);
    EXPECT_EQ(p.thicknessMm, q.thicknessMm);
    EXPECT_EQ(p.direction, q.direction);
    EXPECT_EQ(p.clearDirection, q.clearDirection);
    EXPECT_EQ(p.innerRim, q.innerRim);
    EXPECT_EQ(p.chart.at, q.chart.at);
    EXPECT_EQ(p.chart.periodMm, q.chart.periodMm);
    EXPECT_EQ(p.group, q.group);
  }
  EXPECT_EQ(back.item().layers->layerCount, 2);
  EXPECT_EQ(back.reached, Stage::Motion);
  EXPECT_EQ(back.keys(), job.keys());
  EXPECT_EQ(reportJson(back.report), reportJson(job.report));
  EXPECT_EQ(back.stages[4].findings, 2u);
  EXPECT_EQ(back.stages[4].timings.ik, 0.125);
}

TEST_F(JobFile, APartAloneIsAJob) {
  Job job;
  job.item().loaded = sampleJob().item().loaded;
  job.item().partName = job.item().loaded->name;
  const Job back = readBack(project::jobBytes(job));
  EXPECT_EQ(back.item().part, nullptr);
  EXPECT_FALSE(back.reached);
  EXPECT_EQ(back.item().loaded->source->vertices, job.item().loaded->source->vertices);
}

TEST_F(JobFile, NewerFormatIsNamedWithARemedy) {
  std::string bytes = project::jobBytes(sampleJob());
  bytes.replace(0, 8, "VOLUTA 4");
  const std::string said = errorOf(bytes);
  EXPECT_NE(said.find("saved by a newer version of Voluta (format 4; this version reads up to 3)"),
            std::string::npos)
      << said;
  EXPECT_NE(said.find("job.voluta"), std::string::npos) << said;
  EXPECT_NE(said.find("open it with"), std::string::npos) << said;
  EXPECT_NE(errorOf("solid box\n").find("not a Voluta job"), std::string::npos);
  EXPECT_NE(errorOf("VOLUTA x\n").find("damaged"), std::string::npos);
  EXPECT_NE(errorOf("VOLUTA 3").find("truncated"), std::string::npos);
}

TEST_F(JobFile, ResultsAfterAStageCanBeLeftOut) {
  const Job job = sampleJob();
  const Job cut = project::upTo(job, Stage::Layers);
  EXPECT_EQ(cut.item().layers, job.item().layers);
  EXPECT_EQ(cut.toolPlan, nullptr);
  EXPECT_EQ(cut.trajectory, nullptr);
  EXPECT_EQ(cut.reached, Stage::Layers);
  ASSERT_EQ(cut.report.findings.size(), 1u);
  EXPECT_EQ(*cut.report.findings[0].value("radius"), base::Value(base::mm(50.0)));
  EXPECT_EQ(cut.report.timings.ik, 0.0);
  EXPECT_TRUE(cut.report.motion.maxJerk.empty());
  EXPECT_TRUE(cut.keys()[3].empty());
  EXPECT_EQ(cut.keys()[2], job.keys()[2]);
  const Job none = project::upTo(job, std::nullopt);
  EXPECT_EQ(none.item().part, nullptr);
  EXPECT_FALSE(none.reached);
  EXPECT_TRUE(none.report.findings.empty());
  EXPECT_EQ(none.item().loaded, job.item().loaded);
  EXPECT_EQ(reportJson(project::upTo(job, Stage::Replay).report), reportJson(job.report));
  EXPECT_EQ(readBack(project::jobBytes(cut)).reached, Stage::Layers);
}

TEST_F(JobFile, APlanThatStoppedEarlyIsAJobToo) {
  Job job = sampleJob();
  job.toolPlan = nullptr;
  job.trajectory = nullptr;
  job.reached = Stage::Layers;
  const Job back = readBack(project::jobBytes(job));
  EXPECT_EQ(back.toolPlan, nullptr);
  EXPECT_EQ(back.trajectory, nullptr);
}

TEST_F(JobFile, DamageIsAnErrorNeverACrashOrAWrongPlan) {
  const std::string whole = project::jobBytes(sampleJob());
  std::mt19937 random(7);
  for (int trial = 0; trial < 2000; ++trial) {
    std::string bytes = whole;
    if (trial % 2 == 0)
      bytes.resize(random() % whole.size());
    else
      bytes[random() % whole.size()] ^= static_cast<char>(1 << random() % 8);
    EXPECT_NE(errorOf(bytes), "no error") << "trial " << trial;
  }
}

TEST_F(JobFile, IndicesOutsideTheirArraysAreRefused) {
  Job job = sampleJob();
  auto broken = *job.toolPlan;
  broken.paths[0].count = 99;
  job.toolPlan = std::make_shared<plan::ToolPlan>(broken);
  EXPECT_THROW(readBack(project::jobBytes(job)), base::Error);
}

// A file whose sums are right and whose arrays are not.
TEST_F(JobFile, ContradictionsAreRefused) {
  const auto refused = [&](const char* what, auto&& change) {
    Job job = sampleJob();
    change(job);
    EXPECT_NE(errorOf(project::jobBytes(job)).find("is inconsistent"), std::string::npos) << what;
  };
  const auto withDecomposition = [&](auto&& change) {
    return [change](Job& job) {
      curved::Decomposition d = *job.item().decomposition();
      change(d);
      job.item().result = std::make_shared<curved::Decomposition>(d);
    };
  };
  const auto withPiece = [&](auto&& change) {
    return [change](Job& job) {
      job = test::sampleJobOfPieces();
      planar::PlanarDecomposition d = *job.item().pieces();
      change(d.pieces[1]);
      job.item().result = std::make_shared<planar::PlanarDecomposition>(d);
    };
  };
  refused("a piece on one that is not there", withPiece([](auto& p) { p.parent = 2; }));
  refused("a piece with corners that are not there",
          withPiece([](auto& p) { p.solid.mesh.triangles[0][1] = 8; }));
  refused("tags too few", withPiece([](auto& p) { p.solid.tag.pop_back(); }));
  refused("a base plane nowhere", withPiece([](auto& p) { p.base.offsetMm = 1e300 * 1e300; }));
  const auto withPatch = [&](auto&& change) {
    return [change](Job& job) {
      layers::LayerStack stack = *job.item().layers;
      change(stack.patches[1]);
      job.item().layers = std::make_shared<layers::LayerStack>(stack);
    };
  };
  refused("grid larger than its ranks", withDecomposition([](auto& d) {
            d.grid.size = {9, 9, 9};
          }));
  refused("negative grid", withDecomposition([](auto& d) { d.grid.size = {-2, -1, 2}; }));
  refused("no pitch", withDecomposition([](auto& d) { d.grid.pitch = 0.0; }));
  refused("field too short", withDecomposition([](auto& d) { d.field.pop_back(); }));
  refused("losses too short", withDecomposition([](auto& d) { d.loss.pop_back(); }));
  refused("a loss that is none",
          withDecomposition([](auto& d) { d.loss[0] = static_cast<curved::Loss>(9); }));
  refused("heads too short", withDecomposition([](auto& d) { d.byHead.pop_back(); }));
  refused("supports too long", withDecomposition([](auto& d) { d.support.push_back(1); }));
  refused("normals too short", withDecomposition([](auto& d) { d.frontNormal.pop_back(); }));
  refused("triangle beyond", withPatch([](auto& p) { p.surface.triangles[0][0] = 4; }));
  refused("not finite", withPatch([](auto& p) { p.surface.vertices[0].x() = NAN; }));
  refused("thickness too short", withPatch([](auto& p) { p.thicknessMm.pop_back(); }));
  refused("kind of path", [](Job& job) {
    plan::ToolPlan p = *job.toolPlan;
    p.paths[0].kind = static_cast<plan::PathKind>(77);
    job.toolPlan = std::make_shared<plan::ToolPlan>(p);
  });
  refused("a part of corners that are not there", [](Job& job) {
    auto part = std::make_shared<project::LoadedPart>(*job.item().loaded);
    auto mesh = std::make_shared<geometry::TriangleMesh>(*part->source);
    mesh->triangles[0][1] = 1'000'000'000;
    part->source = part->mesh = mesh;
    job.item().loaded = part;
  });
  refused("a platform nowhere", [](Job& job) { job.item().platform.polygon[1].y() = INFINITY; });
  refused("a waypoint nowhere", [](Job& job) {
    plan::ToolPlan p = *job.toolPlan;
    p.position[2].z() = NAN;
    job.toolPlan = std::make_shared<plan::ToolPlan>(p);
  });
  refused("joints that are no numbers", [](Job& job) {
    plan::Trajectory t = *job.trajectory;
    t.joints[1] = NAN;
    job.trajectory = std::make_shared<plan::Trajectory>(t);
  });
  refused("reached more than there is", [](Job& job) { job.toolPlan = nullptr; });
  refused("more findings than the report", [](Job& job) { job.stages[0].findings = 9; });
  refused("findings beyond all number", [](Job& job) {
    job.stages[0].findings = std::numeric_limits<std::size_t>::max();
    job.stages[1].findings = 2;
  });
  refused("a path of a tool that is not there", [](Job& job) {
    plan::ToolPlan p = *job.toolPlan;
    p.paths[0].tool = 1;
    job.toolPlan = std::make_shared<plan::ToolPlan>(p);
  });
  refused("a path of an item that is not there", [](Job& job) {
    plan::ToolPlan p = *job.toolPlan;
    p.paths[0].item = 1;
    job.toolPlan = std::make_shared<plan::ToolPlan>(p);
  });
  refused("a motion that begins with a tool that is not there", [](Job& job) {
    plan::Trajectory t = *job.trajectory;
    t.firstTool = 1;
    job.trajectory = std::make_shared<plan::Trajectory>(t);
  });
  refused("a change to a tool that is not there", [](Job& job) {
    plan::Trajectory t = *job.trajectory;
    t.events = {{.point = 1, .kind = plan::EventKind::ToolChange, .tool = 1}};
    job.trajectory = std::make_shared<plan::Trajectory>(t);
  });
  refused("an item too few", [](Job& job) { job.choices.items.emplace_back(); });
  refused("scale", [](Job& job) { job.item().scale = 0.0; });
}

} // namespace
