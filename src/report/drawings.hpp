#pragma once
/// Figures and still pictures as parts of a page.

#include <string>
#include <vector>

#include "creepcontact/platform/private_directory.hpp"
#include "creepcontact/plot/figure.hpp"
#include "html.hpp"
#include "run_data.hpp"

namespace creepcontact::report {

/// Draws for one report in a directory of its own. What is missing on the machine is noted once.
class Drawings {
 public:
  /// Adds a figure, or nothing if there is no gnuplot.
  void add(const plot::Figure& figure, const std::string& alternative, Html& page);
  void add(const io::RecordedPlot& plot, Html& page);

  /// A PNG file as the source of an image, and what it shows.
  struct Still {
    std::string url, title;
    bool on_contact = false;
  };
  /// The mesh of every body; none if there is no VTK.
  std::vector<Still> meshes(const RunData& run);
  /// Von Mises stress at the start and the end, contact pressure at the end; none if there is no VTK.
  std::vector<Still> fields(const RunData& run);

  const std::vector<std::string>& notes() const { return notes_; }

 private:
  std::vector<Still> stills(const RunData& run, const std::vector<struct Picture>& pictures);
  void note(const std::string& sentence);

  platform::PrivateDirectory directory_;
  std::size_t n_drawn_ = 0;
  std::vector<std::string> notes_;
};

}  // namespace creepcontact::report
