// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>
#include <vector>

/// Files in the form in which other programs write them, made here, of the closed box of SampleFiles.h (1 × 2 × 3 units) unless
/// said otherwise.
namespace glenoid::peers {

/// What a glTF of the box is like.
struct Gltf {
  bool quantised = false;     ///< positions are 16-bit integers that the node scales back, as gltfpack 1.3 writes them by default
  bool normalized = false;    ///< … as shares of one, as gltf-transform 4.5 writes them
  bool packed = false;        ///< views packed by meshoptimizer, as gltfpack -c writes them
  bool exponential = false;   ///< … positions as floats behind the exponential filter, as gltfpack -c -vpf
  int vertexVersion = 0;      ///< what the packed points say of their version
  bool skinned = false;       ///< by two joints, half of the weight each, that together move it by 10 units along x
  bool mirroredJoints = false;
  std::string node = {};      ///< members of the box's node beside its own
};
std::string gltf(const Gltf& like, bool binary);

/// A 3MF package: files by name.
std::string threeMf(const std::vector<std::pair<std::string, std::string>>& models, bool deflate = true);
/// <mesh> of the box.
std::string threeMfMesh();
/// A model with namespaces of core and production, and these resources and build.
std::string threeMfModel(const std::string& attributes, const std::string& resources, const std::string& build);

/// A prism 10 high over a star of ten corners (radii 30 and 12): caps are concave polygons. Volume and area in closed form.
std::string starPly();
std::string starObj();
double starVolume();
double starArea();

/// Gmsh 4.8's only VTK: an unstructured grid of tetrahedra, the box cut into six.
std::string gmshVtk();

}  // namespace glenoid::peers
