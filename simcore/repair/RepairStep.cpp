// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/repair/RepairStep.h"

#include <cmath>
#include <sstream>

#include "simcore/file/ByteReader.h"
#include "simcore/import/LengthUnit.h"
#include "simcore/mesh/MeshHealth.h"
#include "simcore/repair/Edges.h"
#include "simcore/repair/Topology.h"
#include "simcore/repair/Weld.h"
#include "simcore/repair/Wrap.h"

namespace glenoid {
namespace {

struct Word {
  RepairKind kind;
  const char* name;
  enum { Nothing, MayAmount, Amount, Axis, SignedAxis } needs;
};
constexpr std::array<Word, kRepairKindCount> kWords{{{RepairKind::Weld, "weld", Word::MayAmount},
                                                     {RepairKind::DropDegenerate, "dropDegenerate", Word::Nothing},
                                                     {RepairKind::DropDuplicates, "dropDuplicates", Word::Nothing},
                                                     {RepairKind::SplitNonManifold, "splitNonManifold", Word::Nothing},
                                                     {RepairKind::Orient, "orient", Word::Nothing},
                                                     {RepairKind::Outwards, "outwards", Word::Nothing},
                                                     {RepairKind::FillHoles, "fillHoles", Word::MayAmount},
                                                     {RepairKind::KeepLargest, "keepLargest", Word::Nothing},
                                                     {RepairKind::DropSmall, "dropSmall", Word::MayAmount},
                                                     {RepairKind::DropSheets, "dropSheets", Word::MayAmount},
                                                     {RepairKind::KeepSide, "keepSide", Word::SignedAxis},
                                                     {RepairKind::RemoveSelfIntersections, "removeSelfIntersections", Word::Nothing},
                                                     {RepairKind::Thicken, "thicken", Word::Amount},
                                                     {RepairKind::Wrap, "wrap", Word::MayAmount},
                                                     {RepairKind::Scale, "scale", Word::Amount},
                                                     {RepairKind::Mirror, "mirror", Word::Axis}}};

Error outOfRange(const RepairStep& step, const char* low) {
  return {Fault::OutOfRange, {}, {std::to_string(step.amount), low, "inf"}, repairName(step.kind)};
}

Error leavesNothing(const char* what) { return {Fault::BadMesh, {}, {what}, "repair"}; }

/// Shells of at least this area stay.
TriMesh ofArea(const TriMesh& mesh, const Shells& shells, double least, bool onlyOne, long& dropped) {
  std::vector<char> keepShell(shells.list.size(), 0), keep(mesh.triangles.size());
  bool have = false;
  dropped = 0;
  for (std::size_t s = 0; s < keepShell.size(); ++s) {
    keepShell[s] = shells.list[s].area >= least && !(onlyOne && have);
    have = have || keepShell[s];
    dropped += !keepShell[s];
  }
  for (std::size_t t = 0; t < keep.size(); ++t) keep[t] = keepShell[shells.ofTriangle[t]];
  return withTriangles(mesh, keep);
}

TriMesh withoutSheets(const TriMesh& mesh, double share, long& dropped, long& left) {
  const Shells shells = findShells(mesh, sidesOf(mesh.triangles));
  double largest = 0;
  for (const Shell& shell : shells.list)
    if (!shell.sheet()) largest = std::max(largest, shell.area);
  std::vector<char> keep(mesh.triangles.size());
  const auto stays = [&](const Shell& shell) { return !shell.sheet() || shell.area > share * largest; };
  for (const Shell& shell : shells.list) (stays(shell) ? left : dropped) += shell.sheet();
  for (std::size_t t = 0; t < keep.size(); ++t) keep[t] = stays(shells.list[shells.ofTriangle[t]]);
  return withTriangles(mesh, keep);
}

Result<TriMesh> ofSide(const TriMesh& mesh, const RepairStep& step, long& dropped) {
  const Shells shells = findShells(mesh, sidesOf(mesh.triangles));
  const double plane = boundsOf(mesh).center()[step.axis];
  std::vector<char> keep(mesh.triangles.size());
  dropped = 0;
  for (const Shell& shell : shells.list) {
    if (shell.box.min()[step.axis] < plane && shell.box.max()[step.axis] > plane) return leavesNothing("a piece reaches across the middle between the two sides");
    dropped += (shell.box.center()[step.axis] > plane) != step.upper;
  }
  for (std::size_t t = 0; t < keep.size(); ++t) keep[t] = (shells.list[shells.ofTriangle[t]].box.center()[step.axis] > plane) == step.upper;
  TriMesh out = withTriangles(mesh, keep);
  if (out.triangles.empty()) return leavesNothing("nothing lies on that side");
  return out;
}

Result<TriMesh> take(const TriMesh& mesh, const RepairStep& step, RepairChange& change) {
  switch (step.kind) {
    case RepairKind::Weld:
      if (!(step.amount >= 0)) return outOfRange(step, "0");
      return welded(mesh, step.amount, change.changed);
    case RepairKind::DropDegenerate: return withoutDegenerate(mesh, change.changed, change.left);
    case RepairKind::DropDuplicates: return withoutDuplicates(mesh, change.changed);
    case RepairKind::SplitNonManifold: return withoutCrowdedEdges(mesh, change.changed);
    case RepairKind::Orient: return orientedAlike(mesh, change.changed, change.left);
    case RepairKind::Outwards: return turnedOutwards(mesh, change.changed);
    case RepairKind::FillHoles:
      if (!(step.amount >= 0)) return outOfRange(step, "0");
      return withoutHoles(mesh, step.amount, change.changed, change.left, change.measure);
    case RepairKind::KeepLargest:
    case RepairKind::DropSmall: {
      if (!(step.amount >= 0 && step.amount <= 1)) return outOfRange(step, "0");
      const Shells shells = findShells(mesh, sidesOf(mesh.triangles));
      double largest = 0;
      for (const Shell& shell : shells.list) largest = std::max(largest, shell.area);
      const bool one = step.kind == RepairKind::KeepLargest;
      return ofArea(mesh, shells, one ? largest : largest * (step.amount > 0 ? step.amount : 0.01), one, change.changed);
    }
    case RepairKind::DropSheets:
      if (!(step.amount >= 0 && step.amount <= 1)) return outOfRange(step, "0");
      return withoutSheets(mesh, step.amount > 0 ? step.amount : 0.02, change.changed, change.left);
    case RepairKind::KeepSide: return ofSide(mesh, step, change.changed);
    case RepairKind::RemoveSelfIntersections: return withoutSelfCuts(mesh, change.changed, change.left);
    case RepairKind::Thicken:
      if (!(step.amount > 0 && std::isfinite(step.amount))) return outOfRange(step, "0");
      return thickened(mesh, step.amount, change.changed, change.left, change.measure);
    case RepairKind::Wrap: {
      if (!(step.amount >= 0 && std::isfinite(step.amount))) return outOfRange(step, "0");
      change.changed = static_cast<long>(mesh.triangles.size());
      return wrapped(mesh, step.amount);
    }
    case RepairKind::Scale:
      if (!(step.amount > 0 && std::isfinite(step.amount))) return outOfRange(step, "0");
      change.changed = static_cast<long>(mesh.vertices.size());
      return placed(mesh, step.amount, {}, Vec3::Zero());
    case RepairKind::Mirror: {
      AxisMap map;
      map.sign[step.axis] = -1;
      change.changed = static_cast<long>(mesh.vertices.size());
      return placed(mesh, 1, map, Vec3::Zero());
    }
  }
  return mesh;
}

}  // namespace

const char* repairName(RepairKind kind) {
  for (const Word& word : kWords)
    if (word.kind == kind) return word.name;
  return "";
}

bool isLength(RepairKind kind) { return kind == RepairKind::Weld || kind == RepairKind::FillHoles || kind == RepairKind::Thicken || kind == RepairKind::Wrap; }

Result<RepairStep> repairStepFrom(std::string_view text) {
  const std::size_t mark = text.find('=');
  const std::string_view name = text.substr(0, mark), value = mark == std::string_view::npos ? std::string_view() : text.substr(mark + 1);
  const auto fail = [&](const std::string& what) { return Error{Fault::BadUsage, {}, {what}, "repair step"}; };
  for (const Word& word : kWords) {
    if (name != word.name) continue;
    RepairStep step{word.kind};
    if (word.needs == Word::Amount || (word.needs == Word::MayAmount && mark != std::string_view::npos)) {
      std::string_view number = value;
      if (isLength(word.kind))
        for (const LengthUnit& unit : kLengthUnits)  // the longest that fits: “mm” ends as “m” does
          if (value.size() > unit.word.size() && value.ends_with(unit.word) && value.size() - unit.word.size() < number.size()) {
            number = value.substr(0, value.size() - unit.word.size());
            step.metresPerUnit = unit.metres;
          }
      const auto amount = realIn(number);
      if (!amount || !std::isfinite(*amount) || *amount < 0) return fail(std::string(name) + (isLength(word.kind) ? " needs a length, such as " : " needs a number, such as ") + word.name + (isLength(word.kind) ? "=0.5mm" : "=0.5"));
      step.amount = *amount;
    } else if (word.needs == Word::Axis || word.needs == Word::SignedAxis) {
      std::string_view axis = value;
      if (word.needs == Word::SignedAxis && !axis.empty() && (axis[0] == '+' || axis[0] == '-')) {
        step.upper = axis[0] == '+';
        axis.remove_prefix(1);
      } else if (word.needs == Word::SignedAxis) {
        axis = {};
      }
      if (axis.size() != 1 || axis[0] < 'x' || axis[0] > 'z')
        return fail(word.needs == Word::Axis ? "mirror needs an axis: mirror=x" : "keepSide needs a side: keepSide=-x or keepSide=+x");
      step.axis = axis[0] - 'x';
    } else if (mark != std::string_view::npos) {
      return fail(std::string(name) + " takes no value");
    }
    return step;
  }
  std::string known;
  for (const Word& word : kWords) known += (known.empty() ? "" : ", ") + std::string(word.name);
  return fail("“" + std::string(name) + "” is no repair; there are " + known);
}

std::string toWord(const RepairStep& step) {
  std::ostringstream out;
  out.imbue(std::locale::classic());
  out.precision(17);
  out << repairName(step.kind);
  for (const Word& word : kWords) {
    if (word.kind != step.kind) continue;
    if (word.needs == Word::Axis) out << '=' << "xyz"[step.axis];
    if (word.needs == Word::SignedAxis) out << '=' << (step.upper ? '+' : '-') << "xyz"[step.axis];
    if (word.needs == Word::Amount || (word.needs == Word::MayAmount && step.amount > 0)) {
      std::ostringstream plain;
      plain.imbue(std::locale::classic());
      plain.precision(6);
      plain << step.amount;
      if (realIn(plain.str()) == step.amount) out << '=' << plain.str();
      else out << '=' << step.amount;
      if (step.metresPerUnit > 0) out << unitWord(step.metresPerUnit);
    }
  }
  return out.str();
}

Result<RepairOutcome> repair(const TriMesh& mesh, const std::vector<RepairStep>& steps, double metresPerUnit) {
  const MeshHealth health = healthOf(mesh);
  if (health.badIndices > 0) return Error{Fault::BadIndex, {}, {"of a triangle", std::to_string(health.vertices)}, "repair"};
  if (health.notFinite > 0) return Error{Fault::NotFinite, {}, {}, "repair"};
  RepairOutcome outcome{mesh, {}};
  for (const RepairStep& step : steps) {
    RepairChange change;
    change.step = step;
    change.trianglesBefore = static_cast<long>(outcome.mesh.triangles.size());
    if (step.axis < 0 || step.axis > 2) return Error{Fault::OutOfRange, {}, {std::to_string(step.axis), "0", "2"}, "axis of a repair"};
    RepairStep own = step;
    if (own.metresPerUnit > 0) {
      if (!(metresPerUnit > 0)) return Error{Fault::BadUsage, {}, {"the surface has no unit that “" + toWord(step) + "” could be measured in: name it"}, "repair"};
      own.amount *= own.metresPerUnit / metresPerUnit;
    }
    Result<TriMesh> next = take(outcome.mesh, own, change);
    if (!next) return next.error();
    if (next->triangles.empty()) return leavesNothing("the repair would leave no triangle");
    outcome.mesh = std::move(*next);
    change.trianglesAfter = static_cast<long>(outcome.mesh.triangles.size());
    outcome.changes.push_back(change);
  }
  return outcome;
}

Mat3 AxisMap::matrix() const {
  Mat3 m = Mat3::Zero();
  for (int i = 0; i < 3; ++i) m(i, axis[i]) = sign[i];
  return m;
}

AxisMap proposedAxes(FileAxes said) {
  switch (said) {
    case FileAxes::Lps:
    case FileAxes::ZUp: return {{1, 2, 0}, {-1, 1, -1}};
    case FileAxes::Ras: return {{1, 2, 0}, {1, 1, 1}};
    default: return {};
  }
}

std::string axisWords(const AxisMap& map) {
  std::string out;
  for (int i = 0; i < 3; ++i) out += std::string(i ? " " : "") + (map.sign[i] < 0 ? "-" : "") + "xyz"[map.axis[i]];
  return out;
}

Result<AxisMap> axisMapFrom(const std::array<std::string, 3>& words) {
  AxisMap map;
  std::array<bool, 3> used{};
  for (int i = 0; i < 3; ++i) {
    std::string_view word = words[i];
    map.sign[i] = 1;
    if (!word.empty() && (word[0] == '-' || word[0] == '+')) {
      map.sign[i] = word[0] == '-' ? -1 : 1;
      word.remove_prefix(1);
    }
    if (word.size() != 1 || word[0] < 'x' || word[0] > 'z' || used[word[0] - 'x'])
      return Error{Fault::BadUsage, {}, {"axes name x, y and z once each, with or without a sign, such as -y z -x"}, "axes"};
    map.axis[i] = word[0] - 'x';
    used[map.axis[i]] = true;
  }
  return map;
}

TriMesh placed(const TriMesh& mesh, double factor, const AxisMap& map, const Vec3& shift) {
  const Mat3 turn = map.matrix();
  TriMesh out = mesh;
  for (Vec3& v : out.vertices) v = factor * (turn * v) + shift;
  if (turn.determinant() < 0)
    for (auto& t : out.triangles) std::swap(t[1], t[2]);
  return out;
}

std::vector<TriMesh> shellsOf(const TriMesh& mesh) {
  const Shells shells = findShells(mesh, sidesOf(mesh.triangles));
  std::vector<int> order(shells.list.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<int>(i);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return shells.list[a].area > shells.list[b].area; });
  std::vector<std::vector<std::array<int, 3>>> parts(order.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) parts[shells.ofTriangle[t]].push_back(mesh.triangles[t]);
  std::vector<TriMesh> out;
  std::vector<int> number(mesh.vertices.size(), -1);
  for (const int s : order) {  // each only touches its own vertices: thousands of shells cost no more than one
    TriMesh piece;
    std::vector<int> used;
    for (const auto& t : parts[s]) used.insert(used.end(), t.begin(), t.end());
    std::sort(used.begin(), used.end());
    used.erase(std::unique(used.begin(), used.end()), used.end());
    for (const int v : used) {
      number[v] = static_cast<int>(piece.vertices.size());
      piece.vertices.push_back(mesh.vertices[v]);
    }
    for (const auto& t : parts[s]) piece.triangles.push_back({number[t[0]], number[t[1]], number[t[2]]});
    out.push_back(std::move(piece));
  }
  return out;
}

}  // namespace glenoid
