#include "geometry/facet_soup.h"

#include "base/error.h"

#include <algorithm>
#include <assimp/Importer.hpp>
#include <assimp/scene.h>

namespace voluta::geometry {

using base::Error;
using base::ErrorCode;
using Eigen::Vector3d;

namespace {

void collect(const aiScene& scene, const aiNode& node, const aiMatrix4x4& parent,
             std::vector<Facet>& facets) {
  const aiMatrix4x4 world_T_node = parent * node.mTransformation;
  for (unsigned m = 0; m < node.mNumMeshes; ++m) {
    const aiMesh& mesh = *scene.mMeshes[node.mMeshes[m]];
    for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
      const aiFace& face = mesh.mFaces[f];
      if (face.mNumIndices != 3)
        continue; // points and lines
      Facet facet;
      for (unsigned k = 0; k < 3; ++k) {
        if (face.mIndices[k] >= mesh.mNumVertices)
          throw Error(ErrorCode::UnreadableFile, "a facet names a vertex that is not there");
        const aiVector3D v = world_T_node * mesh.mVertices[face.mIndices[k]];
        facet[k] = {v.x, v.y, v.z};
      }
      facets.push_back(facet);
    }
  }
  for (unsigned c = 0; c < node.mNumChildren; ++c)
    collect(scene, *node.mChildren[c], world_T_node, facets);
}

// In one line, without what only means something to assimp.
std::string reason(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text.empty() ? "unknown reason" : text;
}

} // namespace

FacetSoup read3mfByAssimp(std::string_view bytes, const std::string& name) {
  Assimp::Importer importer;
  const aiScene* scene = importer.ReadFileFromMemory(bytes.data(), bytes.size(), 0, "3mf");
  if (!scene || !scene->mRootNode)
    throw Error(ErrorCode::UnreadableFile,
                "not readable as a mesh: " + reason(importer.GetErrorString()), name);
  FacetSoup soup;
  soup.format = "3MF";
  soup.repairs.push_back("lengths taken as mm; the unit named in a 3MF file is not read");
  collect(*scene, *scene->mRootNode, aiMatrix4x4(), soup.facets);
  return soup;
}

} // namespace voluta::geometry
