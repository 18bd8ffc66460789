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
  /// Adds a figure, or nothing if there is no gnuplot. Its title is the caption.
  void add(plot::Figure figure, const std::string& caption, Html& page);
  /// Over the time, the axis is logarithmic where a linear one would hide the beginning.
  void add(const io::RecordedPlot& plot, Html& page);

  /// A PNG file as the source of an image, and what it shows.
  struct Still {
    std::string url, title;
  };
  /// The bodies with their supports, loads and contacts, as the run has recorded them; none if there is no VTK.
  std::vector<Still> model(const RunData& run);
  /// The mesh of every body; none if there is no VTK.
  std::vector<Still> meshes(const RunData& run);
  /// The pictures that the configuration asks for; else von Mises stress at the start and the end, and contact pressure
  /// at the end. None if there is no VTK.
  std::vector<Still> fields(const RunData& run);
  /// One picture per run, of the same field at the end, with the same colours; none if there is no VTK.
  std::vector<Still> compared(const std::vector<RunData>& runs);

  const std::vector<std::string>& notes() const { return notes_; }

 private:
  std::vector<Still> stills(const RunData& run, const std::vector<struct Picture>& pictures);
  void note(const std::string& sentence);

  platform::PrivateDirectory directory_;
  std::size_t n_drawn_ = 0;
  std::vector<std::string> notes_;
};

}  // namespace creepcontact::report
