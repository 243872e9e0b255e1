// relume devices: what there is to shade on, and whether it can be trusted.
#include <cstdio>
#include <iomanip>
#include <iostream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "cli/commands.h"
#include "gbuffer/error.h"
#include "gbuffer/printable.h"
#include "host/lobes.h"
#include "host/self_test.h"
#include "host/twin.h"

namespace relume {
namespace {

/// "passed", or what differed. GGX with Lambert stands for all: every shade runs its own programs through the same test.
std::string verdict_of(Device& device) {
  const Choice choice{DIFFUSE_lambert, find_lobe(false, "ggx")->number, FRESNEL_schlick, SHADOWING_smith, 0};
  try {
    const double difference = self_test(device, choice);
    if (difference == 0) return "passed, bit-identical to the twin";
    std::ostringstream verdict;
    verdict << "passed, within " << std::setprecision(2) << difference << " of the twin (" << self_test_tolerance
            << " is allowed where divide and square root are not correctly rounded)";
    return verdict.str();
  } catch (const Error& error) {
    return error.what();
  }
}

int devices(bool as_json) {
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  std::vector<std::unique_ptr<Device>> opened;
  for (const DeviceInfo& info : list_devices()) opened.push_back(open_device(std::to_string(info.index)));
  opened.push_back(open_twin());
  for (const auto& device : opened) {
    const DeviceInfo& d = device->info();
    all.push_back({{"index", d.index},
                   {"name", d.name},
                   {"platform", d.platform},
                   {"version", d.version},
                   {"driver", d.driver},
                   {"kind", d.is_gpu   ? "gpu"
                            : d.is_cpu ? "cpu"
                                       : "other"},
                   {"lanes", d.lanes},
                   {"correctly_rounded", d.correctly_rounded},
                   {"memory", d.memory},
                   {"self_test", verdict_of(*device)}});
  }
  if (as_json) {
    std::cout << all.dump(2) << "\n";
    return 0;
  }
  for (const auto& d : all) {
    const int index = d["index"];
    std::printf("%-3s %-4s %2d lanes  %s (%s, %s)\n                  self-test %s\n", index < 0 ? "-" : std::to_string(index).c_str(),
                d["kind"].get<std::string>().c_str(), d["lanes"].get<int>(), printable(d["name"].get<std::string>()).c_str(),
                printable(d["platform"].get<std::string>()).c_str(), printable(d["version"].get<std::string>()).c_str(),
                printable(d["self_test"].get<std::string>()).c_str());
  }
  return 0;
}

}  // namespace

void add_devices(CLI::App& command, Action& action) {
  const auto as_json = std::make_shared<bool>(false);
  command.add_flag("--json", *as_json, "for programs");
  command.footer("The first column is what --device takes; so is any part of a name. Example: relume devices");
  command.callback([as_json, &action] { action = [as_json] { return devices(*as_json); }; });
}

}  // namespace relume
