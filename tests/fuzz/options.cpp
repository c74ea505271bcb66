// The command line, its arguments separated by line ends.
#include "app/options.h"

#include <string>
#include <vector>

#include "app/failure.h"
#include "fuzz_input.h"

namespace {

std::vector<std::string> split(std::string_view text) {
  std::vector<std::string> out;
  while (!text.empty()) {
    const std::size_t end = text.find('\n');
    out.emplace_back(text.substr(0, end));
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  }
  return out;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::vector<std::string> words = split(ucvt::fuzz::as_text(data, size));
  std::vector<const char*> argv{"ucvt"};
  for (const std::string& word : words) {
    argv.push_back(word.c_str());
  }
  const int argc = static_cast<int>(argv.size());
  argv.push_back(nullptr);
  try {
    static_cast<void>(ucvt::parse_arguments(argc, argv.data()));
  } catch (const ucvt::Failure& failure) {
    if (failure.status() != ucvt::ExitStatus::Usage) {
      std::abort();
    }
  }
  return 0;
}
