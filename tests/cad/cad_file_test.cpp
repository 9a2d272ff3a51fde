// STEP and IGES: own solids are written by Open CASCADE and read through the program beside this
// one.
#include "base/error.h"
#include "base/files.h"
#include "base/run_context.h"
#include "cad_solids.h"
#include "geometry/formats/cad_reader.h"
#include "geometry/formats/foreign_reader.h"
#include "geometry/formats/mesh_reader.h"
#include "geometry/measures.h"
#include "helpers/shapes.h"
#include "helpers/temporary_folder.h"
#include "project/cad_parts.h"

#include <algorithm>
#include <cmath>
#include <gmock/gmock.h>
#include <numbers>

namespace voluta {
namespace {

using Eigen::Vector3d;
using std::numbers::pi;
using test::CadFormat;
using test::CadSolid;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

const char* const kUnits[] = {"MM", "INCH", "M"};

std::vector<CadSolid> singleSolids() {
  return {test::boxWithHoles(), test::bentPipe(), test::blendedBlock(), test::thinShell()};
}

// mm3, in closed form.
double closedForm(const std::string& name) {
  if (name == "box with holes")
    return (40.0 * 30.0 - pi * (25.0 + 9.0)) * 20.0;
  if (name == "bent pipe")
    return pi * (100.0 - 64.0) * 30.0 * pi / 2.0;
  if (name == "blended block") // a core, slabs on its faces, quarter cylinders, a ball
    return 22.0 * 12.0 * 7.0 + 2.0 * 4.0 * (22.0 * 12.0 + 22.0 * 7.0 + 12.0 * 7.0) +
           pi * 16.0 * (22.0 + 12.0 + 7.0) + 4.0 / 3.0 * pi * 64.0;
  return pi * (144.0 * 30.0 - 10.8 * 10.8 * 28.8); // thin shell
}

class CadFiles : public ::testing::Test {
protected:
  std::filesystem::path written(const std::vector<CadSolid>& solids, CadFormat format,
                                const std::string& unit = "MM") {
    const auto file = folder_ / (format == CadFormat::Step ? "part.step" : "part.igs");
    test::writeCad(solids, format, unit, file);
    return file;
  }
  std::filesystem::path written(const std::string& name, const std::string& bytes) {
    base::writeFile(folder_ / name, bytes);
    return folder_ / name;
  }
  static geometry::MeshFile read(const std::filesystem::path& file,
                                 const geometry::Tessellation& facets = {}) {
    return geometry::readCad(file, facets, {});
  }
  static std::string complaint(const std::filesystem::path& file,
                               std::chrono::milliseconds limit = geometry::kCadLimit) {
    try {
      geometry::readCad(file, {}, {}, limit);
    } catch (const base::Error& e) {
      EXPECT_EQ(std::string(e.what()).find('\n'), std::string::npos);
      EXPECT_THAT(e.what(), HasSubstr(file.filename().string()));
      return e.what();
    }
    return "no error";
  }
  const test::TemporaryFolder folder_;
};

TEST_F(CadFiles, SolidsHaveTheirVolumeInEveryUnit) {
  for (const CadSolid& solid : singleSolids()) {
    const double volume = closedForm(solid.name);
    ASSERT_NEAR(test::volumeMm3(solid.shape), volume, 1e-6 * volume) << solid.name;
    for (const CadFormat format : {CadFormat::Step, CadFormat::Iges, CadFormat::IgesFaces})
      for (const char* unit : kUnits) {
        if (format != CadFormat::Step && unit != kUnits[0] && solid.name != "thin shell")
          continue; // written and read as the others
        const geometry::MeshFile file = read(written({solid}, format, unit));
        EXPECT_EQ(file.format, format == CadFormat::Step ? "STEP" : "IGES");
        EXPECT_NEAR(geometry::volume(file.mesh), volume, 1e-3 * volume)
            << solid.name << ", " << unit << ", format " << static_cast<int>(format);
      }
  }
}

// Sharp corners of facets along one edge are those of the neighbouring face.
TEST_F(CadFiles, SolidsAreClosedWithoutRepair) {
  for (const CadSolid& solid : singleSolids()) {
    const auto part = project::loadAsOne(written({solid}, CadFormat::Step).string(), true, {}, {});
    EXPECT_TRUE(part->found.clean()) << solid.name;
  }
}

// Largest distance of the middle of an edge or a facet from the axis' circle around it.
double chordOfHole(const geometry::TriangleMesh& mesh, double x, double y, double radiusMm) {
  double most = 0.0;
  const auto fromAxis = [&](const Vector3d& p) { return std::hypot(p.x() - x, p.y() - y); };
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    bool isOfHole = true;
    for (int k = 0; k < 3; ++k)
      isOfHole = isOfHole && std::abs(fromAxis(mesh.corner(t, k)) - radiusMm) < 1e-6;
    for (int k = 0; isOfHole && k < 3; ++k)
      most = std::max(most,
                      radiusMm - fromAxis(0.5 * (mesh.corner(t, k) + mesh.corner(t, (k + 1) % 3))));
  }
  return most;
}

TEST_F(CadFiles, FacetsAreAsCloseAsAsked) {
  const auto file = written({test::boxWithHoles()}, CadFormat::Step);
  std::size_t before = 0;
  for (const double chordMm : {0.2, 0.05, 0.01, 0.002}) {
    const geometry::TriangleMesh mesh = read(file, {chordMm, 1.0}).mesh;
    const double chord = chordOfHole(mesh, 12, 15, 5);
    EXPECT_GT(chord, 0.1 * chordMm);
    EXPECT_LE(chord, chordMm + 1e-9);
    EXPECT_GT(mesh.triangles.size(), before);
    before = mesh.triangles.size();
  }
  // The angle between facets, where the chord would allow a larger one.
  const double angle = 0.1;
  EXPECT_LE(chordOfHole(read(file, {1.0, angle}).mesh, 12, 15, 5),
            5.0 * (1.0 - std::cos(0.5 * angle)) + 1e-9);
  EXPECT_DOUBLE_EQ(geometry::tessellationFor(1.2).chordMm, 0.024);
}

TEST_F(CadFiles, AnAssemblyIsItsProductsInTheirPlaces) {
  for (const char* unit : kUnits) {
    const auto file = written(test::assemblySolids(), CadFormat::Step, unit);
    const std::vector<geometry::PartOfFile> parts = geometry::readCadParts(file, {}, {});
    std::vector<std::string> names;
    for (const geometry::PartOfFile& part : parts)
      names.push_back(part.name);
    ASSERT_THAT(names, ElementsAre("base", "lid", "pin", "pin"));
    EXPECT_LT((parts[1].placeMm - Vector3d(50, 0, 0)).norm(), 1e-6) << unit;
    EXPECT_LT((parts[3].placeMm - Vector3d(90, 25, 0)).norm(), 1e-6) << unit;
    EXPECT_EQ(parts[2].file.mesh.vertices, parts[3].file.mesh.vertices); // one product
    EXPECT_NEAR(geometry::volume(parts[3].file.mesh), pi * 16.0 * 18.0, 0.001 * pi * 16.0 * 18.0);
    const Eigen::AlignedBox3d all = geometry::bounds(read(file).mesh);
    EXPECT_LT((all.max() - Vector3d(94, 30, 18)).norm(), 0.01) << unit;
  }
  const auto parts = project::loadParts(written(test::assemblySolids(), CadFormat::Step).string(),
                                        true, {0.05, 0.2}, {});
  ASSERT_EQ(parts.size(), 4u);
  EXPECT_EQ(parts[1].part->name, "lid");
  EXPECT_EQ(parts[2].part->hash, parts[3].part->hash);
}

TEST_F(CadFiles, ABodyFarFromTheOriginStaysThere) {
  CadSolid block = test::assemblySolids()[1]; // 20 x 30 x 6 mm at x = 50
  const auto parts = geometry::readCadParts(written({block}, CadFormat::Step), {}, {});
  ASSERT_EQ(parts.size(), 1u);
  EXPECT_EQ(parts.front().placeMm, Vector3d::Zero());
  EXPECT_NEAR(geometry::bounds(parts.front().file.mesh).min().x(), 50.0, 1e-6);
}

TEST_F(CadFiles, OfAnObstacleOrARobotHaveItsUnit) {
  const auto file = written({test::boxWithHoles()}, CadFormat::Step, "INCH");
  const auto sizes = [&](geometry::ForeignFrame frame) -> Vector3d {
    return geometry::bounds(geometry::readMeshOf(file, frame).mesh).sizes();
  };
  EXPECT_LT((sizes(geometry::ForeignFrame::Upright) - Vector3d(40, 30, 20)).norm(), 1e-6);
  EXPECT_LT((sizes(geometry::ForeignFrame::AsWritten) - Vector3d(0.04, 0.03, 0.02)).norm(), 1e-9);
}

TEST_F(CadFiles, BadFilesAreRefusedInALine) {
  const std::string step =
      base::readFile(written({test::boxWithHoles()}, CadFormat::Step).string());
  const std::string iges =
      base::readFile(written({test::boxWithHoles()}, CadFormat::Iges).string());
  EXPECT_THAT(complaint(written("empty.step", "")), HasSubstr("the file is empty"));
  EXPECT_THAT(complaint(written("words.step", "Dear all\n")), HasSubstr("not a STEP or IGES"));
  EXPECT_THAT(complaint(written("half.step", step.substr(0, step.size() / 2))),
              HasSubstr("cut short"));
  EXPECT_THAT(complaint(written("half.igs", iges.substr(0, iges.size() / 2))),
              HasSubstr("cut short"));
  // Without a line in the middle, the counts of the last line are wrong.
  std::string lacking = iges;
  lacking.erase(lacking.find('\n', lacking.size() / 2) + 1, 81);
  EXPECT_THAT(complaint(written("lacking.igs", lacking)), HasSubstr("cut short"));
  const std::string stl = geometry::writeStl(test::box({0, 0, 0}, {1, 2, 3}));
  EXPECT_THAT(complaint(written("mesh.step", stl)), HasSubstr("give it the ending .stl"));
  test::writeCurves(folder_ / "curves.step");
  EXPECT_THAT(complaint(folder_ / "curves.step"), HasSubstr("only curves"));
  std::string headOnly = step.substr(0, step.find("DATA;")) + "DATA;\nENDSEC;\nEND-ISO-10303-21;\n";
  EXPECT_THAT(complaint(written("head.step", headOnly)), HasSubstr("head.step"));
  EXPECT_THAT(complaint(folder_ / "none.step"), HasSubstr("none.step"));
  EXPECT_THAT(complaint(written("slow.step", step), std::chrono::milliseconds(0)),
              HasSubstr("takes longer"));
}

TEST_F(CadFiles, AnEndingOfTheOtherFormatDoesNotMatter) {
  const std::string step =
      base::readFile(written({test::boxWithHoles()}, CadFormat::Step).string());
  EXPECT_EQ(read(written("other.IGS", step)).format, "STEP");
}

// Whatever is in a damaged file, this process gets a mesh or one line.
TEST_F(CadFiles, DamagedFilesEndInALineOrAMesh) {
  const std::string step =
      base::readFile(written({test::assemblySolids()}, CadFormat::Step).string());
  int refused = 0;
  for (std::size_t i = 0; i < 16; ++i) {
    std::string bytes = step;
    const std::size_t from = bytes.find("DATA;") + 5;
    const std::size_t at = from + (bytes.size() - from - 60) * i / 16;
    if (i % 2 == 0)
      bytes.erase(bytes.find('\n', at), 400); // a few entities
    else
      std::ranges::fill(bytes.begin() + static_cast<long>(at),
                        bytes.begin() + static_cast<long>(at) + 40, '9');
    if (bytes.rfind("END-ISO") == std::string::npos)
      bytes += "END-ISO-10303-21;\n";
    refused += complaint(written("damaged.step", bytes)) != "no error";
  }
  EXPECT_GT(refused, 0);
}

TEST_F(CadFiles, ReadingIsCancelled) {
  const base::CancelToken cancel;
  cancel.cancel();
  EXPECT_THROW(geometry::readCad(written({test::bentPipe()}, CadFormat::Step), {1e-4, 0.01},
                                 base::RunContext(cancel, 1)),
               base::Cancelled);
}

} // namespace
} // namespace voluta
