// SPDX-License-Identifier: Apache-2.0
// How the boundaries of the project report failure: a value, or an error that says what to do.
#pragma once

#include <string>
#include <tl/expected.hpp>
#include <utility>

namespace auslan {

enum class ErrorCode {
  kUsage,        ///< the command line or an argument was wrong
  kNotFound,     ///< a file, entry or device is not there
  kUnreadable,   ///< it is there but cannot be opened or read
  kMalformed,    ///< it was read and breaks its format
  kLimit,        ///< it would need more time or memory than the stated bound
  kUnwritable,   ///< the output cannot be created, written or synced
  kUnsupported,  ///< well formed, but something this program cannot do
};

/// A failure at a boundary. `message` is one sentence for a person, naming what to do next; `place` is file:line, a
/// byte offset or empty.
struct Error {
  ErrorCode code = ErrorCode::kMalformed;
  std::string message;
  std::string place;
};

/// "place: message", or the message alone.
inline std::string to_string(const Error& error) {
  return error.place.empty() ? error.message : error.place + ": " + error.message;
}

template <typename T>
using Result = tl::expected<T, Error>;

inline tl::unexpected<Error> fail(ErrorCode code, std::string message, std::string place = {}) {
  return tl::unexpected<Error>(Error{code, std::move(message), std::move(place)});
}

}  // namespace auslan
