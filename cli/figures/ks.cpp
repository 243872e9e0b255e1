// relume figure ks: the greatest coefficient of Phong's and Blinn's lobes against the exponent, from the kernels and from the formula.
#include "cli/figures/list.h"
#include "gbuffer/whole_file.h"
#include "lab/brdf.h"
#include "lab/greatest_ks.h"

namespace relume {

void figure_ks(CLI::App& command, Action& action) {
  struct Arguments {
    std::string output, csv, device = "twin";
    bool overwrite = false;
  };
  const auto a = std::make_shared<Arguments>();
  command.add_option("-o,--output", a->output, "the figure, .svg, .png or .pdf")->required();
  command.add_option("--csv", a->csv, "its numbers");
  command.add_flag("--overwrite", a->overwrite, "allow existing files to be replaced");
  command.add_option("--device", a->device, "as for shade; default: twin");
  command.footer("Example: relume figure ks -o ks.svg --csv ks.csv");
  command.callback([a, &action] {
    action = [a] {
      terminal_for(a->output, {});  // the ending, before the work
      const std::vector<GreatestKs> all = greatest_ks(lab_device(a->device));
      if (!a->csv.empty()) write_whole(a->csv, ks_csv(all), a->overwrite);
      draw(ks_figure(all), a->output, a->overwrite);
      return 0;
    };
  });
}

}  // namespace relume
