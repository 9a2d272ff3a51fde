// voluta-mesh-reader as-written|upright FILE: reads a mesh file with assimp and writes its
// triangles to standard output as nine doubles each. Run by geometry/formats/foreign_reader.cpp,
// which explains the two words.
#include "reader_limits.h"

#include <assimp/Importer.hpp>
#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <cctype>
#include <cstdio>
#include <cstring>
#include <string>
#include <vector>

namespace {

constexpr rlim_t kMaxSeconds = 120;

bool endsWith(std::string text, const char* end) {
  for (char& c : text)
    c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text.ends_with(end);
}

void append(const aiNode& node, const aiMatrix4x4& above, const aiScene& scene,
            std::vector<double>& out) {
  const aiMatrix4x4 here = above * node.mTransformation;
  for (unsigned m = 0; m < node.mNumMeshes; ++m) {
    const aiMesh& mesh = *scene.mMeshes[node.mMeshes[m]];
    for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
      const aiFace& face = mesh.mFaces[f];
      if (face.mNumIndices != 3)
        continue;
      for (unsigned k = 0; k < 3; ++k) {
        const aiVector3D p = here * mesh.mVertices[face.mIndices[k]];
        out.insert(out.end(),
                   {static_cast<double>(p.x), static_cast<double>(p.y), static_cast<double>(p.z)});
      }
    }
  }
  for (unsigned c = 0; c < node.mNumChildren; ++c)
    append(*node.mChildren[c], here, scene, out);
}

} // namespace

int main(int argc, char** argv) {
  if (argc != 3)
    return 2;
  voluta::limitReader(kMaxSeconds);
  const bool upright = std::strcmp(argv[1], "upright") == 0;
  const std::string file = argv[2];
  const bool collada = endsWith(file, ".dae");
  const bool gltf = endsWith(file, ".gltf") || endsWith(file, ".glb");
  Assimp::Importer importer;
  // Scenes are read as they are. In COLLADA files without an up axis, assimp assumes y.
  importer.SetPropertyBool(AI_CONFIG_IMPORT_COLLADA_IGNORE_UP_DIRECTION, !upright);
  importer.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE,
                              aiPrimitiveType_POINT | aiPrimitiveType_LINE);
  const aiScene* scene = importer.ReadFile(file, aiProcess_Triangulate | aiProcess_SortByPType);
  if (!scene || !scene->mRootNode)
    return 1;
  std::vector<double> out;
  append(*scene->mRootNode, aiMatrix4x4(), *scene, out);
  if (upright && (collada || gltf)) {
    constexpr double kMmInMetre = 1000.0;
    for (std::size_t i = 0; i < out.size(); i += 3) {
      const double y = out[i + 1], z = out[i + 2];
      out[i] *= kMmInMetre;
      out[i + 1] = -kMmInMetre * z;
      out[i + 2] = kMmInMetre * y;
    }
  }
  return std::fwrite(out.data(), sizeof(double), out.size(), stdout) == out.size() &&
                 std::fflush(stdout) == 0
             ? 0
             : 1;
}
