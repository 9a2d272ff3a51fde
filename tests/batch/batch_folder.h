// A folder with parts, in which voluta-cli batch runs.
#pragma once

#include "helpers/program_output.h"
#include "helpers/temporary_folder.h"

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>

namespace voluta::test {

class BatchFolder {
public:
  explicit BatchFolder() { std::filesystem::create_directory(folder_ / "parts"); }

  std::filesystem::path operator/(const std::string& name) const { return folder_ / name; }

  void write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name, std::ios::binary) << text;
  }
  std::string read(const std::string& name) const {
    std::ifstream in(folder_ / name, std::ios::binary);
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
  }
  nlohmann::ordered_json json(const std::string& name) const {
    return nlohmann::ordered_json::parse(read(name));
  }

  // A square bar, as an ASCII STL.
  void writeBar(const std::string& name, double side, double height) const {
    const double s = side, h = height;
    const double corners[8][3] = {{0, 0, 0}, {s, 0, 0}, {s, s, 0}, {0, s, 0},
                                  {0, 0, h}, {s, 0, h}, {s, s, h}, {0, s, h}};
    const int faces[12][3] = {{0, 2, 1}, {0, 3, 2}, {4, 5, 6}, {4, 6, 7}, {0, 1, 5}, {0, 5, 4},
                              {1, 2, 6}, {1, 6, 5}, {2, 3, 7}, {2, 7, 6}, {3, 0, 4}, {3, 4, 7}};
    std::ostringstream stl;
    stl << "solid bar\n";
    for (const auto& face : faces) {
      stl << "facet normal 0 0 0\nouter loop\n";
      for (const int corner : face)
        stl << "vertex " << corners[corner][0] << ' ' << corners[corner][1] << ' '
            << corners[corner][2] << '\n';
      stl << "endloop\nendfacet\n";
    }
    stl << "endsolid\n";
    write(name, stl.str());
  }

  // Runs the words of a shell in the folder; standard error is in "err".
  ProgramOutput run(const std::string& words) const {
    return outputOf("cd '" + folder_.path().string() + "' && " + words + " 2> err");
  }
  ProgramOutput batch(const std::string& words) const {
    return run(std::string(VOLUTA_CLI) + " batch " + words);
  }

private:
  TemporaryFolder folder_;
};

} // namespace voluta::test
