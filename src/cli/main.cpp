/// creepcontact: creep of bodies in contact.

#include <fmt/format.h>
#include <unistd.h>

#include <cstdlib>
#include <cstring>
#include <exception>
#include <filesystem>
#include <iostream>
#include <new>
#include <sstream>
#include <system_error>

#include "command.hpp"
#include "creepcontact/base/error.hpp"
#include "creepcontact/base/suggestion.hpp"
#include "creepcontact/cli/processes.hpp"
#include "creepcontact/linalg/blas_library.hpp"
#include "creepcontact/platform/interrupt.hpp"
#include "creepcontact/platform/library_settings.hpp"
#include "creepcontact/platform/memory.hpp"
#include "standard_output.hpp"

namespace creepcontact::cli {
namespace {

const std::vector<Command>& commands() {
  static const std::vector<Command> all{
      {"run", "CONFIG.toml [options]", "Runs the analysis that a configuration describes.", run},
      {"heat", "CONFIG.toml [options]", "Computes the temperatures of a configuration alone, without its mechanics.",
       heat_alone},
      {"check", "CONFIG.toml [options]", "Checks a configuration and its mesh without running the analysis.", check},
      {"study", "STUDY.toml [options]", "Runs a configuration with many different settings and compares the results.",
       study},
      {"plot", "DIR... [options]",
       "Plots the probes and the time steps of a run, or the probes of several, as SVG and PNG (needs gnuplot).", plot},
      {"report", "DIR... [options]",
       "Writes a report on a run, or on several in comparison, as one HTML file that needs no network.", report},
      {"picture", "DIR [options]", "Draws a field of a run as a PNG picture (needs VTK for Python).", picture},
      {"faces", "FILE [options]",
       "Lists the faces of a CAD model or a mesh and which of them are next to each other; proposes contacts.", faces},
      {"new", "DIR --template NAME", "Writes a commented configuration and its geometry to begin with.", new_model,
       "`creepcontact list templates` shows the templates.\n"},
      {"import", "DECK.inp [options]", "Makes a configuration and its mesh of a deck of CalculiX or Abaqus.", import},
      {"fit", "DATA.csv --law NAME [options]",
       "Fits a creep law to measured creep curves, relaxation tests, times to rupture or creep rates.", fit,
       "DATA.csv has the columns time, stress, strain and, if need be, temperature, test, kind, rate, rupture_time, "
       "with\n"
       "units in the header: time [h], stress [MPa], strain [%].\n"},
      {"material", "NAME [options]",
       "Compares the data that the material library has of a steel: creep, relaxation, rupture.", material},
      {"list", "(keys|study-keys|integrators|laws|elements|quantities|templates|materials) [KEY|WORD] [options]",
       "Lists the keys and names that a configuration or a study may use.", list,
       "KEY selects the keys to show. It is one of:\n"
       "  a path (time, contacts[0].gap): this key and all keys below it;\n"
       "  a table as written in the file ('[time]'; '[]' for the keys above all tables);\n"
       "  a word (tolerance, cvode_bdf): the keys with this word in their names or allowed values,\n"
       "  or else in their descriptions.\n"
       "WORD selects materials of the library by a part of their names: P91, 1.4903.\n"},
  };
  return all;
}

std::string help() {
  std::string text =
      fmt::format("{} COMMAND [arguments]\n\nCreep of bodies in contact.\n\nCommands\n", Processes::program());
  for (const Command& command : commands()) text += fmt::format("  {:<9}{}\n", command.name, command.summary);
  text +=
      "\nOptions\n  --help     show this help; after a command: help on it\n  --version  show the version; with "
      "--verbose also the libraries that decide the speed\n";
  return text;
}

int dispatch(const Arguments& arguments) {
  const std::string first = arguments.empty() ? "" : arguments.front();
  if (!Processes::share(first) && !Processes::is_first()) return 0;
  if (first == "--help" || first == "-h") {
    std::cout << help();
    return 0;
  }
  if (first == "--version") {
    const bool is_verbose = arguments.size() == 2 && arguments.back() == "--verbose";
    if (arguments.size() > 1 && !is_verbose)
      throw ConfigError(fmt::format("--version takes no '{}'; allowed: --verbose", arguments[1]));
    std::cout << Processes::program() << " " CREEPCONTACT_VERSION "\n";
    if (is_verbose) {
      const linalg::BlasLibrary library = linalg::blas_library();
      std::cout << "BLAS:   " << library.blas << "\nLAPACK: " << library.lapack << '\n';
      if (!library.warning.empty()) std::cout << library.warning << '\n';
    }
    return 0;
  }
  if (first.empty()) throw ConfigError(fmt::format("no command; see {} --help", Processes::program()));
  std::vector<std::string> names;
  for (const Command& command : commands()) {
    if (command.name == first) return command.execute(command, Arguments(arguments.begin() + 1, arguments.end()));
    names.push_back(command.name);
  }
  const bool is_option = first.front() == '-';
  if (is_option) names = {"--help", "--version"};
  const std::string question = did_you_mean(first, names);
  throw ConfigError(fmt::format("unknown {} '{}'{} See {} --help", is_option ? "option" : "command", first,
                                question.empty() ? "." : question, Processes::program()));
}

/// Every line is an error of its own (a configuration may have many).
void print_error(const std::string& message) {
  std::istringstream lines(message);
  for (std::string line; std::getline(lines, line);) std::cerr << "error: " << line << '\n';
}

/// Errors have their exit status; anything unforeseen counts as a failure of the solver.
Ending guarded(const Arguments& arguments) {
  try {
    return {dispatch(arguments)};
  } catch (const Error& error) {
    return {error.exit_status(), error.what()};
  } catch (const std::bad_alloc&) {
    return {SolverError::status, platform::out_of_memory};
  } catch (const std::filesystem::filesystem_error& error) {
    return {ConfigError::status, fmt::format("'{}': {}", error.path1().string(), error.code().message())};
  } catch (const std::system_error& error) {
    return {SolverError::status,
            fmt::format("the system refuses a resource: {}; limits (ulimit -a) on memory, threads or open files may be "
                        "too low",
                        error.code().message())};
  } catch (const std::exception& error) {
    return {SolverError::status, error.what()};
  }
}

/// Where an exception cannot be caught: in threads, and in functions that libraries call.
[[noreturn]] void give_up() {
  try {
    if (const std::exception_ptr error = std::current_exception()) std::rethrow_exception(error);
  } catch (const std::bad_alloc&) {
    print_error(platform::out_of_memory);
  } catch (const std::exception& error) {
    print_error(error.what());
  } catch (...) {
    print_error("the program failed for an unknown reason");
  }
  ::_exit(SolverError::status);
}

}  // namespace
}  // namespace creepcontact::cli

int main(int argc, char** argv) {
  using namespace creepcontact;
  platform::end_at_signals();
  if (argc > 1 && argv[1][0] != '-') platform::set_libraries(argv);  // what needs no threads does not start twice
  std::set_terminate(cli::give_up);
  cli::Processes processes(argc, argv);
  cli::StandardOutput output;
  const auto [status, message] = processes.end(cli::guarded(cli::Arguments(argv + 1, argv + argc)));
  if (!message.empty() && cli::Processes::is_first()) cli::print_error(message);
  const int lost = output.finish();
  if (lost == 0) return status;
  cli::print_error(
      fmt::format("cannot write to standard output: {}; the result files are not affected", std::strerror(lost)));
  return status != 0 ? status : SolverError::status;
}
