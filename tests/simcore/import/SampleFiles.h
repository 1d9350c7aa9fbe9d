// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>
#include <vector>

/// Small valid files of every format that can be imported, written without the code under test. All hold the same
/// closed box of 1 × 2 × 3 units, wound outwards, six quads or twelve triangles.
namespace glenoid::samples {

struct Sample {
  std::string name;   ///< with the format's ending
  std::string bytes;
  bool quads = false; ///< six faces of four corners each
  double unit = 0;    ///< metres per unit as the file says it, 0: it does not
  /// What one unit of the box measures in the coordinates that are read.
  double scale = 1;
  bool mirrored = false;  ///< in a node that mirrors x
};

std::vector<Sample> all();
std::string zipped(const std::vector<std::pair<std::string, std::string>>& members, bool deflate);
std::string base64(const std::string& bytes);
std::string zlibPacked(const std::string& bytes, bool raw = false);
std::string obj();
std::string stlText();
std::string stlBinary();
std::string gltf();
std::string dae(const std::string& unit, bool mirrored);

enum class VtpForm { Ascii, Binary, BinaryZlib, AppendedRaw, AppendedRawZlib, AppendedBase64, AppendedBase64Zlib };
std::string vtp(VtpForm form, bool wideHeader, bool bigEndian);
std::string vtk(bool binary, bool offsets);

}  // namespace glenoid::samples
