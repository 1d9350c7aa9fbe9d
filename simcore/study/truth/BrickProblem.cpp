// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/study/truth/BrickProblem.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <map>
#include <sstream>
#include <string>

extern char** environ;

namespace glenoid::truth {

namespace {

/// Corners and middles of a brick of 20 nodes by half steps from its first corner, in the order of the
/// program's manual.
constexpr int kOrder[20][3] = {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {0, 0, 2}, {2, 0, 2}, {2, 2, 2},
                               {0, 2, 2}, {1, 0, 0}, {2, 1, 0}, {1, 2, 0}, {0, 1, 0}, {1, 0, 2}, {2, 1, 2},
                               {1, 2, 2}, {0, 1, 2}, {0, 0, 1}, {2, 0, 1}, {2, 2, 1}, {0, 2, 1}};

using Nodes = std::map<std::array<int, 3>, int>;

/// A static problem; of its `modes` lowest frequencies where there are any.
Nodes writeInput(const BrickProblem& p, const std::string& path, double density = 0, int modes = 0) {
  std::ofstream out(path);
  out.precision(
      12);  // the program reads twenty characters of a number and leaves out the rest, an exponent too
  Nodes nodes;
  out << "*NODE, NSET=ALL\n";
  for (int k = 0; k <= 2 * p.nz; ++k)
    for (int j = 0; j <= 2 * p.nt; ++j)
      for (int i = 0; i <= 2 * p.ns; ++i) {
        if (i % 2 + j % 2 + k % 2 > 1) continue;
        const int id = nodes[{i, j, k}] = static_cast<int>(nodes.size()) + 1;
        const Vec2 x = p.map(0.5 * i / p.ns, 0.5 * j / p.nt);
        const double lift = p.lift ? p.lift(0.5 * i / p.ns, 0.5 * j / p.nt) : 0;
        out << id << ", " << x.x() << ", " << x.y() << ", " << p.thickness * 0.5 * k / p.nz + lift << "\n";
      }
  out << "*ELEMENT, TYPE=C3D20R, ELSET=BODY\n";
  std::string pressed;
  int element = 0;
  for (int k = 0; k < p.nz; ++k)
    for (int j = 0; j < p.nt; ++j)
      for (int i = 0; i < p.ns; ++i) {
        out << ++element;
        for (int n = 0; n < 20; ++n)
          out << (n == 10 ? ",\n" : ", ")
              << nodes.at({2 * i + kOrder[n][0], 2 * j + kOrder[n][1], 2 * k + kOrder[n][2]});
        out << "\n";
        const bool loaded = p.pressed == '+' ? k == p.nz - 1 : j == p.nt - 1;
        if (loaded)
          pressed += std::to_string(element) + (p.pressed == '+' ? ", P2, " : ", P5, ") +
                     std::to_string(p.pressure) + "\n";
      }
  out << "*MATERIAL, NAME=M\n*ELASTIC\n" << p.young << ", " << p.poisson << "\n";
  if (modes > 0) out << "*DENSITY\n" << density << "\n";
  out << "*SOLID SECTION, ELSET=BODY, MATERIAL=M\n";
  if (p.held) out << "*BOUNDARY\n";
  for (const auto& [at, id] : nodes)
    for (int axis = 0; axis < 3; ++axis)
      if (p.held && p.held(0.5 * at[0] / p.ns, 0.5 * at[1] / p.nt, 0.5 * at[2] / p.nz, axis))
        out << id << ", " << axis + 1 << "\n";
  if (modes > 0)
    out << "*STEP\n*FREQUENCY\n" << modes << "\n*END STEP\n";
  else
    out << "*STEP\n*STATIC\n*DLOAD\n" << pressed << "*EL FILE\nS\n*END STEP\n";
  return nodes;
}

/// The six numbers of a node in the block STRESS of a result file: fields of twelve characters.
std::optional<Mat3> stressAt(const std::string& path, int node) {
  std::ifstream in(path);
  bool stress = false;
  for (std::string line; std::getline(in, line);) {
    if (line.rfind(" -4", 0) == 0) stress = line.find("STRESS") != std::string::npos;
    if (!stress || line.rfind(" -1", 0) != 0 || line.size() < 13 + 6 * 12 ||
        std::atoi(line.substr(3, 10).c_str()) != node)
      continue;
    double s[6];
    for (int i = 0; i < 6; ++i)
      s[i] = std::atof(line.substr(13 + 12 * static_cast<std::size_t>(i), 12).c_str());
    Mat3 sigma;
    sigma << s[0], s[3], s[5], s[3], s[1], s[4], s[5], s[4], s[2];
    return sigma;
  }
  return std::nullopt;
}

}  // namespace

bool runCalculix(const std::string& folder, const std::string& name) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
  posix_spawn_file_actions_addopen(&actions, 1, (name + ".log").c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
  posix_spawn_file_actions_adddup2(&actions, 1, 2);
  // One thread: what several add up in differs from run to run.
  std::vector<std::string> texts;
  for (char** entry = environ; *entry; ++entry)
    if (std::strncmp(*entry, "OMP_NUM_THREADS=", 16) != 0) texts.emplace_back(*entry);
  texts.emplace_back("OMP_NUM_THREADS=1");
  std::vector<char*> environment;
  for (std::string& text : texts) environment.push_back(text.data());
  environment.push_back(nullptr);
  std::string program = "ccx", option = "-i", job = name;
  char* const arguments[] = {program.data(), option.data(), job.data(), nullptr};
  pid_t child = 0;
  const bool started = posix_spawnp(&child, "ccx", &actions, nullptr, arguments, environment.data()) == 0;
  posix_spawn_file_actions_destroy(&actions);
  int status = 0;
  return started && waitpid(child, &status, 0) == child && WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

bool hasCalculix() {
  const char* path = std::getenv("PATH");
  std::istringstream folders(path ? path : "");
  for (std::string folder; std::getline(folders, folder, ':');)
    if (access((folder + "/ccx").c_str(), X_OK) == 0) return true;
  return false;
}

std::optional<Mat3> stressByCalculix(const BrickProblem& problem, double s, double t, double z,
                                     const std::string& folder, const std::string& name) {
  const std::string stem = folder + "/" + name;
  const Nodes nodes = writeInput(problem, stem + ".inp");
  if (!runCalculix(folder, name)) return std::nullopt;
  const auto half = [](double share, int count) { return static_cast<int>(std::lround(2 * share * count)); };
  return stressAt(stem + ".frd", nodes.at({half(s, problem.ns), half(t, problem.nt), half(z, problem.nz)}));
}

std::optional<std::vector<double>> frequenciesByCalculix(const BrickProblem& problem, double density,
                                                         int count, const std::string& folder,
                                                         const std::string& name) {
  const std::string stem = folder + "/" + name;
  writeInput(problem, stem + ".inp", density, count);
  if (!runCalculix(folder, name)) return std::nullopt;
  // A table of number, eigenvalue and frequency in radians and in cycles for each time, under a title in
  // spaced capitals.
  std::ifstream in(stem + ".dat");
  std::vector<double> found;
  for (std::string line; std::getline(in, line) && static_cast<int>(found.size()) < count;) {
    std::istringstream words(line);
    int number = 0;
    double eigenvalue = 0, radians = 0, cycles = 0;
    if (words >> number >> eigenvalue >> radians >> cycles && number == static_cast<int>(found.size()) + 1)
      found.push_back(cycles);
  }
  if (static_cast<int>(found.size()) < count) return std::nullopt;
  return found;
}

}  // namespace glenoid::truth
