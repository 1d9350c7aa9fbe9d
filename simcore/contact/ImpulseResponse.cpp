// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/contact/ImpulseResponse.h"

namespace glenoid {

namespace {

class CholeskyResponse : public ImpulseResponse {
 public:
  CholeskyResponse(std::shared_ptr<const BlockSymbolic> symbolic, bool portable) : m_factor(std::move(symbolic), portable) {}
  bool factor(const BlockMatrix& X) override { return m_factor.factor(X); }
  void solve(Eigen::Ref<VecX> x) const override { m_factor.solve(x); }
  void prepare(std::span<const SparseRow> rows) override { m_factor.halfSolve(rows, m_panels); }
  void addDelassus(std::span<const int> rowIds, Eigen::Ref<MatX> W) const override { m_factor.addDelassus(m_panels, rowIds, W); }
  void addImpulses(std::span<const double> lambda, Eigen::Ref<VecX> v) const override {
    m_factor.addImpulses(m_panels, lambda, v);
  }

 private:
  BlockCholesky m_factor;
  RowPanels m_panels;
};

class ReferenceResponse : public ImpulseResponse {
 public:
  explicit ReferenceResponse(std::shared_ptr<const BlockSymbolic> symbolic)
      : m_size(3 * symbolic->blockCount()), m_factor(std::move(symbolic)) {}
  bool factor(const BlockMatrix& X) override { return m_factor.factor(X); }
  void solve(Eigen::Ref<VecX> x) const override { m_factor.solve(x); }

  void prepare(std::span<const SparseRow> rows) override {
    m_rows = rows;
    m_columns.resize(m_size, static_cast<Eigen::Index>(rows.size()));
    m_columns.setZero();
    for (std::size_t row = 0; row < rows.size(); ++row) {
      for (const RowTerm& term : rows[row]) m_columns.col(row).segment<3>(3 * term.block) += term.coefficient;
      m_factor.solve(m_columns.col(row));
    }
  }

  void addDelassus(std::span<const int> rowIds, Eigen::Ref<MatX> W) const override {
    for (std::size_t i = 0; i < m_rows.size(); ++i)
      for (std::size_t j = 0; j < m_rows.size(); ++j)
        for (const RowTerm& term : m_rows[i])
          W(rowIds[i], rowIds[j]) += term.coefficient.dot(m_columns.col(j).segment<3>(3 * term.block));
  }

  void addImpulses(std::span<const double> lambda, Eigen::Ref<VecX> v) const override {
    v += m_columns * Eigen::Map<const VecX>(lambda.data(), static_cast<Eigen::Index>(lambda.size()));
  }

 private:
  Eigen::Index m_size;
  mutable ReferenceCholesky m_factor;
  std::span<const SparseRow> m_rows;
  MatX m_columns;
};

}  // namespace

std::unique_ptr<ImpulseResponse> makeCholeskyResponse(std::shared_ptr<const BlockSymbolic> symbolic, bool portable) {
  return std::make_unique<CholeskyResponse>(std::move(symbolic), portable);
}

std::unique_ptr<ImpulseResponse> makeReferenceResponse(std::shared_ptr<const BlockSymbolic> symbolic) {
  return std::make_unique<ReferenceResponse>(std::move(symbolic));
}

}  // namespace glenoid
