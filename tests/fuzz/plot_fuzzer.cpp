/// Results that `plot` and `study` read: history.csv, steps.csv and summary.json, and the scripts drawn from them.

#include <algorithm>
#include <string>

#include "creepcontact/base/log.hpp"
#include "creepcontact/plot/run_plots.hpp"
#include "fuzz_target.hpp"

namespace creepcontact {
namespace {

/// Texts from the files must stay texts in the script, which gnuplot executes.
void require_closed_quotes(std::string_view script) {
  while (!script.empty()) {
    const std::string_view line = script.substr(0, script.find('\n'));
    fuzz::require(std::ranges::count(line, '\'') % 2 == 0, "quotes are closed in every line of a script");
    script.remove_prefix(std::min(line.size() + 1, script.size()));
  }
}

void draw(const plot::RunTables& run, const plot::PlotOptions& options) {
  fuzz::may_refuse([&] {
    for (const plot::NamedFigure& one : plot::run_figures(run, options)) {
      require_closed_quotes(plot::gnuplot_script(one.figure, one.name));
      plot::gnuplot_data(one.figure);
    }
  });
}

}  // namespace
}  // namespace creepcontact

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace creepcontact;
  log::set_level(log::Level::off);
  const auto parts = fuzz::parts_of(fuzz::text_of(data, size), "\n---\n", 3);
  plot::RunTables run{"out", {}, {}, {}};
  fuzz::may_refuse([&] {
    io::parse_summary(parts[2]);
    run.heading = io::parse_summary_heading(parts[2], "summary.json");
  });
  fuzz::may_refuse([&] { run.steps = io::parse_csv_table(parts[1], "steps.csv", io::UnendedRow::is_left_out); });
  fuzz::may_refuse([&] {
    run.history = io::parse_csv_table(parts[0], "history.csv", io::UnendedRow::is_left_out);
    for (const std::vector<double>& column : run.history.columns)
      fuzz::require(column.size() == run.history.rows(), "columns are of one length");
    draw(run, {});
    draw(run, {.log_time = true});
    draw(run, {.log_time = false, .probes = {run.history.names.back()}});
  });
  return 0;
}
