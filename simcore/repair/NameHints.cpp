// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/repair/NameHints.h"

#include <array>
#include <cctype>
#include <utility>
#include <vector>

namespace glenoid {
namespace {

constexpr std::array<std::pair<const char*, double>, 24> kSizes{
    {{"humerus", 0.31},       {"scapula", 0.155},     {"clavicle", 0.145},    {"clavicula", 0.145}, {"labrum", 0.037},
     {"ligament", 0.035},     {"capsule", 0.055},     {"disc", 0.025},        {"supraspinatus", 0.14}, {"infraspinatus", 0.17},
     {"subscapularis", 0.16}, {"teres", 0.14},        {"deltoid", 0.18},      {"biceps", 0.3},      {"triceps", 0.28},
     {"trapezius", 0.4},      {"pectoralis", 0.25},   {"coracobrachialis", 0.18}, {"sternum", 0.18}, {"radius", 0.24},
     {"ulna", 0.26},          {"femur", 0.45},        {"tibia", 0.38},        {"bursa", 0.04}}};

std::string lower(const std::string& text) {
  std::string out = text;
  for (char& c : out) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return out;
}

std::vector<std::string> wordsOf(const std::string& name) {
  std::vector<std::string> words(1);
  for (const char c : lower(name)) {
    if (std::isalpha(static_cast<unsigned char>(c))) words.back() += c;
    else if (!words.back().empty()) words.emplace_back();
  }
  return words;
}

}  // namespace

double usualSize(const std::string& name) {
  const std::string text = lower(name);
  for (const auto& [word, size] : kSizes)
    if (text.find(word) != std::string::npos) return size;
  return 0;
}

BodySide sideInName(const std::string& name) {
  bool left = false, right = false;
  for (const std::string& word : wordsOf(name)) {
    left = left || word == "l" || word == "left" || word == "lt" || word == "sinister" || word == "sinistra";
    right = right || word == "r" || word == "right" || word == "rt" || word == "dexter" || word == "dextra";
  }
  return left == right ? (left ? BodySide::Both : BodySide::Unknown) : left ? BodySide::Left : BodySide::Right;
}

}  // namespace glenoid
