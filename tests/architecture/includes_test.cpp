// The house (docs/design.md, The house), held by reading every #include: directions between
// modules, no Qt and no VTK in core, no planner in replay.
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace fs = std::filesystem;

namespace {

// The modules that each module may include besides itself and base.
const std::map<std::string, std::set<std::string>> kMayInclude = {
    {"base", {}},
    {"texts", {}},
    {"page", {}},
    {"geometry", {}},
    {"milling", {"geometry", "plan"}},
    {"platform", {"geometry"}},
    {"process", {"geometry", "plan"}},
    {"voxel", {"geometry"}},
    {"plan", {}},
    {"build3mf", {"geometry", "process", "voxel", "plan"}},
    {"layers", {"geometry", "voxel", "process", "plan"}},
    {"curved", {"geometry", "voxel", "process", "layers", "plan"}},
    {"support", {"geometry", "voxel", "process", "layers", "plan", "curved"}},
    {"planar", {"geometry", "voxel", "process", "layers", "plan"}},
    {"substrate", {"geometry", "platform", "voxel", "process", "layers", "plan"}},
    {"placement", {"geometry", "voxel", "process", "layers", "plan", "curved"}},
    {"robot", {"geometry", "platform", "process"}},
    {"indicator", {"geometry", "platform", "process", "robot", "plan"}},
    {"collision", {"geometry", "platform", "process", "voxel", "robot", "plan"}},
    {"cells", {"geometry", "platform", "process", "voxel", "robot", "plan", "collision"}},
    {"toolpath",
     {"geometry", "platform", "process", "voxel", "robot", "plan", "collision", "layers"}},
    {"elastic", {"geometry", "voxel", "process", "plan"}},
    {"together", {"geometry", "platform", "process", "voxel", "robot", "plan", "collision"}},
    {"motion",
     {"geometry", "platform", "process", "voxel", "robot", "plan", "collision", "layers",
      "toolpath", "indicator"}},
    {"program", {"geometry", "process", "robot", "plan"}},
    {"sliced", {"geometry", "process", "voxel", "plan", "build3mf", "program"}},
    {"record", {"geometry", "robot", "plan", "program"}},
    {"replay", {"geometry", "platform", "process", "voxel", "robot", "plan", "program"}},
    {"project",
     {"texts", "geometry", "platform", "process", "voxel", "plan", "build3mf", "layers", "curved",
      "planar", "sliced"}},
    {"regions",
     {"geometry", "process", "plan", "layers", "curved", "planar", "substrate", "toolpath",
      "project"}},
    {"modes",
     {"geometry", "platform", "process", "voxel", "plan", "layers", "curved", "planar", "substrate",
      "support", "robot", "project"}},
    {"pipeline",
     {"geometry", "platform", "process",   "voxel",   "plan",      "build3mf", "layers",
      "curved",   "planar",   "substrate", "support", "placement", "robot",    "collision",
      "cells",    "toolpath", "together",  "motion",  "program",   "record",   "replay",
      "elastic",  "project",  "regions",   "modes",   "page",      "sliced",   "milling"}},
};

struct Include {
  fs::path file;
  std::string target;
};

std::vector<Include> includesBelow(const fs::path& folder) {
  static const std::regex kInclude(R"(^\s*#\s*include\s*[<"]([^>"]+)[>"])");
  std::vector<Include> found;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const std::string extension = entry.path().extension().string();
    if (extension != ".h" && extension != ".cpp" && extension != ".in")
      continue;
    std::ifstream in(entry.path());
    for (std::string line; std::getline(in, line);)
      if (std::smatch match; std::regex_search(line, match, kInclude))
        found.push_back({entry.path(), match[1]});
  }
  return found;
}

const fs::path kCore = fs::path(VOLUTA_SOURCE_DIR) / "core";

TEST(Architecture, CoreIncludesNeitherQtNorVtk) {
  const std::regex graphical(R"(^(Q[A-Z]|Qt|vtk|QtCore/|VTK))");
  const auto all = includesBelow(kCore);
  ASSERT_GT(all.size(), 100u);
  for (const Include& include : all)
    EXPECT_FALSE(std::regex_search(include.target, graphical))
        << include.file << " includes " << include.target;
}

// The window: drawing code does not use Qt, only the viewer uses both, and dependencies point one
// way.
const fs::path kWidgets = fs::path(VOLUTA_SOURCE_DIR) / "widgets";
const std::map<std::string, std::set<std::string>> kWidgetsMayInclude = {
    {"language", {}},
    {"scene", {}},
    {"pictures", {"scene"}},
    {"viewer", {"scene"}},
    {"forms", {"language"}},
    {"panels", {"forms", "language"}},
    {"jobs", {}},
    {"document", {"jobs", "language"}},
    {"timeline", {"forms", "jobs"}},
    {"window",
     {"language", "scene", "pictures", "viewer", "forms", "panels", "jobs", "document",
      "timeline"}},
};

TEST(Architecture, WidgetsKeepTheirDirections) {
  for (const auto& entry : fs::directory_iterator(kWidgets)) {
    const bool known = kWidgetsMayInclude.count(entry.path().filename().string()) > 0;
    EXPECT_TRUE(known || !entry.is_directory()) << entry.path();
  }
  const std::regex qt("^(Q[A-Z]|Qt)"), vtk("^vtk");
  for (const Include& include : includesBelow(kWidgets)) {
    const std::string from = fs::relative(include.file, kWidgets).begin()->string();
    const bool qtInScene =
        (from == "scene" || from == "pictures") && std::regex_search(include.target, qt);
    const bool vtkInPanels =
        from != "scene" && from != "viewer" && std::regex_search(include.target, vtk);
    const std::string to = fs::path(include.target).begin()->string();
    const bool against =
        kWidgetsMayInclude.count(to) && to != from && !kWidgetsMayInclude.at(from).count(to);
    EXPECT_FALSE(qtInScene || vtkInPanels || against)
        << include.file << " includes " << include.target;
  }
}

std::string contentOf(const fs::path& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

// A dialog of Qt's own asks about an existing file before the name has its ending.
TEST(Architecture, FilesToWriteAreAskedForInOnePlace) {
  for (const auto& entry : fs::recursive_directory_iterator(kWidgets)) {
    if (!entry.is_regular_file() || entry.path().filename() == "save_file.cpp")
      continue;
    const std::string text = contentOf(entry.path());
    EXPECT_EQ(text.find("getSaveFileName"), std::string::npos)
        << entry.path() << ": forms::saveFile";
    EXPECT_EQ(text.find("AcceptSave"), std::string::npos) << entry.path() << ": forms::saveFile";
  }
}

TEST(Architecture, CoreIncludesNoWidgets) {
  for (const Include& include : includesBelow(kCore))
    EXPECT_FALSE(kWidgetsMayInclude.count(fs::path(include.target).begin()->string()))
        << include.file << " includes " << include.target;
}

TEST(Architecture, ModulesIncludeOnlyTheirAllowedDependencies) {
  for (const auto& entry : fs::directory_iterator(kCore))
    EXPECT_TRUE(kMayInclude.count(entry.path().filename().string()))
        << entry.path() << " is not in the table of modules";
  for (const Include& include : includesBelow(kCore)) {
    const std::string from = fs::relative(include.file, kCore).begin()->string();
    const std::string to = fs::path(include.target).begin()->string();
    if (!kMayInclude.count(to) || to == from || to == "base")
      continue;
    EXPECT_TRUE(kMayInclude.at(from).count(to)) << include.file << " includes " << include.target;
  }
}

// Programs are read by core/program alone: what judges a milled part takes motions and statements.
TEST(Architecture, MillingParsesNoText) {
  const std::set<std::string> parsers{"cctype", "charconv", "istream", "regex", "sstream"};
  for (const Include& include : includesBelow(kCore / "milling"))
    EXPECT_FALSE(parsers.count(include.target)) << include.file << " includes " << include.target;
}

// Headers that cost seconds to compile stay in sources, or in headers that only sources of the same
// module include; the way from a mesh to CGAL's and back and the triangulation of the plane are for
// sources of any module that needs them.
TEST(Architecture, HeavyHeadersStayPrivate) {
  const std::regex heavy(R"(^(CGAL|fcl|libsvm|ompl|nlohmann|CLI)/)");
  const auto all = includesBelow(kCore);
  std::set<std::string> heavyHeaders;
  for (const Include& include : all)
    if (include.file.extension() == ".h" && std::regex_search(include.target, heavy) &&
        include.target != "nlohmann/json_fwd.hpp")
      heavyHeaders.insert(fs::relative(include.file, kCore).string());
  for (const Include& include : all)
    if (heavyHeaders.count(include.target)) {
      EXPECT_EQ(include.file.extension(), ".cpp")
          << include.file << " passes on " << include.target;
      const bool shared = include.target == "geometry/cgal_mesh.h" ||
                          include.target == "layers/constrained_triangulation.h";
      EXPECT_TRUE(shared ||
                  *fs::relative(include.file, kCore).begin() == *fs::path(include.target).begin())
          << include.file;
    }
}

// A damaged CAD file must not reach a process with a job in it: only the reader's has the kernel.
TEST(Architecture, OnlyTheReaderOfCadFilesHasTheKernel) {
  const fs::path root = VOLUTA_SOURCE_DIR;
  std::set<std::string> folders;
  for (const char* folder : {"app", "core", "widgets", "tests"})
    for (const Include& include : includesBelow(root / folder))
      if (include.target.ends_with(".hxx"))
        folders.insert(fs::relative(include.file.parent_path(), root).generic_string());
  EXPECT_EQ(folders, (std::set<std::string>{"app/cad_reader", "tests/cad"}));
}

// Headers that hundreds of sources include declare the types that they only refer to: an edit of an
// algorithm's header then compiles little, and each compiler reads little.
TEST(Architecture, WidelyIncludedHeadersReachNoAlgorithm) {
  // Modules and single headers.
  const std::map<std::string, std::set<std::string>> mayReach = {
      {"pipeline/plan_result.h",
       {"base", "geometry", "plan", "platform", "process", "project", "layers/print_order.h",
        "curved/growth_scheme.h"}},
      {"pipeline/stages.h", {"base", "plan", "project", "motion/too_large.h"}},
      {"project/job.h",
       {"base", "geometry", "plan", "platform", "project", "layers/print_order.h",
        "curved/growth_scheme.h"}},
      {"modes/mode.h", {"base", "geometry", "plan", "platform", "project", "modes/from_options.h"}},
      {"toolpath/plan_toolpaths.h",
       {"base", "geometry", "plan", "platform", "process", "toolpath/cover_rules.h",
        "toolpath/options.h"}},
      {"collision/cell_collision.h", {"base", "robot/body.h", "collision/margins.h"}},
      {"collision/growing_part.h", {"base", "robot/body.h"}}};
  std::map<std::string, std::vector<std::string>> includes;
  for (const Include& include : includesBelow(kCore))
    includes[fs::relative(include.file, kCore).string()].push_back(include.target);
  for (const auto& [header, allowed] : mayReach) {
    ASSERT_TRUE(includes.count(header)) << header;
    std::set<std::string> reached;
    std::vector<std::string> next = includes[header];
    while (!next.empty()) {
      const std::string target = next.back();
      next.pop_back();
      const bool isOurs = kMayInclude.count(fs::path(target).begin()->string()) > 0;
      if (!isOurs || !reached.insert(target).second)
        continue;
      EXPECT_TRUE(allowed.count(target) || allowed.count(fs::path(target).begin()->string()))
          << header << " reaches " << target;
      for (const std::string& further : includes[target])
        next.push_back(further);
    }
  }
}

} // namespace
