// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace glenoid {

/// What can be wrong with something that came from outside. The user's sentence for each is made at the
/// top (editor/core/Sentences), so this list and that table grow together; a test compares them.
enum class Fault {
  FileMissing,        ///< no such file or folder
  FileUnreadable,     ///< exists, cannot be read (permission, is a folder)
  FileUnwritable,     ///< cannot be written (permission, disk full)
  FileEmpty,          ///< zero bytes
  FileTruncated,      ///< ends before its own header says
  FileTooLarge,       ///< beyond the limit that protects memory: arguments size, limit
  NotJson,            ///< arguments: line, column
  TooDeep,            ///< nesting beyond the limit
  NewerSchema,        ///< written by a newer version: arguments found, known
  SchemaMismatch,     ///< does not fit the JSON Schema: arguments: what
  NotFinite,          ///< NaN or infinity where a number must be
  OutOfRange,         ///< arguments: value, low, high
  UnknownId,          ///< refers to something that is not there: arguments: id, kind
  DuplicateId,        ///< arguments: id
  CyclicReference,    ///< arguments: id
  BadReference,       ///< a reference leaves its folder or has the wrong kind
  BadMesh,            ///< arguments: what
  BadElement,         ///< a tetrahedron without positive volume: arguments: volume
  MeshNotClosed,      ///< arguments: open edges
  BadIndex,           ///< an index outside its array: arguments: index, size
  HashMismatch,       ///< content is not what its name promises
  UnknownFormat,      ///< neither by ending nor by content a known format
  TooFewSprings,      ///< a coupling over a line or nothing: arguments: area in mm², radii of gyration in mm, larger first
  BadNodes,           ///< picked nodes that cannot hold a coupling: arguments: why (a word, see Sentences), two figures
  NothingNear,        ///< couplings by distance that find no surface: arguments: which, with their nearest distances
  Unusable,           ///< fits the schema, yet cannot be simulated: arguments: what
  BadUsage,           ///< command line: arguments: what
  NoGraphics,         ///< no OpenGL context could be made
  Cancelled,          ///< the user asked to stop
  TimedOut,           ///< took longer than its limit: arguments: seconds
  OutOfMemory,        ///< needed more memory than its limit: arguments: limit
  ReaderStopped,      ///< the process that reads a file of another program broke down over it
  CheckFailed,        ///< a check did not hold: arguments: what
  Internal,           ///< a bug of ours, reported rather than hidden
};
/// Number of faults above, for tables and tests.
inline constexpr int kFaultCount = static_cast<int>(Fault::Internal) + 1;

/// English word of a fault, for logs and tests.
const char* faultName(Fault fault);

/// Where it is wrong.
struct Place {
  std::string file;         ///< path as the user gave it, may be empty
  std::string pointer;      ///< JSON pointer inside the file, may be empty
  std::string part;         ///< id of the part, coupling or tool, may be empty
  std::optional<long> element;  ///< triangle, tetrahedron, vertex or line
};

/// What the sentence needs: names, numbers with units, in the order the Fault's comment gives.
using Arguments = std::vector<std::string>;

/// Why something could not be done.
struct Error {
  Fault fault = Fault::Internal;
  Place place;
  Arguments arguments;
  std::string detail;  ///< English, for the log only
};

/// One line of English for logs and test failures; not for users.
std::string toLogLine(const Error& error);

/// A value or the reason why there is none. Reading the wrong one is a bug (std::bad_variant_access).
template <class T>
class [[nodiscard]] Result {
 public:
  Result(T value) : m_content(std::in_place_index<0>, std::move(value)) {}
  Result(Error error) : m_content(std::in_place_index<1>, std::move(error)) {}
  bool ok() const { return m_content.index() == 0; }
  explicit operator bool() const { return ok(); }
  T& value() & { return std::get<0>(m_content); }
  const T& value() const& { return std::get<0>(m_content); }
  T value() && { return std::get<0>(std::move(m_content)); }  ///< by value: a loop over it must not dangle
  T& operator*() & { return value(); }
  const T& operator*() const& { return value(); }
  T* operator->() { return &value(); }
  const T* operator->() const { return &value(); }
  Error& error() { return std::get<1>(m_content); }
  const Error& error() const { return std::get<1>(m_content); }

 private:
  std::variant<T, Error> m_content;
};

/// For functions that answer nothing: Result<Done>.
struct Done {};

}  // namespace glenoid
