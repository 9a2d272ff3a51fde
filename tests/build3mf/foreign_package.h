// Packages as another program may write them, from their parts.
#pragma once

#include "helpers/package_3mf.h"

#include <string>
#include <vector>

namespace voluta::test {

struct ForeignBuild {
  std::string unit = "millimeter", required = "tp p", unitFactor = "0.001", type = "6axis";
  std::string profile = "uuid=\"00000000-0000-0000-0000-00000000000A\" name=\"Perimeter\" "
                        "depositionspeed=\"30\" beadwidth=\"2\" beadheight=\"1\"";
  std::string modifiers;               // of that profile
  std::string extra;                   // further elements of the resource
  std::string object;                  // an object with id 7 and its item, where there is one
  std::string build = "";              // attributes of the build
  std::vector<std::string> layers;     // whole layer parts
  std::vector<int> tops;               // ztop of the first of them
  std::string layerPath = "/Slices/L"; // and the number, and .xml
  std::string moreRelations;           // of the model
  bool related = true;

  std::string bytes() const {
    ZipWriter zip(true);
    zip.add("[Content_Types].xml", "<Types/>");
    zip.add("_rels/.rels",
            "<Relationships xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\">"
            "<Relationship Target=\"/Model/it.model\" Id=\"a\" "
            "Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/>"
            "</Relationships>");
    std::string references, relations;
    for (std::size_t k = 0; k < layers.size(); ++k) {
      const std::string path = layerPath + std::to_string(k) + ".xml";
      references += "<tp:toolpathlayer path=\"" + path + "\"" +
                    (k < tops.size() ? " ztop=\"" + std::to_string(tops[k]) + "\"" : "") + "/>";
      relations += "<Relationship Target=\"" + path + "\" Id=\"l" + std::to_string(k) +
                   "\" Type=\"http://schemas.3mf.io/3dmanufacturing/toolpath/2026/03/layer\"/>";
      zip.add(path.substr(1), layers[k]);
    }
    if (related)
      zip.add("Model/_rels/it.model.rels",
              "<Relationships xmlns=\"http://schemas.openxmlformats.org/package/2006/"
              "relationships\">" +
                  relations + moreRelations + "</Relationships>");
    zip.add("Model/it.model",
            "<?xml version=\"1.0\"?><model unit=\"" + unit +
                "\" xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\" "
                "xmlns:p=\"http://schemas.microsoft.com/3dmanufacturing/production/2015/06\" "
                "xmlns:tp=\"http://schemas.3mf.io/3dmanufacturing/toolpath/2026/03\" "
                "xmlns:x=\"urn:somebody\" requiredextensions=\"" +
                required + "\"><resources><tp:toolpathresource id=\"3\" uuid=\"u\" unitfactor=\"" +
                unitFactor + "\" toolpathtype=\"" + type +
                "\"><tp:toolpathprofiles><tp:toolpathprofile " + profile + ">" + modifiers +
                "</tp:toolpathprofile></tp:toolpathprofiles><tp:toolpathlayers>" + references +
                "</tp:toolpathlayers>" + extra + "</tp:toolpathresource>" + object +
                "</resources><build " + build + ">" +
                (object.empty() ? "" : "<item objectid=\"7\"/>") + "</build></model>");
    return zip.bytes();
  }
};

inline std::string foreignLayer(const std::string& segments) {
  return "<layer xmlns=\"http://schemas.3mf.io/3dmanufacturing/toolpath/2026/03\" "
         "xmlns:x=\"urn:somebody\"><parts><part id=\"4\" uuid=\"q\"/></parts><profiles><profile "
         "id=\"9\" uuid=\"00000000-0000-0000-0000-00000000000a\"/></profiles><segments>" +
         segments + "</segments></layer>";
}
// `type`: polyline6d or polyline3d.
inline std::string foreignSegment(const std::string& type, const std::string& points) {
  return "<segment type=\"" + type + "\" profileid=\"9\" partid=\"4\">" + points + "</segment>";
}
// Coordinates in units; upright.
inline std::string point6d(int x, int y, int z, const std::string& factors = "") {
  return "<point6d x=\"" + std::to_string(x) + "\" y=\"" + std::to_string(y) + "\" z=\"" +
         std::to_string(z) + "\" i=\"0\" j=\"0\" k=\"0\" w=\"1\" " + factors + "/>";
}

} // namespace voluta::test
