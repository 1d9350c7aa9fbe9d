// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <Eigen/Core>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "simcore/base/Error.h"
#include "simcore/mesh/TriMesh.h"

namespace glenoid {

/// A thing of a 3MF model: a mesh, or parts that are other things.
struct ThreeMfObject {
  struct Use {
    std::string model, object;  ///< which model file, which of its objects
    Eigen::Matrix4d transform = Eigen::Matrix4d::Identity();
  };
  std::string name;
  TriMesh mesh;
  std::vector<Use> parts;
};

/// One .model file of a package.
struct ThreeMfModel {
  double metresPerUnit = 1e-3;
  std::map<std::string, ThreeMfObject, std::less<>> objects;  ///< by id
  std::vector<ThreeMfObject::Use> build;                      ///< what is meant to be seen
  long materials = 0, colours = 0, textures = 0, lines = 0;
};

/// The package as its files: models are parsed when they are asked for, names are in lower case and begin with '/'.
class ThreeMfPackage {
 public:
  /// Fails as readZip does, and with BadMesh where it holds no model.
  static Result<ThreeMfPackage> open(const std::string& path);

  const std::string& start() const { return m_start; }
  bool isParsed(const std::string& name) const { return m_models.contains(name); }
  /// `most` is the number of triangles that the file may have. Fails with BadMesh, NotFinite, BadIndex, FileTooLarge.
  Result<const ThreeMfModel*> model(const std::string& name, long long most);
  /// What slicers (PrusaSlicer, Bambu Studio, Orca) call an object, or a part of one, in a file beside the model.
  std::string nameOf(const std::string& object, const std::string& part) const;

 private:
  std::string m_path, m_start;
  std::map<std::string, std::string, std::less<>> m_texts;
  std::map<std::string, ThreeMfModel, std::less<>> m_models;
  std::map<std::pair<std::string, std::string>, std::string> m_names;  ///< by object and part; of the object itself: part ""
};

}  // namespace glenoid
