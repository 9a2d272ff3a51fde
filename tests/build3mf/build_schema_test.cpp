// A package of ours against the extension's schemas, by xmllint. Both are no part of the project:
// the tests skip where one is absent.
#include "base/files.h"
#include "base/run_context.h"
#include "build3mf/build_writer.h"
#include "geometry/formats/zip_package.h"
#include "helpers/temporary_folder.h"
#include "sample_beads.h"

#include <cstdlib>
#include <filesystem>
#include <gtest/gtest.h>

using namespace voluta;

namespace {

// VOLUTA_REFERENCES, or ../shared/references beside the checkout.
std::filesystem::path referenceFolder() {
  if (const char* folder = std::getenv("VOLUTA_REFERENCES"))
    return folder;
  return std::filesystem::path(VOLUTA_SOURCE_DIR).parent_path() / "shared" / "references";
}

bool valid(const std::filesystem::path& xml, const std::filesystem::path& schema) {
  const std::string command = "xmllint --nonet --noout --schema '" + schema.string() + "' '" +
                              xml.string() + "' > /dev/null 2> '" + xml.string() + ".said'";
  const bool good = std::system(command.c_str()) == 0;
  if (!good)
    ADD_FAILURE() << base::readFile(xml.string() + ".said").substr(0, 2000);
  return good;
}

// The schema as xmllint takes it: without its import of xml.xsd, which names a server and declares
// nothing it uses, and with no end instead of 2^31 - 1 elements, more than libxml2 counts to.
std::filesystem::path local(const std::filesystem::path& schema,
                            const std::filesystem::path& folder) {
  std::string text = base::readFile(schema);
  if (const std::size_t at = text.find("<xs:import"); at != std::string::npos)
    text.erase(at, text.find("/>", at) + 2 - at);
  const std::string maximum = "\"2147483647\"";
  for (std::size_t at = 0; (at = text.find(maximum, at)) != std::string::npos;)
    text.replace(at, maximum.size(), "\"unbounded\"");
  const std::filesystem::path copy = folder / schema.filename();
  base::writeFile(copy, text);
  return copy;
}

// The element with all that is in it, with the namespaces that it needs.
std::string element(const std::string& text, const std::string& name, const std::string& spaces) {
  const std::size_t begin = text.find("<" + name), end = text.find("</" + name + ">");
  std::string cut = text.substr(begin, end - begin) + "</" + name + ">";
  return cut.insert(name.size() + 1, " " + spaces);
}

TEST(BuildSchema, ResourceAndLayersAreValid) {
  const std::filesystem::path folder = referenceFolder();
  if (!std::filesystem::exists(folder / "toolpath_2026_03.xsd"))
    GTEST_SKIP() << "the schemas are not here (set VOLUTA_REFERENCES)";
  if (std::system("xmllint --version > /dev/null 2>&1") != 0)
    GTEST_SKIP() << "xmllint is not here (libxml2-utils)";
  const test::TemporaryFolder temporary;
  const auto whole = local(folder / "toolpath_2026_03.xsd", temporary.path());
  const auto layer = local(folder / "toolpath_layer_2026_03.xsd", temporary.path());
  const std::string bytes = build3mf::writeBuild(
      test::randomBeads(11, 6), test::box({0, 0, 0}, {1, 1, 1}), "part.stl", base::RunContext());
  const std::string name = "part.build.3mf";
  const geometry::ZipPackage package(bytes, name);
  const auto resource = temporary.path() / "resource.xml";
  base::writeFile(resource,
                  element(package.member("3D/3dmodel.model"), "tp:toolpathresource",
                          "xmlns:tp=\"http://schemas.3mf.io/3dmanufacturing/toolpath/2026/03\" "
                          "xmlns:v=\"urn:voluta:toolpath:2026\""));
  EXPECT_TRUE(valid(resource, whole));
  int layers = 0;
  for (; package.has("Toolpath/Layers/layer0000" + std::to_string(layers + 1) + ".xml"); ++layers) {
    const auto file = temporary.path() / "layer.xml";
    base::writeFile(
        file, package.member("Toolpath/Layers/layer0000" + std::to_string(layers + 1) + ".xml"));
    EXPECT_TRUE(valid(file, layer));
    EXPECT_TRUE(valid(file, whole));
  }
  EXPECT_EQ(layers, 3);
  // The check can fail.
  base::writeFile(resource,
                  "<layer xmlns=\"http://schemas.3mf.io/3dmanufacturing/toolpath/2026/03\">"
                  "<segments><segment type=\"spiral\"/></segments></layer>");
  EXPECT_NE(std::system(("xmllint --nonet --noout --schema '" + layer.string() + "' '" +
                         resource.string() + "' > /dev/null 2>&1")
                            .c_str()),
            0);
}

} // namespace
