// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <Eigen/Core>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "simcore/base/Error.h"
#include "simcore/file/JsonValue.h"

namespace glenoid {

/// The text of a glTF: of a GLB its first chunk; empty where there is none.
std::string_view gltfText(std::string_view bytes, bool binary);

/// A glTF's document beside its bytes, for what the reader behind does not know: packed views, values that are not floats.
/// Nothing of a file is trusted: every index, length and count is held to what there is. Source: Khronos, glTF 2.0 specification.
class GltfFile {
 public:
  /// `bytes` must outlive it. `path`: where buffers of their own lie beside. Fails as parseJson does.
  static Result<GltfFile> open(std::string_view bytes, const std::string& path, bool binary);

  const JsonValue& json() const { return m_json; }
  std::string_view binaryChunk() const { return m_chunk; }

  /// The bytes of a view, unpacked where EXT_meshopt_compression packs them. Fails with BadMesh, BadIndex, FileTruncated and as
  /// readWholeFile does.
  Result<std::string_view> view(std::int64_t index);

  /// An accessor's numbers, a column for each of its elements: integers as they are or, where it says so, as shares of one;
  /// sparse values put in. Fails as view does.
  Result<Eigen::MatrixXd> values(std::int64_t accessor);

  Error bad(const std::string& what, const std::string& pointer = {}) const;

 private:
  Result<std::string_view> buffer(std::int64_t index);
  Result<std::string_view> cut(std::string_view whole, const JsonValue& from, const std::string& pointer) const;
  /// `count` elements of `rows` numbers each, written into the columns of `out` that `to` names (all where it is null).
  Result<Done> take(const JsonValue& source, int type, int rows, bool normalized, const Eigen::VectorXd* to, Eigen::MatrixXd& out, const std::string& pointer);

  std::string m_path;
  JsonValue m_json;
  std::string_view m_chunk;
  std::map<std::int64_t, std::string> m_buffers, m_views;  ///< loaded, unpacked
};

}  // namespace glenoid
