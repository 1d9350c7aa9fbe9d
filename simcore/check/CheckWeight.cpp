// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "simcore/body/PartMass.h"
#include "simcore/check/CheckParts.h"
#include "simcore/embed/Bind.h"
#include "simcore/scene/CouplingHold.h"
#include "simcore/scene/TriangleUse.h"

namespace glenoid::check {
namespace {

constexpr int kCuts = 128;
/// A tenth of the hanging height: what is weak over less of it stretches little.
constexpr int kWindow = kCuts / 10;
/// Stretches up to here are those of tissue under loads of its own kind.
constexpr double kStretchMost = 1.5;
/// What the advised modulus leaves: the linear range of the law.
constexpr double kStrainWanted = 0.2;

/// Area in which a plane cuts a closed surface, m²: Green's theorem along the cut.
double sectionOf(const TriMesh& mesh, const Vec3& up, double height) {
  const Vec3 origin = height * up;
  double twice = 0;
  for (const auto& t : mesh.triangles) {
    std::array<Vec3, 3> x;
    std::array<double, 3> h;
    for (int k = 0; k < 3; ++k) {
      x[k] = mesh.vertices[t[k]] - origin;
      h[k] = x[k].dot(up);
    }
    std::array<Vec3, 2> ends;
    int found = 0;
    for (int k = 0; k < 3 && found < 2; ++k) {
      const int l = (k + 1) % 3;
      if ((h[k] < 0) != (h[l] < 0)) ends[found++] = x[k] + h[k] / (h[k] - h[l]) * (x[l] - x[k]);
    }
    if (found < 2) continue;
    const Vec3 along = up.cross((x[1] - x[0]).cross(x[2] - x[0]));  // counterclockwise seen from above, the normal pointing out
    twice += ((ends[1] - ends[0]).dot(along) < 0 ? -1 : 1) * up.dot(ends[0].cross(ends[1]));
  }
  return 0.5 * twice;
}

/// Mean modulus and density of the tissue at each cut, by the tetrahedra that it goes through.
struct TissueAtCuts {
  std::vector<double> modulus, density;
};
TissueAtCuts tissueAt(const Joint& joint, const Part& part, const Vec3& up, double low, double step) {
  const Material& first = joint.materials[findMaterial(joint, part.materials[0].material)];
  TissueAtCuts tissue{std::vector<double>(kCuts, first.youngsModulus), std::vector<double>(kCuts, first.density)};
  if (part.materials.size() < 2) return tissue;
  std::vector<double> weight(kCuts, 0.0), modulus(kCuts, 0.0), density(kCuts, 0.0);
  const std::vector<int> label = labelTets(*part.volume, *part.visual, useOfTriangles(part));
  for (std::size_t e = 0; e < label.size(); ++e) {
    double from = std::numeric_limits<double>::infinity(), to = -from;
    for (const int node : part.volume->tets[e]) {
      const double height = part.volume->nodes[node].dot(up);
      from = std::min(from, height);
      to = std::max(to, height);
    }
    const Material& material = joint.materials[findMaterial(joint, part.materials[std::max(label[e], 0)].material)];
    const double share = tetVolume(*part.volume, static_cast<int>(e)) / (to - from);
    for (int cut = std::max(0, static_cast<int>(std::ceil((from - low) / step - 0.5))); cut < kCuts && low + (cut + 0.5) * step < to; ++cut) {
      weight[cut] += share;
      modulus[cut] += share * material.youngsModulus;
      density[cut] += share * material.density;
    }
  }
  for (int cut = 0; cut < kCuts; ++cut) {
    if (weight[cut] <= 0) continue;
    tissue.modulus[cut] = modulus[cut] / weight[cut];
    tissue.density[cut] = density[cut] / weight[cut];
  }
  return tissue;
}

double massOf(const Joint& joint, const Part& part) {
  if (part.kind == PartKind::Soft)
    return enclosedVolume(*part.visual) * joint.materials[findMaterial(joint, part.materials[0].material)].density;
  const auto properties = massPropertiesOf(joint, part);
  return properties ? properties->mass : 0;
}

class Hanging {
 public:
  explicit Hanging(const Work& work) : m_work(work), m_joint(work.joint), m_free(m_joint.parts.size(), 1), m_stays(m_joint.parts.size(), 0) {
    const Scenario standard;
    m_gravity = (work.scenario ? *work.scenario : standard).gravity_W;
    for (std::size_t i = 0; i < m_joint.parts.size(); ++i) {
      const Part& part = m_joint.parts[i];
      if (!work.scenario) {
        m_free[i] = part.kind != PartKind::Rigid;
      } else {
        const auto& fixed = work.scenario->fixedParts;
        m_free[i] = std::find(fixed.begin(), fixed.end(), part.id) == fixed.end();
        for (const Hold& hold : work.scenario->holds) m_stays[i] |= hold.part == part.id;
        for (const Support& support : work.scenario->supports) m_stays[i] |= support.part == part.id;
      }
      m_stays[i] |= !m_free[i];
    }
  }

  /// Largest mean strain of a tenth of the height that hangs from the part's bonds, by the weight below it; nothing where it does not
  /// hang, or something holds it besides its couplings.
  struct Strain {
    double strain = 0, modulus = 0;
  };
  std::optional<Strain> weakest(int part) const {
    const Part& p = m_joint.parts[part];
    const double g = m_gravity.norm();
    if (p.kind == PartKind::Rigid || m_stays[part] || !m_work.usable[part] || !(g > 0) || !hasMaterials(p)) return {};
    const Vec3 up = -m_gravity / g;
    const std::vector<char> reached = reachedWithout(part);
    double held = std::numeric_limits<double>::infinity();  // lowest point of what holds it
    std::vector<std::pair<double, double>> hung;            // height, mass
    std::vector<char> counted(m_joint.parts.size(), 0);
    for (const Coupling& coupling : m_joint.couplings) {
      const int a = findPart(m_joint, coupling.partA), b = findPart(m_joint, coupling.partB);
      if (a < 0 || b < 0 || a == b || (a != part && b != part) || !m_work.usable[a] || !m_work.usable[b]) continue;
      if (!hasHold(m_joint, coupling)) continue;
      double low = std::numeric_limits<double>::infinity(), high = -low;
      for (const Vec3& place : holdPlaces(m_joint.parts[a], coupling)) {
        low = std::min(low, place.dot(up));
        high = std::max(high, place.dot(up));
      }
      const int other = a == part ? b : a;
      if (reached[other]) held = std::min(held, low);
      else hung.push_back({0.5 * (low + high), massHungOn(other, part, counted)});
    }
    double low = std::numeric_limits<double>::infinity();
    for (const Vec3& x : p.visual->vertices) low = std::min(low, x.dot(up));
    if (!std::isfinite(held) || !(held > low)) return {};
    const double step = (held - low) / kCuts;
    const TissueAtCuts tissue = tissueAt(m_joint, p, up, low, step);
    std::array<double, kCuts> strain;
    double mass = 0;
    for (int cut = 0; cut < kCuts; ++cut) {
      const double height = low + (cut + 0.5) * step, area = sectionOf(*p.visual, up, height), slice = tissue.density[cut] * area * step;
      double below = mass + 0.5 * slice;
      for (const auto& [at, more] : hung)
        if (at < height) below += more;
      mass += slice;
      strain[cut] = area > 0 ? below * g / (tissue.modulus[cut] * area) : 0;
    }
    Strain most;
    for (int cut = 0; cut + kWindow <= kCuts; ++cut) {
      double sum = 0;
      for (int k = 0; k < kWindow; ++k) sum += strain[cut + k];
      if (sum / kWindow > most.strain) most = {sum / kWindow, tissue.modulus[cut + kWindow / 2]};
    }
    return most;
  }

 private:
  bool hasMaterials(const Part& part) const {
    return !part.materials.empty() && std::all_of(part.materials.begin(), part.materials.end(),
                                                  [&](const MaterialUse& use) { return findMaterial(m_joint, use.material) >= 0; });
  }

  template <class Visit>
  void eachNeighbour(int part, const Visit& visit) const {
    for (const Coupling& coupling : m_joint.couplings) {
      const int a = findPart(m_joint, coupling.partA), b = findPart(m_joint, coupling.partB);
      if (a < 0 || b < 0 || a == b) continue;
      if (a == part) visit(b);
      if (b == part) visit(a);
    }
  }

  /// Parts that something holds by another way than through this one.
  std::vector<char> reachedWithout(int without) const {
    std::vector<char> reached(m_joint.parts.size(), 0);
    std::vector<int> open;
    for (std::size_t i = 0; i < reached.size(); ++i)
      if (m_stays[i] && static_cast<int>(i) != without) reached[i] = 1, open.push_back(static_cast<int>(i));
    while (!open.empty()) {
      const int part = open.back();
      open.pop_back();
      eachNeighbour(part, [&](int next) {
        if (next == without || reached[next]) return;
        reached[next] = 1;
        open.push_back(next);
      });
    }
    return reached;
  }

  /// Mass of a part and of what it carries further on, each once.
  double massHungOn(int part, int without, std::vector<char>& counted) const {
    if (counted[part] || !m_work.usable[part] || !hasMaterials(m_joint.parts[part])) return 0;
    counted[part] = 1;
    double mass = massOf(m_joint, m_joint.parts[part]);
    eachNeighbour(part, [&](int next) {
      if (next != without) mass += massHungOn(next, without, counted);
    });
    return mass;
  }

  const Work& m_work;
  const Joint& m_joint;
  std::vector<char> m_free, m_stays;
  Vec3 m_gravity;
};

}  // namespace

void checkWeight(Work& work) {
  const Hanging hanging(work);
  for (std::size_t i = 0; i < work.joint.parts.size() && work.goesOn(); ++i) {
    const auto weakest = hanging.weakest(static_cast<int>(i));
    if (!weakest || 1 + weakest->strain <= kStretchMost) continue;
    Problem& problem = work.add(ProblemKind::WeightOverstretches, Severity::Warning, work.joint.parts[i].id);
    problem.figure = 1 + weakest->strain;
    problem.wanted = weakest->modulus * weakest->strain / kStrainWanted;
  }
}

}  // namespace glenoid::check
