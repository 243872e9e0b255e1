// relume figure NAME: pictures that compare one way of lighting with another, each from one command.
#include "cli/figures/list.h"

namespace relume {

void add_figure(CLI::App& command, Action& action) {
  command.require_subcommand(1);
  (void)action;
#define RELUME_ADD_FIGURE(name, summary) figure_##name(*command.add_subcommand(#name, summary), action);
  RELUME_FIGURES(RELUME_ADD_FIGURE)
#undef RELUME_ADD_FIGURE
}

}  // namespace relume
