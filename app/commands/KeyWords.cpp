// SPDX-License-Identifier: GPL-3.0-or-later
#include <cctype>

#include "app/commands/TableText.h"

namespace glenoid {
namespace {

struct Unit {
  const char* ending;  ///< of a key
  const char* words;
};
/// Longer endings first.
constexpr Unit kUnits[] = {{"NsPerM", ", N·s/m"}, {"NPerM", ", N/m"}, {"MPerS", ", m/s"}, {"MiB", ", MiB"}, {"Ms", ", ms"}, {"Mm", ", mm"},
                           {"MJ", ", mJ"}, {"Hz", ", Hz"}, {"Kg", ", kg"}, {"N", ", N"}, {"S", ", s"}};

bool endsWith(const std::string& word, const std::string& ending) {
  return word.size() > ending.size() && word.compare(word.size() - ending.size(), ending.size(), ending) == 0;
}

}  // namespace

std::string keyWords(const std::string& key) {
  std::string stem = key, unit;
  for (const Unit& known : kUnits)
    if (endsWith(key, known.ending)) {
      stem.resize(key.size() - std::string(known.ending).size());
      unit = known.words;
      break;
    }
  std::string words;
  for (std::size_t i = 0; i < stem.size(); ++i) {
    const char c = stem[i];
    if (std::isupper(static_cast<unsigned char>(c)) && i > 0) words += ' ';
    words += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  return words + unit;
}

}  // namespace glenoid
