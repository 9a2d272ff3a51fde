// The formats of parts: one table for readers, dialogs and help.
#include "project/part_formats.h"

#include "base/error.h"
#include "base/files.h"
#include "geometry/formats/mesh_reader.h"
#include "helpers/shapes.h"
#include "helpers/temporary_folder.h"
#include "project/loaded_part.h"

#include <algorithm>
#include <cctype>
#include <gtest/gtest.h>
#include <set>

namespace voluta::project {
namespace {

TEST(PartFormats, EachEndingIsLowerCaseAndHasOneFormatWithAReader) {
  std::set<std::string_view> endings;
  for (const PartFormat& format : partFormats()) {
    EXPECT_TRUE(endings.insert(format.ending).second) << format.ending;
    EXPECT_EQ(format.ending.front(), '.');
    std::string shouted(format.ending);
    std::ranges::transform(shouted, shouted.begin(),
                           [](unsigned char c) { return std::toupper(c); });
    EXPECT_EQ(partFormatOf("PART" + shouted), &format);
    EXPECT_NE(format.read, nullptr);
    EXPECT_FALSE(format.holds.english().empty());
    EXPECT_EQ(isSlicedFile("part" + std::string(format.ending)),
              format.content == PartContent::SlicedPaths);
  }
}

TEST(PartFormats, EachReaderRefusesAnEmptyFileInOneLine) {
  const test::TemporaryFolder folder;
  for (const PartFormat& format : partFormats()) {
    const std::filesystem::path file = folder / ("empty" + std::string(format.ending));
    base::writeFile(file, "");
    EXPECT_THROW(loadPart(file.string(), true, {}), base::Error) << format.ending;
  }
}

TEST(PartFormats, DialogsOfferReadableFormats) {
  EXPECT_TRUE(filePatterns(NamedFiles::Parts).starts_with("*.stl *.obj "));
  const auto offers = [](NamedFiles files, std::string_view ending) {
    return (" " + filePatterns(files) + " ").find(" *" + std::string(ending) + " ") !=
           std::string::npos;
  };
  for (const PartFormat& format : partFormats()) {
    const bool isMesh = format.content == PartContent::Mesh;
    EXPECT_TRUE(offers(NamedFiles::Parts, format.ending)) << format.ending;
    EXPECT_EQ(offers(NamedFiles::AllMeshes, format.ending), isMesh) << format.ending;
    EXPECT_EQ(offers(NamedFiles::Meshes, format.ending), isMesh && !format.foreign)
        << format.ending;
  }
}

TEST(PartFormats, AFileOfUnknownEndingIsReadByItsContent) {
  const test::TemporaryFolder folder;
  base::writeFile(folder / "cells", "0110\n----\n");
  EXPECT_EQ(detectedFormat((folder / "cells").string()).content, PartContent::Voxels);
  base::writeFile(folder / "box.part",
                  geometry::writeStl(test::box(Eigen::Vector3d::Zero(), Eigen::Vector3d::Ones())));
  EXPECT_EQ(detectedFormat((folder / "box.part").string()).content, PartContent::Mesh);
  EXPECT_EQ(loadPart((folder / "box.part").string(), true, {})->mesh->triangles.size(), 12u);
  EXPECT_THROW(detectedFormat((folder / "missing").string()), base::Error);
}

TEST(PartFormats, AFileOfNoFormatIsToldTheFormatsAndAProjectItsCommands) {
  const test::TemporaryFolder folder;
  const auto refusalOf = [&](const std::string& name, const std::string& bytes) -> std::string {
    base::writeFile(folder / name, bytes);
    try {
      loadPart((folder / name).string(), true, {});
    } catch (const base::Error& error) {
      return error.what();
    }
    return "no error";
  };
  const std::string letter = refusalOf("letter.doc", "Dear all\n");
  for (const PartFormat& format : partFormats())
    EXPECT_NE(letter.find(format.name), std::string::npos) << format.name << ": " << letter;
  EXPECT_NE(refusalOf("job.voluta", "VOLUTA 3\n0 0\n").find("'resume'"), std::string::npos);
  EXPECT_NE(refusalOf("station.voluta", "VOLUTA STATION 1\n0 0\n").find("station"),
            std::string::npos);
  EXPECT_NE(refusalOf("empty.doc", "").find("empty"), std::string::npos);
}

} // namespace
} // namespace voluta::project
