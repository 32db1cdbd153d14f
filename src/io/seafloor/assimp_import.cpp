#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <fmt/format.h>

#include <assimp/Importer.hpp>

#include "io/files/text.h"
#include "io/seafloor/assimp_internal.h"
#include "mesh/base/error.h"

namespace swathplan {
namespace {

/// glTF is y up by its standard. Assimp gives COLLADA y up, whatever axis the file states.
bool comes_y_up(const std::string& extension) {
  return extension == ".gltf" || extension == ".glb" || extension == ".dae";
}

void append(const aiMesh& mesh, bool y_up, SurfaceData& data) {
  const auto first = static_cast<std::uint32_t>(data.vertices.size());
  for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
    const aiVector3D& p = mesh.mVertices[i];
    if (y_up) {
      data.vertices.emplace_back(p.x, -p.z, p.y);
    } else {
      data.vertices.emplace_back(p.x, p.y, p.z);
    }
  }
  for (unsigned i = 0; i < mesh.mNumFaces; ++i) {
    const aiFace& face = mesh.mFaces[i];
    if (face.mNumIndices != 3) continue;
    data.faces.push_back(
        {first + face.mIndices[0], first + face.mIndices[1], first + face.mIndices[2]});
  }
}

}  // namespace

bool assimp_reads(const std::string& extension) {
  return Assimp::Importer().IsExtensionSupported(extension);
}

SurfaceData read_with_assimp(const std::filesystem::path& path) {
  Assimp::Importer importer;
  importer.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE,
                              aiPrimitiveType_POINT | aiPrimitiveType_LINE);
  const aiScene* scene =
      importer.ReadFile(path.string(), aiProcess_ValidateDataStructure | aiProcess_Triangulate |
                                           aiProcess_SortByPType | aiProcess_GlobalScale |
                                           aiProcess_PreTransformVertices);
  if (scene == nullptr) {
    throw InvalidInput(
        fmt::format("'{}' cannot be read as a mesh ({}); export it again, for "
                    "instance as OBJ or PLY",
                    path.string(), quotable(importer.GetErrorString(), 300)));
  }
  SurfaceData data;
  const std::string extension = lower(path.extension().string());
  data.format = extension.empty() ? "mesh" : extension == ".dae" ? "COLLADA" : extension.substr(1);
  const bool y_up = comes_y_up(extension);
  for (unsigned i = 0; i < scene->mNumMeshes; ++i) append(*scene->mMeshes[i], y_up, data);
  if (extension == ".gltf" || extension == ".glb") {
    data.notes.emplace_back("glTF is y up: turned so that its y axis is up and its -z axis north");
  }
  return data;
}

}  // namespace swathplan
