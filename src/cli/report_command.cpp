#include <fmt/format.h>

#include <iostream>

#include "command.hpp"
#include "creepcontact/report/report.hpp"

namespace creepcontact::cli {

int report(const Command& self, const Arguments& arguments) {
  namespace po = boost::program_options;
  std::string output;
  CommandLine line(self);
  line.add_options()("output,o", po::value(&output)->value_name("FILE.html"),
                     "the report (default: report.html, in the directory of the run; with several runs, in the working "
                     "directory)");
  if (!line.parse_several(arguments, "DIR, the output directory of a run")) return 0;
  report::ReportOptions options;
  options.output = output;
  const report::WrittenReport written =
      report::write_report({line.positionals().begin(), line.positionals().end()}, options);
  std::cout << fmt::format("{} ({:.1f} MB)\n", written.file.string(), written.megabytes);
  for (const std::string& note : written.notes) std::cout << "note: " << note << '\n';
  return 0;
}

}  // namespace creepcontact::cli
