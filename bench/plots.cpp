// write_plots: each plot's script goes into the folder, and gnuplot makes SVG and PNG of it there.
#include "bench/plots.h"

#include <spawn.h>
#include <sys/wait.h>

#include <system_error>

#include "bench/plot_scripts.h"
#include "gbuffer/error.h"
#include "gbuffer/whole_file.h"

extern char** environ;

namespace relume::bench {
namespace {

/// Okabe and Ito's colours, which the colour-blind tell apart too.
constexpr const char* look =
    "set encoding utf8\n"
    "set linetype 1 lc rgb '#0072B2' lw 2 pt 7 ps 0.8\nset linetype 2 lc rgb '#D55E00' lw 2 pt 5 ps 0.8\nset linetype 3 lc rgb '#009E73' lw 2 pt 9 "
    "ps 1\n"
    "set linetype 4 lc rgb '#CC79A7' lw 2 pt 11 ps 1\nset linetype 5 lc rgb '#E69F00' lw 2 pt 13 ps 1\nset linetype 6 lc rgb '#56B4E9' lw 2 pt 4 ps "
    "0.8\n"
    "set border 3\nset tics nomirror out\nset grid lc rgb '#dddddd' lt 1 lw 1\nset rmargin 6\nset key left top\n";

/// Whether gnuplot ran and was content. `folder` becomes its working directory.
bool run_gnuplot(const std::filesystem::path& folder, const std::string& script) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
  std::string program = "gnuplot", argument = script;
  char* arguments[] = {program.data(), argument.data(), nullptr};
  pid_t child = 0;
  const int failed = posix_spawnp(&child, "gnuplot", &actions, nullptr, arguments, environ);
  posix_spawn_file_actions_destroy(&actions);
  int status = 0;
  return failed == 0 && waitpid(child, &status, 0) == child && WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

std::string terminal(const char* type, const Plot& plot) {
  const std::string size = std::to_string(plot.width) + "," + std::to_string(plot.height);
  return std::string("set terminal ") + type + " size " + size + " font 'DejaVu Sans,12'" + (std::string(type) == "svg" ? "" : " noenhanced") +
         "\nset output '" + plot.name + (std::string(type) == "svg" ? ".svg" : ".png") + "'\n";
}

void write_text(const std::filesystem::path& file, const std::string& text) {
  WholeFile whole(file, true);
  whole.write(text.data(), text.size());
  whole.commit();
}

}  // namespace

std::vector<std::string> write_plots(const std::filesystem::path& folder, const Bench& bench, std::string& note) {
  std::error_code failed;
  std::filesystem::create_directories(folder, failed);
  if (failed) throw Error(ErrorKind::output, folder.string() + ": cannot be made (" + failed.message() + ")");
  std::vector<std::string> files;
  for (const Plot& plot : plots_of(bench)) {
    const std::string script = plot.name + ".gnuplot";
    write_text(folder / script,
               look + plot.data + terminal("svg", plot) + plot.commands + "\n" + terminal("pngcairo", plot) + plot.commands + "\nunset output\n");
    if (!run_gnuplot(folder, script)) {
      note =
          "no plots: gnuplot is not here, or failed on " + (folder / script).string() + " (the package gnuplot-nox has it; the measurements stand)";
      return files;
    }
    files.insert(files.end(), {plot.name + ".svg", plot.name + ".png"});
  }
  return files;
}

}  // namespace relume::bench
