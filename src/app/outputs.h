// Where results go: standard output and files.
//
// Everything that can be known about an output before the computation is found out before it.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "app/failure.h"

namespace ucvt {

/// Gives each closed standard stream a descriptor that refuses, so that no file opened later takes
/// its number and is written into by mistake.
void reserve_standard_streams();

/// Makes sure that every output can be made. Throws Failure that names the first that cannot.
void check_writable(const std::vector<std::string>& outputs);

/// Runs the work that writes one output, unless its path is empty. Throws Failure that names it.
template <typename Work>
void write_output(const std::string& path, const Work& work) {
  if (!path.empty()) {
    about_file(output_name(path), work);
  }
}

/// Whether an output takes standard output, where nothing else may go then.
inline bool takes_stdout(const std::vector<std::string>& outputs) {
  return std::find(outputs.begin(), outputs.end(), "-") != outputs.end();
}

/// Writes results to standard output. Throws Failure when it does not take them.
void print_results(const std::string& text);

/// Writes a text file, whole or not at all. Throws Failure.
void write_text(const std::string& path, const std::string& text);

}  // namespace ucvt
