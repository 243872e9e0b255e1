// relume tabulate: a BRDF of the kernels as a file in MERL's format, for other tools.
#include <algorithm>
#include <cstdio>

#include "cli/commands.h"
#include "gbuffer/error.h"
#include "gbuffer/printable.h"
#include "lab/tabulate.h"

namespace relume {
namespace {

struct TabulateArguments {
  std::string brdf, output, device;
  std::vector<std::string> set;
  bool overwrite = false;
};

bool claims_reciprocity(const Material& material) {
  return std::ranges::all_of(std::array{true, false}, [&](bool diffuse) {
    const Lobe* lobe = find_lobe(diffuse, diffuse ? material.diffuse : material.specular);
    return !lobe || std::ranges::find(lobe->claims, "reciprocal") != lobe->claims.end();
  });
}

int run_tabulate(const TabulateArguments& a) {
  if (!a.overwrite && std::filesystem::exists(a.output)) throw Error(ErrorKind::output, printable(a.output) + ": exists (--overwrite replaces it)");
  const Brdf brdf(a.brdf, a.set, lab_device(a.device));
  if (!claims_reciprocity(brdf.material()))
    std::fprintf(stderr, "relume: %s is not reciprocal: who reads the table gets the mean of both orders of light and view, or either\n",
                 printable(a.brdf).c_str());
  write_merl(tabulate(brdf), a.output, a.overwrite);
  return 0;
}

}  // namespace

void add_tabulate(CLI::App& command, Action& action) {
  const auto a = std::make_shared<TabulateArguments>();
  command.add_option("brdf", a->brdf, "a lobe, a pair DIFFUSE+SPECULAR (relume list brdfs), or a table")->required();
  command.add_option("--set", a->set, "PARAM=VALUE");
  command.add_option("-o,--output", a->output, "the table, 90 x 90 x 180 in MERL's format (35 MB)")->required();
  command.add_flag("--overwrite", a->overwrite, "replace an existing file");
  command.add_option("--device", a->device, "as for shade; default: the best there is");
  command.footer("Example: relume tabulate lambert+ggx --set alpha=0.3 -o ggx.binary");
  command.callback([a, &action] { action = [a] { return run_tabulate(*a); }; });
}

}  // namespace relume
