// A file that appears whole or not at all.
//
// Bytes go to a temporary file beside the target, which `commit` flushes to the disk and renames;
// every step is checked. Without a commit nothing is left behind. "-" is standard output; it,
// devices and pipes are written directly, at the commit. Serves all outputs.
#pragma once

#include <string>
#include <string_view>

namespace ucvt {

class OutputFile {
 public:
  /// Opens the temporary file, or the device. Throws IoError when that is not possible.
  explicit OutputFile(const std::string& path);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;
  OutputFile(OutputFile&&) = delete;
  OutputFile& operator=(OutputFile&&) = delete;

  /// Appends bytes. Throws IoError when the disk is full.
  void write(std::string_view bytes);

  /// Makes the file appear, replacing an older one; to be called once. Throws IoError.
  void commit();

 private:
  void open_direct(const std::string& path);
  void open_temporary(const std::string& path);
  void flush();
  [[noreturn]] void fail(const char* what, int error) const;

  std::string target_;     // links resolved
  std::string temporary_;  // empty when written directly
  std::string buffer_;
  int descriptor_ = -1;
  bool direct_ = false;
};

}  // namespace ucvt
