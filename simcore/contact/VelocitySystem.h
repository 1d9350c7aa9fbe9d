// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <limits>
#include <memory>
#include <vector>

#include "simcore/contact/ContactSystem.h"
#include "simcore/contact/ImpulseResponse.h"

namespace glenoid {

/// One coupling island of a contact island as VelocitySystem sees it; all must outlive the solve.
struct VelocityIsland {
  const BlockMatrix* A = nullptr;
  const VecX* b = nullptr;
  const ImpulseResponse* response = nullptr;  ///< of A, factored
  std::span<const SparseRow> rows;            ///< of J, over the island's blocks
  std::span<const int> ids;                   ///< their rows of the problem
  VecX* v = nullptr;                          ///< velocities: answer out
};

/// The contact problem in velocities: Newton's matrix H = A + Jᵀ G J is as sparse as A but for the blocks that a contact
/// joins, so a thousand contacts cost what a factorization costs and W never exists. Right for more rows than unknowns
/// (rigid bodies on many contacts) and for hundreds or thousands of rows; wrong where contacts share a compliance (dents).
/// What a contact answers is estimated from A's diagonal blocks and, for each island, how much more a few of its rows yield
/// than those blocks say: stiff tissue moves as a whole.
/// The symbolic factorization of H is kept while the blocks that contacts join stay within its pattern; a new one
/// allocates, all else only grows. One thread at a time; the same input gives the same bits.
class VelocitySystem : public ContactSystem {
 public:
  explicit VelocitySystem(bool portable) : m_portable(portable) {}

  /// The problem of the calls that follow: w = J v + C λ + d, d without J v*; compliance: C of each contact's normal row.
  /// False where contacts join blocks so that a factorization would cost more than `updatesMost` products of 3×3 blocks; then
  /// nothing else may be called.
  bool set(std::span<const VelocityIsland> islands, std::span<const ContactUnknowns> contacts, std::span<const double> compliance,
           const Eigen::Ref<const VecX>& d, double updatesMost = std::numeric_limits<double>::infinity());
  /// Products of 3×3 blocks in one factorization, contacts included.
  double updates() const { return static_cast<double>(m_symbolic->updateCount()) + m_joined; }
  /// A new symbolic factorization was needed.
  bool renewed() const { return m_renewed; }

  std::span<const ContactUnknowns> contacts() const override { return m_contacts; }
  double answer(int contact) const override { return m_answers[contact]; }
  double compliance(int contact) const override { return m_compliance[contact]; }
  void begin(const VecX& lambda, VecX& w) override;
  void residual(const VecX& lambda) override;
  bool factor(std::span<const ConePoint> points) override;
  Along step(VecX& dw) override;
  void respond(const VecX& impulses, VecX& dw) override;
  void move(double alpha, VecX& w) override;
  void impulses(VecX&) const override {}
  void take(const VecX&, VecX&) override {}
  double imbalance(const VecX& lambda) override;

 private:
  struct Term {
    int block;  ///< over all islands
    Mat3 C;     ///< rows: normal, tangents
  };
  void gatherTerms();
  void gatherAnswers();
  /// How much more an island answers at its rows, neighbours moving along, than blocks that stand alone would: the
  /// median of a few rows, at least 1 (a free rigid body: 1).
  double yieldOf(std::size_t island);
  bool renewPattern(double updatesMost);
  bool patternHolds() const;
  void mapEntries();
  void speeds(const VecX& v, VecX& w) const;            ///< w ← J v
  void addPush(const VecX& lambda, double sign, VecX& r) const;  ///< r += sign Jᵀ λ
  void multiplyA(const VecX& v, VecX& r);               ///< r ← A v
  void momentum();                                      ///< A v − b
  void scatter();                                       ///< v to the islands

  static constexpr double kLaidOut = 20;     ///< products that a block which contacts join costs where the pattern is new

  bool m_portable, m_renewed = false;
  double m_joined = 0;                       ///< blocks that contacts join, each contact by itself
  std::span<const VelocityIsland> m_islands;
  std::span<const ContactUnknowns> m_contacts;
  std::span<const double> m_compliance;
  VecX m_d;
  std::vector<int> m_base;                   ///< first block of each island
  int m_blocks = 0, m_rows = 0;
  std::vector<std::vector<Term>> m_terms;    ///< of each contact; more than are in use stay
  std::vector<int> m_contactOfRow;
  std::vector<double> m_answers;
  std::vector<Mat3> m_inverse;               ///< of A's diagonal blocks, times their island's yield

  std::vector<const BlockSymbolic*> m_patterns;  ///< of the islands that H was laid out for
  std::shared_ptr<const BlockSymbolic> m_symbolic;
  std::unique_ptr<BlockMatrix> m_H;
  std::unique_ptr<BlockCholesky> m_factor;
  std::vector<BlockEntry> m_fromA;           ///< where the stored blocks of the islands' A go
  std::vector<BlockEntry> m_fromContacts;    ///< and those of each contact, lower triangle by row

  VecX m_v, m_momentum, m_gradient, m_dv, m_product;
  std::vector<std::array<VecX, 2>> m_local;  ///< of each island: v and A v
};

}  // namespace glenoid
