// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <span>

#include "simcore/contact/FrictionCone.h"

namespace glenoid {

/// What the friction solve (ConeSolve.h) asks of the mechanics behind the contacts of one contact island: a point (in
/// velocities, or in impulses that stand for them), and Newton steps of
///     ½ (v − v*)ᵀ A (v − v*) + Σ ℓ_i(w_i),   w = J v − c,   with λ_i = −∂ℓ_i/∂w_i and slopes G_i = −∂λ_i/∂w_i.
/// Two kinds: ImpulseSystem keeps W = J A⁻¹ Jᵀ (dense, few rows on many unknowns), VelocitySystem keeps A + Jᵀ G J
/// (sparse, many rows). All vectors over rows are as long as the problem; units as in Lcp.h.
class ContactSystem {
 public:
  virtual ~ContactSystem() = default;
  virtual std::span<const ContactUnknowns> contacts() const = 0;
  /// About how fast a contact's own rows answer a unit impulse, 1/kg; zero: nothing answers.
  virtual double answer(int contact) const = 0;
  /// C of w = J v + C λ − c on the contact's normal row, 1/kg, where it is not already in W.
  virtual double compliance(int contact) const = 0;
  /// The point that impulses λ lead to, and its w.
  virtual void begin(const VecX& lambda, VecX& w) = 0;
  /// The contacts give λ at the point: kept for step().
  virtual void residual(const VecX& lambda) = 0;
  /// Slopes G_i = root·rootᵀ of the points, weights included. False where the matrix is not definite to working precision.
  virtual bool factor(std::span<const ConePoint> points) = 0;
  /// Newton's step for the last residual with the last factor: dw, and the derivative of the quadratic part along it
  /// at α: linear + α quadratic.
  struct Along {
    double linear = 0, quadratic = 0;
  };
  virtual Along step(VecX& dw) = 0;
  /// What `impulses` beside those of the last residual would add to that step's dw. The step stays as it is.
  virtual void respond(const VecX& impulses, VecX& dw) = 0;
  /// Goes α of the last step, and w with it, round-off of the way included.
  virtual void move(double alpha, VecX& w) = 0;
  /// λ ← the impulses that the point stands for; left as they are where the point is a velocity.
  virtual void impulses(VecX& lambda) const = 0;
  /// The point ← that of λ where points are impulses, and its w; where it is a velocity it stays.
  virtual void take(const VecX& lambda, VecX& w) = 0;
  /// How far the point is from the momentum that λ gives, m/s.
  virtual double imbalance(const VecX& lambda) = 0;
};

}  // namespace glenoid
