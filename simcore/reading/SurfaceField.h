// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "simcore/reading/StressRecovery.h"
#include "simcore/step/Model.h"
#include "simcore/step/Stepper.h"

namespace glenoid {

/// What can be shown as a number at each place of a part's surface.
enum class Quantity {
  Stress,    ///< von Mises, √(3/2) |dev σ|, Pa, ≥ 0
  Strain,    ///< the largest principal one of ε = sym(RᵀF) − I, 1; below zero where tissue shrinks every way
  Pressure,  ///< −tr σ / 3, Pa; above zero where tissue is pressed
  Contact    ///< normal contact force for each area, Pa, ≥ 0: see spreadContacts
};
inline constexpr Quantity kQuantities[] = {Quantity::Stress, Quantity::Strain, Quantity::Pressure, Quantity::Contact};
const char* quantityName(Quantity quantity);  ///< "stress", "strain", "pressure", "contact"
std::optional<Quantity> quantityNamed(std::string_view name);

/// Of tensors as ElementReading has them.
double largestPrincipal(const Mat3& symmetric);
double pressureOf(const Mat3& stress);  ///< Pa

/// By object, then by vertex of its visual surface. Empty: the object has no such value (rigid parts have no stress; tools
/// have none at all), which is not the same as zero.
using SurfaceValues = std::vector<std::vector<float>>;

/// Values on the visual surfaces of a model, for drawing and for reading them off. What tissue says inside its elements is
/// recovered at each vertex where that vertex lies at rest (recoveryWeights: moving least squares over samples of one
/// material within recoveryReach), the tensor first and the number from it, so a free surface and one that cuts through
/// cells have the value of the tissue at the surface. The weights are found once; a reading reuses them. With tetrahedra
/// samples are the tissue's centroids in them, with cells eight places in each; both follow the law of the step.
/// Cost: README.md (0.4 to 1.1 ms a reading on the shipped arthroscopy, 20 ms for its weights). Frame W, SI units. Any number of threads may read from one.
class SurfaceField {
 public:
  /// Finds the weights, which takes a while: not for the thread that draws.
  explicit SurfaceField(std::shared_ptr<const Model> model);

  const std::shared_ptr<const Model>& model() const { return m_model; }
  /// Whether any part has tissue that could bear stress.
  bool hasTissue() const { return m_hasTissue; }

  /// `state`: q and rotations of the model. `contacts`: of the step that led there; only for Quantity::Contact.
  /// `stretchLaw`: whether that step had it (StepSettings).
  SurfaceValues read(Quantity quantity, const State& state, std::span<const ContactView> contacts, bool stretchLaw = true) const;

 private:
  void readTissue(int object, Quantity quantity, const State& state, bool stretchLaw, std::vector<float>& out) const;

  std::shared_ptr<const Model> m_model;
  std::vector<RecoveryTable> m_tables;  ///< by object; without places for those that have no tissue
  bool m_hasTissue = false;
};

/// The largest value of a part and where it is.
struct FieldPeak {
  double value = 0;
  Vec3 at_W = Vec3::Zero();  ///< m
};
/// Nothing where the object has no values.
std::optional<FieldPeak> peakOf(const Model& model, const SurfaceValues& values, int object, const VecX& q);

}  // namespace glenoid
