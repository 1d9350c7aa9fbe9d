// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <vector>

#include "simcore/contact/ContactSystem.h"

namespace glenoid {

/// The contact problem in impulses μ, v = v* + A⁻¹ Jᵀ μ: w = W μ + d. Right for some hundred rows, whatever lies behind
/// W; memory n², a factorization n³/3 in what touches. A Newton step is, with G = B Bᵀ and r = μ − λ,
///     Δμ = −(I + G W)⁻¹ r = −r + B (I + Bᵀ W B)⁻¹ Bᵀ W r:   symmetric and definite however dependent the rows.
/// Scratch only grows.
class ImpulseSystem : public ContactSystem {
 public:
  /// The problem of the calls that follow; W, d and contacts must live as long.
  void set(const Eigen::Ref<const MatX>& W, const Eigen::Ref<const VecX>& d, std::span<const ContactUnknowns> contacts,
           double compliance);

  std::span<const ContactUnknowns> contacts() const override { return m_contacts; }
  double answer(int contact) const override;
  double compliance(int) const override { return 0; }
  void begin(const VecX& lambda, VecX& w) override;
  void residual(const VecX& lambda) override;
  bool factor(std::span<const ConePoint> points) override;
  Along step(VecX& dw) override;
  void respond(const VecX& impulses, VecX& dw) override;
  void move(double alpha, VecX& w) override;
  void impulses(VecX& lambda) const override { lambda.head(m_rows) = m_impulses.head(m_rows); }
  void take(const VecX& lambda, VecX& w) override { begin(lambda, w); }
  double imbalance(const VecX&) override { return 0; }

 private:
  void multiply(const VecX& impulses, VecX& speeds) const;  ///< speeds ← W impulses
  void newton(const VecX& gap, VecX& change, VecX& speeds);   ///< change ← −(I + G W)⁻¹ gap, speeds ← W change

  int m_rows = 0;
  std::span<const ContactUnknowns> m_contacts;
  MatX m_W;                ///< with its relative compliance
  VecX m_d;
  VecX m_impulses;         ///< μ
  VecX m_gap;              ///< r
  VecX m_change, m_speeds; ///< Δμ and W Δμ
  VecX m_answer, m_other;  ///< scratch
  MatX m_factor;           ///< of I + Bᵀ W B
  VecX m_inner;
  struct Part {
    int contact, column;   ///< its first column of B
  };
  std::vector<Part> m_parts;
  struct Root {
    Mat3 root;             ///< weight included
    int rank;
  };
  std::vector<Root> m_roots;  ///< of the parts
  int m_columns = 0;
};

}  // namespace glenoid
