// relume: arguments to a subcommand, failures to one line on stderr and a documented exit code.
#include <unistd.h>
#include <algorithm>
#include <csignal>
#include <iostream>
#include <new>
#include <string>

#include "cli/commands.h"
#include "cli/supervised.h"
#include "gbuffer/error.h"
#include "gbuffer/printable.h"
#include "gbuffer/watched.h"
#include "gbuffer/whole_file.h"

namespace {

/// An interrupt at any moment leaves nothing half-written: outputs are temporaries until they are whole.
extern "C" void interrupted(int signal) {
  relume::remove_temporaries();
  relume::watched().finish(128 + signal);
  _exit(128 + signal);
}

void catch_signals() {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP})
    if (std::signal(signal, interrupted) == SIG_IGN && signal == SIGHUP) std::signal(signal, SIG_IGN);  // nohup
  std::signal(SIGXFSZ, SIG_IGN);  // a file-size limit is an error of write(), with a sentence
}

int complain(const std::string& message, int code) {
  std::string line;
  for (const char c : message) line += c == '\n' ? ' ' : c;
  std::cerr << "relume: " << relume::printable_sentence(line) << "\n";
  return code;
}

/// CLI11 says of a mistyped command only that one is required.
void check_command(const CLI::App& app, int argc, char** argv) {
  const std::string given = argc > 1 ? argv[1] : "";
  if (given.starts_with('-')) return;
  std::string names;
  for (const CLI::App* command : app.get_subcommands({})) {
    if (command->get_name() == given) return;
    names += (names.empty() ? "" : ", ") + command->get_name();
  }
  const std::string what = given.empty() ? "no command given" : "no command \"" + relume::printable(given) + '"';
  throw relume::Error(relume::ErrorKind::input, what + " (has: " + names + "; relume --help)");
}

/// What users type for a C++ name.
std::string command_name(std::string name) {
  std::replace(name.begin(), name.end(), '_', '-');
  return name;
}

int run(int argc, char** argv) {
  CLI::App app{"Relights stored G-buffers: normals, positions and materials from OpenEXR, new lights, OpenCL kernels, scene-linear OpenEXR out."};
  app.set_version_flag("--version", "relume " RELUME_VERSION);
  app.require_subcommand(1);
  relume::Action action;
#define RELUME_ADD_COMMAND(name, summary) relume::add_##name(*app.add_subcommand(command_name(#name), summary), action);
  RELUME_COMMANDS(RELUME_ADD_COMMAND)
  check_command(app, argc, argv);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& help) {
    return app.exit(help);
  } catch (const CLI::ParseError& error) {
    return complain(std::string(error.what()) + " (relume --help, relume COMMAND --help)", int(relume::ErrorKind::input));
  }
  return action();
}

/// Every failure in one line.
int run_or_complain(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const relume::Error& error) {
    return complain(error.what(), int(error.kind));
  } catch (const std::bad_alloc&) {
    return complain("not enough memory (--memory makes bands smaller)", int(relume::ErrorKind::memory));
  } catch (const std::exception& error) {
    return complain(std::string("a defect of ours: ") + error.what(), int(relume::ErrorKind::internal));
  }
}

}  // namespace

int main(int argc, char** argv) {
  catch_signals();
  return relume::supervised([&] { return run_or_complain(argc, argv); });
}
