// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/import/ThreeMf.h"

#include <Eigen/LU>
#include <algorithm>

#include "simcore/import/ThreeMfPackage.h"

namespace glenoid {
namespace {

constexpr std::size_t kDepth = 32;  ///< parts of parts of parts; files of the wild have one or two

class Builder {
 public:
  Builder(ThreeMfPackage& package, const std::string& path, long long most) : m_package(package), m_path(path), m_most(most) {}

  Result<ImportedFile> build() {
    const auto start = m_package.model(m_package.start(), m_most);
    if (!start) return start.error();
    m_out.format = "3MF";
    m_out.metresPerUnit = (*start)->metresPerUnit;
    countWhatIsLost(**start);
    for (const ThreeMfObject::Use& item : (*start)->build) {
      m_item = item.object;
      if (!place(item, (*start)->metresPerUnit, Eigen::Matrix4d::Identity(), {}, 0)) return m_error;
    }
    if (m_out.surfaces.empty())
      return Error{Fault::BadMesh, {m_path, {}, {}, {}}, {(*start)->build.empty() ? "its build is empty: it holds no part that is to be made" : "it holds no triangles"}, "3MF"};
    return std::move(m_out);
  }

 private:
  bool fail(Error error) {
    m_error = std::move(error);
    return false;
  }

  void countWhatIsLost(const ThreeMfModel& model) {
    addNote(m_out.notes, ImportNote::MaterialsDropped, model.materials);
    addNote(m_out.notes, ImportNote::ColoursDropped, model.colours);
    addNote(m_out.notes, ImportNote::TexturesDropped, model.textures);
    addNote(m_out.notes, ImportNote::LinesDropped, model.lines);
  }

  /// `name`: of what it is a part of; `unit`: of the model that says so, and so of the shift.
  bool place(const ThreeMfObject::Use& use, double unit, const Eigen::Matrix4d& outer, const std::string& name, std::size_t depth) {
    if (depth > kDepth) return fail({Fault::CyclicReference, {m_path, {}, {}, {}}, {use.object}, "3MF"});
    const bool first = !m_package.isParsed(use.model);
    const auto model = m_package.model(use.model, m_most);
    if (!model) return fail(model.error());
    if (first) countWhatIsLost(**model);
    const auto found = (*model)->objects.find(use.object);
    if (found == (*model)->objects.end())
      return fail({Fault::BadMesh, {m_path, {}, {}, {}}, {"an object that it names is not in it (" + use.object.substr(0, 40) + ")"}, "3MF"});
    const ThreeMfObject& object = found->second;
    Eigen::Matrix4d transform = use.transform;
    transform.topRightCorner<3, 1>() *= unit / *m_out.metresPerUnit;
    const Eigen::Matrix4d toBuild = outer * transform;
    if (!toBuild.allFinite() || ++m_placed > kMostPlaced) return fail({Fault::FileTooLarge, {m_path, {}, {}, {}}, {std::to_string(m_placed) + " parts", std::to_string(kMostPlaced)}, "3MF"});
    std::string own = object.name;
    if (own.empty()) own = m_package.nameOf(m_item, depth == 0 ? std::string() : use.object);
    if (own.empty()) own = name;
    if (!object.mesh.triangles.empty() && !add(object.mesh, toBuild, (*model)->metresPerUnit, own)) return false;
    if (object.mesh.triangles.empty() && object.parts.empty()) addNote(m_out.notes, ImportNote::SurfacesWithoutTriangles, 1);
    for (const ThreeMfObject::Use& part : object.parts)
      if (!place(part, (*model)->metresPerUnit, toBuild, own, depth + 1)) return false;
    return true;
  }

  bool add(const TriMesh& mesh, const Eigen::Matrix4d& m, double metresPerUnit, const std::string& name) {
    m_triangles += static_cast<long long>(mesh.triangles.size());
    if (m_triangles > m_most) return fail({Fault::FileTooLarge, {m_path, {}, {}, {}}, {std::to_string(m_triangles) + " triangles", std::to_string(m_most)}, "3MF"});
    const double ratio = metresPerUnit / *m_out.metresPerUnit, determinant = m.topLeftCorner<3, 3>().determinant();
    ImportedSurface surface{name, mesh};
    const bool still = m.isIdentity(0) && ratio == 1;
    if (!still)
      for (Vec3& p : surface.mesh.vertices) {
        p = m.topLeftCorner<3, 3>() * (ratio * p) + m.topRightCorner<3, 1>();
        if (!p.allFinite()) return fail({Fault::NotFinite, {m_path, {}, {}, {}}, {}, "3MF"});
      }
    if (determinant < 0)
      for (auto& t : surface.mesh.triangles) std::swap(t[1], t[2]);
    addNote(m_out.notes, ImportNote::NodesMoved, !m.isIdentity(0));
    addNote(m_out.notes, ImportNote::NodesMirrored, determinant < 0);
    addNote(m_out.notes, ImportNote::PointsJoined, joinIdenticalPoints(surface.mesh));
    m_out.surfaces.push_back(std::move(surface));
    return true;
  }

  static constexpr long long kMostPlaced = 100000;
  ThreeMfPackage& m_package;
  const std::string& m_path;
  long long m_most, m_triangles = 0, m_placed = 0;
  std::string m_item;
  ImportedFile m_out;
  Error m_error;
};

}  // namespace

Result<ImportedFile> readThreeMf(const std::string& path, long long triangles) {
  Result<ThreeMfPackage> package = ThreeMfPackage::open(path);
  if (!package) return package.error();
  return Builder(*package, path, triangles).build();
}

}  // namespace glenoid
