// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/import/AssimpRead.h"

#include <assimp/DefaultIOSystem.h>
#include <assimp/config.h>
#include <assimp/importerdesc.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <assimp/Importer.hpp>
#include <assimp/MemoryIOWrapper.h>
#include <cmath>
#include <filesystem>
#include <sstream>

#include "simcore/file/AtomicWrite.h"
#include "simcore/import/FileUnits.h"
#include "simcore/import/Uri.h"

namespace glenoid {
namespace {

namespace fs = std::filesystem;

const char* endingFor(MeshFormat format) {
  switch (format) {
    case MeshFormat::Obj: return "obj";
    case MeshFormat::Stl: return "stl";
    case MeshFormat::Gltf: return "gltf";
    case MeshFormat::Glb: return "glb";
    case MeshFormat::Dae: return "dae";
    case MeshFormat::Fbx: return "fbx";
    default: return "";
  }
}

/// Lets assimp see the main file, under a name with the right ending, and regular files beside and below it.
class FolderFiles : public Assimp::DefaultIOSystem {
 public:
  FolderFiles(fs::path file, std::string shownAs, const InsteadOfFile& instead)
      : m_file(std::move(file)), m_folder(m_file.parent_path()), m_shownAs(std::move(shownAs)), m_instead(instead) {}
  bool Exists(const char* name) const override { return isBeside(name) || !allowed(name).empty(); }
  Assimp::IOStream* Open(const char* name, const char*) override {
    const std::string_view bytes = name == m_shownAs ? m_instead.bytes : isBeside(name) ? m_instead.beside : std::string_view();
    if (!bytes.empty()) return new Assimp::MemoryIOStream(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());  // the importer deletes it
    const std::string path = allowed(name);
    return path.empty() ? nullptr : Assimp::DefaultIOSystem::Open(path.c_str(), "rb");
  }

 private:
  bool isBeside(const char* name) const { return !m_instead.beside.empty() && fs::path(name).filename() == kBesideName; }
  std::string allowed(const char* name) const {
    if (name == m_shownAs) return m_file.string();
    std::error_code failed;
    fs::path whole = fs::weakly_canonical(name, failed);
    if (!failed && !fs::is_regular_file(whole, failed)) whole = fs::weakly_canonical(decodedUri(name), failed);  // glTF: a URI
    if (failed || !fs::is_regular_file(whole, failed)) return {};
    const fs::path inside = whole.lexically_relative(m_folder);
    return inside.empty() || *inside.begin() == ".." ? std::string() : whole.string();
  }
  fs::path m_file, m_folder;
  std::string m_shownAs;
  InsteadOfFile m_instead;
};

bool handles(const aiImporterDesc* description, const std::string& ending) {
  std::istringstream words(description && description->mFileExtensions ? description->mFileExtensions : "");
  for (std::string word; words >> word;)
    if (word == ending) return true;
  return false;
}

/// Leaves only the loaders of one ending, so that no other is asked to judge the bytes.
void keepLoaders(Assimp::Importer& importer, const std::string& ending) {
  std::vector<Assimp::BaseImporter*> others;
  for (std::size_t i = 0; i < importer.GetImporterCount(); ++i)
    if (!handles(importer.GetImporterInfo(i), ending)) others.push_back(importer.GetImporter(i));
  for (Assimp::BaseImporter* other : others) importer.UnregisterLoader(other);
}

class SceneReader {
 public:
  /// An STL's normals are no more than those of its triangles.
  SceneReader(const aiScene& scene, const std::string& file, long long most, MeshFormat format)
      : m_scene(scene), m_file(file), m_most(most), m_ownNormals(format != MeshFormat::Stl), m_gltf(format == MeshFormat::Gltf || format == MeshFormat::Glb) {}

  Result<ImportedFile> read() {
    countWhatIsLost();
    struct Open {
      const aiNode* node;
      aiMatrix4x4 toRoot;
    };
    std::vector<Open> open{{m_scene.mRootNode, m_scene.mRootNode->mTransformation}};
    while (!open.empty()) {
      const Open top = open.back();
      open.pop_back();
      if (top.node->mNumMeshes > 0 && !addNode(*top.node, top.toRoot)) return m_error;
      for (unsigned i = top.node->mNumChildren; i-- > 0;)
        open.push_back({top.node->mChildren[i], top.toRoot * top.node->mChildren[i]->mTransformation});
    }
    if (m_out.surfaces.empty()) return Error{Fault::BadMesh, {m_file, {}, {}, {}}, {"it holds no triangles"}, {}};
    return std::move(m_out);
  }

 private:
  bool fail(Fault fault, Arguments arguments, std::optional<long> element = {}) {
    m_error = {fault, {m_file, {}, {}, element}, std::move(arguments), {}};
    return false;
  }
  void note(ImportNote what, long count) { addNote(m_out.notes, what, count); }

  void countWhatIsLost() {
    for (unsigned i = 0; i < m_scene.mNumMeshes; ++i) {
      const aiMesh& mesh = *m_scene.mMeshes[i];
      note(ImportNote::NormalsDropped, m_ownNormals && mesh.HasNormals());
      note(ImportNote::TexturesDropped, mesh.HasTextureCoords(0));
      note(ImportNote::ColoursDropped, mesh.HasVertexColors(0));
      note(ImportNote::AnimationsDropped, mesh.mNumBones + mesh.mNumAnimMeshes);
    }
    // assimp adds a material of its own behind those of a glTF.
    const unsigned own = m_gltf && m_scene.mNumMaterials > 0 && m_scene.mMaterials[m_scene.mNumMaterials - 1]->GetName().length == 0;
    for (unsigned i = 0; i + own < m_scene.mNumMaterials; ++i)
      note(ImportNote::MaterialsDropped, m_scene.mMaterials[i]->GetName() != aiString(AI_DEFAULT_MATERIAL_NAME));
    note(ImportNote::AnimationsDropped, m_scene.mNumAnimations);
    note(ImportNote::OthersDropped, m_scene.mNumLights + m_scene.mNumCameras);
  }

  bool addNode(const aiNode& node, const aiMatrix4x4& toRoot) {
    Eigen::Matrix4d m;
    for (int r = 0; r < 4; ++r)
      for (int c = 0; c < 4; ++c) m(r, c) = toRoot[r][c];
    if (!m.allFinite()) return fail(Fault::NotFinite, {});
    const double determinant = m.topLeftCorner<3, 3>().determinant();
    if (!m.isIdentity(0)) note(ImportNote::NodesMoved, 1);
    if (determinant < 0) note(ImportNote::NodesMirrored, 1);
    ImportedSurface surface;
    surface.name = node.mName.C_Str();
    for (unsigned i = 0; i < node.mNumMeshes; ++i) {
      if (node.mMeshes[i] >= m_scene.mNumMeshes)
        return fail(Fault::BadIndex, {std::to_string(node.mMeshes[i]), std::to_string(m_scene.mNumMeshes)});
      const aiMesh& mesh = *m_scene.mMeshes[node.mMeshes[i]];
      if (surface.name.empty()) surface.name = mesh.mName.C_Str();
      if (!addMesh(mesh, m, determinant < 0, surface.mesh)) return false;
    }
    if (surface.mesh.triangles.empty()) {
      note(ImportNote::SurfacesWithoutTriangles, 1);
      return true;
    }
    note(ImportNote::PointsJoined, joinIdenticalPoints(surface.mesh));
    m_out.surfaces.push_back(std::move(surface));
    return true;
  }

  bool addMesh(const aiMesh& mesh, const Eigen::Matrix4d& m, bool mirrored, TriMesh& out) {
    m_triangles += mesh.mNumFaces;
    if (m_triangles > m_most || out.vertices.size() + mesh.mNumVertices > 0x7fffffffu)
      return fail(Fault::FileTooLarge, {std::to_string(m_triangles) + " triangles", std::to_string(m_most)});
    const int base = static_cast<int>(out.vertices.size());
    const bool still = m.isIdentity(0);
    for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
      const aiVector3D& v = mesh.mVertices[i];
      const Vec3 x(v.x, v.y, v.z);
      const Vec3 moved = still ? x : Vec3(m.topLeftCorner<3, 3>() * x + m.topRightCorner<3, 1>());
      if (!moved.allFinite()) return fail(Fault::NotFinite, {}, static_cast<long>(i));
      out.vertices.push_back(moved);
    }
    for (unsigned i = 0; i < mesh.mNumFaces; ++i) {
      const aiFace& face = mesh.mFaces[i];
      for (unsigned k = 0; k < face.mNumIndices; ++k)
        if (face.mIndices[k] >= mesh.mNumVertices)
          return fail(Fault::BadIndex, {std::to_string(face.mIndices[k]), std::to_string(mesh.mNumVertices)}, static_cast<long>(i));
      if (face.mNumIndices == 1) note(ImportNote::PointsDropped, 1);
      if (face.mNumIndices == 2) note(ImportNote::LinesDropped, 1);
      if (face.mNumIndices != 3) continue;  // longer ones were cut before
      std::array<int, 3> t{};
      for (int k = 0; k < 3; ++k) t[k] = base + static_cast<int>(face.mIndices[k]);
      if (mirrored) std::swap(t[1], t[2]);
      out.triangles.push_back(t);
    }
    return true;
  }

  const aiScene& m_scene;
  const std::string& m_file;
  long long m_most, m_triangles = 0;
  bool m_ownNormals, m_gltf;
  ImportedFile m_out;
  Error m_error;
};

long polygonsIn(const aiScene& scene) {
  long count = 0;
  for (unsigned i = 0; i < scene.mNumMeshes; ++i)
    for (unsigned f = 0; f < scene.mMeshes[i]->mNumFaces; ++f) count += scene.mMeshes[i]->mFaces[f].mNumIndices > 3;
  return count;
}

std::optional<double> fbxUnit(const aiScene& scene) {
  double centimetres = 0;
  float narrow = 0;
  if (!scene.mMetaData) return std::nullopt;
  if (!scene.mMetaData->Get("UnitScaleFactor", centimetres)) {
    if (!scene.mMetaData->Get("UnitScaleFactor", narrow)) return std::nullopt;
    centimetres = narrow;
  }
  return centimetres > 0 && std::isfinite(centimetres) ? std::optional(0.01 * centimetres) : std::nullopt;
}

/// The reader's own words, on one line, with the file's own name and in a length that a sentence bears.
std::string reasonIn(std::string said, const std::string& shownAs, const std::string& name) {
  for (const std::string& shown : {shownAs, fs::path(shownAs).filename().string()})
    for (std::size_t at = said.find(shown); at != std::string::npos; at = said.find(shown, at + name.size())) said.replace(at, shown.size(), name);
  std::string reason;
  for (const char c : said)
    if (static_cast<unsigned char>(c) >= ' ') reason += c;
    else if (!reason.empty() && reason.back() != ' ') reason += ' ';
  while (!reason.empty() && (reason.back() == ' ' || reason.back() == '.')) reason.pop_back();
  if (reason.size() <= 200) return reason;
  std::size_t end = 200;
  while (end > 0 && (static_cast<unsigned char>(reason[end]) & 0xc0) == 0x80) --end;  // no half of a letter
  return reason.substr(0, end) + "…";
}

}  // namespace

Result<ImportedFile> readWithAssimp(const std::string& path, MeshFormat format, long long triangles, const InsteadOfFile& instead) {
  std::error_code failed;
  const fs::path file = fs::canonical(path, failed);
  if (failed) return Error{Fault::FileMissing, {path, {}, {}, {}}, {}, failed.message()};
  const std::string ending = endingFor(format);
  const std::string shownAs = (file.parent_path() / ("surface-to-import." + ending)).string();
  Assimp::Importer importer;
  keepLoaders(importer, ending);
  importer.SetIOHandler(new FolderFiles(file, shownAs, instead));  // the importer deletes it
  importer.SetPropertyBool(AI_CONFIG_IMPORT_COLLADA_IGNORE_UP_DIRECTION, true);
  importer.SetPropertyBool(AI_CONFIG_IMPORT_COLLADA_USE_COLLADA_NAMES, true);
  importer.SetPropertyBool(AI_CONFIG_IMPORT_NO_SKELETON_MESHES, true);
  importer.SetPropertyBool(AI_CONFIG_IMPORT_FBX_PRESERVE_PIVOTS, false);
  importer.SetPropertyBool(AI_CONFIG_IMPORT_FBX_READ_TEXTURES, false);
  importer.SetPropertyBool(AI_CONFIG_IMPORT_FBX_READ_ANIMATIONS, false);
  const auto refused = [&] {
    const std::string said = importer.GetErrorString(), reason = reasonIn(said, shownAs, file.filename().string());
    return Error{Fault::BadMesh, {path, {}, {}, {}}, {std::string("the ") + formatName(format) + " reader refused it" + (reason.empty() ? "" : ": " + reason)}, said};
  };
  const aiScene* scene = importer.ReadFile(shownAs, 0);
  if (!scene || !scene->mRootNode) return refused();
  const long polygons = polygonsIn(*scene);
  if (polygons > 0) scene = importer.ApplyPostProcessing(aiProcess_Triangulate);
  if (!scene || !scene->mRootNode) return refused();
  Result<ImportedFile> out = SceneReader(*scene, path, triangles, format).read();
  if (!out) return out;
  out->format = formatName(format);
  addNote(out->notes, ImportNote::PolygonsSplit, polygons);
  switch (format) {
    case MeshFormat::Gltf:
    case MeshFormat::Glb: out->metresPerUnit = 1; break;  // the format's own unit
    case MeshFormat::Fbx: out->metresPerUnit = fbxUnit(*scene); break;
    case MeshFormat::Dae: {
      const auto bytes = readWholeFile(path);
      if (!bytes) return bytes.error();
      out->metresPerUnit = daeUnit(*bytes);
      break;
    }
    default: break;
  }
  return out;
}

}  // namespace glenoid
