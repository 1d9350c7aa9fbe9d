// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/import/ThreeMfPackage.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <pugixml.hpp>
#include <sstream>

#include "simcore/file/ByteReader.h"
#include "simcore/file/Zip.h"

namespace glenoid {
namespace {

using Node = pugi::xml_node;

std::string inPackage(std::string_view name) {
  std::string out(name.starts_with('/') ? "" : "/");
  for (const char c : name) out += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return out;
}

std::string_view local(std::string_view name) {
  const std::size_t colon = name.rfind(':');
  return colon == std::string_view::npos ? name : name.substr(colon + 1);
}

/// Elements by their name without a namespace's prefix, which writers choose as they like.
template <class Take>
void eachChild(Node parent, std::string_view name, Take&& take) {
  for (Node child = parent.first_child(); child; child = child.next_sibling())
    if (local(child.name()) == name) take(child);
}

Node childOf(Node parent, std::string_view name) {
  for (Node child = parent.first_child(); child; child = child.next_sibling())
    if (local(child.name()) == name) return child;
  return {};
}

std::string attribute(Node node, std::string_view name) {
  for (const pugi::xml_attribute& each : node.attributes())
    if (local(each.name()) == name) return each.value();
  return {};
}

std::optional<double> metresOf(std::string_view unit) {
  if (unit.empty() || unit == "millimeter") return 1e-3;
  if (unit == "micron") return 1e-6;
  if (unit == "centimeter") return 1e-2;
  if (unit == "inch") return 0.0254;
  if (unit == "foot") return 0.3048;
  if (unit == "meter") return 1.0;
  return std::nullopt;
}

/// Twelve numbers, row by row for rows of points: the last three are the shift.
std::optional<Eigen::Matrix4d> transformIn(const std::string& text) {
  Eigen::Matrix4d m = Eigen::Matrix4d::Identity();
  if (text.empty()) return m;
  ByteReader words(text);
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 3; ++column) {
      const auto value = realIn(words.takeWord());
      if (!value || !std::isfinite(*value)) return std::nullopt;
      m(column, row) = *value;
    }
  return words.takeWord().empty() ? std::optional(m) : std::nullopt;
}

/// The namespace that a prefix stands for on the model's own tag.
std::string namespaceOf(Node model, const std::string& prefix) { return model.attribute(("xmlns:" + prefix).c_str()).value(); }

/// Extensions that change no shape, or that are read here.
bool isUnderstood(std::string_view space) {
  static constexpr std::array<std::string_view, 4> kKnown{"/core/", "/production/", "/material/", "/trianglesets/"};
  return std::any_of(kKnown.begin(), kKnown.end(), [&](std::string_view part) { return space.find(part) != std::string_view::npos; });
}

class ModelParser {
 public:
  ModelParser(const std::string& file, std::string name, long long most) : m_file(file), m_name(std::move(name)), m_most(most) {}

  Result<ThreeMfModel> parse(const std::string& text) {
    pugi::xml_document document;
    const pugi::xml_parse_result read = document.load_buffer(text.data(), text.size());
    if (!read) return bad("its model is damaged: " + std::string(read.description()));
    const Node model = childOf(document, "model");
    if (!model) return bad("its model file holds no model");
    std::istringstream required(attribute(model, "requiredextensions"));
    for (std::string prefix; required >> prefix;) {
      const std::string space = namespaceOf(model, prefix);
      if (!isUnderstood(space))
        return bad("it requires what is not understood here (" + (space.empty() ? prefix : space).substr(0, 100) + "): write it without that, or in another format");
    }
    const auto metres = metresOf(attribute(model, "unit"));
    if (!metres) return bad("it is in a unit that 3MF does not have (" + attribute(model, "unit").substr(0, 40) + ")");
    m_out.metresPerUnit = *metres;
    const Node resources = childOf(model, "resources");
    eachChild(resources, "basematerials", [&](Node list) { eachChild(list, "base", [&](Node) { ++m_out.materials; }); });
    eachChild(resources, "colorgroup", [&](Node) { ++m_out.colours; });
    eachChild(resources, "texture2d", [&](Node) { ++m_out.textures; });
    for (Node object = resources.first_child(); object && m_good; object = object.next_sibling())
      if (local(object.name()) == "object") addObject(object);
    eachChild(childOf(model, "build"), "item", [&](Node item) { addUse(item, m_out.build); });
    if (!m_good) return m_error;
    return std::move(m_out);
  }

 private:
  Error bad(const std::string& what) { return {Fault::BadMesh, {m_file, m_name, {}, {}}, {what}, "3MF"}; }
  void fail(Error error) {
    if (m_good) m_error = std::move(error);
    m_good = false;
  }

  void addUse(Node node, std::vector<ThreeMfObject::Use>& uses) {
    const auto transform = transformIn(attribute(node, "transform"));
    if (!transform) return fail(bad("a transform of it is not twelve numbers"));
    const std::string path = attribute(node, "path");
    uses.push_back({path.empty() ? m_name : inPackage(path), attribute(node, "objectid"), *transform});
  }

  void addObject(Node node) {
    ThreeMfObject object;
    object.name = attribute(node, "name");
    eachChild(childOf(node, "components"), "component", [&](Node part) { addUse(part, object.parts); });
    const Node mesh = childOf(node, "mesh");
    eachChild(childOf(mesh, "vertices"), "vertex", [&](Node vertex) { addVertex(vertex, object.mesh); });
    eachChild(childOf(mesh, "triangles"), "triangle", [&](Node triangle) { addTriangle(triangle, object.mesh); });
    eachChild(childOf(mesh, "beamlattice"), "beams", [&](Node beams) { eachChild(beams, "beam", [&](Node) { ++m_out.lines; }); });
    if (m_good && !m_out.objects.emplace(attribute(node, "id"), std::move(object)).second) fail(bad("two objects of it have one number (" + attribute(node, "id").substr(0, 40) + ")"));
  }

  void addVertex(Node node, TriMesh& mesh) {
    Vec3 point;
    int axis = 0;
    for (const char* name : {"x", "y", "z"}) {
      const auto value = realIn(node.attribute(name).value());
      if (!value || !std::isfinite(*value)) return fail({Fault::NotFinite, {m_file, m_name, {}, static_cast<long>(mesh.vertices.size())}, {}, "3MF"});
      point[axis++] = *value;
    }
    mesh.vertices.push_back(point);
  }

  void addTriangle(Node node, TriMesh& mesh) {
    std::array<int, 3> corners{};
    const long number = static_cast<long>(mesh.triangles.size());
    int k = 0;
    for (const char* name : {"v1", "v2", "v3"}) {
      const auto index = integerIn(node.attribute(name).value());
      if (!index || *index < 0 || *index >= static_cast<long long>(mesh.vertices.size()))
        return fail({Fault::BadIndex, {m_file, m_name, {}, number}, {node.attribute(name).value(), std::to_string(mesh.vertices.size())}, "3MF"});
      corners[static_cast<std::size_t>(k++)] = static_cast<int>(*index);
    }
    if (++m_triangles > m_most) return fail({Fault::FileTooLarge, {m_file, {}, {}, {}}, {std::to_string(m_triangles) + " triangles", std::to_string(m_most)}, "3MF"});
    mesh.triangles.push_back(corners);
  }

  const std::string& m_file;
  std::string m_name;
  long long m_most, m_triangles = 0;
  ThreeMfModel m_out;
  bool m_good = true;
  Error m_error;
};

/// <object id><metadata key="name" value/><part id><metadata …: what PrusaSlicer, Bambu Studio and Orca keep for themselves.
void takeSlicersNames(const std::string& text, std::map<std::pair<std::string, std::string>, std::string>& names) {
  pugi::xml_document document;
  if (!document.load_buffer(text.data(), text.size())) return;
  const auto nameIn = [](Node node) {
    for (Node data = node.child("metadata"); data; data = data.next_sibling("metadata"))
      if (data.attribute("key").value() == std::string_view("name")) return std::string(data.attribute("value").value());
    return std::string();
  };
  for (Node object = document.child("config").child("object"); object; object = object.next_sibling("object")) {
    const std::string id = object.attribute("id").value();
    names[{id, {}}] = nameIn(object);
    for (Node part = object.child("part"); part; part = part.next_sibling("part")) names[{id, part.attribute("id").value()}] = nameIn(part);
  }
}

}  // namespace

Result<ThreeMfPackage> ThreeMfPackage::open(const std::string& path) {
  ThreeMfPackage package;
  package.m_path = path;
  const auto read = readZip(path, [&](const std::string& name, std::string_view bytes) -> Result<Done> {
    const std::string known = inPackage(name);
    if (known.ends_with(".model") || known == "/_rels/.rels" || known.ends_with("_config") || known.ends_with(".config")) package.m_texts.emplace(known, bytes);
    return Done{};
  });
  if (!read) return read.error();
  pugi::xml_document relations;
  if (const auto root = package.m_texts.find("/_rels/.rels"); root != package.m_texts.end() && relations.load_buffer(root->second.data(), root->second.size()))
    eachChild(childOf(relations, "Relationships"), "Relationship", [&](Node each) {
      if (package.m_start.empty() && attribute(each, "Type").ends_with("/3dmodel")) package.m_start = inPackage(attribute(each, "Target"));
    });
  if (package.m_start.empty()) package.m_start = "/3d/3dmodel.model";
  if (!package.m_texts.contains(package.m_start)) return Error{Fault::BadMesh, {path, {}, {}, {}}, {"it is a zip archive without the model that a 3MF file has"}, "3MF"};
  for (const auto& [name, text] : package.m_texts)
    if (name.ends_with("config")) takeSlicersNames(text, package.m_names);
  return package;
}

Result<const ThreeMfModel*> ThreeMfPackage::model(const std::string& name, long long most) {
  if (const auto known = m_models.find(name); known != m_models.end()) return &known->second;
  const auto text = m_texts.find(name);
  if (text == m_texts.end()) return Error{Fault::BadMesh, {m_path, {}, {}, {}}, {"a model file that it names is not in it (" + name.substr(0, 100) + ")"}, "3MF"};
  Result<ThreeMfModel> model = ModelParser(m_path, name, most).parse(text->second);
  if (!model) return model.error();
  text->second.clear();  // no longer needed, and as large as all the rest
  return &m_models.emplace(name, std::move(*model)).first->second;
}

std::string ThreeMfPackage::nameOf(const std::string& object, const std::string& part) const {
  const auto found = m_names.find({object, part});
  return found == m_names.end() ? std::string() : found->second;
}

}  // namespace glenoid
