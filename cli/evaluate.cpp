// relume evaluate: a CSV of cosines in, the same with BRDF values out, from the kernels that shade frames.
#include <cstdio>
#include <iostream>
#include <iterator>

#include "cli/commands.h"
#include "gbuffer/watched.h"
#include "host/evaluate.h"

namespace relume {
namespace {

struct EvaluateArguments {
  std::string brdf, device;
  std::vector<std::string> set;
};

int evaluate(const EvaluateArguments& a) {
  watched().input_used = true;
  const std::string table{std::istreambuf_iterator<char>(std::cin), {}};
  std::cout << evaluate_table(a.brdf, a.set, a.device, table);
  return std::cout.flush() ? 0 : 5;
}

}  // namespace

void add_evaluate(CLI::App& command, Action& action) {
  const auto a = std::make_shared<EvaluateArguments>();
  command.add_option("brdf", a->brdf, "a lobe (relume list brdfs); a name that both halves have is their sum")->required();
  command.add_option("--set", a->set, "PARAM=VALUE for all rows");
  command.add_option("--device", a->device, "as for shade; default: the best there is");
  command.footer(
      "stdin: CSV with a header; columns n_l, n_v, l_v (cosines), and any parameter by its name (or name.r, name.g, name.b). Other columns are "
      "kept.\n"
      "stdout: the same with f_r and reflectance = f_r n.l (or .r .g .b of each) appended, 9 digits.\n"
      "Example: printf 'n_l,n_v,l_v\\n0.7,0.8,0.9\\n' | relume evaluate ggx --set roughness=0.4");
  command.callback([a, &action] { action = [a] { return evaluate(*a); }; });
}

}  // namespace relume
