// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/import/vtk/XmlScan.h"

#include <array>
#include <utility>

#include "simcore/file/ByteReader.h"

namespace glenoid {
namespace {

bool ends(char c) { return ByteReader::isSpace(c) || c == '=' || c == '>' || c == '/'; }

std::string withoutEntities(std::string_view text) {
  static constexpr std::array<std::pair<std::string_view, char>, 5> kEntities{
      {{"&lt;", '<'}, {"&gt;", '>'}, {"&amp;", '&'}, {"&quot;", '"'}, {"&apos;", '\''}}};
  std::string out;
  for (std::size_t i = 0; i < text.size();) {
    bool found = false;
    for (const auto& [word, letter] : kEntities)
      if (text.substr(i, word.size()) == word) {
        out += letter;
        i += word.size();
        found = true;
        break;
      }
    if (!found) out += text[i++];
  }
  return out;
}

}  // namespace

bool XmlScan::skipPast(std::string_view mark) {
  const std::size_t at = m_text.find(mark, m_at);
  if (at == std::string_view::npos) {
    m_at = m_text.size();
    m_broken = true;
    return false;
  }
  m_at = at + mark.size();
  return true;
}

std::string_view XmlScan::textHere() const {
  const std::size_t end = m_text.find('<', m_at);
  return m_text.substr(m_at, end == std::string_view::npos ? end : end - m_at);
}

std::optional<XmlScan::Tag> XmlScan::next() {
  while (true) {
    m_at = m_text.find('<', m_at);
    if (m_at == std::string_view::npos) {
      m_at = m_text.size();
      return std::nullopt;
    }
    const std::string_view here = m_text.substr(m_at);
    if (here.substr(0, 4) == "<!--") {
      if (!skipPast("-->")) return std::nullopt;
    } else if (here.substr(0, 9) == "<![CDATA[") {
      if (!skipPast("]]>")) return std::nullopt;
    } else if (here.substr(0, 2) == "<?" || here.substr(0, 2) == "<!") {
      if (!skipPast(">")) return std::nullopt;
    } else {
      break;
    }
  }
  ++m_at;
  Tag tag;
  const auto cut = [&] {
    m_broken = true;
    m_at = m_text.size();
    return std::optional<Tag>();
  };
  const auto skipSpace = [&] {
    while (m_at < m_text.size() && ByteReader::isSpace(m_text[m_at])) ++m_at;
  };
  const auto word = [&] {
    const std::size_t begin = m_at;
    while (m_at < m_text.size() && !ends(m_text[m_at])) ++m_at;
    return m_text.substr(begin, m_at - begin);
  };
  if (m_at < m_text.size() && m_text[m_at] == '/') tag.closing = true, ++m_at;
  const std::string_view name = word();
  const std::size_t colon = name.rfind(':');
  tag.name = name.substr(colon == std::string_view::npos ? 0 : colon + 1);
  while (true) {
    skipSpace();
    if (m_at >= m_text.size()) return cut();
    if (m_text[m_at] == '>') {
      ++m_at;
      return tag;
    }
    if (m_text[m_at] == '/') {
      tag.empty = true;
      ++m_at;
      continue;
    }
    const std::string_view key = word();
    skipSpace();
    if (m_at >= m_text.size()) return cut();
    if (m_text[m_at] != '=') {
      if (key.empty()) ++m_at;  // a stray sign
      continue;
    }
    ++m_at;
    skipSpace();
    if (m_at >= m_text.size()) return cut();
    const char quote = m_text[m_at];
    if (quote != '"' && quote != '\'') continue;
    const std::size_t end = m_text.find(quote, m_at + 1);
    if (end == std::string_view::npos) return cut();
    tag.attributes.emplace(std::string(key), withoutEntities(m_text.substr(m_at + 1, end - m_at - 1)));
    m_at = end + 1;
  }
}

}  // namespace glenoid
