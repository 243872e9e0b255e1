// Program text, build options, and the cache of binaries.
#include "host/program.h"

#include <algorithm>
#include <fstream>
#include <functional>
#include <iterator>
#include <optional>
#include <set>
#include <sstream>

#include "gbuffer/error.h"
#include "gbuffer/whole_file.h"
#include "host/driver_environment.h"
#include "host/kernel_files.h"
#include "host/lobes.h"
#include "host/opencl.h"

namespace relume {
namespace {

std::string_view text_of(const std::string& file) {
  for (const KernelFile& f : kernel_files())
    if (f.name == file) return f.text;
  throw Error(ErrorKind::internal, "no kernel file " + file + " in the program");
}

/// The names that stand in build options and file names for the numbers of a choice.
struct ChoiceNames {
  std::string diffuse = "none", specular = "none", fresnel, shadowing, distribution;

  explicit ChoiceNames(const Choice& c)
      : fresnel(fresnels()[std::size_t(c.fresnel)].name),
        shadowing(shadowings()[std::size_t(c.shadowing)].name),
        distribution(distributions()[std::size_t(c.distribution)].name) {
    if (c.diffuse != DIFFUSE_none) diffuse = diffuse_lobes()[std::size_t(c.diffuse - 1)].name;
    if (c.specular != SPECULAR_none) specular = specular_lobes()[std::size_t(c.specular - 1)].name;
  }
};

/// kernels/lobes.h for one program.
std::string chosen_lobes(const Choice& choice) {
  const ChoiceNames names(choice);
  std::string text;
  if (names.diffuse != "none") text += "#include \"kernels/diffuse/" + names.diffuse + ".h\"\n";
  if (names.specular != "none") text += "#include \"kernels/specular/" + names.specular + ".h\"\n";
  return text;
}

void join(const std::string& file, const Choice& choice, std::set<std::string>& seen, std::string& out) {
  if (!seen.insert(file).second) return;
  std::istringstream lines{file == "kernels/lobes.h" ? chosen_lobes(choice) : std::string(text_of(file))};
  out += "#line 1 \"" + file + "\"\n";
  int number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    const std::size_t quote = line.rfind("#include \"", 0) == 0 ? 10 : 0;
    const std::string included = quote ? line.substr(quote, line.find('"', quote) - quote) : "";
    if (included == "kernels/native.h" || included.empty()) {
      out += included.empty() ? line + "\n" : "\n";  // native.h is C++ only
    } else {
      join(included, choice, seen, out);
      out += "#line " + std::to_string(number + 1) + " \"" + file + "\"\n";
    }
  }
}

/// Everything that a binary depends on; kept in full in the cached file, so that two keys are never taken for each other.
std::string cache_key(const std::string& text, const std::string& options, const DeviceInfo& info) {
  return info.platform + "\n" + info.name + "\n" + info.version + "\n" + info.driver + "\n" + options + "\n" + text;
}

std::filesystem::path cache_file(const std::string& key) {
  std::ostringstream name;
  name << std::hex << std::hash<std::string>{}(key) << ".program";
  return cache_folder() / name.str();
}

std::uint64_t checksum(const std::string& bytes) { return std::hash<std::string>{}(bytes); }

/// The file is: sizes of key and binary, checksum of the binary, key, binary. Anything amiss is a miss: drivers abort on damaged binaries.
std::string cached_binary(const std::string& key) {
  std::ifstream in(cache_file(key), std::ios::binary);
  std::uint64_t header[3] = {};
  if (!in.read(reinterpret_cast<char*>(header), sizeof header) || header[0] != key.size()) return {};
  const std::string rest{std::istreambuf_iterator<char>(in), {}};
  if (rest.size() != header[0] + header[1] || rest.compare(0, key.size(), key) != 0) return {};
  std::string binary = rest.substr(key.size());
  return checksum(binary) == header[2] ? binary : std::string{};
}

void keep_binary(const std::string& key, const std::string& binary) try {
  const std::uint64_t header[3] = {key.size(), binary.size(), checksum(binary)};
  WholeFile file(cache_file(key), true);
  file.write(header, sizeof header);
  file.write(key.data(), key.size());
  file.write(binary.data(), binary.size());
  file.commit();
} catch (const Error&) {
  // A full or read-only disk costs the next run its build time, nothing else.
}

/// Nothing where the driver does not take the binary or finds no kernel in it: one of another build of the driver, or a driver that takes none.
std::optional<cl::Program> program_from_binary(const cl::Context& context, const cl::Device& device, const std::string& binary,
                                               const std::string& options, const std::string& entry) try {
  if (binary.empty()) return {};
  cl::Program program(context, {device}, {std::vector<unsigned char>(binary.begin(), binary.end())});
  program.build(options.c_str());
  cl::Kernel(program, entry.c_str());
  return program;
} catch (const cl::Error&) {
  return {};
}

/// Empty where the driver does not give it away.
std::string binary_of(const cl::Program& program) try {
  const auto binaries = program.getInfo<CL_PROGRAM_BINARIES>();
  return binaries.empty() ? std::string{} : std::string(binaries[0].begin(), binaries[0].end());
} catch (const cl::Error&) {
  return {};
}

std::string first_error_line(const std::string& log) {
  std::istringstream lines(log);
  for (std::string line; std::getline(lines, line);)
    if (line.find("error") != std::string::npos) return line;
  return log.substr(0, log.find('\n'));
}

}  // namespace

std::string joined_text(const std::string& file, const Choice& choice) {
  std::set<std::string> seen;
  std::string out;
  join(file, choice, seen, out);
  return out;
}

std::string build_options(const DeviceInfo& device, const Choice& choice) {
  std::ostringstream options;
  const ChoiceNames names(choice);
  options << "-cl-std=CL1.2 -DRELUME_OPENCL -DRELUME_LANES=" << device.lanes << " -DRELUME_DIFFUSE=" << names.diffuse
          << " -DRELUME_SPECULAR=" << names.specular << " -DRELUME_FRESNEL=" << names.fresnel << " -DRELUME_SHADOWING=" << names.shadowing
          << " -DRELUME_DISTRIBUTION=" << names.distribution;
  if (device.correctly_rounded) options << " -cl-fp32-correctly-rounded-divide-sqrt";
  // Not -cl-fast-relaxed-math: it assumes that NaN never comes, and pixels without a normal turn bright or black at random.
  if (device.precision == Precision::relaxed) options << " -cl-mad-enable -cl-no-signed-zeros -cl-unsafe-math-optimizations -DRELUME_RELAXED";
  return options.str();
}

cl::Program build_program(const cl::Context& context, const cl::Device& device, const DeviceInfo& info, const std::string& entry,
                          const Choice& choice) {
  const std::string text = joined_text("kernels/" + entry + ".cl", choice), options = build_options(info, choice),
                    key = cache_key(text, options, info);
  if (std::optional<cl::Program> cached = program_from_binary(context, device, cached_binary(key), options, entry)) return *cached;
  cl::Program program(context, text);
  try {
    program.build({device}, options.c_str());
  } catch (const cl::Error& error) {
    if (error.err() != CL_BUILD_PROGRAM_FAILURE) rethrow(error, info.name);
    throw Error(ErrorKind::device, info.name + ": a kernel does not build: " + first_error_line(program.getBuildInfo<CL_PROGRAM_BUILD_LOG>(device)));
  }
  if (const std::string binary = binary_of(program); !binary.empty()) keep_binary(key, binary);
  return program;
}

}  // namespace relume
