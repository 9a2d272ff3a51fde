// The files that the package installs: component `program` of the build.
#include "helpers/program_output.h"
#include "helpers/temporary_folder.h"

#include <filesystem>
#include <gtest/gtest.h>
#include <set>
#include <string>

namespace fs = std::filesystem;

namespace voluta {
namespace {

TEST(InstalledPrograms, AreWholeAndBringNoHeadersOrLibraries) {
  const test::TemporaryFolder tree;
  const test::ProgramOutput install = test::outputOf(
      VOLUTA_CMAKE " --install " VOLUTA_BINARY_DIR " --component program --prefix '" +
      tree.path().string() + "'");
  ASSERT_EQ(install.code, 0) << install.text;
  std::set<std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(tree.path()))
    if (entry.is_regular_file())
      files.insert(fs::relative(entry.path(), tree.path()).string());
  for (const char* file :
       {"bin/voluta", "bin/voluta-cli", "libexec/voluta/voluta-cad-reader",
        "libexec/voluta/voluta-mesh-reader", "share/applications/org.voluta.voluta.desktop",
        "share/bash-completion/completions/voluta-cli",
        "share/icons/hicolor/scalable/apps/org.voluta.voluta.svg", "share/man/man1/voluta.1",
        "share/man/man1/voluta-cli.1", "share/metainfo/org.voluta.voluta.metainfo.xml",
        "share/mime/packages/voluta.xml", "share/voluta/robots/ur5.json",
        "share/voluta/cells/ur5-fixed.json", "share/voluta/processes/fdm-1.0.json",
        "share/voluta/materials/pla.json"})
    EXPECT_TRUE(files.contains(file)) << file;
  for (const std::string& file : files) {
    const std::string ending = fs::path(file).extension().string();
    EXPECT_FALSE(ending == ".h" || ending == ".a" || ending == ".cmake") << file;
    EXPECT_FALSE(file.starts_with("share/voluta/icons")) << file;
  }
}

} // namespace
} // namespace voluta
