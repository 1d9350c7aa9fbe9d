// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "simcore/base/Error.h"
#include "simcore/import/ImportedFile.h"
#include "simcore/mesh/TriMesh.h"

namespace glenoid {

enum class RepairKind {
  Weld,                    ///< amount: distance; 0: only what is at the very same place
  DropDegenerate,
  DropDuplicates,
  SplitNonManifold,
  Orient,                  ///< neighbours alike
  Outwards,                ///< shells that enclose a volume, and cavities inwards
  FillHoles,               ///< amount: longest loop that is closed; 0: all
  KeepLargest,
  DropSmall,               ///< amount: share of the largest shell's area below which a piece goes; 0: 0.01
  DropSheets,              ///< amount: pieces without thickness go, where others have some, up to this share of the largest's area; 0: 0.02
  KeepSide,                ///< axis and its sign in `axis`: one of two body sides
  RemoveSelfIntersections,
  Thicken,                 ///< amount: thickness, > 0
  Wrap,                    ///< a new surface around all of it (Wrap.h); amount: openings up to this width are bridged; 0: a hundredth of the diagonal
  Scale,                   ///< amount: factor, > 0
  Mirror,                  ///< axis
};
inline constexpr int kRepairKindCount = static_cast<int>(RepairKind::Mirror) + 1;

/// One step of a repair, as data: lists of them are kept, shown, and repeated from a recipe. A length without a unit of its own
/// is in the one that the surface has when the step's turn comes.
struct RepairStep {
  RepairKind kind = RepairKind::Weld;
  double amount = 0;
  int axis = 0;         ///< 0, 1, 2: x, y, z
  bool upper = false;   ///< KeepSide: the half of larger coordinates
  double metresPerUnit = 0;  ///< of a length that was written with its unit; 0: without one
  bool operator==(const RepairStep&) const = default;
};

/// "weld", "dropDegenerate" … as recipes and the command line write them.
const char* repairName(RepairKind kind);

/// Whether its amount is a length.
bool isLength(RepairKind kind);

/// "weld", "weld=0.01", "thicken=1mm" (units as in LengthUnit.h), "keepSide=-x", "mirror=y": BadUsage (argument: what) for anything else.
Result<RepairStep> repairStepFrom(std::string_view word);
std::string toWord(const RepairStep& step);

/// What one step did.
struct RepairChange {
  RepairStep step;
  long changed = 0;            ///< of what the step is about: holes filled, faces dropped, shells turned …
  long left = 0;               ///< of the same that could not be repaired
  long trianglesBefore = 0, trianglesAfter = 0;
  double measure = 0;          ///< Thicken: least thickness reached (median of rays); FillHoles: longest loop left open
};

struct RepairOutcome {
  TriMesh mesh;
  std::vector<RepairChange> changes;  ///< one for each step, also where nothing was to do
};

/// Takes the steps one after the other. Pure: the same mesh and steps give the same answer. Fails with BadIndex or
/// NotFinite for a mesh that cannot be read, with OutOfRange for an amount that makes no sense, and with BadMesh
/// (argument: what) when a step would leave nothing. Wrap fails as wrapped() does. Lengths with a unit need the surface's own, m (0: not known), else BadUsage;
/// Scale leaves it as it is: what was a millimetre is one afterwards.
Result<RepairOutcome> repair(const TriMesh& mesh, const std::vector<RepairStep>& steps, double metresPerUnit = 0);

/// Three directions of the surface's own axes that become X, Y and Z: {"-y", "z", "-x"}. The frame of many atlases (Z up,
/// Y backward, right = −X) becomes ours (X anterior, Y superior, Z lateral of a right shoulder) by exactly these.
struct AxisMap {
  std::array<int, 3> axis{0, 1, 2};
  std::array<int, 3> sign{1, 1, 1};
  Mat3 matrix() const;  ///< x_new = matrix() x; determinant −1 mirrors
  bool operator==(const AxisMap&) const = default;
};

/// The map that makes a file's axes ours (X forward, Y up, Z to the right) where the file says enough: LPS {"-y", "z", "-x"}, RAS
/// {"y", "z", "x"}; Z up is taken as LPS is; else as they are.
AxisMap proposedAxes(FileAxes said);
/// "-y z -x", as --axes takes it.
std::string axisWords(const AxisMap& map);

/// From three words; BadUsage unless each axis is named once.
Result<AxisMap> axisMapFrom(const std::array<std::string, 3>& words);

/// Moves every vertex: x_new = factor · map x + shift; turns the triangles where the map mirrors, so that what was
/// outside stays outside.
TriMesh placed(const TriMesh& mesh, double factor, const AxisMap& map, const Vec3& shift);

/// The shells of a surface, joined through edges, largest area first; each compact, order kept.
std::vector<TriMesh> shellsOf(const TriMesh& mesh);

}  // namespace glenoid
