#include "gnuplot_process.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <utility>
#include <vector>

#include "creepcontact/base/error.hpp"
#include "creepcontact/base/files.hpp"
#include "creepcontact/platform/child_process.hpp"
#include "creepcontact/platform/private_directory.hpp"
#include "creepcontact/platform/replace_file.hpp"

namespace creepcontact::plot {
namespace {

std::string without_blank_ends(const std::string& text) {
  const std::size_t begin = text.find_first_not_of(" \n"), end = text.find_last_not_of(" \n");
  return begin == std::string::npos ? "it gave no message" : text.substr(begin, end - begin + 1);
}

/// Runs gnuplot in `directory`, without a shell, without settings in files and without those of the environment that
/// name files.
void run_gnuplot(const std::filesystem::path& directory, const std::vector<std::string>& arguments) {
  const std::filesystem::path program = platform::find_on_path("gnuplot");
  if (program.empty())
    throw ConfigError(
        "pictures are drawn by gnuplot, which was not found on the PATH; install it (Debian: apt-get "
        "install gnuplot-nox)");
  std::vector<std::string> words;
  for (const char* variable : {"GNUTERM", "GNUPLOT_LIB", "GNUPLOT_DRIVER_DIR", "GNUPLOT_PS_DIR", "FIT_SCRIPT"}) {
    words.emplace_back("-u");
    words.emplace_back(variable);
  }
  words.push_back(program.string());
  words.emplace_back("--default-settings");
  words.insert(words.end(), arguments.begin(), arguments.end());
  platform::Pipe pipe;
  platform::ChildProcess gnuplot(
      {.program = "/usr/bin/env",
       .arguments = words,
       .descriptors = {{pipe.writing_end(), STDOUT_FILENO}, {pipe.writing_end(), STDERR_FILENO}},
       .directory = directory});
  pipe.close_writing_end();
  const std::string messages = platform::read_to_end(pipe);
  if (gnuplot.wait() != 0) throw Error(fmt::format("gnuplot failed: {}", without_blank_ends(messages)), 4);
}

void write(const GnuplotFiles& files, const std::filesystem::path& directory) {
  if (!files.data.empty()) platform::replace_file(directory / (files.stem + ".dat"), files.data);
  platform::replace_file(directory / (files.stem + ".gp"), files.script);
}

}  // namespace

GnuplotDrawing::GnuplotDrawing(GnuplotFiles files, std::filesystem::path directory)
    : files_(std::move(files)), directory_(std::move(directory)) {
  write(files_, directory_);
}

void GnuplotDrawing::draw(PictureFormat format) const {
  const platform::PrivateDirectory place;
  write(files_, place.path());
  const bool is_png = format == PictureFormat::png;
  const std::string picture = files_.stem + (is_png ? ".png" : ".svg");
  std::vector<std::string> arguments{files_.stem + ".gp"};
  if (is_png) arguments = {"-e", "format='png'", files_.stem + ".gp"};
  run_gnuplot(place.path(), arguments);
  platform::replace_file(directory_ / picture, read_file(place.path() / picture).bytes);
}

}  // namespace creepcontact::plot
