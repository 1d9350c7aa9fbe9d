// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/contact/ContactRows.h"

#include <algorithm>

namespace glenoid {

namespace {

/// Share of their length below which what is left of two rows that cancel is rounding.
constexpr double kCancelled = 1e-6;

/// Sums the terms of one block from `first` to the end of a list that ascends by block; false where next to nothing is left.
bool mergeTerms(std::vector<RowTerm>& terms, std::size_t first) {
  double before = 0, after = 0;
  std::size_t last = first;
  for (std::size_t i = first; i < terms.size(); ++i) {
    before += terms[i].coefficient.squaredNorm();
    if (i == last) continue;
    if (terms[i].block == terms[last].block)
      terms[last].coefficient += terms[i].coefficient;
    else
      terms[++last] = terms[i];
  }
  if (last + 1 == terms.size()) return true;  // nothing was shared
  terms.resize(last + 1);
  for (std::size_t i = first; i < terms.size(); ++i) after += terms[i].coefficient.squaredNorm();
  return after > kCancelled * kCancelled * before;
}

}  // namespace

void IslandRows::clear() {
  m_terms.clear();
  m_contact.clear();
  m_start.assign(1, 0);
}

void IslandRows::begin(int contact) { m_contact.push_back(contact); }

void IslandRows::append(const ContactObject& object, const MaterialPoint& point, const Vec3& direction, const VecX& q,
                        int base) {
  RowTerm terms[kMaxPointTerms];
  const int count = object.rowTerms(point, direction, q, base, terms);
  m_terms.insert(m_terms.end(), terms, terms + count);
}

bool IslandRows::finish() {
  const auto first = m_terms.begin() + m_start.back();
  if (first == m_terms.end()) {
    m_contact.pop_back();
    return false;
  }
  std::sort(first, m_terms.end(), [](const RowTerm& a, const RowTerm& b) { return a.block < b.block; });
  if (const std::size_t begin = static_cast<std::size_t>(m_start.back()); !mergeTerms(m_terms, begin)) {
    m_terms.resize(begin);
    m_contact.pop_back();
    return false;
  }
  m_start.push_back(static_cast<int>(m_terms.size()));
  return true;
}

double dot(SparseRow row, const VecX& v) {
  double sum = 0;
  for (const RowTerm& term : row) sum += term.coefficient.dot(v.segment<3>(3 * term.block));
  return sum;
}

void addTransposed(SparseRow row, double lambda, VecX& r) {
  for (const RowTerm& term : row) r.segment<3>(3 * term.block) += lambda * term.coefficient;
}

}  // namespace glenoid
