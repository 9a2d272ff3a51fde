// Solids and files of CAD, made with Open CASCADE by the tests.
#pragma once

#include <TopoDS_Shape.hxx>
#include <filesystem>
#include <string>
#include <vector>

namespace voluta::test {

struct CadSolid {
  std::string name;
  TopoDS_Shape shape; // lengths in mm
};

CadSolid boxWithHoles(); // 40 x 30 x 20 mm, holes of 10 and 6 mm along z
CadSolid bentPipe();     // a quarter of a bend: 20 mm outside, 16 mm inside, bent about 30 mm
CadSolid blendedBlock(); // 30 x 20 x 15 mm, every edge rounded by 4 mm
CadSolid thinShell();    // a cup: cylinder of 24 mm and 30 mm height, walls of 1.2 mm inside
double volumeMm3(const TopoDS_Shape& shape); // by the kernel

// The solids of an assembly with their names, in place; not its file.
std::vector<CadSolid> assemblySolids(); // base, lid, and a pin that is used twice

enum class CadFormat { Step, Iges, IgesFaces }; // the last: trimmed surfaces that form no solid

// `unit`: "MM", "INCH" or "M", in which the file states its lengths. Several solids are the
// products of one assembly.
void writeCad(const std::vector<CadSolid>& solids, CadFormat format, const std::string& unit,
              const std::filesystem::path& file);
void writeCurves(const std::filesystem::path& file); // STEP: a circle and no face

} // namespace voluta::test
