// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/simcore/linear/Problems.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace glenoid::test {
namespace {

Mat3 randomMatrix(Random& random) {
  Mat3 m;
  for (int c = 0; c < 3; ++c) m.col(c) = random.vector();
  return m;
}

/// Adds (B0 B1 …)ᵀ(B0 B1 …) scaled: positive semidefinite, rank 3, on all pairs of the blocks.
void addTerm(BlockMatrix& A, const std::vector<std::pair<int, Mat3>>& term, double scale) {
  for (std::size_t i = 0; i < term.size(); ++i)
    for (std::size_t j = 0; j <= i; ++j)
      A.add(A.symbolic().entry(term[i].first, term[j].first),
            scale * term[i].second.transpose() * term[j].second);
}

void addAllPairs(Pairs& pairs, const std::vector<int>& blocks) {
  for (const int a : blocks)
    for (const int b : blocks)
      if (a < b) pairs.push_back({a, b});
}

}  // namespace

VecX Random::vector(int size) {
  VecX v(size);
  for (int i = 0; i < size; ++i) v[i] = symmetric();
  return v;
}

std::vector<Pattern> patterns() {
  std::vector<Pattern> result;
  result.push_back({"single", 1, {}});
  result.push_back({"diagonal", 7, {{3, 3}, {0, 0}}});
  Pattern chain{"chain", 40, {}}, dense{"dense", 18, {}}, star{"star", 30, {}}, islands{"islands", 60, {}};
  for (int i = 0; i + 1 < chain.blocks; ++i) chain.pairs.push_back({i + 1, i});
  for (int i = 0; i < dense.blocks; ++i)
    for (int j = 0; j < dense.blocks; ++j) dense.pairs.push_back({i, j});  // both triangles: duplicates
  for (int i = 0; i < star.blocks; ++i) star.pairs.push_back({14, i});
  for (int i = 0; i < islands.blocks; ++i)  // stripes of five chains and isolated blocks between them
    if (i % 6 != 0 && i + 6 < islands.blocks) islands.pairs.push_back({i, i + 6});
  Pattern grid{"grid", 5 * 6 * 4, {}};
  const auto at = [](int x, int y, int z) { return (z * 6 + y) * 5 + x; };
  for (int z = 0; z < 4; ++z)
    for (int y = 0; y < 6; ++y)
      for (int x = 0; x < 5; ++x) {
        if (x + 1 < 5) grid.pairs.push_back({at(x, y, z), at(x + 1, y, z)});
        if (y + 1 < 6) grid.pairs.push_back({at(x, y, z), at(x, y + 1, z)});
        if (z + 1 < 4) grid.pairs.push_back({at(x, y, z + 1), at(x, y, z)});
      }
  result.insert(result.end(), {chain, dense, star, islands, grid});
  for (const int edges : {30, 120, 600}) {
    Pattern random{"random" + std::to_string(edges), 70, {}};
    Random generator(static_cast<unsigned>(edges));
    for (int e = 0; e < edges; ++e) {
      const int row = generator.below(random.blocks);
      const int col = generator.below(random.blocks);
      random.pairs.push_back({row, col});
    }
    result.push_back(random);
  }
  return result;
}

BlockMatrix randomSpd(const Pattern& pattern, unsigned seed, double shift, double decades) {
  const bool floating = decades > 0.0;
  BlockMatrix A(std::make_shared<const BlockSymbolic>(pattern.blocks, pattern.pairs));
  Random random(seed);
  for (int i = 0; i < pattern.blocks; ++i) A.add(A.symbolic().entry(i, i), shift * Mat3::Identity());
  for (const auto& [row, col] : pattern.pairs) {
    const Mat3 left = randomMatrix(random);
    const Mat3 right = floating ? Mat3(-left) : randomMatrix(random);
    const double scale = std::pow(10.0, 0.5 * decades * random.symmetric());
    if (row == col && !floating)
      addTerm(A, {{row, left}}, scale);
    else if (row != col)
      addTerm(A, {{row, left}, {col, right}}, scale);
  }
  return A;
}

std::vector<std::vector<RowTerm>> randomRows(int blocks, int count, int maxTerms, unsigned seed) {
  Random random(seed);
  std::vector<std::vector<RowTerm>> rows(static_cast<std::size_t>(count));
  for (auto& row : rows) {
    std::map<int, Vec3> terms;
    const int size = 1 + random.below(maxTerms);
    for (int t = 0; t < size; ++t) {
      const int block = random.below(blocks);
      terms[block] = random.vector();
    }
    for (const auto& [block, coefficient] : terms) row.push_back({block, coefficient});
  }
  return rows;
}

std::vector<SparseRow> asRows(const std::vector<std::vector<RowTerm>>& rows) {
  return {rows.begin(), rows.end()};
}

MatX denseRows(const std::vector<std::vector<RowTerm>>& rows, int blocks) {
  MatX J = MatX::Zero(static_cast<Eigen::Index>(rows.size()), 3 * blocks);
  for (std::size_t r = 0; r < rows.size(); ++r)
    for (const RowTerm& term : rows[r])
      J.block<1, 3>(static_cast<Eigen::Index>(r), 3 * term.block) += term.coefficient.transpose();
  return J;
}

ShoulderSize shoulderSize(double stiffnessRatio) {
  // Cells per axis: 60 + 84 + 102 + 56 + 60 + 66 + 84 = 512 nodes, 153 cells of five tetrahedra.
  constexpr std::array<std::array<int, 3>, 7> kCells{
      {{1, 2, 9}, {1, 2, 13}, {1, 2, 16}, {1, 1, 13}, {1, 2, 9}, {1, 2, 10}, {1, 2, 13}}};
  constexpr int kRigid = 4, kCouplings = 24, kSprings = 8;
  // Corner bits of the five tetrahedra of an even cell; an odd one is its mirror image.
  constexpr std::array<std::array<int, 4>, 5> kTets{
      {{0, 1, 2, 4}, {3, 2, 1, 7}, {5, 1, 4, 7}, {6, 4, 2, 7}, {1, 2, 4, 7}}};

  ShoulderSize result;
  Pairs pairs;
  int blocks = 0;
  for (const auto& cells : kCells) {
    std::vector<std::array<int, 4>> tets;
    const int first = blocks;
    const auto node = [&](int x, int y, int z) {
      return first + (z * (cells[1] + 1) + y) * (cells[0] + 1) + x;
    };
    for (int z = 0; z < cells[2]; ++z)
      for (int y = 0; y < cells[1]; ++y)
        for (int x = 0; x < cells[0]; ++x)
          for (const auto& corners : kTets) {
            std::array<int, 4> tet;
            for (int c = 0; c < 4; ++c) {
              const int bits = (x + y + z) % 2 == 0 ? corners[c] : corners[c] ^ 1;
              tet[c] = node(x + (bits & 1), y + (bits >> 1 & 1), z + (bits >> 2));
            }
            tets.push_back(tet);
            addAllPairs(pairs, {tet.begin(), tet.end()});
          }
    blocks += (cells[0] + 1) * (cells[1] + 1) * (cells[2] + 1);
    result.tetrahedra += static_cast<int>(tets.size());
    result.partTets.push_back(tets);
  }
  const int firstRigid = blocks;
  blocks += 2 * kRigid;
  for (int body = 0; body < kRigid; ++body)
    pairs.push_back({firstRigid + 2 * body, firstRigid + 2 * body + 1});

  // Springs between embedded points, each coupling in a narrow region: a third hold a part to the next one, a
  // third to a free rigid body, a third to something fixed.
  Random random(7);
  constexpr int kRegion = 10;  // tetrahedra
  std::vector<std::vector<std::pair<int, Mat3>>> springs;
  for (int coupling = 0; coupling < kCouplings; ++coupling) {
    const auto& left = result.partTets[static_cast<std::size_t>(coupling % 7)];
    const auto& right = result.partTets[static_cast<std::size_t>((coupling + 1) % 7)];
    const int kind = coupling / 7 % 3;
    const int leftStart = (static_cast<int>(left.size()) - kRegion) * (coupling % 4) / 3;
    for (int s = 0; s < kSprings; ++s) {
      std::map<int, Mat3> term;
      for (const int block : left[static_cast<std::size_t>(leftStart + random.below(kRegion))])
        term[block] = 0.25 * Mat3::Identity();
      if (kind == 0) {
        for (const int block : right[static_cast<std::size_t>(random.below(kRegion))])
          term[block] = -0.25 * Mat3::Identity();
      } else if (kind == 1) {
        const int body = firstRigid + 2 * (coupling % kRigid);
        term[body] = -Mat3::Identity();
        term[body + 1] = skew(0.03 * random.vector());
      }
      springs.emplace_back(term.begin(), term.end());
      std::vector<int> members;
      for (const auto& [block, value] : term) members.push_back(block);
      addAllPairs(pairs, members);
    }
  }

  result.symbolic = std::make_shared<const BlockSymbolic>(blocks, pairs);
  result.A = std::make_unique<BlockMatrix>(result.symbolic);
  BlockMatrix& A = *result.A;
  for (int i = 0; i < blocks; ++i) A.add(A.symbolic().entry(i, i), 1e-3 * Mat3::Identity());
  for (std::size_t part = 0; part < result.partTets.size(); ++part) {
    const double stiffness = std::pow(stiffnessRatio, static_cast<double>(part) / 6.0);
    for (const auto& tet : result.partTets[part]) {
      for (int rank = 0; rank < 2; ++rank) {  // six independent strains
        std::vector<std::pair<int, Mat3>> term;
        Mat3 sum = Mat3::Zero();
        for (int c = 0; c < 3; ++c) {
          term.emplace_back(tet[c], randomMatrix(random));
          sum += term.back().second;
        }
        term.emplace_back(tet[3], -sum);  // a translation costs nothing
        addTerm(A, term, 0.01 * stiffness);
      }
    }
  }
  for (std::size_t s = 0; s < springs.size(); ++s)
    addTerm(A, springs[s], std::pow(100.0, static_cast<double>(s) / static_cast<double>(springs.size())));
  return result;
}

std::vector<std::vector<RowTerm>> ShoulderSize::contactRows(int count, unsigned seed) const {
  Random random(seed);
  std::vector<std::vector<RowTerm>> rows(static_cast<std::size_t>(count));
  const int parts = static_cast<int>(partTets.size());
  for (int r = 0; r < count; ++r) {
    // Contacts come in patches: a few regions, each with rows that share neighbouring elements.
    const int patch = r / 16;
    std::map<int, Vec3> terms;
    const Vec3 normal = random.vector();
    for (const int side : {0, 1}) {
      const auto& tets = partTets[static_cast<std::size_t>((patch + side) % parts)];
      const int start = static_cast<int>((static_cast<std::size_t>(patch) * 37 + 11) % (tets.size() - 20));
      for (int corner = 0; corner < 2; ++corner)
        for (const int block : tets[static_cast<std::size_t>(start + random.below(20))]) {
          const auto [it, added] = terms.try_emplace(block, Vec3::Zero());
          it->second += (side == 0 ? 0.125 : -0.125) * normal;
        }
    }
    for (const auto& [block, coefficient] : terms)
      rows[static_cast<std::size_t>(r)].push_back({block, coefficient});
  }
  return rows;
}

}  // namespace glenoid::test
