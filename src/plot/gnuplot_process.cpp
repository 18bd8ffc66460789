#include "gnuplot_process.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include "creepcontact/base/error.hpp"
#include "creepcontact/platform/child_process.hpp"

namespace creepcontact::plot {
namespace {

std::string without_blank_ends(const std::string& text) {
  const std::size_t begin = text.find_first_not_of(" \n"), end = text.find_last_not_of(" \n");
  return begin == std::string::npos ? "it gave no message" : text.substr(begin, end - begin + 1);
}

}  // namespace

void run_gnuplot(const std::filesystem::path& directory, const std::vector<std::string>& arguments) {
  // env changes the directory and searches the PATH, then becomes gnuplot.
  std::vector<std::string> words{"--chdir=" + directory.string(), "gnuplot", "--default-settings"};
  words.insert(words.end(), arguments.begin(), arguments.end());
  platform::Pipe pipe;
  platform::ChildProcess gnuplot(
      {"/usr/bin/env", words, {{pipe.writing_end(), STDOUT_FILENO}, {pipe.writing_end(), STDERR_FILENO}}});
  pipe.close_writing_end();
  const std::string messages = platform::read_to_end(pipe);
  const int status = gnuplot.wait();
  constexpr int not_found = 127;
  if (status == not_found)
    throw ConfigError(
        "pictures are drawn by gnuplot, which was not found on the PATH; install it (Debian: apt-get "
        "install gnuplot-nox)");
  if (status != 0)
    throw Error(fmt::format("gnuplot failed in '{}': {}", directory.string(), without_blank_ends(messages)), 4);
}

}  // namespace creepcontact::plot
