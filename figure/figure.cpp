// draw: gnuplot reads the script from one temporary file and writes the picture to another, so that neither waits for the other.
#include "figure/figure.h"

#include <spawn.h>
#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <memory>
#include <vector>

#include "gbuffer/error.h"
#include "gbuffer/printable.h"
#include "gbuffer/whole_file.h"

extern char** environ;

namespace relume {

// Okabe and Ito's colours.
const char* const figure_look =
    "set encoding utf8\n"
    "set linetype 1 lc rgb '#0072B2' lw 2 pt 7 ps 0.8\nset linetype 2 lc rgb '#D55E00' lw 2 pt 5 ps 0.8\n"
    "set linetype 3 lc rgb '#009E73' lw 2 pt 9 ps 1\nset linetype 4 lc rgb '#CC79A7' lw 2 pt 11 ps 1\n"
    "set linetype 5 lc rgb '#E69F00' lw 2 pt 13 ps 1\nset linetype 6 lc rgb '#56B4E9' lw 2 pt 4 ps 0.8\n"
    "set border 3\nset tics nomirror out\nset grid lc rgb '#dddddd' lt 1 lw 1\nset rmargin 6\nset key left top\n";

namespace {

using Scratch = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

Scratch scratch() {
  Scratch file(std::tmpfile(), &std::fclose);
  if (!file) throw Error(ErrorKind::output, "no temporary file for a figure (is TMPDIR full?)");
  return file;
}

std::string contents(std::FILE* file) {
  std::string text;
  std::rewind(file);
  for (std::array<char, 1 << 16> block; const std::size_t count = std::fread(block.data(), 1, block.size(), file);) text.append(block.data(), count);
  return text;
}

std::string first_line(const std::string& text) {
  const std::size_t begin = text.find_first_not_of(" \n\t^");
  return begin == std::string::npos ? std::string() : text.substr(begin, text.find('\n', begin) - begin);
}

/// What gnuplot writes for the script.
std::string run_gnuplot(const std::string& script, const std::string& who) {
  const Scratch in = scratch(), out = scratch(), complaints = scratch();
  std::fwrite(script.data(), 1, script.size(), in.get());
  std::rewind(in.get());
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, fileno(in.get()), 0);
  posix_spawn_file_actions_adddup2(&actions, fileno(out.get()), 1);
  posix_spawn_file_actions_adddup2(&actions, fileno(complaints.get()), 2);
  char program[] = "gnuplot";
  char* arguments[] = {program, nullptr};
  pid_t child = 0;
  const int failed = posix_spawnp(&child, program, &actions, nullptr, arguments, environ);
  posix_spawn_file_actions_destroy(&actions);
  int status = 0;
  if (failed != 0 || waitpid(child, &status, 0) != child || (WIFEXITED(status) && WEXITSTATUS(status) == 127))
    throw Error(ErrorKind::output, who + ": no figure: gnuplot is not here (the package gnuplot-nox has it)");
  std::string picture = contents(out.get());
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0 || picture.empty())
    throw Error(ErrorKind::output, who + ": gnuplot drew no figure: " + printable(first_line(contents(complaints.get()))));
  return picture;
}

}  // namespace

std::string terminal_for(const std::filesystem::path& file, const Figure& figure) {
  const std::string ending = file.extension().string(), text = std::string("font 'DejaVu Sans,12' ") + (figure.markup ? "" : "no") + "enhanced\n";
  const auto size = [&](double unit, const char* suffix) {
    return " size " + std::to_string(figure.width * unit) + suffix + "," + std::to_string(figure.height * unit) + suffix + " ";
  };
  if (ending == ".svg") return "set terminal svg" + size(1, "") + "background rgb 'white' " + text;
  if (ending == ".png") return "set terminal pngcairo" + size(1, "") + text;
  if (ending == ".pdf") return "set terminal pdfcairo" + size(1.0 / 96, "in") + text;  // CSS pixels, as SVG's are
  throw Error(ErrorKind::input, printable(file.string()) + ": a figure ends in .svg, .png or .pdf");
}

void draw(const Figure& figure, const std::filesystem::path& file, bool overwrite) {
  const std::string script = figure_look + figure.data + terminal_for(file, figure) + figure.commands + "\nunset output\n";
  WholeFile whole(file, overwrite);
  const std::string picture = run_gnuplot(script, printable(file.string()));
  whole.write(picture.data(), picture.size());
  whole.commit();
}

std::string quoted(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    if (c == '\n' || c == '\r') continue;
    if (c == '"' || c == '\\' || c == '`') escaped += '\\';
    escaped += c;
  }
  return '"' + escaped + '"';
}

}  // namespace relume
