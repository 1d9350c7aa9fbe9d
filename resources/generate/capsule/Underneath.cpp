// SPDX-License-Identifier: GPL-3.0-or-later
#include "resources/generate/capsule/Underneath.h"

#include <algorithm>

namespace glenoid::generate {
namespace {

constexpr double kDeepest = 4;  ///< mm
constexpr double kStep = 0.05;  ///< mm
constexpr int kRounds = 4;      ///< of evening out

/// How far a point moves, and how far it may.
struct Way {
  double needed = 0, most = 0;
};

Way wayOf(const Vec3& p, const Vec3& out, const shape::Field& over, const shape::Field& head, double room, double least) {
  Way way;
  while (way.most + kStep <= kDeepest && head(p - (way.most + kStep) * out) >= least) way.most += kStep;
  // What is nearest to being free where nothing is.
  double best = over(p);
  for (double t = 0; best < room && t <= way.most; t += kStep)
    if (const double off = over(p - t * out); off > best) best = off, way.needed = t;
  return way;
}

}  // namespace

void moveUnder(Sheet& sheet, const shape::Field& over, const shape::Field& head, double room, double least) {
  const int across = sheet.across, rows = static_cast<int>(sheet.points.size()) / across;
  std::vector<Way> ways;
  for (std::size_t k = 0; k < sheet.points.size(); ++k) ways.push_back(wayOf(sheet.points[k], sheet.out[k], over, head, room, least));
  std::vector<double> way;
  for (const Way& each : ways) way.push_back(each.needed);
  for (int round = 0; round < kRounds; ++round) {
    std::vector<double> next = way;
    for (int j = 0; j < rows; ++j)
      for (int i = 0; i < across; ++i) {
        double sum = 0;
        int count = 0;
        for (const auto& [di, dj] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
          int k = i + di;
          const int l = j + dj;
          if (sheet.closed) k = (k + across) % across;
          if (k < 0 || k >= across || l < 0 || l >= rows) continue;
          sum += way[l * across + k];
          ++count;
        }
        const Way& own = ways[j * across + i];
        next[j * across + i] = std::clamp(0.5 * way[j * across + i] + 0.5 * sum / count, own.needed, std::max(own.needed, own.most));
      }
    way = std::move(next);
  }
  for (std::size_t k = 0; k < way.size(); ++k) sheet.points[k] -= way[k] * sheet.out[k];
}

}  // namespace glenoid::generate
