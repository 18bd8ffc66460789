#include <fmt/format.h>

#include <iostream>

#include "command.hpp"
#include "creepcontact/report/report.hpp"

namespace creepcontact::cli {

int report(const Command& self, const Arguments& arguments) {
  namespace po = boost::program_options;
  std::string output;
  CommandLine line(self);
  report::ReportOptions options;
  line.add_options()("output,o", po::value(&output)->value_name("FILE.html"),
                     "the report (default: report.html, in the directory of the run or study; with several, in the "
                     "working directory)")("pdf", po::bool_switch(&options.pdf),
                                           "write it as PDF, by Chromium: report.pdf, or the FILE.pdf of --output");
  if (!line.parse_several(arguments, "DIR, the output directory of a run or a study")) return 0;
  options.output = output;
  // Said by the name alone: nobody wants a page of this name.
  if (options.output.extension() == ".pdf") options.pdf = true;
  const report::WrittenReport written =
      report::write_report({line.positionals().begin(), line.positionals().end()}, options);
  std::cout << fmt::format("{} ({:.1f} MB)\n", written.file.string(), written.megabytes);
  for (const std::string& note : written.notes) std::cout << "note: " << note << '\n';
  return 0;
}

}  // namespace creepcontact::cli
