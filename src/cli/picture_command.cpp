#include <fmt/ranges.h>

#include <charconv>
#include <cmath>
#include <iostream>
#include <sstream>

#include "command.hpp"
#include "creepcontact/base/error.hpp"
#include "creepcontact/platform/replace_file.hpp"
#include "creepcontact/report/picture.hpp"

namespace creepcontact::cli {
namespace {

std::vector<std::string> separated(const std::string& text, char separator) {
  std::vector<std::string> words;
  std::istringstream stream(text);
  for (std::string word; std::getline(stream, word, separator);) words.push_back(word);
  return words;
}

template <typename Number>
std::optional<Number> number_of(const std::string& text) {
  Number value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

std::pair<double, double> range_of(const std::string& text) {
  const std::vector<std::string> words = separated(text, ',');
  if (words.size() == 2)
    if (const auto low = number_of<double>(words[0]), high = number_of<double>(words[1]);
        low && high && std::isfinite(*low) && std::isfinite(*high) && *low < *high)
      return {*low, *high};
  throw ConfigError(fmt::format("--range: '{}' is not a range; give two numbers, the smaller one first: 0,150", text));
}

void set_size(const std::string& text, report::Picture& picture) {
  constexpr int least = 200, most = 8000;
  const std::vector<std::string> words = separated(text, 'x');
  if (words.size() == 2)
    if (const auto width = number_of<int>(words[0]), height = number_of<int>(words[1]);
        width && height && std::min(*width, *height) >= least && std::max(*width, *height) <= most) {
      picture.width = *width;
      picture.height = *height;
      return;
    }
  throw ConfigError(
      fmt::format("--size: '{}' is not a size; give width x height in pixels, {} to {}: 1200x900", text, least, most));
}

}  // namespace

int picture(const Command& self, const Arguments& arguments) {
  namespace po = boost::program_options;
  report::Picture wanted;
  std::string bodies, range, size, output;
  double time = 0;
  CommandLine line(self);
  line.add_options()(
      "field,f", po::value(&wanted.field)->value_name("NAME"),
      "a quantity of the field files, such as von_mises (default), contact_pressure, stress_xx, or 'mesh'");
  line.add_options()("time,t", po::value(&time)->value_name("T"),
                     "the output time nearest to T is drawn (default: the last)");
  line.add_options()("warp,w", po::value(&wanted.warp)->value_name("FACTOR"),
                     "enlarged displacements (default: 0, none)");
  line.add_options()("body,b", po::value(&bodies)->value_name("a,b,..."), "draw only these bodies");
  line.add_options()("range,r", po::value(&range)->value_name("LOW,HIGH"),
                     "of the colours (default: that of the values drawn)");
  line.add_options()("view", po::value(&wanted.view)->value_name("VIEW"),
                     "direction from which it is seen: iso (default), x, -x, y, -y, z, -z");
  line.add_options()("size", po::value(&size)->value_name("WxH"), "pixels (default: 1200x900)");
  line.add_options()("output,o", po::value(&output)->value_name("FILE.png"),
                     "the picture (default: plots/FIELD.png, in the directory of the run)");
  if (!line.parse(arguments, "DIR, the output directory of a run")) return 0;
  if (line.has("time")) wanted.time = time;
  if (line.has("body")) wanted.bodies = separated(bodies, ',');
  if (line.has("range")) wanted.range = range_of(range);
  if (line.has("size")) set_size(size, wanted);
  const std::filesystem::path directory = line.positional();
  wanted.output = output.empty() ? directory / "plots" / (wanted.field + ".png") : std::filesystem::path(output);
  if (wanted.output.extension() != ".png")
    throw ConfigError(fmt::format("--output: '{}': pictures are PNG files; give a name that ends in .png", output));
  // Nothing is made before it is known that there is a run; a link is refused.
  if (output.empty() && std::filesystem::is_symlink(directory / "plots"))
    platform::make_inner_directory(directory / "plots");
  const report::DrawnPicture drawn = report::draw_pictures(directory, {wanted}).front();
  std::cout << drawn.file.string() << '\n';
  if (line.has("time") && std::abs(drawn.time - time) > 1e-6 * std::abs(time))
    std::cout << fmt::format("note: the nearest output time with fields is {:.6g}\n", drawn.time);
  return 0;
}

}  // namespace creepcontact::cli
