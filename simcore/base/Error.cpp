// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/base/Error.h"

namespace glenoid {

const char* faultName(Fault fault) {
  switch (fault) {
    case Fault::FileMissing: return "FileMissing";
    case Fault::FileUnreadable: return "FileUnreadable";
    case Fault::FileUnwritable: return "FileUnwritable";
    case Fault::FileEmpty: return "FileEmpty";
    case Fault::FileTruncated: return "FileTruncated";
    case Fault::FileTooLarge: return "FileTooLarge";
    case Fault::NotJson: return "NotJson";
    case Fault::TooDeep: return "TooDeep";
    case Fault::NewerSchema: return "NewerSchema";
    case Fault::SchemaMismatch: return "SchemaMismatch";
    case Fault::NotFinite: return "NotFinite";
    case Fault::OutOfRange: return "OutOfRange";
    case Fault::UnknownId: return "UnknownId";
    case Fault::DuplicateId: return "DuplicateId";
    case Fault::CyclicReference: return "CyclicReference";
    case Fault::BadReference: return "BadReference";
    case Fault::BadMesh: return "BadMesh";
    case Fault::BadElement: return "BadElement";
    case Fault::MeshNotClosed: return "MeshNotClosed";
    case Fault::BadIndex: return "BadIndex";
    case Fault::HashMismatch: return "HashMismatch";
    case Fault::UnknownFormat: return "UnknownFormat";
    case Fault::TooFewSprings: return "TooFewSprings";
    case Fault::BadNodes: return "BadNodes";
    case Fault::NothingNear: return "NothingNear";
    case Fault::Unusable: return "Unusable";
    case Fault::BadUsage: return "BadUsage";
    case Fault::NoGraphics: return "NoGraphics";
    case Fault::Cancelled: return "Cancelled";
    case Fault::TimedOut: return "TimedOut";
    case Fault::OutOfMemory: return "OutOfMemory";
    case Fault::ReaderStopped: return "ReaderStopped";
    case Fault::CheckFailed: return "CheckFailed";
    case Fault::Internal: return "Internal";
  }
  return "Unknown";
}

std::string toLogLine(const Error& error) {
  std::string line = faultName(error.fault);
  const Place& place = error.place;
  if (!place.file.empty()) line += " file=" + place.file;
  if (!place.pointer.empty()) line += " at=" + place.pointer;
  if (!place.part.empty()) line += " part=" + place.part;
  if (place.element) line += " element=" + std::to_string(*place.element);
  for (const std::string& argument : error.arguments) line += " [" + argument + "]";
  if (!error.detail.empty()) line += ": " + error.detail;
  return line;
}

}  // namespace glenoid
