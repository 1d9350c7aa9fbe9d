// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/scene/JointFile.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>

#include "simcore/file/AtomicWrite.h"
#include "simcore/file/Ply.h"
#include "simcore/file/Schema.h"
#include "simcore/file/Vtk.h"
#include "simcore/scene/DraftFile.h"
#include "simcore/scene/JointArchive.h"
#include "simcore/scene/JointCheck.h"
#include "simcore/scene/ScenarioJson.h"
#include "simcore/scene/SceneJson.h"
#include "simcore/scene/SceneWords.h"

namespace glenoid {
namespace {

namespace fs = std::filesystem;
using namespace scene_json;

constexpr const char* kMeshMembers[] = {"visual", "collision", "volume"};

std::string jsonPath(const std::string& folder) {
  return (fs::path(folder) / "joint.json").string();
}

template <class Mesh>
std::string meshName(const std::shared_ptr<const Mesh>& mesh, const char* ending) {
  return "meshes/" + (mesh ? toHex(contentHash(*mesh)) : std::string("none")) + ending;
}

JsonValue fromPart(const Part& part) {
  JsonValue json = JsonValue::object();
  json.set("id", part.id);
  json.set("number", part.number);
  json.set("name", part.name);
  json.set("kind", part.kind == PartKind::Rigid ? "rigid" : "soft");
  json.set("color", fromColor(part.color));
  json.set("visual", meshName(part.visual, ".ply"));
  json.set("collision", meshName(part.collision, ".ply"));
  if (part.volume) json.set("volume", meshName(part.volume, ".vtk"));
  if (part.cellSize != 0) json.set("cellSize", part.cellSize);
  if (part.elements != Elements::Tetrahedra) json.set("elements", scene_words::wordOf(scene_words::kElements, part.elements));
  json.set("materials", listOf(part.materials, fromMaterialUse));
  json.set("regions", listOf(part.regions, fromRegion));
  json.set("landmarks", listOf(part.landmarks, fromLandmark));
  if (part.dents) json.set("dents", fromDents(*part.dents));
  return json;
}

/// Everything but the meshes.
Part toPart(const JsonValue& json) {
  Part part;
  part.id = json["id"].text();
  part.number = static_cast<int>(json["number"].integer());
  part.name = json["name"].text();
  part.kind = json["kind"].text() == "rigid" ? PartKind::Rigid : PartKind::Soft;
  if (json.find("color")) part.color = toColor(json["color"]);
  part.cellSize = json["cellSize"].number();
  part.elements = scene_words::valueOf(scene_words::kElements, json["elements"].text(), part.elements);
  part.materials = vectorOf(json["materials"], toMaterialUse);
  part.regions = vectorOf(json["regions"], toRegion);
  part.landmarks = vectorOf(json["landmarks"], toLandmark);
  if (const JsonValue* dents = json.find("dents"); dents && dents->find("radii")) part.dents = std::make_shared<const DentTable>(toDents(*dents));
  return part;
}

void sortParts(Joint& joint) {
  std::stable_sort(joint.parts.begin(), joint.parts.end(),
                   [](const Part& a, const Part& b) { return a.number < b.number; });
}

JsonValue fromAxes(const Mat3& axes) {
  JsonValue json = JsonValue::array();
  for (int row = 0; row < 3; ++row) json.append(fromVec3(axes.row(row)));
  return json;
}

Mat3 toAxes(const JsonValue& json) {
  Mat3 axes;
  for (int row = 0; row < 3; ++row) axes.row(row) = toVec3(json[static_cast<std::size_t>(row)]).transpose();
  return axes;
}

JsonValue fromJoint(const Joint& joint, int version = schemaVersion(Schema::Joint)) {
  JsonValue json = JsonValue::object();
  json.set("schemaVersion", version);
  json.set("id", joint.id);
  json.set("name", joint.name);
  if (!joint.description.empty()) json.set("description", joint.description);
  if (joint.side != JointSide::Unsaid) json.set("side", scene_words::wordOf(scene_words::kJointSides, joint.side));
  if (joint.axes_W != Mat3::Identity()) json.set("axes", fromAxes(joint.axes_W));
  json.set("provenance", fromProvenance(joint.provenance));
  json.set("materials", listOf(joint.materials, fromMaterial));
  json.set("parts", listOf(joint.parts, fromPart));
  json.set("couplings", listOf(joint.couplings, fromCoupling));
  json.set("exclusions", listOf(joint.exclusions, fromExclusion));
  if (!joint.bursae.empty()) json.set("bursae", listOf(joint.bursae, fromBursa));
  if (!joint.cages.empty()) json.set("cages", listOf(joint.cages, fromCage));
  if (joint.startProof) json.set("startProof", fromProof(*joint.startProof));
  return json;
}

Joint toJoint(const JsonValue& json) {
  Joint joint;
  joint.id = json["id"].text();
  joint.name = json["name"].text();
  joint.description = json["description"].text();
  joint.side = scene_words::valueOf(scene_words::kJointSides, json["side"].text(), joint.side);
  if (json.find("axes")) joint.axes_W = toAxes(json["axes"]);
  joint.materials = vectorOf(json["materials"], toMaterial);
  joint.parts = vectorOf(json["parts"], toPart);
  joint.couplings = vectorOf(json["couplings"], toCoupling);
  joint.exclusions = vectorOf(json["exclusions"], toExclusion);
  joint.bursae = vectorOf(json["bursae"], toBursa);
  joint.cages = vectorOf(json["cages"], toCage);
  if (const JsonValue* proof = json.find("startProof")) joint.startProof = toProof(*proof);
  joint.provenance = toProvenance(json["provenance"]);
  return joint;
}

/// Loads each mesh file once, however many parts show it.
class MeshStore {
 public:
  MeshStore(const std::string& folder, const std::string& json) : m_folder(folder), m_json(json) {}

  Result<std::shared_ptr<const TriMesh>> surface(const std::string& name, const std::string& pointer,
                                                 const std::string& part) {
    return load(name, ".ply", pointer, part, m_surfaces,
                [](const std::string& path) { return readPly(path); });
  }
  Result<std::shared_ptr<const TetMesh>> volume(const std::string& name, const std::string& pointer,
                                                const std::string& part) {
    return load(name, ".vtk", pointer, part, m_volumes, readVtk);
  }

 private:
  template <class Mesh, class Reader>
  Result<std::shared_ptr<const Mesh>> load(const std::string& name, const char* ending,
                                           const std::string& pointer, const std::string& part,
                                           std::map<std::string, std::shared_ptr<const Mesh>>& known,
                                           Reader&& reader) {
    const fs::path relative(name);
    if (!staysInside(name) || relative.extension() != ending)
      return Error{Fault::BadReference, {m_json, pointer, part, {}}, {name}, {}};
    if (const auto found = known.find(name); found != known.end()) return found->second;
    const std::string path = (fs::path(m_folder) / relative).string();
    Result<Mesh> mesh = reader(path);
    if (!mesh) {
      mesh.error().place.part = part;
      return mesh.error();
    }
    const std::string found = toHex(contentHash(*mesh)), named = relative.stem().string();
    if (found != named) return Error{Fault::HashMismatch, {path, {}, part, {}}, {found, named}, {}};
    return known[name] = std::make_shared<const Mesh>(std::move(*mesh));
  }

  const std::string& m_folder;
  const std::string& m_json;
  std::map<std::string, std::shared_ptr<const TriMesh>> m_surfaces;
  std::map<std::string, std::shared_ptr<const TetMesh>> m_volumes;
};

Result<Done> loadMeshes(const JsonValue& json, const std::string& folder, const std::string& file,
                        Joint& joint) {
  MeshStore store(folder, file);
  for (std::size_t i = 0; i < joint.parts.size(); ++i) {
    Part& part = joint.parts[i];
    const JsonValue& from = json["parts"][i];
    const std::string pointer = pointerTo("/parts", i);
    auto visual = store.surface(from["visual"].text(), pointerTo(pointer, "visual"), part.id);
    if (!visual) return visual.error();
    part.visual = std::move(*visual);
    auto collision = store.surface(from["collision"].text(), pointerTo(pointer, "collision"), part.id);
    if (!collision) return collision.error();
    part.collision = std::move(*collision);
    if (!from.find("volume")) continue;
    auto volume = store.volume(from["volume"].text(), pointerTo(pointer, "volume"), part.id);
    if (!volume) return volume.error();
    part.volume = std::move(*volume);
  }
  return Done{};
}

/// Mesh files that a joint.json names, whatever else may be wrong with it.
std::set<std::string> meshesNamedBy(const JsonValue& json) {
  std::set<std::string> names;
  for (const JsonValue& part : json["parts"].items())
    for (const char* member : kMeshMembers) {
      const std::string& name = part[member].text();
      const fs::path path(name);
      if (path.parent_path() == "meshes" && path.stem().string().size() == 32) names.insert(name);
    }
  return names;
}

Error folderFault(Fault fault, const std::string& folder, const std::error_code& why) {
  return {fault, {folder, {}, {}, {}}, {}, why.message()};
}

Result<Done> makeFolder(const std::string& folder) {
  std::error_code failed;
  if (fs::is_directory(folder, failed)) return Done{};
  fs::create_directory(folder, failed);
  if (!failed && fs::is_directory(folder)) return Done{};
  const bool missing = failed == std::errc::no_such_file_or_directory;
  return folderFault(missing ? Fault::FileMissing : Fault::FileUnwritable, folder, failed);
}

/// A blob of this name may be there already; it is left alone when it is what its name says.
template <class Mesh, class Reader, class Writer>
Result<Done> saveMesh(const std::shared_ptr<const Mesh>& mesh, const fs::path& path, Reader&& reader,
                      Writer&& writer) {
  std::error_code ignored;
  if (fs::exists(path, ignored))
    if (const auto there = reader(path.string()); there && contentHash(*there) == contentHash(*mesh))
      return Done{};
  return writer(path.string(), *mesh);
}

Result<Done> saveMeshes(const Joint& joint, const std::string& folder) {
  const auto surface = [&](const std::shared_ptr<const TriMesh>& mesh) {
    return saveMesh(
        mesh, fs::path(folder) / meshName(mesh, ".ply"),
        [](const std::string& path) { return readPly(path); }, writePly);
  };
  const auto volume = [&](const std::shared_ptr<const TetMesh>& mesh) {
    return saveMesh(mesh, fs::path(folder) / meshName(mesh, ".vtk"), readVtk,
                    [](const std::string& path, const TetMesh& tets) { return writeVtk(path, tets); });
  };
  for (const Part& part : joint.parts) {
    if (const auto saved = surface(part.visual); !saved) return saved;
    if (const auto saved = surface(part.collision); !saved) return saved;
    if (!part.volume) continue;
    if (const auto saved = volume(part.volume); !saved) return saved;
  }
  return Done{};
}

/// The first save over a joint.json of an older form keeps it, and the meshes it names, for the program that wrote it.
std::string olderName(int version) {
  return "joint.v" + std::to_string(version) + ".json";
}
Result<Done> keepOlder(const std::string& folder, const JsonValue& before) {
  const auto version = before["schemaVersion"].integer();
  if (version < 1 || version >= schemaVersion(Schema::Joint)) return Done{};
  const std::string copy = (fs::path(folder) / olderName(static_cast<int>(version))).string();
  std::error_code ignored;
  if (fs::exists(copy, ignored)) return Done{};
  const auto bytes = readWholeFile(jsonPath(folder));
  if (!bytes) return bytes.error();
  return writeWholeFile(copy, *bytes);
}

/// Meshes that kept copies of older forms name.
std::set<std::string> meshesOfOlder(const std::string& folder) {
  std::set<std::string> names;
  for (int version = 1; version < schemaVersion(Schema::Joint); ++version)
    if (const Result<JsonValue> older = readJson((fs::path(folder) / olderName(version)).string()))
      names.merge(meshesNamedBy(*older));
  return names;
}

Result<Done> checkSorted(const Joint& joint, const JsonValue& json, const std::string& file) {
  if (const auto pointer = notFiniteIn(json))
    return Error{Fault::NotFinite, {file, *pointer, {}, {}}, {}, {}};
  if (const auto valid = validate(json, Schema::Joint, file); !valid) return valid;
  if (const auto values = joint_check::checkValues(joint, file); !values) return values;
  return joint_check::checkMeshes(joint, file);
}

Result<Joint> loadFolder(const std::string& folder) {
  std::error_code failed;
  const fs::file_status status = fs::status(folder, failed);
  if (!fs::exists(status)) return folderFault(Fault::FileMissing, folder, failed);
  if (!fs::is_directory(status))
    return folderFault(Fault::FileUnreadable, folder, std::make_error_code(std::errc::not_a_directory));
  const std::string file = jsonPath(folder);
  const Result<JsonValue> json = readDocument(file, Schema::Joint);
  if (!json) return json.error();
  Joint joint = toJoint(*json);
  if (const auto values = joint_check::checkValues(joint, file); !values) return values.error();
  if (const auto meshes = loadMeshes(*json, folder, file, joint); !meshes) return meshes.error();
  if (const auto meshes = joint_check::checkMeshes(joint, file); !meshes) return meshes.error();
  sortParts(joint);
  return joint;
}

}  // namespace

Result<Joint> loadJoint(const std::string& path) {
  std::error_code failed;
  if (!fs::is_regular_file(path, failed)) return loadFolder(path);
  if (isJointArchive(path)) return loadJointArchive(path);
  if (fs::path(path).filename() != "joint.json") return loadFolder(path);
  const fs::path folder = fs::path(path).parent_path();
  return loadFolder(folder.empty() ? "." : folder.string());
}

Result<Done> saveJoint(const Joint& unsorted, const std::string& folder) {
  std::error_code is;
  if (isJointArchive(folder) && !fs::is_directory(folder, is)) return saveJointArchive(unsorted, folder);
  Joint joint = unsorted;
  sortParts(joint);
  const std::string file = jsonPath(folder);
  const JsonValue json = fromJoint(joint);
  if (const auto good = checkSorted(joint, json, file); !good) return good;
  if (const auto made = makeFolder(folder); !made) return made;
  if (const auto made = makeFolder((fs::path(folder) / "meshes").string()); !made) return made;
  std::set<std::string> superseded;
  if (const Result<JsonValue> before = readJson(file)) {
    superseded = meshesNamedBy(*before);
    if (const auto kept = keepOlder(folder, *before); !kept) return kept;
  }
  if (const auto saved = saveMeshes(joint, folder); !saved) return saved;
  if (const auto saved = writeJson(file, json); !saved) return saved;
  for (const std::string& name : meshesNamedBy(json)) superseded.erase(name);
  for (const std::string& name : meshesOfOlder(folder)) superseded.erase(name);
  std::error_code ignored;  // the save has happened; what is left over does no harm
  for (const std::string& name : superseded) fs::remove(fs::path(folder) / name, ignored);
  return Done{};
}

Result<Done> checkJoint(const Joint& unsorted, const std::string& file) {
  Joint joint = unsorted;
  sortParts(joint);
  return checkSorted(joint, fromJoint(joint), file);
}

std::string jointHash(const Joint& unsorted) {
  Joint joint = unsorted;
  sortParts(joint);
  const std::string text = toText(fromJoint(joint, 1));  // the form of the file is no content: hashes outlive it
  return toHex(hashBytes(text.data(), text.size()));
}

Result<Done> saveDraft(const Draft& draft, const std::string& folder, const std::string& blobs) {
  const std::string meshes = (fs::path(folder) / "meshes").string();
  for (const std::string& each : {blobs, meshes})
    if (const auto made = makeFolder(each); !made) return made;
  // Blobs are written under another name first, so that one that has its name is whole and is not looked at again.
  const auto keep = [&](const auto& mesh, const char* ending, auto&& writer) -> Result<Done> {
    if (!mesh) return Done{};
    const std::string name = toHex(contentHash(*mesh)) + ending;
    const fs::path blob = fs::path(blobs) / name, link = fs::path(folder) / "meshes" / name;
    std::error_code failed;
    if (!fs::exists(blob, failed))
      if (const auto written = writer(blob.string(), *mesh); !written) return written;
    if (fs::exists(link, failed)) return Done{};  // another part shows it too
    fs::create_hard_link(blob, link, failed);
    if (failed) fs::copy_file(blob, link, failed);
    if (failed) return folderFault(Fault::FileUnwritable, link.string(), failed);
    return Done{};
  };
  for (const Part& part : draft.joint.parts) {
    for (const auto& surface : {part.visual, part.collision})
      if (const auto kept = keep(surface, ".ply", writePly); !kept) return kept;
    const auto kept = keep(part.volume, ".vtk", [](const std::string& path, const TetMesh& tets) { return writeVtk(path, tets); });
    if (!kept) return kept;
  }
  const auto write = [&](const char* name, const JsonValue& json) {
    return writeWholeFile((fs::path(folder) / name).string(), toText(json));
  };
  if (const auto written = write("scenario.json", fromScenario(draft.scenario)); !written) return written;
  return write("joint.json", fromJoint(draft.joint));
}

Result<Draft> loadDraft(const std::string& folder) {
  const std::string file = jsonPath(folder);
  const Result<JsonValue> json = readJson(file);
  if (!json) return json.error();
  const Result<JsonValue> scenario = readJson((fs::path(folder) / "scenario.json").string());
  if (!scenario) return scenario.error();
  Draft draft{toJoint(*json), toScenario(*scenario)};
  MeshStore store(folder, file);
  for (std::size_t i = 0; i < draft.joint.parts.size(); ++i) {
    Part& part = draft.joint.parts[i];
    const JsonValue& from = (*json)["parts"][i];
    const auto there = [&](const char* member) { return from.find(member) && from[member].text().find("/none.") == std::string::npos; };
    for (const char* member : {"visual", "collision"}) {
      if (!there(member)) continue;
      auto mesh = store.surface(from[member].text(), {}, part.id);
      if (!mesh) return mesh.error();
      (*member == 'v' ? part.visual : part.collision) = std::move(*mesh);
    }
    if (!there("volume")) continue;
    auto volume = store.volume(from["volume"].text(), {}, part.id);
    if (!volume) return volume.error();
    part.volume = std::move(*volume);
  }
  return draft;
}

std::string startHash(const Joint& unsorted) {
  Joint only;
  only.exclusions = unsorted.exclusions;
  only.cages = unsorted.cages;
  for (const Part& from : unsorted.parts) {
    Part part;
    part.id = from.id;
    part.number = from.number;
    part.kind = from.kind;
    part.visual = from.visual;
    part.collision = from.collision;
    part.volume = from.volume;
    only.parts.push_back(std::move(part));
  }
  return jointHash(only);
}

std::string dentBasis(const Joint& joint, const Part& from) {
  Joint only;
  Part part;
  part.kind = from.kind;
  part.visual = from.visual;
  part.materials = from.materials;
  part.regions = from.regions;
  for (Region& region : part.regions) region.name = region.kind = {};
  for (const MaterialUse& use : from.materials) {
    const int index = findMaterial(joint, use.material);
    if (index < 0) continue;
    Material material;
    material.id = use.material;
    material.youngsModulus = joint.materials[index].youngsModulus;
    material.poissonRatio = joint.materials[index].poissonRatio;
    only.materials.push_back(material);
  }
  for (const Coupling& coupling : joint.couplings) {
    if (coupling.partA != from.id && coupling.partB != from.id) continue;
    Coupling held = coupling;
    held.damping = 0;
    only.couplings.push_back(held);
    // Numbers of nodes say nothing without their places.
    const int a = coupling.byNodes() ? findPart(joint, coupling.partA) : -1;
    if (a < 0) continue;
    Part picked;
    picked.id = coupling.partA;
    picked.volume = joint.parts[a].volume;
    only.parts.push_back(std::move(picked));
  }
  only.parts.push_back(std::move(part));
  return jointHash(only);
}

}  // namespace glenoid
