// write_plots: each plot's script goes into the folder, and gnuplot makes SVG and PNG of it there.
#include "bench/plots.h"

#include <system_error>

#include "bench/plot_scripts.h"
#include "figure/figure.h"
#include "gbuffer/error.h"
#include "gbuffer/whole_file.h"

namespace relume::bench {

std::vector<std::string> write_plots(const std::filesystem::path& folder, const Bench& bench, std::string& note) {
  std::error_code failed;
  std::filesystem::create_directories(folder, failed);
  if (failed) throw Error(ErrorKind::output, folder.string() + ": cannot be made (" + failed.message() + ")");
  std::vector<std::string> files;
  for (const Plot& plot : plots_of(bench)) {
    std::string script = figure_look + plot.figure.data;
    for (const char* ending : {".svg", ".png"}) {
      const std::string name = plot.name + ending;
      script += terminal_for(name, plot.figure) + "set output '" + name + "'\n" + plot.figure.commands + "\nunset output\n";
    }
    write_whole(folder / (plot.name + ".gnuplot"), script, true);
    try {
      for (const char* ending : {".svg", ".png"}) {
        draw(plot.figure, folder / (plot.name + ending), true);
        files.push_back(plot.name + ending);
      }
    } catch (const Error& error) {
      note = std::string(error.what()) + "; the measurements stand";
      return files;
    }
  }
  return files;
}

}  // namespace relume::bench
