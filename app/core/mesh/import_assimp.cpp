#include "core/base/error.h"
#include "core/mesh/polygons.h"

#include <assimp/scene.h>

#include <assimp/Importer.hpp>

#include <algorithm>

namespace normalscope {

namespace {

glm::dvec3 from(const aiVector3D& v) { return {v.x, v.y, v.z}; }

}  // namespace

Polygons import_by_assimp(std::string_view bytes, const char* ending, const std::string& file) {
    Assimp::Importer importer;
    // No post-processing: cutting polygons, merging vertices and computing normals is done alike for all formats.
    const aiScene* scene = importer.ReadFileFromMemory(bytes.data(), bytes.size(), 0, ending);
    if (!scene) {
        std::string reason = importer.GetErrorString();
        // It may quote the file: one line of what can be printed is enough.
        reason.resize(std::min(reason.size(), std::size_t{100}));
        std::ranges::replace_if(reason, [](char c) { return c < ' ' || c > '~'; }, ' ');
        throw InputError(file + ": is not a usable " + ending + " file (" + reason + "); export the mesh anew");
    }
    Polygons polygons;
    for (unsigned m = 0; m < scene->mNumMeshes; ++m) {
        const aiMesh& mesh = *scene->mMeshes[m];
        const auto base = static_cast<std::int32_t>(polygons.positions.size());
        for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
            polygons.positions.push_back(from(mesh.mVertices[i]));
            polygons.normals.push_back(mesh.mNormals ? from(mesh.mNormals[i]) : glm::dvec3(0.0));
        }
        Polygons::Block& block = polygons.faces.emplace_back();
        for (unsigned f = 0; mesh.mFaces && f < mesh.mNumFaces; ++f) {
            const aiFace& face = mesh.mFaces[f];
            for (unsigned k = 0; k < face.mNumIndices; ++k) {
                // assimp hands on indices as they are: those out of range must not reach the next mesh's vertices.
                const unsigned index = face.mIndices[k];
                const std::int32_t corner = index < mesh.mNumVertices ? base + static_cast<std::int32_t>(index) : -2;
                block.corners.push_back({corner, mesh.mNormals ? corner : Polygons::kNone});
            }
            block.sizes.push_back(face.mNumIndices);
        }
    }
    return polygons;
}

}  // namespace normalscope
