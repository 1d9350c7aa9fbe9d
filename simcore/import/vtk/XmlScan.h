// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace glenoid {

/// Forward scanner over the tags of an XML text, just enough for VTK's files and for the head of a 3MF model: no
/// entities beyond the five of XML, no DTD, no check that tags close. Keeps no tree, so depth costs nothing.
class XmlScan {
 public:
  explicit XmlScan(std::string_view text) : m_text(text) {}

  struct Tag {
    std::string name;  ///< without namespace prefix; of a closing tag the name alone
    bool closing = false, empty = false;
    std::map<std::string, std::string, std::less<>> attributes;
    std::string attribute(std::string_view key, std::string otherwise = {}) const {
      const auto found = attributes.find(key);
      return found == attributes.end() ? otherwise : found->second;
    }
  };

  /// The next tag; comments, processing instructions and declarations are passed over. Nothing at the end or where
  /// a tag does not end.
  std::optional<Tag> next();

  /// Bytes from here up to the next "<"; stays there.
  std::string_view textHere() const;
  std::size_t position() const { return m_at; }
  bool broken() const { return m_broken; }  ///< a tag did not end

 private:
  bool skipPast(std::string_view mark);
  std::string_view m_text;
  std::size_t m_at = 0;
  bool m_broken = false;
};

}  // namespace glenoid
