// The exceptions of ucvt.
//
// Three kinds, told apart by what the caller can do: change the input, look at the file system, or
// report that the arithmetic gave up. Messages are one line, without the program's or the file's
// name: they say what is wrong, where, and after a semicolon what to do.
#pragma once

#include <stdexcept>

namespace ucvt {

/// The input is not acceptable: names the element, its value and a remedy.
struct InvalidInput : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A file could not be opened, read or written.
struct IoError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A computation on acceptable input did not reach the accuracy it must have.
struct NumericalError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A Monitor asked a computation to stop.
struct Cancelled : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace ucvt
