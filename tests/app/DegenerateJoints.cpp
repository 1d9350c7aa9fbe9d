// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/DegenerateJoints.h"

#include <cmath>
#include <functional>
#include <limits>
#include <nlohmann/json.hpp>
#include <random>

#include "simcore/author/MakeCage.h"
#include "simcore/file/SurfaceWrite.h"
#include "simcore/scene/DraftFile.h"
#include "tests/app/Program.h"
#include "tests/simcore/check/Faults.h"

namespace glenoid::testing {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

class Dice {
 public:
  explicit Dice(unsigned seed) : m_random(seed) {}
  std::size_t below(std::size_t n) { return n == 0 ? 0 : m_random() % n; }
  template <class T>
  const T& of(const std::vector<T>& list) { return list[below(list.size())]; }
  double extreme() { return of(std::vector<double>{0, -1, 1e-300, 1e-12, 1e-6, 1, 1e6, 1e12, 1e100, 1e300, -1e300}); }

 private:
  std::mt19937 m_random;
};

// ---- Meshes

void changeSurface(std::shared_ptr<const TriMesh>& surface, Dice& dice, std::string& what) {
  changeMesh(surface, [&](TriMesh& mesh) {
    auto& x = mesh.vertices;
    auto& t = mesh.triangles;
    switch (dice.below(13)) {
      case 0: what += "collapsed to a point"; for (Vec3& p : x) p = x[0]; break;
      case 1: what += "collapsed to a plane"; for (Vec3& p : x) p.y() = x[0].y(); break;
      case 2: what += "collapsed to a line"; for (Vec3& p : x) p.y() = x[0].y(), p.z() = x[0].z(); break;
      case 3: what += "turned inside out"; for (auto& each : t) std::swap(each[0], each[1]); break;
      case 4: what += "one triangle turned"; std::swap(t[0][0], t[0][1]); break;
      case 5: what += "scaled"; { const double s = dice.of(std::vector<double>{1e-12, 1e-6, 1e-3, 1e3, 1e6, 1e12}); for (Vec3& p : x) p *= s; } break;
      case 6: what += "far away"; { const double s = dice.of(std::vector<double>{1e3, 1e6, 1e12}); for (Vec3& p : x) p.x() += s; } break;
      case 7: what += "triangles twice"; { const auto copy = t; t.insert(t.end(), copy.begin(), copy.end()); } break;
      case 8: what += "open"; t.resize(t.size() / 2); break;
      case 9: what += "empty"; t.clear(); x.clear(); break;
      case 10: what += "one triangle"; t.resize(1); break;
      case 11: what += "a spike"; x[dice.below(x.size())] += Vec3(0, 10, 0); break;
      case 12: what += "triangles of one vertex"; for (auto& each : t) each = {each[0], each[0], each[0]}; break;
    }
  });
}

void changeVolume(std::shared_ptr<const TetMesh>& volume, Dice& dice, std::string& what) {
  changeMesh(volume, [&](TetMesh& mesh) {
    switch (dice.below(7)) {
      case 0: what += "tetrahedra inside out"; for (auto& t : mesh.tets) std::swap(t[0], t[1]); break;
      case 1: what += "flat tetrahedra"; for (Vec3& p : mesh.nodes) p.z() = 0; break;
      case 2: what += "no tetrahedra"; mesh.tets.clear(); break;
      case 3: what += "one tetrahedron"; mesh.tets.resize(1); break;
      case 4: what += "tetrahedra elsewhere"; for (Vec3& p : mesh.nodes) p.x() += 3; break;
      case 5: what += "nodes in one place"; for (Vec3& p : mesh.nodes) p = mesh.nodes[0]; break;
      case 6: what += "tiny tetrahedra"; for (Vec3& p : mesh.nodes) p *= 1e-9; break;
    }
  });
}

// ---- Values

void changeValues(Joint& joint, Dice& dice, std::string& what) {
  Part& part = joint.parts[dice.below(joint.parts.size())];
  Material& material = joint.materials[dice.below(joint.materials.size())];
  switch (dice.below(19)) {
    case 0: what += "density"; material.density = dice.extreme(); break;
    case 1: what += "modulus"; material.youngsModulus = dice.extreme(); break;
    case 2: what += "Poisson's ratio"; material.poissonRatio = dice.of(std::vector<double>{-1, 0, 0.4999, 0.5, 1}); break;
    case 3: what += "damping"; material.stiffnessDamping = dice.extreme(), material.massDamping = dice.extreme(); break;
    case 4: what += "no parts"; joint.parts.clear(); break;
    case 5: what += "no materials"; joint.materials.clear(); break;
    case 6: what += "no material of a part"; part.materials.clear(); break;
    case 7: what += "a part twice"; joint.parts.push_back(part); break;
    case 8: what += "the same place twice"; { Part copy = part; copy.id += "-twin"; copy.number = 77; joint.parts.push_back(copy); } break;
    case 9: what += "stiffness of a coupling"; for (Coupling& c : joint.couplings) c.stiffnessPerArea = dice.extreme(); break;
    case 10: what += "a part coupled to itself"; for (Coupling& c : joint.couplings) c.partB = c.partA; break;
    case 11: what += "a coupling of nobody"; for (Coupling& c : joint.couplings) c.partB = "nobody"; break;
    case 12: what += "empty regions"; for (Region& r : part.regions) r.triangles.clear(); break;
    case 13: what += "regions beyond the end"; for (Region& r : part.regions) r.triangles = {{1000000, 5}}; break;
    case 14: what += "a region of one triangle"; for (Region& r : part.regions) r.triangles = {{0, 1}}; break;
    case 15: what += "kinds exchanged"; part.kind = part.kind == PartKind::Soft ? PartKind::Rigid : PartKind::Soft; break;
    case 16: what += "nothing coupled, nothing excluded"; joint.couplings.clear(), joint.exclusions.clear(); break;
    case 17:
      what += "a cage gone wild";
      for (Part& each : joint.parts)
        if (each.kind == PartKind::Soft)
          if (auto cage = makeCage(each, 40)) {
            for (Vec3& h : cage->moved_W) h = dice.extreme() * Vec3(0.01, 1, -1);
            joint.cages.push_back(*cage);
          }
      break;
    case 18: what += "elements"; part.elements = Elements::Cells; break;
  }
}

// ---- Text

/// Every value of a document, root first.
void collect(Json& json, std::vector<Json*>& out) {
  out.push_back(&json);
  if (json.is_structured())
    for (Json& each : json) collect(each, out);
}

Json strange(Dice& dice) {
  Json deep = Json::array();
  for (int i = 0; i < 50; ++i) deep = Json::array({deep});
  const std::vector<Json> values{Json(), Json::array(), Json::object(), "", std::string(5000, 'x'), "../../../etc/passwd", "meshes/none.ply", "\xc3\xa9\n\t\"", true, 0, -1, 0.5,
                                 1e308, -1e308, std::numeric_limits<std::int64_t>::max(), std::numeric_limits<std::int64_t>::min(), 5e-324, deep,
                                 Json::array({0, 0, 0}), Json::array({1e300, 1e300, 1e300})};
  return dice.of(values);
}

void changeDocument(Json& json, Dice& dice, std::string& what) {
  std::vector<Json*> all;
  collect(json, all);
  Json& at = *all[1 + dice.below(all.size() - 1)];
  switch (dice.below(5)) {
    case 0: what += "a list doubled"; if (at.is_array()) { const Json copy = at; for (const Json& each : copy) at.push_back(each); } break;
    case 1: what += "a member gone"; if (at.is_object() && !at.empty()) at.erase(std::next(at.begin(), static_cast<long>(dice.below(at.size())))); break;
    case 2: what += "a member nobody knows"; if (at.is_object()) at["surprise"] = strange(dice); break;
    default: {
      const Json value = strange(dice);
      what += "a value became " + value.dump(-1, ' ', true).substr(0, 40);
      at = value;
    }
  }
}

void changeText(std::string& text, Dice& dice, std::string& what) {
  const std::size_t at = dice.below(text.size());
  switch (dice.below(6)) {
    case 0: what += "cut"; text.resize(at); break;
    case 1: what += "a byte flipped"; text[at] = static_cast<char>(text[at] ^ (1 << dice.below(8))); break;
    case 2: what += "NaN"; if (const auto digit = text.find_first_of("0123456789", at); digit != std::string::npos) text.replace(digit, 1, "NaN"); break;
    case 3: what += "brackets"; text.insert(at, std::string(100000, '[')); break;
    case 4: what += "zeros"; text.insert(at, std::string(3, '\0')); break;
    case 5: what += "empty"; text.clear(); break;
  }
}

void rewrite(const fs::path& file, Dice& dice, std::string& what) {
  std::string text = readText(file);
  if (dice.below(4) == 0) changeText(text, dice, what);
  else {
    Json json = Json::parse(text, nullptr, false);
    for (std::size_t i = 0; i <= dice.below(2); ++i) changeDocument(json, dice, what);
    text = json.dump(1, ' ', false, Json::error_handler_t::replace);
  }
  writeText(file, text);
}

void spoilFile(const fs::path& folder, Dice& dice, std::string& what) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder)) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  if (files.empty()) return;
  const fs::path file = dice.of(files);
  if (dice.below(3) == 0) {
    what += "a mesh file gone";
    fs::remove(file);
    if (dice.below(2)) fs::create_directory(file);
    return;
  }
  what += "a mesh file: ";
  std::string text = readText(file);
  changeText(text, dice, what);
  writeText(file, text);
}

}  // namespace

std::string writeDegenerateJoint(unsigned seed, const fs::path& folder) {
  Dice dice(seed);
  std::string what;
  Draft draft;
  draft.joint = dice.below(3) == 0 ? scenes::blockOnPlateJoint() : soundJoint();
  const std::size_t kind = dice.below(4);
  if (kind <= 1)
    for (std::size_t i = 0; i <= dice.below(3) && !draft.joint.parts.empty() && !draft.joint.materials.empty(); ++i) {
      what += what.empty() ? "" : ", ";
      Part& part = draft.joint.parts[dice.below(draft.joint.parts.size())];
      const std::size_t which = dice.below(4);
      if (which == 0 && part.visual) changeSurface(part.visual, dice, what);
      else if (which == 1 && part.collision) changeSurface(part.collision, dice, what);
      else if (which == 2 && part.volume) changeVolume(part.volume, dice, what);
      else changeValues(draft.joint, dice, what);
    }
  fs::create_directories(folder);
  if (const auto saved = saveDraft(draft, folder.string(), (folder / "blobs").string()); !saved) what += " (partly written: " + toLogLine(saved.error()) + ")";
  if (kind == 2 && fs::exists(folder / "joint.json")) rewrite(folder / "joint.json", dice, what);
  if (kind == 3 && fs::exists(folder / "meshes")) spoilFile(folder / "meshes", dice, what);
  return what;
}

std::string writeDegenerateRecipe(unsigned seed, const fs::path& folder) {
  Dice dice(seed);
  std::string what;
  fs::create_directories(folder / "meshes");
  Joint joint = soundJoint();
  const std::size_t kind = dice.below(4);
  Json parts = Json::array(), couplings = Json::array();
  for (Part& part : joint.parts) {
    if (kind == 0 && dice.below(2)) changeSurface(part.visual, dice, what), what += ", ";
    const std::string file = part.id + (dice.below(2) ? ".stl" : ".ply");
    if (!writeSurface((folder / "meshes" / file).string(), *part.visual)) what += " (no " + file + ")";
    Json entry{{"id", part.id}, {"number", part.number}, {"kind", part.kind == PartKind::Soft ? "soft" : "rigid"}, {"visual", file},
               {"collisionTriangles", 12}, {"source", {{"unit", "m"}}}, {"materials", {{{"material", part.materials[0].material}}}}};
    if (part.kind == PartKind::Soft) entry["tetrahedra"] = 60;
    parts.push_back(entry);
  }
  for (const Coupling& coupling : joint.couplings)
    couplings.push_back({{"id", coupling.id}, {"partA", coupling.partA}, {"partB", coupling.partB}, {"within", 1e-4}, {"stiffnessPerArea", 1e7}});
  Json materials = Json::array();
  for (const Material& m : joint.materials)
    materials.push_back({{"id", m.id}, {"density", m.density}, {"youngsModulus", m.youngsModulus}, {"poissonRatio", m.poissonRatio}});
  const Json recipe{{"schemaVersion", 1}, {"id", "fuzz"}, {"name", "Fuzz"}, {"materials", materials}, {"parts", parts}, {"couplings", couplings},
                    {"start", {{"clearance", 1e-4}, {"iterations", 3}, {"refinements", 0}}}};
  writeText(folder / "recipe.json", recipe.dump(1));
  if (kind == 1 || kind == 2) rewrite(folder / "recipe.json", dice, what);
  if (kind == 3) spoilFile(folder / "meshes", dice, what);
  return what;
}

}  // namespace glenoid::testing
