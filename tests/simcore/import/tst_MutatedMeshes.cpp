// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <atomic>
#include <chrono>
#include <cstdlib>
#include <map>
#include <mutex>
#include <thread>

#include "simcore/import/ImportSurfaces.h"
#include "tests/simcore/file/TemporaryFolder.h"
#include "tests/simcore/import/SampleFiles.h"

// Damaged files of every format. Each ends in surfaces or in a fault, within the limits, and the program that asked
// goes on. GLENOID_MUTATED_MESHES=10000 asks for that many instead of the short form.
namespace glenoid {
namespace {

/// splitmix64 (Steele, Lea, Flood 2014): the same damage on every machine.
class Random {
 public:
  explicit Random(std::uint64_t seed) : m_state(seed) {}
  std::uint64_t next() {
    std::uint64_t z = (m_state += 0x9e3779b97f4a7c15ull);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
    return z ^ (z >> 31);
  }
  std::size_t below(std::size_t n) { return n ? next() % n : 0; }

 private:
  std::uint64_t m_state;
};

bool isText(const std::string& bytes) {
  return std::all_of(bytes.begin(), bytes.end(), [](char c) { return static_cast<unsigned char>(c) >= 9; });
}

/// Where the nth run of digits begins and ends, counted around.
std::pair<std::size_t, std::size_t> digits(const std::string& bytes, std::size_t from) {
  const auto at = bytes.find_first_of("0123456789", from);
  if (at == std::string::npos) return {0, 0};
  return {at, std::min(bytes.find_first_not_of("0123456789.", at), bytes.size())};
}

const char* const kKinds[] = {"truncated", "bits", "count", "nan", "nested", "repeated", "zeroed", "words"};
constexpr std::size_t kKindCount = 8;

std::string damaged(std::string bytes, std::size_t kind, const std::string& name, Random& random) {
  const bool text = isText(bytes);
  const std::size_t at = random.below(bytes.size());
  switch (kind) {
    case 0: return bytes.substr(0, 1 + at);
    case 1:
      for (std::size_t i = 0, n = 1 + random.below(8); i < n; ++i) bytes[random.below(bytes.size())] ^= static_cast<char>(1 << random.below(8));
      return bytes;
    case 2: {
      static const char* const kHuge[] = {"4294967295", "2147483647", "-1", "99999999999999999999", "1000000000", "18446744073709551615"};
      static const std::uint32_t kWords[] = {0xffffffffu, 0x7fffffffu, 0x80000000u, 0x10000000u, 0x40000000u};
      if (text) {
        const auto [begin, end] = digits(bytes, at);
        return bytes.replace(begin, end - begin, kHuge[random.below(6)]);
      }
      const std::uint32_t word = kWords[random.below(5)];
      const std::size_t place = std::min(at, bytes.size() - std::min<std::size_t>(bytes.size(), 4));
      return bytes.replace(place, 4, std::string(reinterpret_cast<const char*>(&word), 4));
    }
    case 3: {
      static const char* const kNone[] = {"nan", "inf", "-inf", "1e999", "NaN", "-"};
      if (text) {
        const auto [begin, end] = digits(bytes, at);
        return bytes.replace(begin, end - begin, kNone[random.below(6)]);
      }
      return bytes.replace(at, 4, std::string("\xff\xff\xff\x7f", 4));
    }
    case 4: {
      const std::size_t deep = 1000 * (1 + random.below(50));
      std::string open;
      const bool xml = name.find("dae") != std::string::npos || name.find("vtp") != std::string::npos;
      const bool fbx = name.find("fbx") != std::string::npos;
      for (std::size_t i = 0; i < deep; ++i) open += xml ? "<node>" : fbx ? "a: {" : random.below(2) ? "[" : "{\"a\":";
      const std::size_t mark = bytes.find_first_of(xml ? "<" : "{[:", at);
      return bytes.insert(mark == std::string::npos ? at : mark, open);
    }
    case 5: return bytes.insert(at, bytes.substr(random.below(bytes.size()), 1 + random.below(2000)));
    case 6: return bytes.replace(at, 1 + random.below(64), 1 + random.below(64), '\0');
    default: {  // two words of the file change places
      const std::size_t other = random.below(bytes.size()), length = 1 + random.below(24);
      const std::string a = bytes.substr(at, length), b = bytes.substr(other, length);
      bytes.replace(at, a.size(), b);
      return bytes.replace(std::min(other, bytes.size()), std::min(b.size(), bytes.size() - std::min(other, bytes.size())), a);
    }
  }
}

double residentMiB() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024;
}

TEST(MutatedMeshes, eachEndsInAnAnswer) {
  using Clock = std::chrono::steady_clock;
  const char* asked = std::getenv("GLENOID_MUTATED_MESHES");
  const std::size_t count = asked ? std::strtoul(asked, nullptr, 10) : 320;
  const TemporaryFolder folder;
  const std::vector<samples::Sample> samples = samples::all();
  ImportLimits limits;
  limits.seconds = 10;
  limits.memory = 512ull << 20;
  std::map<std::string, int> outcomes, crashes;
  std::mutex lock;
  std::atomic<std::size_t> next{0};
  double longest = 0;
  const double before = residentMiB();
  const auto begin = Clock::now();
  const auto work = [&](int thread) {
    for (std::size_t i = next++; i < count; i = next++) {
      Random random(2010 + i);
      const samples::Sample& sample = samples[i % samples.size()];
      const std::size_t kind = (i / samples.size()) % kKindCount;
      const std::string path = folder.put(std::to_string(thread) + "-" + sample.name, damaged(sample.bytes, kind, sample.name, random));
      const auto start = Clock::now();
      const auto file = importSurfaces(path, limits);
      const double took = std::chrono::duration<double>(Clock::now() - start).count();
      const std::lock_guard guard(lock);
      longest = std::max(longest, took);
      ++outcomes[file ? "read" : faultName(file.error().fault)];
      if (!file && file.error().fault == Fault::ReaderStopped) ++crashes[sample.name + " " + kKinds[kind]];
      if (file) {
        for (const ImportedSurface& surface : file->surfaces) {
          for (const Vec3& v : surface.mesh.vertices) EXPECT_TRUE(v.allFinite()) << sample.name << " " << i;
          for (const auto& t : surface.mesh.triangles)
            for (const int v : t) EXPECT_LT(static_cast<std::size_t>(v), surface.mesh.vertices.size()) << sample.name << " " << i;
        }
      } else {
        EXPECT_NE(file.error().fault, Fault::Internal) << sample.name << " " << i;
        EXPECT_EQ(file.error().place.file, path);
      }
    }
  };
  std::thread other(work, 1);
  work(0);
  other.join();
  const double seconds = std::chrono::duration<double>(Clock::now() - begin).count();
  EXPECT_LT(longest, limits.seconds + 2);            // a kill and a loaded machine
  EXPECT_LT(residentMiB() - before, 600);            // what a reader may send, at most, and then it is dropped
  EXPECT_GT(outcomes["read"], 0);
  EXPECT_GT(outcomes["BadMesh"], 0);
  std::printf("%zu damaged files in %.1f s, the slowest %.2f s, memory of this program +%.0f MiB\n", count, seconds, longest, residentMiB() - before);
  for (const auto& [name, times] : outcomes) std::printf("  %-16s %d\n", name.c_str(), times);
  for (const auto& [name, times] : crashes) std::printf("  reader stopped: %-28s %d\n", name.c_str(), times);
}

}  // namespace
}  // namespace glenoid
