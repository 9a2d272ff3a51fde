// Damaged and hostile packages: each gives one line with the fault and its place, and no other
// error.
#include "base/error.h"
#include "base/run_context.h"
#include "build3mf/build_reader.h"
#include "foreign_package.h"

#include <functional>
#include <gtest/gtest.h>

using namespace voluta;
using test::foreignLayer;
using test::foreignSegment;
using test::point6d;

namespace {

test::ForeignBuild sound() {
  test::ForeignBuild file;
  file.layers = {
      foreignLayer(foreignSegment("polyline6d", point6d(0, 0, 0) + point6d(1000, 0, 0)))};
  return file;
}

std::string refusal(const std::string& bytes) {
  try {
    build3mf::readBuild(bytes, "it.build.3mf", base::RunContext());
  } catch (const base::Error& e) {
    EXPECT_NE(e.code(), base::ErrorCode::Internal) << e.what();
    return e.what();
  }
  return "";
}

struct Case {
  const char* name;
  std::function<void(test::ForeignBuild&)> damage;
  const char* says;
};

std::string pointWith(const std::string& from, const std::string& to) {
  std::string point = point6d(1000, 0, 0);
  return point.replace(point.find(from), from.size(), to);
}
void second(test::ForeignBuild& file, const std::string& point) {
  file.layers = {foreignLayer(foreignSegment("polyline6d", point6d(0, 0, 0) + point))};
}

TEST(HostileBuild, ASoundOneIsTaken) {
  EXPECT_EQ(refusal(sound().bytes()), "");
}

TEST(HostileBuild, EachFaultIsRefusedWithItsReason) {
  const std::vector<Case> cases{
      {"unit", [](auto& f) { f.unit = "furlong"; }, "unknown unit 'furlong'"},
      {"no factor", [](auto& f) { f.unitFactor = "0"; }, "'unitfactor' is not above 0"},
      {"factor nan", [](auto& f) { f.unitFactor = "nan"; }, "'unitfactor' is not a number"},
      {"of another type", [](auto& f) { f.type = "7axis"; }, "tool-paths of type '7axis'"},
      {"a laser's",
       [](auto& f) {
         f.type = "planar";
         f.profile = "uuid=\"00000000-0000-0000-0000-00000000000A\" name=\"Fill\"";
       },
       "tool-paths of type 'planar' without beads"},
      {"planar without heights", [](auto& f) { f.type = "planar"; }, "has no height above"},
      {"planar that sinks",
       [](auto& f) {
         f.type = "planar";
         f.tops = {-5};
       },
       "has no height above"},
      {"six axes in a plane",
       [](auto& f) {
         f.type = "planar";
         f.tops = {800};
       },
       "a segment of type 'polyline6d' among tool-paths of 2 axes"},
      {"extension", [](auto& f) { f.required = "tp p x"; }, "extension 'urn:somebody'"},
      {"undeclared", [](auto& f) { f.required = "tp zz"; }, "extension 'zz'"},
      {"traversal", [](auto& f) { f.layerPath = "/../../etc/passwd"; },
       "is not the name of a part"},
      {"dots within", [](auto& f) { f.layerPath = "/a/../b"; }, "is not the name of a part"},
      {"relative", [](auto& f) { f.layerPath = "Slices/L"; }, "is not the name of a part"},
      {"unrelated", [](auto& f) { f.related = false; }, "is not related to the model"},
      {"no layers", [](auto& f) { f.layers.clear(); }, "contains no tool-paths"},
      {"twice", [](auto& f) { f.extra = "<tp:toolpathlayer path=\"/Slices/L0.xml\"/>"; },
       "duplicate layer"},
      {"missing layer", [](auto& f) { f.extra = "<tp:toolpathlayer path=\"/Slices/L5.xml\"/>"; },
       "is not related to the model"},
      {"laser",
       [](auto& f) {
         f.modifiers = "<tp:modifier attribute=\"laserpower\" type=\"linear\" minvalue=\"0\" "
                       "maxvalue=\"2\" factor=\"f\"/>";
       },
       "an unsupported modifier of 'laserpower'"},
      {"empty range",
       [](auto& f) {
         f.modifiers = "<tp:modifier attribute=\"beadwidth\" type=\"linear\" minvalue=\"2\" "
                       "maxvalue=\"2\" factor=\"f\"/>";
       },
       "without a range"},
      {"no such factor",
       [](auto& f) {
         f.modifiers = "<tp:modifier attribute=\"beadwidth\" type=\"linear\" minvalue=\"1\" "
                       "maxvalue=\"2\" factor=\"z\"/>";
       },
       "without a factor"},
      {"width",
       [](auto& f) {
         f.profile = "uuid=\"00000000-0000-0000-0000-00000000000a\" name=\"n\" beadwidth=\"-1\"";
       },
       "'beadwidth' is not above 0"},
      {"endless width",
       [](auto& f) {
         f.profile = "uuid=\"00000000-0000-0000-0000-00000000000a\" name=\"n\" beadwidth=\"1e300\"";
       },
       "or too large"},
      {"endless range",
       [](auto& f) {
         f.modifiers = "<tp:modifier attribute=\"beadwidth\" type=\"linear\" minvalue=\"1\" "
                       "maxvalue=\"1e300\" factor=\"f\"/>";
       },
       "without a range"},
      {"profile", [](auto& f) { f.profile = "uuid=\"1\" name=\"n\""; }, "is not in the model"},
      {"coordinate", [](auto& f) { second(f, pointWith("x=\"1000\"", "x=\"nan\"")); },
       "'x' is not an integer"},
      {"fraction", [](auto& f) { second(f, pointWith("x=\"1000\"", "x=\"1.5\"")); },
       "'x' is not an integer"},
      {"far", [](auto& f) { second(f, pointWith("x=\"1000\"", "x=\"99999999999999\"")); },
       "more than a kilometre"},
      {"frame", [](auto& f) { second(f, pointWith("w=\"1\"", "w=\"0\"")); }, "has no direction"},
      {"frame inf", [](auto& f) { second(f, pointWith("w=\"1\"", "w=\"1e999\"")); },
       "'w' is not a number"},
      {"beyond one", [](auto& f) { second(f, point6d(1000, 0, 0, "f=\"1.5\"")); },
       "'f' is not within 0 and 1"},
      {"half a pair", [](auto& f) { second(f, point6d(1000, 0, 0, "f1=\"0.5\"")); },
       "'f2' is not a number"},
      {"both", [](auto& f) { second(f, point6d(1000, 0, 0, "f=\"1\" f1=\"0\" f2=\"1\"")); },
       "'f' is given twice"},
      {"one point", [](auto& f) { second(f, ""); }, "fewer than two points"},
      {"other points", [](auto& f) { second(f, "<point x=\"1\" y=\"2\"/>"); },
       "an unexpected point"},
      {"other segment",
       [](auto& f) { f.layers = {foreignLayer(foreignSegment("hatch", "<hatch/>"))}; },
       "a segment of type 'hatch'"},
      {"finer",
       [](auto& f) {
         f.modifiers = "<tp:modifier attribute=\"beadwidth\" type=\"constant\" minvalue=\"1\" "
                       "maxvalue=\"2\" factor=\"f\"/>";
         second(f, point6d(1000, 0, 0, "f1=\"0\" f2=\"1\""));
       },
       "finer than"},
      {"no layer", [](auto& f) { f.layers = {"<html/>"}; }, "is not a layer"},
      {"not closed", [](auto& f) { f.layers = {"<layer"}; }, "unclosed token"},
      {"entities",
       [](auto& f) {
         f.layers = {"<!DOCTYPE l [<!ENTITY a \"b\"><!ENTITY c \"&a;&a;\">]>" + f.layers[0]};
       },
       "document type"},
      {"cdata",
       [](auto& f) { f.extra = "<tp:toolpathdata><x:a><![CDATA[b]]></x:a></tp:toolpathdata>"; },
       "unparsed text"},
  };
  for (const Case& one : cases) {
    test::ForeignBuild file = sound();
    one.damage(file);
    const std::string said = refusal(file.bytes());
    EXPECT_NE(said.find(one.says), std::string::npos) << one.name << ": '" << said << "'";
    EXPECT_EQ(said.find('\n'), std::string::npos) << one.name;
  }
}

TEST(HostileBuild, ABombOfZeroesIsNotUnpacked) {
  test::ForeignBuild file = sound();
  file.layers[0].insert(file.layers[0].find("<parts>"), std::string(std::size_t{1} << 27, ' '));
  EXPECT_NE(refusal(file.bytes()).find("implausible size"), std::string::npos);
}

TEST(HostileBuild, CutShortAnywhereItIsRefused) {
  const std::string whole = sound().bytes();
  for (std::size_t length = 0; length < whole.size(); length += 7)
    EXPECT_NE(refusal(whole.substr(0, length)), "") << length;
}

} // namespace
