#include <fmt/format.h>

#include <filesystem>
#include <iostream>

#include "command.hpp"
#include "creepcontact/base/error.hpp"
#include "creepcontact/base/files.hpp"
#include "creepcontact/base/log.hpp"
#include "creepcontact/fit/fit.hpp"
#include "creepcontact/fit/report.hpp"
#include "creepcontact/platform/replace_file.hpp"

namespace creepcontact::cli {
namespace {

/// A number or an expression in T.
Function modulus_in(const std::string& text) {
  try {
    Function modulus = Function::expression(text, {"T"});
    if (modulus.is_constant()) modulus = modulus({});
    if (modulus.is_constant() && !(modulus({}) > 0)) throw std::invalid_argument("it is not positive");
    return modulus;
  } catch (const std::invalid_argument& error) {
    throw ConfigError(
        fmt::format("--young-modulus: '{}': {}; allowed: a number > 0, or an expression in T", text, error.what()));
  }
}

void require_writable(const std::filesystem::path& file) {
  if (path_is_directory(file)) throw ConfigError(fmt::format("--output: '{}' is a directory", file.string()));
  if (path_exists(file) && !read_file(file).bytes.starts_with(fit::block_heading))
    throw ConfigError(
        fmt::format("--output: '{}' exists and was not written by this command; choose another name", file.string()));
  const std::filesystem::path directory = file.parent_path().empty() ? "." : file.parent_path();
  if (const std::string reason = why_unwritable(directory); !reason.empty())
    throw ConfigError(fmt::format("--output: no files can be written in '{}': {}", directory.string(), reason));
}

}  // namespace

int fit(const Command& self, const Arguments& arguments) {
  namespace po = boost::program_options;
  using Words = std::vector<std::string>;
  fit::LawWishes wishes;
  fit::ReadOptions reading;
  fit::BlockOptions block;
  std::string output, modulus, thousands;
  double temperature = 0;
  CommandLine line(self);
  auto add = line.add_options();
  add("law,l", po::value(&wishes.law)->value_name("NAME"), "creep law; `creepcontact list laws` shows them");
  add("output,o", po::value(&output)->value_name("FILE.toml"),
      "write the material block to this file, and pictures to a directory next to it; without: print the block");
  add("set", po::value<Words>(&wishes.set)->value_name("key=value"),
      "hold a parameter of the law at a value; may be repeated");
  add("free", po::value<Words>(&wishes.free)->value_name("key"), "fit an optional parameter too; may be repeated");
  add("young-modulus", po::value(&modulus)->value_name("E"),
      "Young's modulus, a number or an expression in T, in the unit of the stress: the column strain is then the total "
      "strain; needed for relaxation tests");
  add("poisson-ratio", po::value(&block.poisson_ratio)->value_name("NU"), "for the material block (default: 0.3)");
  add("temperature", po::value(&temperature)->value_name("T"), "only the tests within 2 degrees of this temperature");
  add("thousands", po::value(&thousands)->value_name("SIGN"),
      "what separates thousands in the numbers of the data: '.', ',', ' ' or an apostrophe; the decimal sign is then "
      "the comma or the point that is left (default: nothing does)");
  add("material", po::value(&block.material)->value_name("NAME"), "name in the material block (default: fitted)");
  if (!line.parse(arguments, "DATA.csv")) return 0;
  if (wishes.law.empty()) throw ConfigError("fit needs --law NAME; see `creepcontact list laws`");
  if (line.has("young-modulus")) reading.young_modulus = block.young_modulus = modulus_in(modulus);
  if (line.has("thousands")) {
    const auto found = io::thousands_named(thousands);
    if (!found) throw ConfigError(fmt::format("--thousands: '{}'; allowed: '.', ',', ' ' or an apostrophe", thousands));
    reading.thousands = *found;
  }
  if (line.has("temperature")) reading.temperature = temperature;
  if (block.material.find_first_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_-") !=
          std::string::npos ||
      block.material.empty())
    throw ConfigError(fmt::format("--material: '{}'; allowed: letters, digits, '_' and '-'", block.material));
  if (!output.empty()) {
    require_writable(output);
    const std::filesystem::path file = output;
    require_writable(file.parent_path() / (file.stem().string() + "_scatter.toml"));
  }

  const fit::TestData data = fit::read_test_data(line.positional(), reading);
  for (const std::string& note : data.notes) log::warning("{}: {}", data.file, note);
  const fit::LawChoice choice = fit::choose_law(wishes, data);
  for (const std::string& note : choice.notes) log::warning("{}: {}", data.file, note);
  const fit::FitResult result = fit::fit_law(data, choice, reading.young_modulus);
  std::cout << fit::report(data, choice, result);
  for (const std::string& warning : result.warnings) log::warning("{}: {}", data.file, warning);
  if (const std::string reason = fit::why_useless(choice, result); !reason.empty())
    throw SolverError(fmt::format("{}: {}", data.file, reason));
  const std::string text = fit::material_block(data, choice, result, block);
  if (output.empty()) {
    std::cout << '\n' << text;
    return 0;
  }
  const std::filesystem::path file = output;
  if (file.has_parent_path()) std::filesystem::create_directories(file.parent_path());
  platform::replace_file(file, text);
  std::cout << '\n' << file.string() << '\n';
  const std::filesystem::path scatter = file.parent_path() / (file.stem().string() + "_scatter.toml");
  if (const std::string known = fit::scatter_block(data, choice, result); !known.empty()) {
    platform::replace_file(scatter, known);
    std::cout << scatter.string() << '\n';
  }
  const std::filesystem::path pictures = file.parent_path() / (file.stem().string() + "_plots");
  platform::make_inner_directory(pictures);
  for (std::filesystem::path picture : fit::draw_fit(data, result, reading.young_modulus, pictures)) {
    std::cout << picture.string() << '\n';
    std::cout << picture.replace_extension(".png").string() << '\n';
  }
  return 0;
}

}  // namespace creepcontact::cli
